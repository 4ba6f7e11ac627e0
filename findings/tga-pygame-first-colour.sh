#!/usr/bin/env bash
# pygame 2.6.1 (Python, image reading by its bundled SDL_image).
#
# The guess: a colour-mapped TGA whose colour map begins with entry 10 shows the
# colours that its pixels 10, 11 and 12 name.
# Observed: all pixels are black, without an error; the same picture with a map
# that begins with entry 0 and pixels 0, 1 and 2 is right.
#
# Why the input is valid: the Truevision TGA File Format Specification 2.0,
# field 4.1 (First Entry Index), lets a file store a part of a colour map and
# gives the index of the first entry that is stored.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pygame==2.6.1

PYGAME_HIDE_SUPPORT_PROMPT=1 python - <<'PY'
import struct
import sys

import pygame


def load(first):
    name = f"{first}.tga"
    colour_map = bytes((0, 0, 200, 0, 150, 0, 100, 0, 0))  # blue, green, red
    header = struct.pack("<3BHHB4H2B", 0, 1, 1, first, 3, 24, 0, 0, 3, 1, 8, 0x20)
    with open(name, "wb") as file:
        file.write(header + colour_map + bytes((first, first + 1, first + 2)))
    picture = pygame.image.load(name)
    return [tuple(picture.get_at((x, 0)))[:3] for x in range(3)]


zero, ten = load(0), load(10)
print("map from entry 0:", zero)
print("map from entry 10:", ten)
if zero != [(200, 0, 0), (0, 150, 0), (0, 0, 100)]:
    sys.exit("changed: a map that begins with entry 0 is read otherwise")
if ten != [(0, 0, 0)] * 3:
    sys.exit("changed: a map that begins with entry 10 is read otherwise")
PY
