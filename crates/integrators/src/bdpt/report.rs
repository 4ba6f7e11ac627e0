//! The output that is recorded beside the picture, for those who doubt it.

use super::direct_sum::{JoinedPath, Joint};
use crate::ChunkOutput;
use std::fmt::Write;
use traylib_math::Rgb;

/// Extra output of a rendering.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Report {
    /// The picture alone.
    #[default]
    None,
    /// A picture of each technique, raw and weighted.
    Techniques,
    /// All paths that add to this row-major pixel, as text.
    Pixel(u32),
    /// Every path that is found, for the planner.
    Paths,
}

/// Names the picture of one technique.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Technique {
    /// Vertices from the light.
    pub s: u8,
    /// Vertices from the camera.
    pub t: u8,
    /// True if the last vertex from the camera is joined with a point light by way of mirrors: s
    /// then stands for the light and one or two of them.
    pub by_mirror: bool,
    /// True if its paths carry their weights, so that all pictures add up to the whole; false if
    /// they stand for themselves.
    pub weighted: bool,
}

/// Longer subpaths share the last picture.
const MOST_VERTICES: usize = 127;

impl Technique {
    fn layer(self) -> u16 {
        u16::from(self.by_mirror) << 15
            | u16::from(self.s) << 8
            | u16::from(self.t) << 1
            | u16::from(self.weighted)
    }

    /// The technique whose picture is this layer of a
    /// [`Rendering`](crate::Rendering).
    pub fn of_layer(layer: u16) -> Self {
        Self {
            s: (layer >> 8 & 0x7f) as u8,
            t: (layer >> 1 & 0x7f) as u8,
            by_mirror: layer >> 15 == 1,
            weighted: layer & 1 == 1,
        }
    }
}

impl Report {
    /// Records one contribution: `value` is what its technique alone would add.
    pub(crate) fn record(
        self,
        out: &mut ChunkOutput,
        pixel: u32,
        path: &JoinedPath<'_>,
        value: Rgb,
        weight: f64,
        all_weights: impl FnOnce() -> Vec<f64>,
    ) {
        match self {
            Self::Techniques => {
                add_layers(out, pixel, path, value, weight as f32);
            }
            Self::Pixel(wanted) if wanted == pixel => {
                out.notes.push(describe(path, value, weight, &all_weights()));
            }
            Self::None | Self::Pixel(_) | Self::Paths => {}
        }
    }
}

/// The picture of a technique alone, and as much of it as counts.
fn add_layers(out: &mut ChunkOutput, pixel: u32, path: &JoinedPath<'_>, value: Rgb, weight: f32) {
    let (s, t) = path.technique();
    let [s, t] = [s, t].map(|n| n.min(MOST_VERTICES) as u8);
    let by_mirror = path.is_joined_by_mirror();
    for (weighted, factor) in [(false, 1.0), (true, weight)] {
        let layer = Technique { s, t, by_mirror, weighted }.layer();
        out.layers.push((layer, pixel, value * factor));
    }
}

/// One path as text: a line for itself, a line a vertex from lamp to camera.
fn describe(path: &JoinedPath<'_>, value: Rgb, weight: f64, all_weights: &[f64]) -> String {
    let (s, t) = path.technique();
    let densities = path.path_densities();
    let Rgb { r, g, b } = value;
    let way = if path.is_joined_by_mirror() { ", by way of a mirror" } else { "" };
    let mut text =
        format!("(s={s}, t={t}{way})  value {r:.6e} {g:.6e} {b:.6e}  weight {weight:.6}\n");
    let surfaces = path.light.iter().chain(path.camera.iter().rev());
    // x₀ is a vertex of its own unless the camera path hit it.
    let first_surface = usize::from(s > 0);
    let mut positions = vec![String::from("on the lamp"); first_surface];
    if let Joint::Mirror { by, .. } = path.joint {
        positions.extend(by.places().map(|place| place.to_string()));
    }
    positions.extend(surfaces.map(|vertex| vertex.point.site.position.to_string()));
    positions.push(String::from("camera"));
    for (i, position) in positions.iter().enumerate() {
        let delta = if densities.is_delta[i] { "  mirror" } else { "" };
        let (f, b) = (densities.forward[i], densities.backward[i]);
        let weight = all_weights[i];
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "  x{i}  F {f:.4e}  B {b:.4e}  weight of s={i} {weight:.6}  {position}{delta}"
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_name_their_technique() {
        for technique in [
            Technique { s: 0, t: 2, by_mirror: false, weighted: false },
            Technique { s: 127, t: 127, by_mirror: false, weighted: true },
            Technique { s: 5, t: 1, by_mirror: false, weighted: true },
            Technique { s: 2, t: 2, by_mirror: true, weighted: false },
        ] {
            assert_eq!(Technique::of_layer(technique.layer()), technique);
        }
    }
}
