#!/usr/bin/env bash
# mitsuba 3.9.1.
#
# The guess: the rows of a latitude-longitude picture are bands of equal height,
# as its columns are sectors of equal width, so that `envmap` shows the value of
# row j of h at the polar angle (j + 1/2)/h of 180°, and the mean light of a
# picture is that of its texels weighed by the solid angle of their bands.
# Observed: columns are so, their centres at (i + 1/2)/w of 360°. Rows are not:
# row j is at j/(h - 1) of 180°, the first and the last on the poles, where a
# point has no solid angle: of four rows the second one's value is at 60° from the
# pole for 67.5°. The light of a picture of few rows, or of a sun in one texel near
# a pole, is another than in renderers that take texels for areas.
#
# Why the input is valid: the documentation of `envmap` asks for a picture in
# latitude-longitude format, of any size; it tells of no rows on the poles.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages mitsuba==3.9.1 numpy==2.4.6

python - <<'PY'
import math
import sys

import mitsuba
import numpy

mitsuba.set_variant("scalar_rgb")


def picture(values):
    return mitsuba.load_dict({
        "type": "envmap",
        "bitmap": mitsuba.Bitmap(numpy.repeat(values[..., None], 3, 2).astype("float32")),
    })


def shown(light, around, down):
    """The light from a part of 360 degrees and a part of 180 degrees from the pole."""
    theta, phi = math.pi * down, 2 * math.pi * around
    toward = mitsuba.Vector3f(
        math.sin(phi) * math.sin(theta), math.cos(theta), -math.cos(phi) * math.sin(theta)
    )
    interaction = mitsuba.SurfaceInteraction3f()
    interaction.wi = -toward
    interaction.wavelengths = []
    return round(float(light.eval(interaction)[0]), 3)


rows = picture(numpy.arange(4.0)[:, None].repeat(8, 1))
by_row = [shown(rows, 0.3, down) for down in (1 / 8, 1 / 3, 3 / 8, 2 / 3, 7 / 8)]
columns = picture(numpy.arange(8.0)[None, :].repeat(4, 0))
by_column = [shown(columns, around, 0.4) for around in (0.5 / 8, 1 / 8, 1.5 / 8, 3.5 / 8)]
print(f"rows {by_row}, columns {by_column}")
if by_row != [0.375, 1.0, 1.125, 2.0, 2.625]:
    sys.exit("changed: where rows are")
if by_column != [0.0, 0.5, 1.0, 3.0]:
    sys.exit("changed: where columns are")
PY
