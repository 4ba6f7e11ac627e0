#!/usr/bin/env bash
# pyradiance 1.3.1 (Python, with the programs of Radiance).
#
# The guess: a two-sided emitter of MGF shines from both sides after mgf2rad.
# Observed: it shines from its front only, without a warning: a square with ed
# 562.345 (radiance 1) is seen as 1 from above and as 0 from below, whether the
# material says `sides 1`, `sides 2` or nothing. mgf2rad writes one polygon with a
# Radiance `light`, which is dark behind.
#
# Why the input is valid: Ward, "The Materials and Geometry Format", entity
# sides: 2 is the default, surfaces are then visible from both sides.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pyradiance==1.3.1

python - <<'PY'
import os
import subprocess
import sys

import pyradiance

home = os.path.dirname(pyradiance.__file__)
os.environ["RAYPATH"] = os.path.join(home, "lib")


def run(name, *words, **more):
    tool = os.path.join(home, "bin", name)
    return subprocess.run([tool, *words], check=True, capture_output=True, timeout=120, **more).stdout


def seen(sides):
    lines = ["m lamp =", "ed 562.345", *sides]
    for name, point in (("a", "0 0 0"), ("b", "1 0 0"), ("c", "1 1 0"), ("d", "0 1 0")):
        lines += [f"v {name} =", f"p {point}"]
    with open("lamp.mgf", "w") as file:
        file.write("\n".join([*lines, "f a b c d"]) + "\n")
    with open("lamp.rad", "wb") as file:
        file.write(run("mgf2rad", "lamp.mgf"))
    with open("lamp.oct", "wb") as file:
        file.write(run("oconv", "lamp.rad"))
    rays = b".3 .2 1 0 0 -1\n.3 .2 -1 0 0 1\n"
    rows = run("rtrace", "-h", "-ab", "0", "lamp.oct", input=rays).decode().splitlines()
    return [float(row.split()[0]) for row in rows]


for sides in ([], ["sides 1"], ["sides 2"]):
    above, below = seen(sides)
    print(" ".join(sides) or "no sides entity", f"- from above {above}, from below {below}")
    if abs(above - 1) > 1e-3 or below != 0:
        sys.exit(f"changed: an emitter with {sides or 'no sides entity'}")
PY
