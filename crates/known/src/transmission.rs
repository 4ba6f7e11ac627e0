//! Light that goes through surfaces.

use crate::case::Case;
use crate::furnace::diffuse_walls;
use crate::stage::{
    Stage, ball, camera, disk_facing_down, floor, glass, hollow_ball, lambert, pane, paper,
    rectangle, spot,
};
use std::f64::consts::PI;
use traylib_geometry::Vec3;
use traylib_scene::Camera;

/// Index of refraction of the glass.
const INDEX: f64 = 1.5;

/// E1: a room of radiance 2 (see [`furnace`](super::furnace)) and in it a ball of
/// glass, a pane and a sheet of paper that absorb nothing. Whatever way a path
/// takes through them, it ends on a wall: each shows the radiance of the room.
pub fn clear_surfaces_in_a_furnace() -> Case {
    let square = |corner, edge| rectangle(corner, 0.5 * Vec3::X, edge);
    let scene = Stage::new(into_the_room(Vec3::new(0.1, -0.6, 0.1)))
        .light(hollow_ball(Vec3::ZERO, 1.0), 1.0, diffuse_walls())
        .surface(ball(Vec3::new(-0.2, 0.2, 0.2), 0.3), glass(INDEX as f32))
        .surface(square(Vec3::new(0.15, 0.1, -0.3), Vec3::new(0.0, 0.2, 0.5)), pane(0.1, 0.9))
        .surface(square(Vec3::new(-0.4, 0.0, -0.5), Vec3::new(0.0, 0.1, 0.4)), paper(0.5, 0.5))
        .build();
    Case { name: "E1 clear surfaces".into(), scene, max_depth: None, truth: 2.0 }
}

/// E2: the same room seen from inside of a ball of glass. Radiance over the
/// square of the index is what refraction keeps, so that it is n² times as much.
pub fn furnace_from_inside_of_glass() -> Case {
    let scene = Stage::new(into_the_room(Vec3::new(0.1, -0.15, 0.1)))
        .light(hollow_ball(Vec3::ZERO, 1.0), 1.0, diffuse_walls())
        .surface(ball(Vec3::ZERO, 0.4), glass(INDEX as f32))
        .build();
    Case { name: "E2 from glass".into(), scene, max_depth: None, truth: 2.0 * INDEX * INDEX }
}

/// E3: a disk lamp of Le = 1 and R = h over a floor of albedo one half, F = 0.5,
/// seen through nothing, and a pane in between that lets 0.6 through and
/// reflects nothing: L = 0.6·ρ·F.
pub fn light_behind_a_pane() -> Case {
    let pane_between = rectangle(Vec3::new(-8.0, -8.0, 0.5), 16.0 * Vec3::X, 16.0 * Vec3::Y);
    let scene = Stage::new(spot(Vec3::new(0.3, 0.0, 0.2), Vec3::ZERO))
        .surface(floor(), lambert(0.5))
        .surface(pane_between, pane(0.0, 0.6))
        .light(disk_facing_down(Vec3::Z, 1.0), 1.0, lambert(0.0))
        .build();
    Case { name: "E3 lamp behind a pane".into(), scene, max_depth: None, truth: 0.6 * 0.5 * 0.5 }
}

/// E4: B4, the point light of I = π in the middle of a ball, now with a ball of
/// glass around the light. Light meets the glass at right angles, so what it
/// reflects comes back through the middle and leaves on the other side: nothing
/// is lost, and L = 1 as without it.
pub fn light_in_a_ball_of_glass() -> Case {
    // What is seen through the glass would lack light that nothing finds.
    let away_from_the_glass = camera(Vec3::new(0.1, 0.4, 0.1), Vec3::new(0.2, 1.0, 0.1), 120.0, 32);
    let scene = Stage::new(away_from_the_glass)
        .surface(hollow_ball(Vec3::ZERO, 1.0), diffuse_walls())
        .surface(ball(Vec3::ZERO, 0.2), glass(INDEX as f32))
        .point(Vec3::ZERO, PI as f32)
        .build();
    Case { name: "E4 light in glass".into(), scene, max_depth: None, truth: 1.0 }
}

fn into_the_room(position: Vec3) -> Camera {
    camera(position, position + Vec3::new(-0.1, 1.0, 0.0), 90.0, 32)
}
