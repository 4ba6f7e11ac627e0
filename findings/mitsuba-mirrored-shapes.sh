#!/usr/bin/env bash
# mitsuba 3.9.1 (Python).
#
# The guess: a shape mirrored by its transform is turned inside out by all kinds of
# shapes or by none.
# Observed: it depends on the kind. Mirrored in x, a `sphere` and an `obj` without
# normals are turned inside out: from outside or in front a white surface is black
# and a lamp is dark. A `cube`, a `rectangle`, a `disk` and the same `obj` with normals
# in its file stay as they are, and so do all of them if the same mirroring stands in
# an `instance` of the shape instead. There is no warning.
#
# Why the input is valid: Mitsuba's plugin reference, shapes: to_world takes a linear
# transformation, for spheres without non-uniform scale; scenes mirror symmetric parts
# that way. The area emitter radiates from the exterior of a shape.
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
square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
for name, rest in (("plain.obj", "f 1 2 3 4\n"), ("normals.obj", "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n")):
    with open(name, "w") as file:
        file.write(square + rest)
shapes = {
    "sphere": {"type": "sphere"},
    "obj": {"type": "obj", "filename": "plain.obj"},
    "obj with normals": {"type": "obj", "filename": "normals.obj"},
    "cube": {"type": "cube"},
    "rectangle": {"type": "rectangle"},
    "disk": {"type": "disk"},
}
white = {"type": "rgb", "value": 1.0}
sun = {"type": "directional", "direction": [0, 0, -1], "irradiance": {"type": "rgb", "value": math.pi}}
diffuse = {"bsdf": {"type": "diffuse", "reflectance": white}}
lamp = {"emitter": {"type": "area", "radiance": white}}


# What is seen of the parts from above, by the light of a sun above: 1 for white.
def radiance(parts):
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
        **parts,
    }
    return round(float(numpy.array(mitsuba.render(mitsuba.load_dict(scene), spp=16)).ravel()[0]), 2)


def views(shape, transform):
    group = {"type": "shapegroup", "shape": {**shape, **diffuse}}
    instance = {"type": "instance", "to_world": transform, "reference": {"type": "ref", "id": "group"}}
    return (
        radiance({"sun": sun, "shape": {**shape, "to_world": transform, **diffuse}}),
        radiance({"shape": {**shape, "to_world": transform, **lamp}}),
        radiance({"sun": sun, "group": group, "instance": instance}),
    )


for name, shape in shapes.items():
    plain = views(shape, to_world())
    mirrored = views(shape, to_world().scale([-1, 1, 1]))
    print(f"{name}: white surface, lamp and instance {plain}, mirrored {mirrored}")
    turned = name in ("sphere", "obj")
    if plain != (1, 1, 1) or mirrored != ((0, 0, 1) if turned else (1, 1, 1)):
        sys.exit(f"changed: the mirrored {name}")
PY
