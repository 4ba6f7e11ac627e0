//! Everyone answers the same few questions.

use super::*;
use crate::options::Options;
use clap::Parser;

/// The unit square at z = 0.
fn square() -> Mesh {
    let corner = |x: f32, y: f32| [x, y, 0.0].into();
    let positions = vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
    Mesh::new(positions, vec![[0, 1, 2], [0, 2, 3]]).unwrap()
}

#[test]
fn all_find_the_same_triangle_from_either_side_and_know_where_a_ray_ends() {
    let down = Ray::new([0.25, 0.75, 2.0].into(), [0.0, 0.0, -0.5].into());
    let up = Ray::new([0.75, 0.25, -3.0].into(), [0.0, 0.0, 1.0].into());
    let beside = Ray::new([1.5, 0.5, 2.0].into(), [0.0, 0.0, -1.0].into());
    let rays = [down, up, beside, Ray { t_max: 3.5, ..down }, Ray { t_max: 4.5, ..down }];
    let upper = Found { t: 4.0, primitive: 1 };
    let lower = Found { t: 3.0, primitive: 0 };
    for contestant in chosen(&Options::parse_from(["peers"])) {
        let mut built = contestant.build(&square()).unwrap();
        let (mut found, mut any) = ([Found::NOTHING; 5], [false; 5]);
        built.nearest(&rays, &mut found);
        built.any_hit(&rays, &mut any);
        let expected = [upper, lower, Found::NOTHING, Found::NOTHING, upper];
        assert_eq!(found, expected, "{}", contestant.name);
        assert_eq!(any, [true, true, false, false, true], "{}", contestant.name);
    }
}

#[test]
fn a_filter_keeps_our_own() {
    let names = |words: &[&str]| -> Vec<_> {
        let options = Options::parse_from([&["peers"], words].concat());
        chosen(&options).iter().map(|contestant| contestant.name).collect()
    };
    let ours = ["ours, watertight", "ours, fast", "ours, batch"];
    assert_eq!(names(&["--only", "nobody"]), ours);
    assert_eq!(names(&["--only", "parry,nobody"])[3..], ["parry3d"]);
}
