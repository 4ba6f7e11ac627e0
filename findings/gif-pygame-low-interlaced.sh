#!/usr/bin/env bash
# pygame 2.6.1 (Python, image reading by its bundled SDL_image).
#
# The guess: an interlaced GIF loads like the same GIF without interlace.
# Observed: interlaced pictures of 2, 3 and 4 rows keep their first row only, the
# other rows show colour 0, without an error; from 5 rows on they are right. The
# second pass (every 8th row from row 4) then has no row, and all later rows are
# lost with it.
#
# Why the input is valid: the GIF89a specification, section 20 (Image
# Descriptor, interlace flag) and appendix E (Interlaced Images), have no least
# height; a pass without rows is empty.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pygame==2.6.1

PYGAME_HIDE_SUPPORT_PROMPT=1 python - <<'PY'
import struct
import sys

import pygame

PASSES = ((0, 8), (4, 8), (2, 4), (1, 2))


def lzw(pixels):
    """Codes of 8 bits for 7-bit colours, cleared before they could grow."""
    clear, end = 128, 129
    codes = bytearray()
    for at in range(0, len(pixels), 100):
        codes += bytes((clear, *pixels[at : at + 100]))
    codes.append(end)
    return bytes((7, len(codes))) + bytes(codes) + b"\0"


def load(height, interlaced):
    rows = [y for start, step in PASSES for y in range(start, height, step)] if interlaced else range(height)
    palette = bytes(2 * i for i in range(128) for _ in range(3))
    header = b"GIF89a" + struct.pack("<2H3B", 1, height, 0xF6, 0, 0) + palette
    image = b"," + struct.pack("<4HB", 0, 0, 1, height, 0x40 if interlaced else 0)
    with open("picture.gif", "wb") as file:
        file.write(header + image + lzw(bytes(10 + y for y in rows)) + b";")
    picture = pygame.image.load("picture.gif")
    return [picture.get_at((0, y))[0] // 2 for y in range(height)]


for height in range(1, 18):
    right = list(range(10, 10 + height))
    if load(height, False) != right:
        sys.exit(f"changed: plain GIF of {height} rows")
    found = load(height, True)
    if height < 6:
        print(f"{height} rows, interlaced: {found}")
    expected = right if height in (1, *range(5, 18)) else [10] + [0] * (height - 1)
    if found != expected:
        sys.exit(f"changed: interlaced GIF of {height} rows")
PY
