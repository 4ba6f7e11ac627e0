#!/usr/bin/env bash
# mitsuba 3.9.1 (Python).
#
# The guess: a bitmap that says it is premultiplied by alpha is divided by alpha
# when it is written as PNG, and reads back as the same picture.
# Observed: the premultiplied colours go into the PNG as they are, without an error.
# A grey of 0.25 at a coverage of a half (a surface of 0.5) is stored as 137 instead
# of 188, and the file read back is taken for unmultiplied: over black it shows
# 0.126 instead of 0.25. Edges of a rendering with an alpha channel get dark rims.
# With the alpha transform Unpremultiply asked for by hand the PNG is right.
#
# Why the input is valid: Portable Network Graphics Specification, Alpha channel:
# PNG uses unassociated alpha; the bitmap says by premultiplied_alpha() that it is
# associated, as Mitsuba's films give it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages mitsuba==3.9.1 Pillow==13.0.0 numpy==2.4.6

python - <<'PY'
import sys

import mitsuba
import numpy
from PIL import Image

mitsuba.set_variant("scalar_rgb")
rgba = mitsuba.Bitmap.PixelFormat.RGBA
bitmap = mitsuba.Bitmap(numpy.array([[[0.25, 0.25, 0.25, 0.5]]], "float32"), rgba)
print(f"premultiplied: {bitmap.premultiplied_alpha()}")
byte = mitsuba.Struct.Type.UInt8
bitmap.convert(rgba, byte, True).write("plain.png")
asked = mitsuba.Bitmap.AlphaTransform.Unpremultiply
bitmap.convert(rgba, byte, True, asked).write("asked.png")


def over_black(name):
    stored = numpy.array(Image.open(name)).ravel().tolist()
    back = mitsuba.Bitmap(name)
    linear = back.convert(rgba, mitsuba.Struct.Type.Float32, False)
    red, _, _, alpha = (float(value) for value in numpy.array(linear).ravel())
    seen = red if back.premultiplied_alpha() else red * alpha
    print(f"{name}: bytes {stored}, premultiplied {back.premultiplied_alpha()}, over black {seen:.3f}")
    return stored[0], seen


if not bitmap.premultiplied_alpha():
    sys.exit("changed: the bitmap is not premultiplied")
stored, seen = over_black("plain.png")
if not (abs(stored - 137) <= 1 and abs(seen - 0.126) < 2e-3):
    sys.exit("changed: the bitmap written as it is")
stored, seen = over_black("asked.png")
if not (abs(stored - 188) <= 1 and abs(seen - 0.25) < 4e-3):
    sys.exit("changed: the bitmap unmultiplied by hand")
PY
