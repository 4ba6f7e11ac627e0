"""Renders with Mitsuba 3 what it is told of by lines of JSON, and answers each with one.

Asked:    {"file": "scene.xml", "seed": 1, "passes": 128}
Answered: {"pixels": 256, "passes": [[of all, upper left, upper right, lower left, lower right], ...]}
          the mean luminance of each pass, which is one sample a pixel, of all and of the quarters;
          or {"error": "why not"}
"""
import json
import sys

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")
mi.set_log_level(mi.LogLevel.Error)
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


def cells(image):
    light = image[..., :3].astype(np.float64) @ LUMINANCE
    half = light.shape[0] // 2
    parts = [light, light[:half, :half], light[:half, half:], light[half:, :half], light[half:, half:]]
    return [float(part.mean()) for part in parts]


def answer(question):
    # Surfaces stay apart, as the file has them.
    scene = mi.load_file(question["file"], optimize=False)
    # Seeds are multiplied by the number of pixels in 32 bits.
    first = question["seed"] * 0x9E3779B1
    passes = []
    for number in range(question["passes"]):
        image = np.array(mi.render(scene, spp=1, seed=(first + number) % 2**24))
        passes.append(cells(image))
    return {"pixels": int(image.shape[0] * image.shape[1]), "passes": passes}


for line in sys.stdin:
    try:
        found = answer(json.loads(line))
    except Exception as error:
        found = {"error": str(error)}
    print(json.dumps(found), flush=True)
