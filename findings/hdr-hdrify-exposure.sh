#!/usr/bin/env bash
# hdrify 1.2.1 (npm).
#
# The guess: hdrify's convertHDRToLDR shows two files of the same radiance alike,
# or shows the pixels as they are stored.
# Observed: the EXPOSURE of the header is multiplied on once more. The radiance
# 0.25, stored as it is, becomes 124; the same radiance stored as 0.5 with
# EXPOSURE=2 is shown as if it were 1, and becomes 188; stored as 0.125 with
# EXPOSURE=0.5 it is shown as if it were 0.0625 and becomes 69. The error is the
# square of the exposure to who wants radiance, and the exposure to who wants the
# stored pixels (0.5 becomes 157, 0.125 becomes 94).
#
# Why the input is valid: "Radiance File Formats" by Ward, section
# Picture File Format: EXPOSURE says by what the pixels have been multiplied
# already; radiance is the pixel divided by it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages hdrify@1.2.1

cat > check.mjs <<'JS'
import { convertHDRToLDR } from 'hdrify';

const shown = (lines, exponent) => {
    const head = `#?RADIANCE\n${lines}FORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n`;
    const file = new Uint8Array([...Buffer.from(head), 128, 128, 128, exponent]);
    const { ldrData } = convertHDRToLDR(file);
    console.log(`stored ${2 ** (exponent - 129)}, ${lines.trim() || 'no exposure'}: ${ldrData[0]}`);
    return ldrData[0];
};
const found = [
    shown('', 127), shown('EXPOSURE=2\n', 128), shown('EXPOSURE=0.5\n', 126),
    shown('', 129), shown('', 128), shown('', 126), shown('', 125),
];
if (found.join(' ') !== '124 188 69 188 157 94 69') {
    console.error(`changed: ${found.join(' ')}`);
    process.exit(1);
}
JS
node check.mjs
