#!/usr/bin/env bash
# three 0.187.0 (npm) and zune-hdr 0.5.2 (Rust).
#
# The guess: readers of Radiance HDR turn a picture in XYZ to RGB, or refuse it.
# Observed: both give the XYZ numbers as red, green and blue, without an error. A
# white of 1 (X 0.9375, Y 1, Z 1.078125, close to D65) comes back as a bluish
# (0.94, 1, 1.08).
#
# Why the input is valid: "Radiance File Formats" by Ward, section
# Picture File Format has two formats, 32-bit_rle_rgbe and 32-bit_rle_xyze, the
# second with CIE XYZ in place of red, green and blue; the header names it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages three@0.187.0
rust_program 'zune-core = "=0.5.3"' 'zune-hdr = "=0.5.2"' <<'RS'
use zune_core::bytestream::ZCursor;
use zune_hdr::HdrDecoder;

fn main() {
    let mut file = b"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n".to_vec();
    file.extend([120, 128, 138, 129]);
    match HdrDecoder::new(ZCursor::new(&file[..])).decode() {
        Ok(pixel) if pixel == [0.9375, 1.0, 1.078_125] => println!("zune-hdr: {pixel:?}"),
        other => {
            eprintln!("changed: zune-hdr reads XYZ otherwise: {other:?}");
            std::process::exit(1);
        }
    }
}
RS
cat > check.mjs <<'JS'
import { FloatType } from 'three';
import { HDRLoader } from 'three/examples/jsm/loaders/HDRLoader.js';

const header = new TextEncoder().encode('#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n');
const file = new Uint8Array([...header, 120, 128, 138, 129]);
const { data } = new HDRLoader().setDataType(FloatType).parse(file.buffer);
console.log('three:', Array.from(data.slice(0, 3)).join(' '));
if ([120, 128, 138].some((byte, i) => Math.abs(data[i] - (2 * byte) / 255) > 1e-6)) {
    console.error('changed: three reads XYZ otherwise');
    process.exit(1);
}
JS
./program
node check.mjs
