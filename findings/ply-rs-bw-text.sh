#!/usr/bin/env bash
# ply-rs-bw 4.0.1: numbers and lines of text that other programs write and read.
#
# Guess: in an ascii file numbers are those of C, and white space separates them, so that
# `.5` and `1.` are numbers and one line may hold several vertices.
# Found: all three are errors; the same vertices as `0.5 1.0 0`, a line each, are read.
# Valid: "the data is represented as ascii … numbers separated by spaces" by the format's
# description (Turk, 1994), whose own reader splits at white space and calls atof.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"

rust_program 'ply-rs-bw = "=4.0.1"' <<'RUST'
use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::DefaultElement;

fn reads(body: &str) -> bool {
    let header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n\
                  property float z\nend_header\n";
    let text = format!("{header}{body}");
    Parser::<DefaultElement>::new().read_ply(&mut text.as_bytes()).is_ok()
}

fn main() {
    println!("plain {}", reads("0.5 1.0 0\n1 2 3\n"));
    println!("no zero before the point {}", reads(".5 1.0 0\n1 2 3\n"));
    println!("no zero behind it {}", reads("0.5 1. 0\n1 2 3\n"));
    println!("one line {}", reads("0.5 1.0 0 1 2 3\n"));
}
RUST

found=$(./program)
wanted='plain true
no zero before the point false
no zero behind it false
one line false'
[ "$found" = "$wanted" ] || { echo "changed: $found"; exit 1; }
echo "as stated: $found"
