#!/usr/bin/env bash
# zune-hdr 0.5.2 (Rust).
#
# The guess: a Radiance HDR pixel decodes to mantissa / 256 times two to the
# power of its exponent byte less 128, or is clamped where that is extreme.
# Observed: the power is taken modulo 32, without an error. The pixel
# 128 128 128 96 stands for 1.16e-10, next to black, and is read as 0.5; 160
# stands for 2.1e9 and is read as 0.5 as well. Powers from -31 to 31 are right.
# Shadows of a rendering in absolute units become bright speckles.
#
# Why the input is valid: "Radiance File Formats" by Ward, section
# Picture File Format gives the exponent a whole byte, so that values from
# 1e-38 to 1e38 can be stored.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
rust_program 'zune-core = "=0.5.3"' 'zune-hdr = "=0.5.2"' <<'RS'
use zune_core::bytestream::ZCursor;
use zune_hdr::HdrDecoder;

fn decode(exponent: u8) -> f32 {
    let mut file = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n".to_vec();
    file.extend([128, 128, 128, exponent]);
    HdrDecoder::new(ZCursor::new(&file[..])).decode().expect("a valid picture")[0]
}

fn main() {
    for exponent in [97, 128, 159, 96, 160] {
        let exact = 0.5 * 2.0_f64.powi(i32::from(exponent) - 128);
        let found = decode(exponent);
        println!("exponent byte {exponent}: {found:e}, by the format {exact:e}");
        let expected = if exponent == 96 || exponent == 160 { 0.5 } else { exact };
        if f64::from(found) != expected {
            eprintln!("changed: exponent byte {exponent} is read otherwise");
            std::process::exit(1);
        }
    }
}
RS
./program
