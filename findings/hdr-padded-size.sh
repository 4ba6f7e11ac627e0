#!/usr/bin/env bash
# pyradiance 1.3.1 (Python, with the programs of Radiance), parse-hdr 1.0.0 (npm).
#
# The guess: a picture written by Radiance itself is read by a reader of
# Radiance HDR.
# Observed: Radiance's programs pad the size with blanks ("-Y        2 +X        3"),
# and parse-hdr, which wants one blank, then returns a picture of 0 x 0 pixels
# with no data and no error. With single blanks the same file is read.
#
# Why the input is valid: it is what pcomb of Radiance writes; the resolution
# string of "Radiance File Formats" by Ward is read by its numbers.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pyradiance==1.3.1
node_packages parse-hdr@1.0.0

cat > make.py <<'PY'
import os
import re
import subprocess

import pyradiance

with open("by_hand.hdr", "wb") as file:
    file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 3\n" + bytes((128, 64, 32, 129)) * 6)
pcomb = os.path.join(os.path.dirname(pyradiance.__file__), "bin", "pcomb")
written = subprocess.run([pcomb, "by_hand.hdr"], capture_output=True, check=True).stdout
with open("by_pcomb.hdr", "wb") as file:
    file.write(written)
print("size as pcomb writes it:", re.search(rb"-Y +2 \+X +3", written)[0].decode())
PY
cat > check.cjs <<'JS'
const { readFileSync } = require('node:fs');
const parse = require('parse-hdr');

const read = (name) => {
    const picture = parse(new Uint8Array(readFileSync(name)));
    const text = `${picture.shape.join(' x ')}, ${picture.data.length} numbers`;
    console.log(`${name}: ${text}`);
    return text;
};
const changed = (what) => { console.error(`changed: ${what}`); process.exit(1); };
if (read('by_hand.hdr') !== '3 x 2, 24 numbers') changed('the file with single blanks is read otherwise');
if (read('by_pcomb.hdr') !== '0 x 0, 0 numbers') changed('the file of pcomb is read otherwise');
JS
python make.py
node check.cjs
