#!/usr/bin/env bash
# pyradiance 1.3.1 (Python, with the programs of Radiance).
#
# The guess: an MGF surface that emits and reflects does both after mgf2rad.
# Observed: the reflectance is dropped without a warning: the material becomes a
# plain `light`. In a closed box whose walls all reflect a half (rd .5) and emit
# radiance 0.25 (ed 0.25 * pi * 179 = 140.58) the radiance is 0.25 / (1 - 0.5) =
# 0.5 everywhere; rtrace on the translated scene gives 0.25, with 5 bounces.
#
# Why the input is valid: Ward, "The Materials and Geometry Format", entities rd
# and ed: reflectance and emittance are parts of one material, and ed counts
# emitted light only, not reflected light.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pyradiance==1.3.1

python - <<'PY'
import os
import subprocess
import sys

import pyradiance

home = os.path.dirname(pyradiance.__file__)
os.environ["RAYPATH"] = os.path.join(home, "lib")


def radiance_inside(emittance_first):
    entities = ["ed 140.586", "rd .5"] if emittance_first else ["rd .5", "ed 140.586"]
    lines = ["m wall =", "sides 1", *entities]
    for name, point in (("a", "0 0 0"), ("b", "1 0 0"), ("c", "1 1 0"), ("d", "0 1 0")):
        lines += [f"v {name} =", f"p {point}"]
    lines.append("prism a b c d -1")  # a unit cube above the square, facing inwards
    with open("room.mgf", "w") as file:
        file.write("\n".join(lines) + "\n")
    run = lambda name, *words, **more: subprocess.run(
        [os.path.join(home, "bin", name), *words], check=True, capture_output=True, timeout=120, **more
    ).stdout
    with open("room.rad", "wb") as file:
        file.write(run("mgf2rad", "room.mgf"))
    with open("room.oct", "wb") as file:
        file.write(run("oconv", "room.rad"))
    ray = b".3 .4 .5 1 .2 .1\n"
    return [float(word) for word in run("rtrace", "-h", "-ab", "5", "-aa", "0", "-ad", "64", "room.oct", input=ray).split()]


for first in (False, True):
    found = radiance_inside(first)
    print("radiance in the room:", found)
    if any(abs(value - 0.25) > 1e-3 for value in found):
        sys.exit("changed: the reflectance of a lamp counts otherwise")
PY
