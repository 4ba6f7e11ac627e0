#!/usr/bin/env bash
# OpenCV 5.0.0.93 (opencv-python-headless), mitsuba 3.9.1, OpenImageIO 3.2.2.0
# (Python) and Pillow 13.0.0 (Python).
#
# The guess: readers of PFM agree on the value of a sample, since it is a float.
# Observed: for the stored sample 3 and the scale 2 Mitsuba and OpenImageIO give 6,
# Pillow gives 3 and OpenCV gives 1.5, all without an error; for the scale 0.5 they
# give 1.5, 3 and 6. With a scale of 1 all give 3. The same file compared through
# two of them differs by the square of the scale.
#
# Why the input is valid: the PFM Format Description of Netpbm, Scale Factor /
# Endianness: the sign tells the byte order and the absolute value is a scale
# factor, any number but 0.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages opencv-python-headless==5.0.0.93 mitsuba==3.9.1 OpenImageIO==3.2.2.0 \
    Pillow==13.0.0 numpy==2.4.6

python - <<'PY'
import sys

import cv2
import mitsuba
import numpy
import OpenImageIO
from PIL import Image

mitsuba.set_variant("scalar_rgb")


def samples(scale):
    with open("picture.pfm", "wb") as file:
        file.write(f"Pf\n1 1\n{scale}\n".encode() + numpy.array([3], "<f4" if scale < 0 else ">f4").tobytes())
    found = (
        float(numpy.array(mitsuba.Bitmap("picture.pfm")).ravel()[0]),
        float(OpenImageIO.ImageBuf("picture.pfm").get_pixels().ravel()[0]),
        float(numpy.array(Image.open("picture.pfm")).ravel()[0]),
        float(cv2.imread("picture.pfm", cv2.IMREAD_UNCHANGED).ravel()[0]),
    )
    print("scale {}: Mitsuba {}, OpenImageIO {}, Pillow {}, OpenCV {}".format(scale, *found))
    return found


expected = {
    -1.0: (3, 3, 3, 3),
    1.0: (3, 3, 3, 3),
    -2.0: (6, 6, 3, 1.5),
    2.0: (6, 6, 3, 1.5),
    -0.5: (1.5, 1.5, 3, 6),
}
for scale, values in expected.items():
    if samples(scale) != values:
        sys.exit(f"changed: samples with the scale {scale}")
PY
