#!/usr/bin/env bash
# pygame 2.6.1 (Python, image reading by its bundled SDL_image).
#
# The guess: a 24-bit PCX of odd width loads like one of even width.
# Observed: the green plane of each row is read one byte late and the blue plane
# two bytes late, without an error, so colours are shifted to the right and the
# padding byte 0 appears as a colour. The pixels (1,5,9) (2,6,10) (3,7,11) come
# back as (1,0,7) (2,5,0) (3,6,9). A width of 4 is read rightly.
#
# Why the input is valid: the ZSoft PCX Technical Reference Manual asks in the
# header field BytesPerLine for an even number of bytes a plane and says not to
# compute it from Xmax - Xmin, so a width of 3 is stored with 4 bytes a plane.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pygame==2.6.1

PYGAME_HIDE_SUPPORT_PROMPT=1 python - <<'PY'
import struct
import sys

import pygame


def pcx(width, planes):
    stride = width + width % 2
    header = struct.pack("<4B6H", 10, 5, 1, 8, 0, 0, width - 1, 0, 72, 72)
    header += bytes(48) + struct.pack("<BBHHHH", 0, 3, stride, 1, 0, 0) + bytes(54)
    # No byte reaches 0xC0 and none repeats, so each stands for itself.
    return header + b"".join(bytes(p[:width]).ljust(stride, b"\0") for p in planes)


def load(width):
    planes = [(1, 2, 3, 4), (5, 6, 7, 8), (9, 10, 11, 12)]
    name = f"{width}.pcx"
    with open(name, "wb") as file:
        file.write(pcx(width, planes))
    picture = pygame.image.load(name)
    return [tuple(picture.get_at((x, 0)))[:3] for x in range(width)]


even, odd = load(4), load(3)
print("width 4:", even)
print("width 3:", odd)
if even != [(1, 5, 9), (2, 6, 10), (3, 7, 11), (4, 8, 12)]:
    sys.exit("changed: the picture of even width is read otherwise")
if odd != [(1, 0, 7), (2, 5, 0), (3, 6, 9)]:
    sys.exit("changed: the picture of odd width is read otherwise")
PY
