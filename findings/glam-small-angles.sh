#!/usr/bin/env bash
# glam 0.34.2 (Rust).
#
# The guess: Vec3::angle_between has a small relative error for small angles, as
# for the half-angle of a narrow cone or of a lobe around a mirror direction.
# Observed: angles below about 0.00024 come back as exactly 0 and 0.0003 as
# 0.000345, since the angle is the arc cosine of a rounded cosine; 0.1 is right
# to 1e-6. DVec3 moves the limit, it gives 0.0001 rightly. A formula with atan2
# of cross and dot product has no such limit in f32.
#
# Why the input is valid: the documentation of angle_between asks for vectors that
# are finite and not zero; these have length 1.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
rust_program 'glam = "=0.34.2"' <<'RS'
use glam::Vec3;

fn main() {
    for (angle, low, high) in [
        (0.0001_f32, 0.0, 0.0),
        (0.0002, 0.0, 0.0),
        (0.0003, 0.000_34, 0.000_35),
        (0.1, 0.099_999, 0.100_001),
    ] {
        let turned = Vec3::new(angle.cos(), angle.sin(), 0.0);
        let found = Vec3::X.angle_between(turned);
        let exact = Vec3::X.cross(turned).length().atan2(Vec3::X.dot(turned));
        println!("angle {angle}: angle_between {found}, atan2 {exact}");
        if !(low..=high).contains(&found) || (exact - angle).abs() > 1e-6 * angle {
            eprintln!("changed: angle_between for the angle {angle}");
            std::process::exit(1);
        }
    }
}
RS
./program
