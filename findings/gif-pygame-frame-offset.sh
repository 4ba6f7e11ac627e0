#!/usr/bin/env bash
# pygame 2.6.1 (Python, image reading by its bundled SDL_image).
#
# The guess: a loaded GIF has the size of its logical screen, with the picture
# where the file places it.
# Observed: the surface has the size of the first frame, its place on the screen
# is lost: a frame of 2 x 1 pixels at (3, 2) of a screen of 8 x 4 becomes a
# surface of 2 x 1 pixels. As a texture it fills the whole surface instead of a
# part of it.
#
# Why the input is valid: the GIF89a specification, section 18 (Logical Screen
# Descriptor) and section 20 (Image Descriptor): an image may cover a part of
# the screen, its left and top position say where; optimisers trim frames so.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pygame==2.6.1

PYGAME_HIDE_SUPPORT_PROMPT=1 python - <<'PY'
import struct
import sys

import pygame

palette = bytes((0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255))
screen = b"GIF89a" + struct.pack("<2H3B", 8, 4, 0xF1, 0, 0) + palette
frame = b"," + struct.pack("<4HB", 3, 2, 2, 1, 0)
# Codes of 3 bits, least first: clear (4), colours 1 and 2, end (5).
codes = 4 | 1 << 3 | 2 << 6 | 5 << 9
with open("picture.gif", "wb") as file:
    file.write(screen + frame + bytes((2, 2)) + struct.pack("<H", codes) + b"\0;")

picture = pygame.image.load("picture.gif")
pixels = [tuple(picture.get_at((x, 0)))[:3] for x in range(2)]
print("size:", picture.get_size(), "first pixels:", pixels)
if picture.get_size() != (2, 1) or pixels != [(255, 0, 0), (0, 255, 0)]:
    sys.exit("changed: the frame is placed otherwise")
PY
