#!/usr/bin/env bash
# mitsuba 3.9.1 (Python).
#
# The guess: the size of a light's local axes does not matter to a sun, which is
# infinitely far away and given by its irradiance; a scene put in other units by its
# transforms is lit as before.
# Observed: the irradiance of `directional` is multiplied by the scale in `to_world`,
# without a warning: a white floor under a sun of irradiance pi has radiance 1 without
# a scale, 3 with a scale of 3 and 0.5 with one of 0.5. So is that of `projector`.
# `point` and `spot` lights are not changed by it, nor is a sun whose `direction` is
# given as a vector of length 3.
#
# Why the input is valid: Mitsuba's plugin reference, directional: to_world is an
# emitter-to-world transformation and irradiance the power that arrives per unit
# area; a uniform scale is a transformation of every scene in other units.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages mitsuba==3.9.1 numpy==2.4.6

python - <<'PY'
import math
import sys

import mitsuba
import numpy

mitsuba.set_variant("scalar_rgb")
mitsuba.set_log_level(mitsuba.LogLevel.Error)
to_world = mitsuba.ScalarTransform4f
white = {"type": "rgb", "value": 1.0}
lights = {
    "directional": {"irradiance": {"type": "rgb", "value": math.pi}},
    "projector": {"irradiance": white, "fov": 45.0},
    "point": {"intensity": {"type": "rgb", "value": math.pi}},
    "spot": {"intensity": {"type": "rgb", "value": math.pi}, "cutoff_angle": 30.0},
}


# The middle of a white floor at z = 0, seen from above.
def radiance(light):
    scene = {
        "type": "scene",
        "integrator": {"type": "direct"},
        "sensor": {
            "type": "orthographic",
            "to_world": to_world().look_at([0, 0, 5], [0, 0, 0], [0, 1, 0]) @ to_world().scale([0.01, 0.01, 1]),
            "film": {
                "type": "hdrfilm", "width": 1, "height": 1,
                "pixel_format": "luminance", "rfilter": {"type": "box"},
            },
        },
        "floor": {
            "type": "rectangle",
            "to_world": to_world().scale(10),
            "bsdf": {"type": "diffuse", "reflectance": white},
        },
        "light": light,
    }
    return float(numpy.array(mitsuba.render(mitsuba.load_dict(scene), spp=16)).ravel()[0])


def expect(name, found, expected):
    print(f"{name}: {found:.4f}")
    if abs(found / expected - 1) > 2e-3:
        sys.exit(f"changed: {name}")


down = to_world().look_at([0, 0, 1], [0, 0, 0], [0, 1, 0])
for kind, rest in lights.items():
    plain = radiance({"type": kind, "to_world": down, **rest})
    if kind != "projector":
        expect(f"{kind}", plain, 1)
    for scale in (3, 0.5):
        scaled = radiance({"type": kind, "to_world": down @ to_world().scale(scale), **rest})
        follows = kind in ("directional", "projector")
        expect(f"{kind}, scale {scale}, against no scale", scaled / plain, scale if follows else 1)
sun = {"type": "directional", "direction": [0, 0, -3], **lights["directional"]}
expect("directional, direction of length 3", radiance(sun), 1)
PY
