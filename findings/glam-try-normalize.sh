#!/usr/bin/env bash
# glam 0.34.2 (Rust).
#
# The guess: Vec3::try_normalize gives a vector of length 1, or None where the
# vector is too short for it.
# Observed: for (3e-23, 0, 0) it gives Some((0.80, 0, 0)): the squared length
# has lost its digits below the least normal f32, but is not 0 yet. (1e-20, 0, 0)
# becomes (1.0000026, 0, 0), and (1e-23, 0, 0) is None. Sizes of a scene in other
# units or products of small numbers get there.
#
# Why the input is valid: the documentation of try_normalize takes any vector
# and promises length 1 or None; all components are normal f32 numbers.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
rust_program 'glam = "=0.34.2"' <<'RS'
use glam::Vec3;

fn main() {
    for (x, low, high) in [(1e-10_f32, 0.999_999, 1.000_001), (1e-20, 1.000_001, 1.000_01), (3e-23, 0.8, 0.81)] {
        let found = Vec3::new(x, 0.0, 0.0).try_normalize();
        println!("({x:e}, 0, 0): {found:?}");
        if !found.is_some_and(|v| (low..=high).contains(&v.x)) {
            eprintln!("changed: try_normalize of ({x:e}, 0, 0)");
            std::process::exit(1);
        }
    }
    let none = Vec3::new(1e-23, 0.0, 0.0).try_normalize();
    println!("(1e-23, 0, 0): {none:?}");
    if none.is_some() {
        eprintln!("changed: try_normalize of (1e-23, 0, 0)");
        std::process::exit(1);
    }
}
RS
./program
