#!/usr/bin/env bash
# OpenEXR 3.5.3 (Python, writes the files) and three 0.187.0 (npm).
#
# The guess: three's EXRLoader reads the colours of an EXR that also has an
# integer channel, as an object id, or refuses it.
# Observed: with a channel of type UINT in a file compressed with ZIP nearly all
# colours are garbage, without an error: more than 3,800 of 4,096 pixels are
# wrong. The loader counts no bytes for such a channel when it sizes a block.
# Uncompressed, or with a 32-bit float depth instead of the id, all pixels are
# right.
#
# Why the input is valid: "OpenEXR File Layout", attribute channels (chlist),
# gives every channel a pixel type of its own (UINT, HALF or FLOAT); renderers
# write half-float colours beside integer ids.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages OpenEXR==3.5.3 numpy==2.4.6
node_packages three@0.187.0

cat > make.py <<'PY'
import numpy
import OpenEXR

step = numpy.arange(64 * 64).reshape(64, 64)
colours = {"R": step % 7, "G": step % 11, "B": step % 13}
for name, extra, compression in (
    ("depth_zip", "float32", "ZIP"),
    ("id_none", "uint32", "NO"),
    ("id_zip", "uint32", "ZIP"),
):
    channels = {key: value.astype("float16") for key, value in colours.items()}
    channels[name.split("_")[0]] = (step % 5).astype(extra)
    header = {"compression": getattr(OpenEXR, f"{compression}_COMPRESSION"), "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, channels).write(f"{name}.exr")
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { FloatType } from 'three';
import { EXRLoader } from 'three/examples/jsm/loaders/EXRLoader.js';

const wrong = (name) => {
    const bytes = new Uint8Array(readFileSync(`${name}.exr`));
    const { data } = new EXRLoader().setDataType(FloatType).parse(bytes.buffer);
    let count = 0;
    for (let row = 0; row < 64; row++) {
        for (let column = 0; column < 64; column++) {
            const step = 64 * row + column;
            const at = 4 * (64 * (63 - row) + column); // the loader's rows run upwards
            if (data[at] !== step % 7 || data[at + 1] !== step % 11 || data[at + 2] !== step % 13) count++;
        }
    }
    console.log(`${name}: ${count} of 4096 pixels wrong`);
    return count;
};
const changed = (what) => { console.error(`changed: ${what}`); process.exit(1); };
for (const name of ['depth_zip', 'id_none']) if (wrong(name) !== 0) changed(`colours of ${name}`);
if (wrong('id_zip') < 2048) changed('colours of id_zip');
JS
python make.py
node check.mjs
