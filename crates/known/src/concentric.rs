//! B6: a ball inside a hollow ball, for every length of paths.

use crate::case::Case;
use crate::stage::{Stage, ball, camera, hollow_ball, lambert};
use traylib_geometry::Vec3;
use traylib_scene::{Camera, Scene};

/// Radius of the ball within the hollow ball of radius 1.
const RADIUS: f64 = 0.5;
/// The reflectances of the two: the ball and the shell.
const REFLECTANCES: [f64; 2] = [0.5, 0.8];

/// One of the two balls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shell {
    /// The ball of radius 0.5.
    Inner,
    /// The hollow ball of radius 1 around it.
    Outer,
}

/// One of the two glows with radiance 1, and one of them fills the view.
pub fn concentric(lamp: Shell, seen: Shell, max_depth: Option<u32>) -> Case {
    let truth = radiances(lamp, max_depth)[seen as usize];
    let name = format!("B6 {lamp:?} lights {seen:?} K = {max_depth:?}");
    Case { name, scene: shells(lamp, view(seen)), max_depth, truth }
}

/// Radiances (B₁, B₂) of the ball and the shell for paths of at most
/// `max_depth` edges.
///
/// By symmetry each has the same radiance everywhere. The ball sees nothing but
/// the shell. What the shell sees of the ball is a cone of half-angle asin r₁/r₂
/// about its normal, the part q = (r₁/r₂)² of its hemisphere, and the shell
/// itself in all the rest:
///
/// B₁ = E₁ + ρ₁·B₂,    B₂ = E₂ + ρ₂·(q·B₁ + (1 − q)·B₂)
///
/// One edge carries (E₁, E₂), and each further edge is one more time around.
fn radiances(lamp: Shell, max_depth: Option<u32>) -> [f64; 2] {
    let emitted = match lamp {
        Shell::Inner => [1.0, 0.0],
        Shell::Outer => [0.0, 1.0],
    };
    let share = RADIUS * RADIUS;
    // Without a limit: 0.7 to the power of 200 is below all rounding.
    (1..max_depth.unwrap_or(200)).fold(emitted, |[inner, outer], _| {
        let received = [outer, share * inner + (1.0 - share) * outer];
        [0, 1].map(|i| emitted[i] + REFLECTANCES[i] * received[i])
    })
}

fn shells(lamp: Shell, camera: Camera) -> Scene {
    let surfaces = [ball(Vec3::ZERO, RADIUS as f32), hollow_ball(Vec3::ZERO, 1.0)];
    let stage = Stage::new(camera);
    [Shell::Inner, Shell::Outer]
        .into_iter()
        .fold(stage, |stage, shell| {
            let model = lambert(REFLECTANCES[shell as usize] as f32);
            let surface = surfaces[shell as usize];
            if shell == lamp {
                stage.light(surface, 1.0, model)
            } else {
                stage.surface(surface, model)
            }
        })
        .build()
}

/// From just outside the ball: outward, 120° across, the shell alone; inward from
/// half way 50°, the corners of which are 33.4° off the middle, where the ball
/// reaches to asin 2/3 = 41.8°.
fn view(seen: Shell) -> Camera {
    match seen {
        Shell::Inner => camera(0.75 * Vec3::Z, Vec3::ZERO, 50.0, 32),
        Shell::Outer => camera(0.55 * Vec3::Z, Vec3::Z, 120.0, 32),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radiances_have_their_known_values() {
        let known = [[1.0, 0.0], [1.0, 0.2], [1.1, 0.32], [1.16, 0.412], [1.206, 0.4792]];
        for (depth, known) in (1..).zip(known) {
            let found = radiances(Shell::Inner, Some(depth));
            assert!((0..2).all(|i| (found[i] - known[i]).abs() < 1e-12), "{depth}: {found:?}");
        }
        let [inner, outer] = radiances(Shell::Inner, None);
        assert!((inner - 4.0 / 3.0).abs() < 1e-12 && (outer - 2.0 / 3.0).abs() < 1e-12);
    }
}
