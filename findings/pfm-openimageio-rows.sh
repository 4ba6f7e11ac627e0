#!/usr/bin/env bash
# OpenImageIO 3.2.2.0, mitsuba 3.9.1 and OpenCV 5.0.0.93 (Python).
#
# The guess: a PFM is read as it is written: the first row of the file is the
# bottom one.
# Observed: OpenImageIO writes the bottom row first, and reads the first row of a
# file as the top one, without an error. It turns its own PFM upside down, as those
# of Mitsuba and OpenCV, which agree with each other. Asked for pnm:pfmflip=1 when
# the file is opened, it reads them the right way up.
#
# Why the input is valid: the PFM Format Description of Netpbm, PFM raster: rows
# are stored from bottom to top; the files are written by the programs themselves.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages OpenImageIO==3.2.2.0 mitsuba==3.9.1 opencv-python-headless==5.0.0.93 numpy==2.4.6

python - <<'PY'
import sys

import cv2
import mitsuba
import numpy
import OpenImageIO

mitsuba.set_variant("scalar_rgb")
rows = numpy.repeat(numpy.array([1, 2, 3], "float32"), 3).reshape(3, 1, 3)

picture = OpenImageIO.ImageBuf(OpenImageIO.ImageSpec(1, 3, 3, "float"))
picture.set_pixels(OpenImageIO.ROI(), rows)
picture.write("openimageio.pfm")
mitsuba.Bitmap(rows).write("mitsuba.pfm")
cv2.imwrite("opencv.pfm", rows)


def flipped(name):
    hint = OpenImageIO.ImageSpec()
    hint.attribute("pnm:pfmflip", 1)
    return OpenImageIO.ImageInput.open(name, hint).read_image()


readers = {
    "mitsuba": lambda name: numpy.array(mitsuba.Bitmap(name)),
    "opencv": lambda name: cv2.imread(name, cv2.IMREAD_UNCHANGED),
    "openimageio": lambda name: OpenImageIO.ImageBuf(name).get_pixels(),
    "openimageio, pnm:pfmflip=1": flipped,
}
for writer in ("openimageio", "mitsuba", "opencv"):
    for reader, read in readers.items():
        found = read(writer + ".pfm")[:, 0, 0].tolist()
        print(f"rows 1 2 3 written by {writer}, read by {reader}: {found}")
        if found != ([3, 2, 1] if reader == "openimageio" else [1, 2, 3]):
            sys.exit(f"changed: rows written by {writer} and read by {reader}")
PY
