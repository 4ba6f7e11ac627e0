#!/usr/bin/env bash
# hdrify 1.2.1 (npm).
#
# The guess: whether an uncompressed Radiance HDR is read does not depend on the
# brightness of its first pixel.
# Observed: a picture whose first red mantissa is 10 is refused ("expected 8
# bytes, got 7"): the byte is taken for an empty line of the header and dropped.
# With 9 or 11 in its place, or with 10 in the second pixel, it is read.
#
# Why the input is valid: "Radiance File Formats" by Ward, section
# Picture File Format: the pixels follow the line with the size at once, a
# mantissa may have any value, and rows of less than 8 pixels are not compressed.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages hdrify@1.2.1

cat > check.mjs <<'JS'
import { readHdr } from 'hdrify';

const read = (...pixels) => {
    const head = '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n';
    let text;
    try {
        const { data } = readHdr(new Uint8Array([...Buffer.from(head), ...pixels]));
        text = `read, ${data.length / 4} pixels`;
    } catch (error) {
        text = error.message;
    }
    console.log(`${pixels.join(' ')}: ${text}`);
    return text.startsWith('read');
};
const rest = [20, 30, 129];
const found = [
    read(9, ...rest, 10, ...rest), read(11, ...rest, 10, ...rest), read(10, ...rest, 11, ...rest),
];
if (found.join(' ') !== 'true true false') {
    console.error('changed: which of the pictures are read');
    process.exit(1);
}
JS
node check.mjs
