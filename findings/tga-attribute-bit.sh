#!/usr/bin/env bash
# Pillow 13.0.0 (Python) and three 0.187.0 (npm).
#
# The guess: in a 16-bit TGA whose descriptor says that pixels have no attribute
# bits, the top bit of a pixel means nothing, and where the descriptor says one
# attribute bit, a set bit is opaque.
# Observed: both readers ignore the descriptor and take the bit the other way
# round: a set bit makes the pixel fully transparent (alpha 0), a clear bit makes
# it opaque (255), with 0 as with 1 attribute bits.
#
# Why the input is valid: the Truevision TGA File Format Specification 2.0,
# field 5.6 (Image Descriptor), bits 0 to 3, gives the number of attribute bits
# of a pixel; 16-bit pixels are stored as ARRRRRGG GGGBBBBB, and alpha values
# run from 0 for transparent to full for opaque (extension area, field 24).
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pillow==13.0.0
node_packages three@0.187.0

cat > check.py <<'PY'
import struct
import sys

from PIL import Image

for bits in (0, 1):
    header = struct.pack("<3BHHB4H2B", 0, 0, 2, 0, 0, 0, 0, 0, 2, 2, 16, 0x20 | bits)
    with open(f"{bits}.tga", "wb") as file:
        file.write(header + struct.pack("<2H", 0x7C00, 0x83E0) * 2)  # red, green with the bit
    with Image.open(f"{bits}.tga") as picture:
        alpha = list(picture.convert("RGBA").tobytes())[3::4]
    print(f"Pillow, {bits} attribute bits: alpha", alpha)
    if alpha != [255, 0] * 2:
        sys.exit(f"changed: Pillow reads {bits} attribute bits otherwise")
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { TGALoader } from 'three/examples/jsm/loaders/TGALoader.js';

for (const bits of [0, 1]) {
    const bytes = new Uint8Array(readFileSync(`${bits}.tga`));
    const data = new TGALoader().parse(bytes.buffer).data;
    console.log(`three, ${bits} attribute bits: alpha`, data[3], data[7]);
    if (data[3] !== 255 || data[7] !== 0) {
        console.error(`changed: three reads ${bits} attribute bits otherwise`);
        process.exit(1);
    }
}
JS
python check.py
node check.mjs
