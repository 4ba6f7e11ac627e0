//! Path vertices and the partial weights that make weights cheap.
//!
//! After van Antwerpen (2011) and Georgiev, *Implementing Vertex Connection and
//! Merging* (2012). F_i is the area density of x_i when walked from the light,
//! B_i from the camera; P raises to the heuristic's exponent. Everything here is
//! said for a walk from the light; the other is its mirror image.
//!
//! Of the other techniques that could have found a path, those that connect
//! inside this subpath are summed up in
//!
//! - `d_vcm` = 1/F_i, which stands for connecting x_{i−1} to x_i (M in comments), or, where all
//!   between are mirrors by way of which x_i may be joined with a point light x₀, for that,
//! - `d_vc` = Σ over the connections further back, per P(pdf of going back) (C).
//!
//! They are Georgiev's dVCM and dVC before the heuristic raises the first: here it does
//! where a weight is formed, so that both heuristics share one walk.

use crate::numbers::VertexNumbers;
use crate::path_scattering::PathScattering;
use traylib_materials::BsdfSample;
use traylib_math::{AreaPdf, Heuristic, Rgb, SolidAnglePdf, Vec3, solid_angle_per_area};
use traylib_scene::SurfacePoint;

/// A vertex of a subpath, on a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Vertex {
    pub(crate) point: SurfacePoint,
    /// Unit direction back to the vertex before.
    pub(crate) wo: Vec3,
    /// The throughput of the subpath up to here, over its density.
    pub(crate) throughput: Rgb,
    /// The random numbers of this vertex.
    pub(crate) numbers: VertexNumbers,
    /// Density with which the walk chose this point; of the sky per steradian.
    pub(crate) pdf: AreaPdf,
    /// Steradians per area of the vertex *before*, seen from here: turns this
    /// vertex's density of going back into one per area.
    pub(crate) conversion_back: f32,
    /// Density of going back from here, known once the walk has gone on.
    pub(crate) pdf_back: SolidAnglePdf,
    /// Whether a connection can carry light here.
    pub(crate) connectable: bool,
    /// Whether the vertex before reflected ideally, so that no connection could
    /// have made this edge.
    pub(crate) after_delta: bool,
    /// Whether the surface is sharp: see [`SurfacePoint::is_sharp`].
    pub(crate) is_sharp: bool,
    /// The index of the images that a walk from the camera aims at from here.
    pub(crate) images: Option<u32>,
    pub(crate) d_vcm: f64,
    pub(crate) d_vc: f64,
}

/// A subpath on its way to the next vertex: what that needs to know of this one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SubpathState {
    pub(crate) position: Vec3,
    /// Whether this is a point of the sky.
    pub(crate) is_sky: bool,
    /// Cosine of the leaving edge at this vertex; zero where no walk from the
    /// other end can arrive.
    pub(crate) cosine: f32,
    /// Density of the leaving direction.
    pub(crate) pdf: SolidAnglePdf,
    pub(crate) is_delta: bool,
    /// `d_vcm` of the next vertex is this over its density.
    pub(crate) d_vcm_factor: f64,
    /// `d_vc` of the next vertex is this times P(cosine/(pdf·its cosine)).
    pub(crate) d_vc_factor: f64,
}

impl SubpathState {
    /// The vertex at `point`, reached from this one.
    #[inline]
    pub(crate) fn extend_to(
        &self,
        point: SurfacePoint,
        wo: Vec3,
        throughput: Rgb,
        numbers: VertexNumbers,
        heuristic: Heuristic,
    ) -> Vertex {
        // The density of the direction, per area of the new vertex. The sky is at no distance: its
        // densities are per steradian, and those from there per area across.
        let distance_squared = if self.is_sky | point.is_sky() {
            1.0
        } else {
            (point.site.position - self.position).length_squared()
        };
        let cosine = point.normal.dot(wo).abs();
        let pdf = self.pdf.to_area(solid_angle_per_area(cosine, distance_squared));
        // Both densities of an ideal reflection carry the same chance; without
        // it only the cosines are left.
        let choice = if self.is_delta { 1.0 } else { f64::from(self.pdf.0) };
        // p_back/p_forth of the edge: cosine over density, equations 34 to 36.
        let back_over_forth = f64::from(self.cosine) / (choice * f64::from(cosine));
        Vertex {
            point,
            wo,
            throughput,
            numbers,
            pdf,
            conversion_back: solid_angle_per_area(self.cosine, distance_squared),
            pdf_back: SolidAnglePdf(0.0),
            connectable: point.model.has_smooth_part(),
            after_delta: self.is_delta,
            is_sharp: point.is_sharp(),
            images: None,
            d_vcm: self.d_vcm_factor / f64::from(pdf.0),
            d_vc: heuristic.raise(back_over_forth) * self.d_vc_factor,
        }
    }
}

impl Vertex {
    /// The sum, over all techniques that connect further back than the last edge
    /// of this subpath, of (their density / that of connecting at the edge from
    /// here), raised: P(B)·(M + P(pdf back)·C), with B the density of finding
    /// this vertex from the other side of the edge.
    #[inline]
    pub(crate) fn competition(
        &self,
        density_from_other_side: f64,
        pdf_back: SolidAnglePdf,
        heuristic: Heuristic,
    ) -> f64 {
        // Connecting at the edge before this vertex, and at all edges further back.
        heuristic.raise(density_from_other_side * self.d_vcm)
            + heuristic.raise(density_from_other_side * f64::from(pdf_back.0)) * self.d_vc
    }

    /// Notes how the walk goes on by this sample, and updates the partial weights for the
    /// next vertex (Georgiev, equations 34 to 36, without vertex merging). A walk from the
    /// other end would have gone back with density `pdf_back`; `connections` is whether connecting
    /// at the next edge takes part at all.
    #[inline]
    pub(crate) fn scatter(
        &mut self,
        sample: &BsdfSample,
        pdf_back: SolidAnglePdf,
        connections: bool,
        heuristic: Heuristic,
    ) -> SubpathState {
        let BsdfSample { wi, pdf, is_delta, .. } = *sample;
        // Known only now: how a walk from the other end would have gone on.
        self.pdf_back = pdf_back;
        // An ideal reflection cannot be connected to: nothing is added.
        let d_vc_factor = if is_delta {
            self.d_vc
        } else {
            heuristic.raise(self.d_vcm) + heuristic.raise(f64::from(pdf_back.0)) * self.d_vc
        };
        SubpathState {
            position: self.point.site.position,
            is_sky: false,
            cosine: self.point.normal.dot(wi).abs(),
            pdf,
            is_delta,
            // An ideal reflection, or an edge that nobody connects, is no technique.
            d_vcm_factor: if connections && !is_delta { 1.0 } else { 0.0 },
            d_vc_factor,
        }
    }
}

/// The factors that one end of a connecting edge contributes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct End {
    /// BSDF and densities for the way from `wo` to the other end.
    pub(crate) scattering: PathScattering,
    /// Steradians per area of *this* vertex, seen from the other end.
    pub(crate) conversion: f32,
}
