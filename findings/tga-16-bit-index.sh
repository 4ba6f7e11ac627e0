#!/usr/bin/env bash
# three 0.187.0 (npm) and PyAV 18.1.0 (Python, reading by its bundled FFmpeg).
#
# The guess: a colour-mapped TGA with 16-bit indices is looked up in its colour
# map, or refused.
# Observed: both take the index itself for a 5-5-5 colour and never look at the
# map, without an error: a picture of the indices 0, 31, 0, 31 into a map of 32
# entries (red at 0, green at 31) is black and full blue in FFmpeg (0 0 255) and
# in three (0 0 248).
#
# Why the input is valid: the Truevision TGA File Format Specification 2.0,
# field 5.5 (Pixel Depth) and field 8 (Image Data), store an index in a whole
# number of bytes; field 4.2 lets a map have more than 256 entries, for which
# one byte would not do.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages av==18.1.0 numpy==2.4.6
node_packages three@0.187.0

cat > check.py <<'PY'
import struct
import sys

import av

colour_map = bytes((0, 0, 255)) + bytes((7, 7, 7)) * 30 + bytes((0, 255, 0))
header = struct.pack("<3BHHB4H2B", 0, 1, 1, 0, 32, 24, 0, 0, 2, 2, 16, 0x20)
with open("index.tga", "wb") as file:
    file.write(header + colour_map + struct.pack("<4H", 0, 31, 0, 31))
with av.open("index.tga") as container:
    frame = next(container.decode(video=0)).to_ndarray(format="rgb24")
print("FFmpeg:", frame.tolist())
if frame.tolist() != [[[0, 0, 0], [0, 0, 255]]] * 2:
    sys.exit("changed: FFmpeg reads 16-bit indices otherwise")
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { TGALoader } from 'three/examples/jsm/loaders/TGALoader.js';

const bytes = new Uint8Array(readFileSync('index.tga'));
const data = Array.from(new TGALoader().parse(bytes.buffer).data);
console.log('three:', data.join(' '));
if (data.slice(0, 8).join() !== '0,0,0,255,0,0,248,255') {
    console.error('changed: three reads 16-bit indices otherwise');
    process.exit(1);
}
JS
python check.py
node check.mjs
