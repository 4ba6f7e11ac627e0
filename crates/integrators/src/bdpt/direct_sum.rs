//! The weight of a path from the densities of all techniques: the plain form of
//! multiple importance sampling (Veach 1997, section 10.2).
//!
//! Technique s has density q_s = n_s·Π_{i<s} F_i·Π_{i≥s} B_i, with pN₀ in place of
//! F₀ if s = 1. Sums of logarithms keep any number of factors in range.

use super::Techniques;
use super::vertex::{End, Vertex};
use crate::FoundPath;
use traylib_math::{Heuristic, Rgb, SolidAnglePdf, Vec3};
use traylib_scene::{LightDensities, PointImage};

/// Two subpaths and how they were joined.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JoinedPath<'a> {
    /// x₁ … of the light subpath.
    pub(crate) light: &'a [Vertex],
    /// x_{k−1} … of the camera subpath, from the camera.
    pub(crate) camera: &'a [Vertex],
    /// The densities of the lamp's point x₀.
    pub(crate) densities: LightDensities,
    pub(crate) is_point: bool,
    pub(crate) joint: Joint,
}

/// The edge between the subpaths.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Joint {
    /// s = 0: none; the last camera vertex is x₀.
    Hit,
    /// s = 1: from the last camera vertex to a sampled point of a lamp, which it
    /// would have hit with density `hit_pdf`.
    LightSample { end: End, hit_pdf: f32 },
    /// From the last light vertex to the last camera vertex.
    Connection { light: End, camera: End },
    /// s = 2 or 3: from the last camera vertex to a point light by way of one mirror or two; light
    /// walks would have come that way with the density `walked` for each time that this is tried,
    /// and gone back to the camera with `pdf_back`.
    Mirror { by: Mirrors, walked: f64, pdf_back: SolidAnglePdf },
    /// t = 1: from the last light vertex to the camera, which would have found
    /// it with density `camera_pdf`.
    Splat { pdf_back: SolidAnglePdf, camera_pdf: f32 },
}

/// The points at which a point light is reflected ideally on its way: x₁, and x₂ if there are two
/// mirrors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mirrors {
    x1: Vec3,
    x2: Option<Vec3>,
}

/// The vertex that may be joined with a point light by way of mirrors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BehindMirrors {
    /// The number of that technique, and of that vertex, which mirrors alone come before.
    pub(crate) s: usize,
    /// The density with which light walks come there, for each time that this is tried.
    pub(crate) walked: f64,
}

/// F_i, B_i and whether x_i reflected ideally, for all vertices of a path.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct PathDensities {
    pub(crate) forward: Vec<f64>,
    pub(crate) backward: Vec<f64>,
    pub(crate) is_delta: Vec<bool>,
    pub(crate) toward: f64,
    pub(crate) is_point: bool,
    /// The vertex that only mirrors separate from a point light, if there is one.
    pub(crate) behind_mirrors: Option<BehindMirrors>,
}

impl Mirrors {
    pub(crate) fn of(image: &PointImage) -> Self {
        let seen_at = image.seen_at.position;
        Self { x1: image.lit_at().position, x2: image.shown_at.map(|_| seen_at) }
    }

    /// From the light on.
    pub(crate) fn places(&self) -> impl Iterator<Item = Vec3> {
        [Some(self.x1), self.x2].into_iter().flatten()
    }
}

impl JoinedPath<'_> {
    /// Vertices from the light and from the camera, x₀ and x_k included.
    pub(crate) fn technique(&self) -> (usize, usize) {
        let s = match self.joint {
            Joint::Hit => 0,
            Joint::Mirror { by, .. } => 1 + by.places().count(),
            Joint::LightSample { .. } | Joint::Connection { .. } | Joint::Splat { .. } => {
                self.light.len() + 1
            }
        };
        (s, self.camera.len() + 1)
    }

    /// Tells whether the camera path was joined with a point light by way of a mirror.
    pub(crate) fn is_joined_by_mirror(&self) -> bool {
        matches!(self.joint, Joint::Mirror { .. })
    }

    /// The path as it was found, adding `value` to this pixel; `logs` are the logarithms of the
    /// densities of all techniques.
    pub(crate) fn found_on(&self, pixel: u32, value: Rgb, logs: &[f64]) -> FoundPath {
        let (s, t) = self.technique();
        FoundPath {
            pixel,
            value,
            s,
            is_splat: t == 1,
            is_point: self.is_point,
            mirror_joint: self.mirror_joint(),
            ratios: logs.iter().map(|log| (log - logs[s]).exp()).collect(),
        }
    }

    /// Tells whether technique (s, t) takes part in finding this path.
    pub(crate) fn allows(&self, techniques: Techniques, s: usize, t: usize) -> bool {
        if self.mirror_joint() == Some(s) {
            techniques.mirror_connections
        } else {
            techniques.allow(s, t, self.is_point)
        }
    }

    /// The technique that stands for joining a point light by way of mirrors, if one does.
    pub(crate) fn mirror_joint(&self) -> Option<usize> {
        self.behind_mirrors().map(|vertex| vertex.s)
    }

    /// See [`PathDensities::behind_mirrors`].
    fn behind_mirrors(&self) -> Option<BehindMirrors> {
        match self.joint {
            Joint::Mirror { walked, .. } => Some(BehindMirrors { s: self.technique().0, walked }),
            Joint::Hit
            | Joint::LightSample { .. }
            | Joint::Connection { .. }
            | Joint::Splat { .. } => {
                let mirrors = self.light.iter().skip(1).take_while(|next| next.after_delta).count();
                let s = mirrors + 1;
                // M of that vertex stands for nothing else, and is zero where nothing is joined so.
                let walked = |vertex: &Vertex| 1.0 / vertex.d_vcm;
                (self.is_point && mirrors > 0)
                    .then(|| BehindMirrors { s, walked: walked(&self.light[mirrors]) })
                    .filter(|vertex| vertex.walked.is_finite())
            }
        }
    }

    /// The densities of every vertex from both sides.
    pub(crate) fn path_densities(&self) -> PathDensities {
        let (s, t) = self.technique();
        let k = s + t - 1;
        let mut path = PathDensities {
            forward: vec![0.0; k + 1],
            backward: vec![0.0; k + 1],
            is_delta: vec![false; k + 1],
            toward: f64::from(self.densities.toward),
            is_point: self.is_point,
            behind_mirrors: self.behind_mirrors(),
        };
        // x_k is the pinhole, which is there for certain.
        path.backward[k] = 1.0;
        let (light_back, camera_back) = self.end_densities();
        // x₁ … x_{s−1} from the light walk: forward as walked, backward as it would be.
        for (j, vertex) in self.light.iter().enumerate() {
            let next = self.light.get(j + 1);
            path.forward[j + 1] = f64::from(vertex.pdf.0);
            path.backward[j] = back_area_pdf(vertex, next, light_back);
            path.is_delta[j + 1] = next.is_some_and(|next| next.after_delta);
        }
        // x_{k−1} … x_s from the camera walk, counted from its end.
        for (j, vertex) in self.camera.iter().enumerate() {
            let next = self.camera.get(j + 1);
            let i = k - 1 - j;
            path.backward[i] = f64::from(vertex.pdf.0);
            path.forward[i + 1] = back_area_pdf(vertex, next, camera_back);
            path.is_delta[i] = next.is_some_and(|next| next.after_delta);
        }
        // What is left is x₀ and the edge that joins the two.
        path.forward[0] = f64::from(self.densities.emission);
        self.add_joint(&mut path, s);
        path
    }

    /// Densities with which the last light and camera vertex would have gone
    /// back, had the path come from the other side.
    fn end_densities(&self) -> (SolidAnglePdf, SolidAnglePdf) {
        let none = SolidAnglePdf(0.0);
        match self.joint {
            Joint::Hit => (none, self.densities.direction),
            Joint::LightSample { end, .. } => (none, end.scattering.toward_camera),
            Joint::Connection { light, camera } => {
                (light.scattering.toward_light, camera.scattering.toward_camera)
            }
            Joint::Mirror { pdf_back, .. } => (none, pdf_back),
            Joint::Splat { pdf_back, .. } => (pdf_back, none),
        }
    }

    fn add_joint(&self, path: &mut PathDensities, s: usize) {
        let product =
            |pdf: SolidAnglePdf, conversion: f32| f64::from(pdf.0) * f64::from(conversion);
        match self.joint {
            Joint::Hit => {}
            // That of x₀ to the vertex behind the mirrors is known as a whole.
            Joint::Mirror { .. } => path.is_delta[1..s].fill(true),
            Joint::LightSample { end, hit_pdf } => {
                path.backward[0] = f64::from(hit_pdf);
                path.forward[1] = product(self.densities.direction, end.conversion);
            }
            Joint::Connection { light, camera } => {
                path.backward[s - 1] = product(camera.scattering.toward_light, light.conversion);
                path.forward[s] = product(light.scattering.toward_camera, camera.conversion);
            }
            Joint::Splat { camera_pdf, .. } => path.backward[s - 1] = f64::from(camera_pdf),
        }
    }
}

/// Area density of the vertex before `vertex`, found by going back.
fn back_area_pdf(vertex: &Vertex, next: Option<&Vertex>, at_end: SolidAnglePdf) -> f64 {
    let pdf = if next.is_some() { vertex.pdf_back } else { at_end };
    f64::from(pdf.0) * f64::from(vertex.conversion_back)
}

impl PathDensities {
    /// The weights of s = 0 … k among the techniques (s, t) that take part; that
    /// of s has t = k + 1 − s.
    pub(crate) fn weights(
        &self,
        splats: f64,
        heuristic: Heuristic,
        takes_part: impl Fn(usize, usize) -> bool,
    ) -> Vec<f64> {
        let logs = self.log_densities(splats, takes_part);
        let largest = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let exponent = match heuristic {
            Heuristic::Balance => 1.0,
            Heuristic::Power => 2.0,
        };
        // Relative to the largest, raised, and made to sum up to one.
        let powers: Vec<f64> = logs.iter().map(|log| (exponent * (log - largest)).exp()).collect();
        let sum: f64 = powers.iter().sum();
        powers.iter().map(|power| power / sum).collect()
    }

    /// Logarithms of the densities of s = 0 … k, as products of many densities leave the
    /// range of numbers; minus infinity for those that do not take part or cannot find the path.
    pub(crate) fn log_densities(
        &self,
        splats: f64,
        takes_part: impl Fn(usize, usize) -> bool,
    ) -> Vec<f64> {
        let k = self.forward.len() - 1;
        let log = |s| {
            let takes_part = self.is_possible(s) && takes_part(s, k + 1 - s);
            if takes_part { self.log_density(s, splats) } else { f64::NEG_INFINITY }
        };
        (0..=k).map(log).collect()
    }

    /// Tells whether technique s can find the path: no edge can be chosen freely beside an ideal
    /// reflection.
    fn is_possible(&self, s: usize) -> bool {
        let k = self.forward.len() - 1;
        // A light path does not hit a pinhole, nor see it from the lamp itself.
        let exists = s < k || (s == k && k > 1);
        let by_mirror = self.behind_mirrors.is_some_and(|vertex| vertex.s == s);
        let joins_delta = s > 0 && (self.is_delta[s - 1] && !by_mirror || self.is_delta[s]);
        exists && !joins_delta
    }

    fn log_density(&self, s: usize, splats: f64) -> f64 {
        let k = self.forward.len() - 1;
        // x₀ … x_{s−1} walked from the light, the others from the camera; any of so many
        // light paths could have been splatted.
        let start = if s == 1 { self.toward } else { self.forward[0] };
        let forward: f64 = match self.behind_mirrors {
            None => (0..s).map(|i| if i == 0 { start } else { self.forward[i] }).map(f64::ln).sum(),
            // All that begin at the light come by way of the mirrors, one of them for certain.
            Some(behind) if s <= behind.s => 0.0,
            Some(behind) => {
                let on = &self.forward[behind.s + 1..s];
                behind.walked.ln() + on.iter().map(|pdf| pdf.ln()).sum::<f64>()
            }
        };
        let backward: f64 = self.backward[s..].iter().map(|pdf| pdf.ln()).sum();
        let count = if s == k { splats } else { 1.0 };
        forward + backward + count.ln()
    }
}
