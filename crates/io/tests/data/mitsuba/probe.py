"""What Mitsuba 3.9.1 (`scalar_rgb`) finds along rays in the scenes here, as `expected.json`.

    pip install mitsuba==3.9.1 numpy==2.4.6; python probe.py

Of each ray: where it begins and goes; how far it is to the first surface; what this reflects back
toward the ray, a BRDF times pi; and what it emits toward it. The first rays are those of the
camera through the middles of pixels, the others come from all around.
"""
import json, math
import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")
mi.set_log_level(mi.LogLevel.Error)
NAMES = "shapes meshes textures sides camera-y camera-lens old included box paints".split()


def probe(scene, origin, direction):
    ray = mi.Ray3f(mi.Point3f(origin), mi.Vector3f(direction))
    hit = scene.ray_intersect(ray)
    if not hit.is_valid():
        return None
    bsdf = hit.bsdf()
    # Nearly back along the ray, so that highlights would show, too.
    value = bsdf.eval(mi.BSDFContext(), hit, hit.wi)
    cosine = abs(hit.wi.z)
    emitter = hit.emitter(scene)
    emitted = emitter.eval(hit) if emitter is not None else [0, 0, 0]
    numbers = lambda values: [float("%.5g" % float(v)) for v in values]
    return {"distance": float("%.6g" % hit.t), "reflected": numbers(v * math.pi / cosine for v in value),
            "emitted": numbers(emitted), "normal": numbers(hit.sh_frame.n)}


found = {}
for name in NAMES:
    # Unless told otherwise it refuses rectangles of one material with normals of both ways.
    scene = mi.load_file(name + ".xml", optimize=False)
    sensor = scene.sensors()[0]
    width, height = sensor.film().size()
    rays, random = [], np.random.default_rng(7)
    for _ in range(30):
        x, y = int(random.integers(width)), int(random.integers(height))
        ray, _ = sensor.sample_ray(0, 0.5, [(x + 0.5) / width, (y + 0.5) / height], [0.5, 0.5])
        rays.append(([x, y], list(ray.o), list(ray.d)))
    box = scene.bbox()
    middle, reach = np.array(box.center()), np.linalg.norm(np.array(box.extents()))
    for _ in range(60):
        to = random.normal(size=3)
        end = middle + (random.random(3) - 0.5) * np.array(box.extents())
        start = end + to / np.linalg.norm(to) * reach
        rays.append((None, list(start), list((end - start) / np.linalg.norm(end - start))))
    probes = []
    for pixel, origin, direction in rays:
        origin, direction = ([float("%.6g" % v) for v in vector] for vector in (origin, direction))
        probes.append({"pixel": pixel, "origin": origin, "direction": direction, "hit": probe(scene, origin, direction)})
    found[name] = {"width": int(width), "height": int(height), "probes": probes}
json.dump(found, open("expected.json", "w"), separators=(",", ":"))
print({name: sum(probe["hit"] is not None for probe in found[name]["probes"]) for name in NAMES})
