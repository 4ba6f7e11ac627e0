#!/usr/bin/env bash
# three 0.187.0 (npm).
#
# The guess: HDRLoader reads the run lengths of both kinds that Radiance HDR
# has, or refuses the older kind.
# Observed: the older kind is taken for pixels, without an error: the marker
# 1 1 1 10 ("ten more of the last pixel") becomes one nearly black pixel
# (1.2e-38) and everything after it moves up, so 24 pixels come back as 6.
#
# Why the input is valid: "Radiance File Formats" by Ward, section
# Picture File Format: a pixel with three mantissas of 1 repeats the pixel
# before it as often as its exponent byte says; Radiance's reader takes both.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages three@0.187.0

cat > check.mjs <<'JS'
import { FloatType } from 'three';
import { HDRLoader } from 'three/examples/jsm/loaders/HDRLoader.js';

const header = new TextEncoder().encode('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 12\n');
const row = [128, 64, 32, 129, 1, 1, 1, 10, 200, 100, 50, 130]; // 1 pixel, 10 more, 1 other
const file = new Uint8Array([...header, ...row, ...row]);
const picture = new HDRLoader().setDataType(FloatType).parse(file.buffer);
const reds = Array.from({ length: picture.data.length / 4 }, (_, i) => picture.data[4 * i]);
console.log(`${picture.width} x ${picture.height}, ${reds.length} pixels, red:`, reds.join(' '));
const changed = (what) => { console.error(`changed: ${what}`); process.exit(1); };
if (picture.width !== 12 || picture.height !== 2) changed('the size is read otherwise');
if (reds.length !== 6) changed('the number of pixels is another');
if (!(reds[1] > 0 && reds[1] < 1e-30)) changed('the marker of a run is read otherwise');
if (Math.abs(reds[2] - 800 / 255) > 1e-6) changed('the pixel after a run is read otherwise');
JS
node check.mjs
