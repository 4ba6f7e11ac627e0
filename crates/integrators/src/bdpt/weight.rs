//! The weight of a path by the recursive form: one over the sum of all
//! techniques' densities over that of the one that found it, each raised.
//!
//! All four take the numbers of the two subpath ends alone; see
//! [`vertex`](super::vertex) for M and C. Held equal to
//! [`direct_sum`](super::direct_sum) in tests. Equations are those of Georgiev,
//! *Implementing Vertex Connection and Merging*, 2012.

use super::Techniques;
use super::vertex::{End, Vertex};
use crate::PointSet;
use traylib_math::{Heuristic, SolidAnglePdf};
use traylib_scene::LightDensities;

/// s = 0: the camera path's last vertex is the lamp's point x₀. Not for a lamp
/// seen directly, which nothing else can find.
pub(crate) fn hit(
    x0: &Vertex,
    densities: &LightDensities,
    techniques: Techniques,
    heuristic: Heuristic,
) -> f64 {
    // Against a light sample for x₁, then against all that begin at the lamp: equation 43.
    let sampled = if x0.after_delta || !techniques.samples_light(false) {
        0.0
    } else {
        heuristic.raise(f64::from(densities.toward) / f64::from(x0.pdf.0))
    };
    let walked = f64::from(densities.emission) * f64::from(densities.direction.0);
    1.0 / (1.0 + sampled + heuristic.raise(walked) * x0.d_vc)
}

/// s = 1: a lamp's point was sampled from the camera path's last vertex x₁.
/// `hit_pdf` is the density with which x₁ would have hit it.
pub(crate) fn light_sample(
    x1: &Vertex,
    end: &End,
    densities: &LightDensities,
    hit_pdf: f32,
    techniques: Techniques,
    heuristic: Heuristic,
) -> f64 {
    // Against a hit of the same point: equation 44.
    let toward = f64::from(densities.toward);
    let hit = if techniques.hits { f64::from(hit_pdf) / toward } else { 0.0 };
    // Against light walks that reach x₁, and all behind it: equation 45.
    let arrival = f64::from(densities.direction.0) * f64::from(end.conversion);
    let walked = f64::from(densities.emission) * arrival / toward;
    let back = end.scattering.toward_camera;
    1.0 / (1.0 + heuristic.raise(hit) + x1.competition(walked, back, heuristic))
}

/// s ≥ 2, t ≥ 2: `light` and `camera` were connected.
pub(crate) fn connection(
    light: (&Vertex, &End),
    camera: (&Vertex, &End),
    heuristic: Heuristic,
) -> f64 {
    // Equations 40 and 41, which are one formula read from either end: had the other walk
    // come over the edge, and gone back as this one came.
    let ((y, y_end), (z, z_end)) = (light, camera);
    let over = |pdf: SolidAnglePdf, end: &End| f64::from(pdf.0) * f64::from(end.conversion);
    let to_y = over(z_end.scattering.toward_light, y_end);
    let to_z = over(y_end.scattering.toward_camera, z_end);
    let light_side = y.competition(to_y, y_end.scattering.toward_light, heuristic);
    let camera_side = z.competition(to_z, z_end.scattering.toward_camera, heuristic);
    1.0 / (1.0 + light_side + camera_side)
}

/// A point light was joined with `last` by way of mirrors, where light walks would have come over
/// them with the density `walked` for each time that it is joined so.
///
/// No other technique joins anything up to that vertex: a point is not hit, and what reflects
/// ideally is joined with nothing. So only those compete that walk from the light over it, as at
/// s = 1 those do that walk over x₁.
pub(crate) fn mirror_connection(
    last: &Vertex,
    walked: f64,
    pdf_back: SolidAnglePdf,
    heuristic: Heuristic,
) -> f64 {
    1.0 / (1.0 + last.competition(walked, pdf_back, heuristic))
}

/// Returns the number of light paths that count in the weights as having been able to find a vertex
/// that the camera sees: all, or half of them where the points of camera paths are even.
///
/// To a pixel a light path is a rare event, however even light paths are, while what camera
/// paths find gets the better. Any number that is the same in all weights leaves their sum one.
/// Of 1, 1/2, 1/4 and 1/10 of the paths the half had the least error; see `docs/sampling.md`.
pub(crate) fn splats_in_weights(light_paths: u32, points: PointSet) -> f64 {
    let light_paths = f64::from(light_paths);
    match points {
        PointSet::Independent => light_paths,
        PointSet::Sobol => 0.5 * light_paths,
    }
}

/// t = 1: the light path's last vertex was joined to the camera, which would
/// have found it with density `camera_pdf`; one of so many `splats` might have.
pub(crate) fn splat(
    vertex: &Vertex,
    camera_pdf: f32,
    pdf_back: SolidAnglePdf,
    splats: f64,
    heuristic: Heuristic,
) -> f64 {
    // Each of the light paths could have been splatted here: equation 46.
    let arrival = f64::from(camera_pdf) / splats;
    1.0 / (1.0 + vertex.competition(arrival, pdf_back, heuristic))
}
