#!/usr/bin/env bash
# Pillow 13.0.0 (Python).
#
# The guess: a 32-bit TGA of one pixel loads like one of two, as a 24-bit one
# of one pixel does.
# Observed: Image.open accepts it and load raises OSError (Invalid argument): for
# pictures with alpha the last 26 bytes are looked at for the footer of version
# 2, and header and pixel together have only 22 bytes. 24-bit files of 21 bytes
# and 32-bit files of two pixels (26 bytes) load.
#
# Why the input is valid: the Truevision TGA File Format Specification 2.0,
# "TGA File Header", has 18 bytes, followed here by one pixel of 4 bytes; the
# footer is optional, and files of version 1 have none. One-pixel pictures are
# usual stand-ins for textures.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pillow==13.0.0

python - <<'PY'
import struct
import sys

from PIL import Image


def load(width, bits):
    descriptor = 0x28 if bits == 32 else 0x20
    header = struct.pack("<3BHHB4H2B", 0, 0, 2, 0, 0, 0, 0, 0, width, 1, bits, descriptor)
    with open("picture.tga", "wb") as file:
        file.write(header + bytes((1, 2, 3, 255))[: bits // 8] * width)
    with Image.open("picture.tga") as picture:
        try:
            picture.load()
        except OSError as error:
            return f"OSError: {error.strerror}"
        return picture.getpixel((0, 0))


rgb, two, one = load(1, 24), load(2, 32), load(1, 32)
print("1 pixel of 24 bits:", rgb)
print("2 pixels of 32 bits:", two)
print("1 pixel of 32 bits:", one)
if rgb != (3, 2, 1) or two != (3, 2, 1, 255):
    sys.exit("changed: the other small pictures are read otherwise")
if not str(one).startswith("OSError"):
    sys.exit("changed: the picture of one pixel loads")
PY
