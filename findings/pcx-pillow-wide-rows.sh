#!/usr/bin/env bash
# Pillow 13.0.0 (Python).
#
# The guess: rows of an 8-bit PCX are found by the header's BytesPerLine.
# Observed: with 4 pixels a row and BytesPerLine 6 the second row begins in the
# padding of the first, without an error: rows 10 20 30 40 and 50 60 70 80, each
# padded with 9 9, come back as 10 20 30 40 and 9 9 50 60.
#
# Why the input is valid: the ZSoft PCX Technical Reference Manual, header field
# BytesPerLine, gives the bytes stored for a row of a plane, says that they must
# be even and that they must not be computed from Xmax - Xmin. Programs that
# round up to 4 or more bytes write such files.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pillow==13.0.0

python - <<'PY'
import struct
import sys

from PIL import Image


def pcx(stride):
    rows = [(10, 20, 30, 40), (50, 60, 70, 80)]
    header = struct.pack("<4B6H", 10, 5, 1, 8, 0, 0, 3, 1, 72, 72)
    header += bytes(48) + struct.pack("<BBHHHH", 0, 1, stride, 1, 0, 0) + bytes(54)
    body = b"".join(bytes(row).ljust(stride, b"\x09") for row in rows)
    # Two equal bytes may stand as they are: only bytes from 0xC0 up are runs.
    palette = b"\x0c" + bytes(i for i in range(256) for _ in range(3))
    return header + body + palette


def load(stride):
    name = f"{stride}.pcx"
    with open(name, "wb") as file:
        file.write(pcx(stride))
    with Image.open(name) as picture:
        return list(picture.convert("L").tobytes())


tight, wide = load(4), load(6)
print("4 bytes a row:", tight)
print("6 bytes a row:", wide)
if tight != [10, 20, 30, 40, 50, 60, 70, 80]:
    sys.exit("changed: rows without padding are read otherwise")
if wide != [10, 20, 30, 40, 9, 9, 50, 60]:
    sys.exit("changed: rows with padding are read otherwise")
PY
