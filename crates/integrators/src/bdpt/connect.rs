//! The deterministic step: joining subpaths (section 4 of the paper).
//!
//! Each way asks in order of cost: can light pass, how much, with what weight,
//! and only then whether anything stands between.

use super::connection_roulette::ConnectionRoulette;
use super::direct_sum::{JoinedPath, Joint, Mirrors};
use super::subpath::Subpath;
use super::vertex::{End, Vertex};
use super::walk::LightStart;
use super::{Bdpt, LightPath, Report, Weighting, weight};
use crate::direct::sample_light;
use crate::mirrored_point::{mirrored_lights, walked_by_mirror};
use crate::path_scattering::PathScattering;
use crate::splat::aim_at_camera;
use crate::toward_light::{TowardLight, images_for};
use crate::tracer::Tracer;
use crate::{ChunkOutput, Limits};
use traylib_math::{Rgb, Sampler, solid_angle_per_area};
use traylib_scene::{PointImage, Walk};

/// Joins subpaths and adds what they carry.
pub(crate) struct Joiner<'a> {
    bdpt: &'a Bdpt,
    light_paths: u32,
    splats_in_weights: f64,
}

/// A joined path that carries light, unless something stands between.
struct Found<'a> {
    path: JoinedPath<'a>,
    /// The contribution of its technique alone.
    value: Rgb,
    weight: f64,
}

impl<'a> Joiner<'a> {
    pub(crate) fn new(bdpt: &'a Bdpt, light_paths: u32, splats_in_weights: f64) -> Self {
        Self { bdpt, light_paths, splats_in_weights }
    }

    /// t = 1: joins every vertex of a light path to the camera.
    pub(crate) fn splat_all(
        &self,
        tracer: &mut Tracer<'_>,
        path: LightPath<'_>,
        out: &mut ChunkOutput,
    ) {
        if !self.bdpt.techniques.splats {
            return;
        }
        // The walk has left room for the edge to the camera behind each of them.
        for last in 0..path.vertices.len() {
            self.splat(tracer, path.start, &path.vertices[..=last], out);
        }
    }

    /// All techniques of one camera path with one light path; `sampler` goes on
    /// after the numbers of the camera path.
    pub(crate) fn join_all(
        &self,
        tracer: &mut Tracer<'_>,
        pixel: u32,
        path: &Subpath,
        light: Option<LightPath<'_>>,
        sampler: &mut Sampler,
        out: &mut ChunkOutput,
    ) {
        let camera = &path.vertices[..];
        // What the camera path finds by itself: hits and light samples.
        let mut found = Rgb::BLACK;
        for last in 0..camera.len() {
            let camera = &camera[..=last];
            found += self.hit(tracer, pixel, camera, out).unwrap_or_default();
            // The camera path itself has `last + 1` edges.
            if self.limits().allow(last as u32 + 2) {
                let toward_light = path.toward_light(&camera[last]);
                found +=
                    self.light_sample(tracer, pixel, camera, toward_light, out).unwrap_or_default();
            }
            found += self.mirror_connections(tracer, pixel, camera, out);
        }
        let Some(light) = light.filter(|_| self.bdpt.techniques.connections) else { return };
        // Pair by pair; of very many only some, which count for the rest.
        let light_vertices = light.vertices.len();
        let mut roulette =
            ConnectionRoulette::beside(found, camera.len() * light_vertices, sampler);
        let mut left_out = roulette.pairs_left_out();
        for t in 1..=camera.len() {
            let toward_light = path.toward_light(&camera[t - 1]);
            let mut s = 1 + left_out;
            while s <= light_vertices {
                if self.limits().allow((s + t + 1) as u32) {
                    let light = (light.start, &light.vertices[..s]);
                    let camera = (&camera[..t], toward_light);
                    self.connection(tracer, pixel, light, camera, &mut roulette, out);
                }
                s += 1 + roulette.pairs_left_out();
            }
            left_out = s - light_vertices - 1;
        }
    }

    fn limits(&self) -> Limits {
        self.bdpt.limits
    }

    /// s = 0: the camera path's last vertex is on a lamp.
    fn hit(
        &self,
        tracer: &Tracer<'_>,
        pixel: u32,
        camera: &[Vertex],
        out: &mut ChunkOutput,
    ) -> Option<Rgb> {
        let x0 = camera.last()?;
        let (id, on_lamp) = tracer.scene.emitting_point(&x0.point)?;
        // Nothing competes for a lamp that the camera sees.
        let seen_directly = camera.len() == 1;
        if !seen_directly && !self.bdpt.techniques.hits {
            return None;
        }
        // The vertex before, which a light sample would have been drawn for.
        let x1 = camera
            .len()
            .checked_sub(2)
            .map_or(tracer.scene.camera().position(), |before| camera[before].point.site.position);
        // How else the point could have been found.
        let densities = tracer.scene.light_densities(id, &on_lamp, x1, x0.wo);
        let weight = if seen_directly {
            1.0
        } else {
            weight::hit(x0, &densities, self.bdpt.techniques, self.bdpt.heuristic)
        };
        let path = JoinedPath { light: &[], camera, densities, is_point: false, joint: Joint::Hit };
        let value = x0.throughput * on_lamp.emitted;
        Some(self.add(pixel, &Found { path, value, weight }, out))
    }

    /// s = 1: a fresh point of a lamp for the camera path's last vertex.
    fn light_sample(
        &self,
        tracer: &mut Tracer<'_>,
        pixel: u32,
        camera: &[Vertex],
        toward_light: TowardLight<'_>,
        out: &mut ChunkOutput,
    ) -> Option<Rgb> {
        let x1 = camera.last()?;
        let scene = tracer.scene;
        // Can light pass, and how much?
        let mut light = sample_light(scene, &x1.point, x1.wo, &x1.numbers)?;
        light.mix(toward_light, &x1.point);
        // Points are always aimed at: nothing else finds them.
        let is_point = light.x0.is_point;
        if !self.bdpt.techniques.samples_light(is_point) {
            return None;
        }
        // With what weight?
        let densities = light.densities(scene);
        let cosine = x1.point.normal.dot(light.wi).abs();
        let end = End {
            scattering: light.scattering,
            conversion: solid_angle_per_area(cosine, light.distance_squared),
        };
        let hit_pdf = light.hit_pdf();
        let Bdpt { techniques, heuristic, .. } = *self.bdpt;
        let weight = weight::light_sample(x1, &end, &densities, hit_pdf, techniques, heuristic);
        let joint = Joint::LightSample { end, hit_pdf };
        let path = JoinedPath { light: &[], camera, densities, is_point, joint };
        // Does anything stand between?
        let transmittance = light.visible(tracer, &x1.point)?;
        let value = x1.throughput * light.radiance * transmittance;
        Some(self.add(pixel, &Found { path, value, weight }, out))
    }

    /// s = 2 or 3 by way of mirrors: point lights that the camera path's last vertex sees in them.
    fn mirror_connections(
        &self,
        tracer: &mut Tracer<'_>,
        pixel: u32,
        camera: &[Vertex],
        out: &mut ChunkOutput,
    ) -> Rgb {
        let mut found = Rgb::BLACK;
        let Some(last) = camera.last().filter(|_| self.bdpt.techniques.mirror_connections) else {
            return found;
        };
        let scene = tracer.scene;
        let room = (camera.len() as u32, self.limits());
        for light in mirrored_lights(scene, &last.point, last.wo, &last.numbers, room) {
            // With what weight?
            let PointImage { wi, x0, light: id, walk_spread, .. } = light.image;
            let x1 = light.image.lit_at().position;
            let direction = (x1 - x0.site.position).normalize();
            let densities = scene.light_densities(id, &x0, x1, direction);
            let walked = walked_by_mirror(&densities, walk_spread, &last.point, wi);
            let pdf_back = light.scattering.toward_camera;
            let weight = weight::mirror_connection(last, walked, pdf_back, self.bdpt.heuristic);
            // Does anything stand between?
            let Some(transmittance) = light.visible(tracer, &last.point) else { continue };
            let by = Mirrors::of(&light.image);
            let joint = Joint::Mirror { by, walked, pdf_back };
            let path = JoinedPath { light: &[], camera, densities, is_point: true, joint };
            let value = last.throughput * light.radiance * transmittance;
            found += self.add(pixel, &Found { path, value, weight }, out);
        }
        found
    }

    /// s ≥ 2, t ≥ 2: an edge between the last vertices of both subpaths.
    fn connection(
        &self,
        tracer: &mut Tracer<'_>,
        pixel: u32,
        (start, light): (&LightStart, &[Vertex]),
        (camera, toward_light): (&[Vertex], TowardLight<'_>),
        roulette: &mut ConnectionRoulette<'_>,
        out: &mut ChunkOutput,
    ) {
        let ([.., y], [.., z]) = (light, camera) else { return };
        if !(y.connectable && z.connectable) {
            return;
        }
        // Can light pass? Both surfaces must scatter into the edge.
        let offset = z.point.site.position - y.point.site.position;
        let possible = y.point.may_scatter_to(offset) && z.point.may_scatter_to(-offset);
        let distance_squared = offset.length_squared();
        if !possible || distance_squared == 0.0 {
            return;
        }
        // How much: f at both ends, both cosines, one over the square of the distance.
        let direction = offset / distance_squared.sqrt();
        let mut at_y = PathScattering::by_surface(&y.point, Walk::FromLight, y.wo, direction);
        let mut at_z = PathScattering::by_surface(&z.point, Walk::FromCamera, z.wo, -direction);
        let f = at_y.f * at_z.f;
        if f.is_black() {
            return;
        }
        // With what weight, now that both ends know what is on their other side?
        if self.bdpt.aims_at_images && z.is_sharp {
            let images = images_for(tracer.scene, &y.point);
            at_y.mix(TowardLight::of(images.as_ref()), &y.point, y.wo);
        }
        at_z.mix(toward_light, &z.point, -direction);
        let end = |vertex: &Vertex, scattering| {
            let cosine = vertex.point.normal.dot(direction).abs();
            End { scattering, conversion: solid_angle_per_area(cosine, distance_squared) }
        };
        let (light_end, camera_end) = (end(y, at_y), end(z, at_z));
        let weight = weight::connection((y, &light_end), (z, &camera_end), self.bdpt.heuristic);
        // With shading normals the two ends carry different cosines: see `SurfacePoint::cosine`.
        let cosines = y.point.cosine(Walk::FromLight, y.wo, direction)
            * z.point.cosine(Walk::FromCamera, z.wo, -direction);
        let value = y.throughput * z.throughput * f * (cosines / distance_squared);
        // Is it worth a shadow ray?
        let Some(chance) = roulette.survives(value * weight as f32) else { return };
        // Does anything stand between?
        if let Some(transmittance) = tracer.sees(&z.point.site.segment_to(&y.point.site)) {
            let joint = Joint::Connection { light: light_end, camera: camera_end };
            let path = start.path(light, camera, joint);
            self.add(pixel, &Found { path, value: value * transmittance / chance, weight }, out);
        }
    }

    fn splat(
        &self,
        tracer: &mut Tracer<'_>,
        start: &LightStart,
        light: &[Vertex],
        out: &mut ChunkOutput,
    ) {
        let [.., y] = light else { return };
        // Does the camera see it, and with what weight?
        let Some(splat) = aim_at_camera(tracer.scene, &y.point, y.wo) else { return };
        let camera_pdf = splat.camera_pdf(&y.point);
        let pdf_back = splat.scattering.toward_light;
        let heuristic = self.bdpt.heuristic;
        let weight = weight::splat(y, camera_pdf, pdf_back, self.splats_in_weights, heuristic);
        // Does anything stand between?
        if let Some(transmittance) = tracer.seen_by_camera(&y.point) {
            // The mean over all light paths of the pass.
            let value =
                y.throughput * splat.value * transmittance * (1.0 / self.light_paths as f32);
            let path = start.path(light, &[], Joint::Splat { pdf_back, camera_pdf });
            self.add(splat.pixel(tracer.scene), &Found { path, value, weight }, out);
        }
    }

    /// Adds what was found, and returns it.
    fn add(&self, pixel: u32, found: &Found<'_>, out: &mut ChunkOutput) -> Rgb {
        let Found { path, value, weight } = found;
        let Bdpt { techniques, heuristic, weighting, report, .. } = *self.bdpt;
        // By the recursive weight whatever the form, so that all of them try the
        // same connections.
        let alone = *value * found.weight as f32;
        let (s, t) = path.technique();
        if !weighting.includes(s, t) {
            return alone;
        }
        // Other weights than the recursive one are formed from all densities of the path.
        let takes_part = |s, t| path.allows(techniques, s, t) && weighting.includes(s, t);
        let splats = self.splats_in_weights;
        let all_weights = || path.path_densities().weights(splats, heuristic, takes_part);
        let weight = match weighting {
            Weighting::Recursive => *weight,
            Weighting::DirectSum | Weighting::Among(_) => all_weights()[s],
        };
        out.add(pixel, *value * weight as f32);
        if report == Report::Paths {
            let logs = path.path_densities().log_densities(splats, takes_part);
            out.paths.push(path.found_on(pixel, *value, &logs));
        }
        report.record(out, pixel, path, *value, weight, all_weights);
        alone
    }
}

impl LightStart {
    fn path<'a>(&self, light: &'a [Vertex], camera: &'a [Vertex], joint: Joint) -> JoinedPath<'a> {
        let is_point = self.x0.is_point;
        JoinedPath { light, camera, densities: self.densities, is_point, joint }
    }
}
