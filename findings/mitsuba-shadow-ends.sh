#!/usr/bin/env bash
# mitsuba 3.9.1 (Python).
#
# The guess: a black sheet between a lamp and a floor throws a shadow, however
# near the lamp it is, as long as floats can tell the two apart.
# Observed: a shadow ray ends 9e-4 of its length before the light. A sheet 2 mm
# in front of a lamp keeps all light from a floor 2 m below, one 1 mm in front of
# it none, where lamps are sampled, as by `path`; rays by the surface's own density
# meet the sheet. So a thin tube that shines inward lights what is outside it
# through its wall.
#
# Why the input is valid: three rectangles with metres between 0.001 and 10;
# single precision tells 2 m from 2.001 m ten thousand times over.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages mitsuba==3.9.1 numpy==2.4.6

python - <<'PY'
import sys

import mitsuba
import numpy

mitsuba.set_variant("scalar_rgb")
T = mitsuba.ScalarTransform4f
down = T().rotate([1, 0, 0], 90)
film = {"type": "hdrfilm", "width": 8, "height": 8, "rfilter": {"type": "box"}}
camera = {
    "type": "perspective",
    "fov": 10,
    "film": film,
    "to_world": T().look_at([4, 1, 0], [0, 0, 0], [0, 1, 0]),
}


def rectangle(height, size, **more):
    to_world = T().translate([0, height, 0]) @ down @ T().scale([size, size, 1])
    grey = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.5}}
    return {"type": "rectangle", "to_world": to_world, "bsdf": {"type": "twosided", "n": grey}} | more


def mean(gap, integrator):
    emitter = {"type": "area", "radiance": {"type": "rgb", "value": 1.0}}
    scene = {
        "type": "scene",
        "camera": camera,
        "integrator": integrator,
        "floor": rectangle(0, 10),
        "lamp": rectangle(2 + gap, 0.25, emitter=emitter),
        "sheet": rectangle(2, 0.5),
    }
    return float(numpy.array(mitsuba.render(mitsuba.load_dict(scene), spp=1024)).mean())


def direct(emitter, bsdf):
    return {"type": "direct", "emitter_samples": emitter, "bsdf_samples": bsdf}


by_light = {gap: mean(gap, direct(1, 0)) for gap in (0.002, 0.001)}
by_surface = mean(0.001, direct(0, 1))
path = mean(0.001, {"type": "path", "max_depth": 2})
print(f"by the light: {by_light}; by the surface {by_surface:.6f}; path {path:.6f}")
if by_light[0.002] != 0 or by_surface != 0:
    sys.exit("changed: a sheet that throws its shadow")
if by_light[0.001] < 0.005 or path < 0.005:
    sys.exit("changed: a sheet near the lamp")
PY
