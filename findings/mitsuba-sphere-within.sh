#!/usr/bin/env bash
# mitsuba 3.9.1 (Python).
#
# The guess: `path` finds the light of a sphere that shines inward and reflects
# (a dome, a furnace) without bias, as it finds that of every other lamp.
# Observed: seen from within, a sphere of radiance 1 and reflectance 0.5 is
# 1.5 bright after two edges, but `path` finds 1.508. Of points on the
# sphere `sample_direction` samples it as from within, while `pdf_direction`
# takes one in six, as they are rounded, for points outside, which see it in a
# cone: the weights of the two techniques no longer add up to one.
# `direct` with either technique alone finds 1.5.
#
# Why the input is valid: `flip_normals` is how the plugin documentation of
# `sphere` turns one inside out, and an area emitter may stand on any shape.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages mitsuba==3.9.1 numpy==2.4.6

python - <<'PY'
import sys

import mitsuba
import numpy

mitsuba.set_variant("scalar_rgb")
to_world = mitsuba.ScalarTransform4f().look_at([0, 0.2, 0.24], [0, 0, 0], [0, 1, 0])
film = {"type": "hdrfilm", "width": 16, "height": 16, "rfilter": {"type": "box"}}
sphere = {
    "type": "sphere",
    "flip_normals": True,
    "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.5}},
    "emitter": {"type": "area", "radiance": {"type": "rgb", "value": 1.0}},
}


def mean(integrator):
    camera = {"type": "perspective", "fov": 40, "to_world": to_world, "film": film}
    scene = {"type": "scene", "integrator": integrator, "sphere": sphere, "camera": camera}
    picture = numpy.array(mitsuba.render(mitsuba.load_dict(scene), spp=256))
    return float(picture.mean())


def direct(emitter, bsdf):
    return mean({"type": "direct", "emitter_samples": emitter, "bsdf_samples": bsdf})


shape = mitsuba.load_dict(sphere)
random = numpy.random.default_rng(1)
wrong = 0
for _ in range(1000):
    direction = random.normal(size=3)
    direction /= numpy.linalg.norm(direction)
    met = shape.ray_intersect(mitsuba.Ray3f([0.5, 0.3, 0.1], direction.tolist()))
    sample = shape.sample_direction(met, random.random(2).tolist())
    wrong += abs(shape.pdf_direction(met, sample) / sample.pdf - 1) > 1e-3
path, by_light, by_bsdf = mean({"type": "path", "max_depth": 2}), direct(1, 0), direct(0, 1)
print(f"path {path:.4f}, by the light {by_light:.4f}, by the surface {by_bsdf:.4f}")
print(f"densities differ at {wrong} of 1000 points")
if abs(by_light - 1.5) > 1e-4 or abs(by_bsdf - 1.5) > 1e-4:
    sys.exit("changed: one technique alone")
if path < 1.504 or wrong < 20:
    sys.exit("changed: path within a sphere that shines")
PY
