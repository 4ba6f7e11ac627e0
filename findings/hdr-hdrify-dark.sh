#!/usr/bin/env bash
# hdrify 1.2.1 (npm).
#
# The guess: a value written by writeHdr comes back within a percent or so, dark
# or bright, since each pixel of Radiance HDR has an exponent of its own.
# Observed: the exponent byte is never below 128, so that everything below 0.5 is
# stored in steps of 1/255, without an error. 0.01 comes back as 0.0098, 0.004 as
# 0.0059, and 0.001 and 0.0001 both as 0.00196. The shadows of a rendering turn
# into bands with a grey floor. 100 comes back as 100.14.
#
# Why the input is valid: "Radiance File Formats" by Ward, section
# Picture File Format gives the exponent a byte with an offset of 128, so that
# values far below 1 keep eight bits as bright ones do.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages hdrify@1.2.1

cat > check.mjs <<'JS'
import { readHdr, writeHdr } from 'hdrify';

const kept = (value) => {
    const data = new Float32Array([value, value, value, 1]);
    const file = writeHdr({ width: 1, height: 1, data, linearColorSpace: 'linear-rec709' });
    const back = readHdr(file).data[0];
    console.log(`${value}: bytes ${file.slice(-4).join(' ')}, back as ${back}`);
    return back;
};
const expect = (value, back) => {
    if (Math.abs(kept(value) / back - 1) > 1e-3) {
        console.error(`changed: ${value} does not come back as ${back}`);
        process.exit(1);
    }
};
expect(100, 100.141);
expect(0.01, 0.0098039);
expect(0.004, 0.0058824);
expect(0.001, 0.0019608);
expect(0.0001, 0.0019608);
JS
node check.mjs
