#!/usr/bin/env bash
# mitsuba 3.9.1 and OpenEXR 3.5.3 (Python).
#
# The guess: Mitsuba's Bitmap keeps the precision of the channels of an EXR, so
# that a 32-bit depth or an object id beside half-float colours stays exact.
# Observed: one half-float channel makes the whole bitmap half-float: the depth
# 1000.123 becomes 1000, the depth 70001 infinite, the id 2049 becomes 2048 and
# the id 70001 infinite, without an error. With 32-bit colours the same depths
# stay.
#
# Why the input is valid: "OpenEXR File Layout", attribute channels (chlist),
# gives every channel a pixel type of its own; 32-bit depth beside half colours
# is what common renderers write.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages mitsuba==3.9.1 OpenEXR==3.5.3 numpy==2.4.6

python - <<'PY'
import sys

import mitsuba
import numpy
import OpenEXR

mitsuba.set_variant("scalar_rgb")


def load(colour_type):
    channels = {key: numpy.array([[1, 2]], colour_type) for key in "RGB"}
    channels["Z"] = numpy.array([[1000.123, 70001]], "float32")
    channels["id"] = numpy.array([[2049, 70001]], "uint32")
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, channels).write("picture.exr")
    bitmap = mitsuba.Bitmap("picture.exr")
    names = [field.name for field in bitmap.struct_()]
    values = numpy.array(bitmap)[0]
    depth = values[:, names.index("Z")].astype(float).tolist()
    ids = values[:, names.index("id")].astype(float).tolist()
    print(f"{colour_type} colours: depths {depth}, ids {ids}")
    return depth + ids


infinite = float("inf")
if load("float16") != [1000.0, infinite, 2048.0, infinite]:
    sys.exit("changed: channels beside half-float colours")
full = load("float32")
if any(abs(a - b) > 1e-4 for a, b in zip(full, (1000.123, 70001, 2049, 70001))):
    sys.exit("changed: channels beside 32-bit colours")
PY
