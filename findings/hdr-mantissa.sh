#!/usr/bin/env bash
# OpenCV 5.0.0.93 (opencv-python-headless), pyradiance 1.3.1 (Python, with the
# programs of Radiance) and three 0.187.0 (npm).
#
# The guess: readers of Radiance HDR agree on the value of a pixel, since its
# four bytes are exact numbers.
# Observed: three readers give three values. For the pixel 128 0 255 129 OpenCV
# gives 1, 0 and 1.9921875 (mantissa / 256), Radiance's pvalue 1.004, 0.0039 and
# 1.996 ((mantissa + 0.5) / 256, so a mantissa of 0 is not black) and three's
# HDRLoader 1.0039, 0 and 2 (mantissa / 255). The same file compared through two
# of them differs by up to 0.4 % of the brightest channel. three also reads an
# exponent byte of 0 as a colour (1.5e-39 here) where the format says black.
#
# Why the input is valid: "Radiance File Formats" by Ward, section
# Picture File Format: four bytes a pixel, three mantissas and a shared
# exponent with excess 128, flat pixels for rows narrower than 8; black is
# exponent 0.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages opencv-python-headless==5.0.0.93 pyradiance==1.3.1
node_packages three@0.187.0

cat > check.py <<'PY'
import os
import subprocess
import sys

import cv2
import pyradiance

with open("pixel.hdr", "wb") as file:
    file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n")
    file.write(bytes((128, 0, 255, 129)) + bytes((128, 64, 32, 0)))

opencv = cv2.imread("pixel.hdr", cv2.IMREAD_UNCHANGED)[0, :, ::-1].tolist()
pvalue = os.path.join(os.path.dirname(pyradiance.__file__), "bin", "pvalue")
lines = subprocess.run([pvalue, "-h", "-H", "-d", "pixel.hdr"], capture_output=True, text=True, check=True).stdout
radiance = [[float(word) for word in line.split()] for line in lines.splitlines()]
print("OpenCV:", opencv)
print("Radiance:", radiance)
if opencv != [[1.0, 0.0, 1.9921875], [0.0, 0.0, 0.0]]:
    sys.exit("changed: OpenCV decodes otherwise")
if any(abs(a - b) > 6e-4 for a, b in zip(radiance[0], (128.5 / 128, 0.5 / 128, 255.5 / 128))):
    sys.exit("changed: pvalue decodes otherwise")
if radiance[1] != [0.0, 0.0, 0.0]:
    sys.exit("changed: pvalue reads exponent 0 otherwise")
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { FloatType } from 'three';
import { HDRLoader } from 'three/examples/jsm/loaders/HDRLoader.js';

const bytes = new Uint8Array(readFileSync('pixel.hdr'));
const data = new HDRLoader().setDataType(FloatType).parse(bytes.buffer).data;
console.log('three:', Array.from(data).join(' '));
const expected = [256 / 255, 0, 2];
if (expected.some((value, i) => Math.abs(data[i] - value) > 1e-6) || !(data[4] > 0)) {
    console.error('changed: three decodes otherwise');
    process.exit(1);
}
JS
python check.py
node check.mjs
