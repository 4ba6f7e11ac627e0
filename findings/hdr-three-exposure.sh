#!/usr/bin/env bash
# three 0.187.0 (npm) and pyradiance 1.3.1 (Python, with the programs of Radiance).
#
# The guess: the exposure that three's HDRLoader gives is the one by which the
# picture has to be divided for radiance.
# Observed: it is the last EXPOSURE line anywhere in the header. For a header with
# EXPOSURE=2 and EXPOSURE=4 it gives 4, where Radiance divides by 8. For a picture
# that pcompos puts together from that one and one with EXPOSURE=16 it gives 16,
# where Radiance divides by 1: there the lines are the history of the inputs and
# begin with a tab.
#
# Why the input is valid: "Radiance File Formats" by Ward, section
# Picture File Format: EXPOSURE lines multiply; programs indent the headers of
# their inputs by a tab. The second file is written by pcompos itself.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages pyradiance==1.3.1
node_packages three@0.187.0

cat > check.py <<'PY'
import os
import subprocess
import sys

import pyradiance


def run(name, *words):
    tool = os.path.join(os.path.dirname(pyradiance.__file__), "bin", name)
    return subprocess.run([tool, *words], check=True, capture_output=True).stdout


for name, lines in (("twice.hdr", b"EXPOSURE=2\nEXPOSURE=4\n"), ("once.hdr", b"EXPOSURE=16\n")):
    with open(name, "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + lines + b"\n-Y 1 +X 1\n" + bytes((128, 128, 128, 132)))
with open("composed.hdr", "wb") as file:
    file.write(run("pcompos", "twice.hdr", "0", "0", "once.hdr", "1", "0"))
for name, divisor in (("twice.hdr", 8), ("composed.hdr", 1)):
    stored = float(run("pvalue", "-h", "-H", "-d", name).split()[0])
    radiance = float(run("pvalue", "-o", "-h", "-H", "-d", name).split()[0])
    print(f"Radiance, {name}: {stored} stands for {radiance}")
    if abs(stored / radiance / divisor - 1) > 2e-3:
        sys.exit(f"changed: Radiance undoes the exposure of {name} otherwise")
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { HDRLoader } from 'three/examples/jsm/loaders/HDRLoader.js';

for (const [name, expected] of [['twice.hdr', 4], ['composed.hdr', 16]]) {
    const { exposure } = new HDRLoader().parse(new Uint8Array(readFileSync(name)).buffer);
    console.log(`three, ${name}: exposure ${exposure}`);
    if (exposure !== expected) {
        console.error(`changed: three's exposure of ${name}`);
        process.exit(1);
    }
}
JS
python check.py
node check.mjs
