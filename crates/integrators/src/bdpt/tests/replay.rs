//! A whole path, walked again from both ends.

use super::super::vertex::{End, SubpathState, Vertex};
use super::super::walk::{LightStart, Walker};
use super::super::{Bdpt, weight};
use crate::emission::Emitted;
use crate::mirrored_point::walked_by_mirror;
use crate::numbers::VertexNumbers;
use crate::path_scattering::PathScattering;
use crate::toward_light::{TowardLight, images_for};
use traylib_geometry::Ray;
use traylib_materials::BsdfSample;
use traylib_math::{Rgb, Sampler, SolidAnglePdf, Vec3, solid_angle_per_area};
use traylib_scene::{
    ImageDirections, Light, LightId, LightPoint, PointImage, Scene, SurfacePoint, Walk,
};

/// x₀ … x_k; surfaces holds x₁ … x_{k−1}.
#[derive(Clone, Debug)]
pub(super) struct FullPath {
    id: LightId,
    x0: LightPoint,
    surfaces: Vec<SurfacePoint>,
    /// For each surface, whether it reflected ideally.
    is_delta: Vec<bool>,
    /// x₀ as a surface, where it is one of the camera subpath.
    lamp: Option<SurfacePoint>,
}

fn delta_events(vertices: &[Vertex]) -> Vec<bool> {
    let after = vertices.iter().skip(1).map(|next| next.after_delta);
    after.chain([false]).collect()
}

impl FullPath {
    /// The path of a camera subpath that ends on a lamp.
    pub(super) fn hit(scene: &Scene, camera: &[Vertex]) -> Option<Self> {
        let (last, inner) = camera.split_last()?;
        let (id, x0) = scene.emitting_point(&last.point)?;
        if inner.is_empty() {
            return None;
        }
        let mut is_delta = delta_events(camera);
        is_delta.pop();
        is_delta.reverse();
        let surfaces = inner.iter().rev().map(|vertex| vertex.point).collect();
        Some(Self { id, x0, surfaces, is_delta, lamp: Some(last.point) })
    }

    /// The path of two subpaths with an edge between their last vertices, if it
    /// could carry light.
    pub(super) fn connected(
        scene: &Scene,
        start: &LightStart,
        light: &[Vertex],
        camera: &[Vertex],
    ) -> Option<Self> {
        let (y, z) = (light.last()?, camera.last()?);
        let w = (z.point.site.position - y.point.site.position).try_normalize()?;
        let f = y.point.evaluate(y.wo, w).f * z.point.evaluate(z.wo, -w).f;
        // What underflows carries no light and has no technique.
        if f.max_band() < 1e-12 {
            return None;
        }
        let surfaces = light.iter().chain(camera.iter().rev()).map(|v| v.point).collect();
        let mut camera_events = delta_events(camera);
        camera_events.reverse();
        let is_delta = [delta_events(light), camera_events].concat();
        let id = scene.light_ids().find(|&id| owns(scene, id, &start.x0))?;
        Some(Self { id, x0: start.x0, surfaces, is_delta, lamp: None })
    }

    /// The path of a camera subpath whose last vertex is joined with a point light by way of
    /// mirrors.
    pub(super) fn by_way_of_mirrors(
        scene: &Scene,
        image: &PointImage,
        camera: &[Vertex],
    ) -> Option<Self> {
        let PointImage { seen_at, shown_at, x0, .. } = *image;
        let id = scene.light_ids().find(|&id| owns(scene, id, &x0))?;
        // The mirrors as the light comes to them, if it does.
        let places = shown_at.into_iter().chain([seen_at]).map(|site| site.position);
        let (mut surfaces, mut from) = (Vec::new(), x0.site.position);
        for place in places {
            let offset = (place - from).normalize();
            let origin = match surfaces.last() {
                None => from,
                Some(SurfacePoint { site, .. }) => site.ray_origin(offset),
            };
            let mirror = scene.intersect(&Ray::new(origin, offset))?;
            if (mirror.site.position - place).length() > 1e-4 {
                return None;
            }
            from = mirror.site.position;
            surfaces.push(mirror);
        }
        let mut events = vec![true; surfaces.len()];
        surfaces.extend(camera.iter().rev().map(|vertex| vertex.point));
        let mut camera_events = delta_events(camera);
        camera_events.reverse();
        events.extend(camera_events);
        Some(Self { id, x0, surfaces, is_delta: events, lamp: None })
    }

    pub(super) fn has_mirror(&self) -> bool {
        self.is_delta.contains(&true)
    }

    pub(super) fn starts_at_point(&self) -> bool {
        self.x0.is_point
    }

    pub(super) fn starts_in_the_sky(&self) -> bool {
        self.x0.is_sky
    }

    /// The weights of all techniques that can find the path, each with its s.
    pub(super) fn weights(
        &self,
        scene: &Scene,
        walker: &Walker,
        bdpt: &Bdpt,
        splats: f64,
    ) -> Vec<(usize, f64)> {
        let heuristic = bdpt.heuristic;
        let light = self.light_vertices(scene, walker, bdpt);
        let camera = self.camera_vertices(scene, bdpt, splats);
        let n = self.surfaces.len();
        let free = |i: usize| !self.is_delta[i];
        let mut weights = Vec::new();
        if let Some(x0) = self.lamp_vertex(scene, &camera, bdpt) {
            let densities = self.densities(scene);
            weights.push((0, weight::hit(&x0, &densities, bdpt.techniques, heuristic)));
        }
        if free(0) {
            weights.push((1, self.light_sample(scene, &camera[n - 1], bdpt)));
        }
        weights.extend(self.mirror_connection(scene, &camera, bdpt));
        for s in 1..n {
            // Connects surfaces s − 1 and s.
            if free(s - 1) && free(s) {
                let (y, z) = (&light[s - 1], &camera[n - 1 - s]);
                let y_end = end(y, Walk::FromLight, z, self.images(scene, s - 1));
                let z_end = end(z, Walk::FromCamera, y, self.images(scene, s));
                weights.push((s + 1, weight::connection((y, &y_end), (z, &z_end), heuristic)));
            }
        }
        if free(n - 1) {
            let y = &light[n - 1];
            if let Some(found) = scene.camera().project(y.point.site.position) {
                let conversion = solid_angle_per_area(
                    y.point.normal.dot(found.to_camera).abs(),
                    found.distance_squared,
                );
                let back = y.point.evaluate(y.wo, found.to_camera).pdf_reverse;
                let camera_pdf = found.pdf.to_area(conversion).0;
                let weight = weight::splat(y, camera_pdf, back, splats, heuristic);
                weights.push((n + 1, weight));
            }
        }
        weights
    }

    /// The weight of joining the first vertex behind mirrors with the light by way of them, if that
    /// is possible, with its s.
    fn mirror_connection(
        &self,
        scene: &Scene,
        camera: &[Vertex],
        bdpt: &Bdpt,
    ) -> Option<(usize, f64)> {
        let mirrors = self.is_delta.iter().take_while(|is_delta| **is_delta).count();
        if !self.x0.is_point || !(1..=2).contains(&mirrors) {
            return None;
        }
        let joined = &camera[camera.len().checked_sub(1 + mirrors)?];
        let image = self.image(scene, &joined.point, mirrors)?;
        let walked =
            walked_by_mirror(&self.densities(scene), image.walk_spread, &joined.point, image.wi);
        let back = joined.scattering(Walk::FromCamera, image.wi, None).toward_camera;
        Some((1 + mirrors, weight::mirror_connection(joined, walked, back, bdpt.heuristic)))
    }

    /// The image of x₀ that is seen by way of so many mirrors.
    fn image(&self, scene: &Scene, from: &SurfacePoint, mirrors: usize) -> Option<PointImage> {
        let [x1, last] = [0, mirrors - 1].map(|i| self.surfaces[i].site.position);
        scene.point_images(from, [0.5; 2]).find(|image| {
            image.light == self.id
                && image.mirrors() as usize == mirrors
                && (image.lit_at().position - x1).length() < 1e-4
                && (image.seen_at.position - last).length() < 1e-4
        })
    }

    fn first_direction(&self) -> Vec3 {
        if self.x0.is_sky {
            return self.x0.site.normal;
        }
        (self.surfaces[0].site.position - self.x0.site.position).normalize()
    }

    /// The square of the length of the first edge; one from the sky, whose densities are those of
    /// directions and of places across them.
    fn first_distance_squared(&self) -> f32 {
        let offset = self.surfaces[0].site.position - self.x0.site.position;
        if self.x0.is_sky { 1.0 } else { offset.length_squared() }
    }

    fn densities(&self, scene: &Scene) -> traylib_scene::LightDensities {
        let x1 = self.surfaces[0].site.position;
        scene.light_densities(self.id, &self.x0, x1, self.first_direction())
    }

    pub(super) fn light_vertices(
        &self,
        scene: &Scene,
        walker: &Walker,
        bdpt: &Bdpt,
    ) -> Vec<Vertex> {
        let direction = self.first_direction();
        let (light, x0, densities) = (self.id, self.x0, self.densities(scene));
        let start = LightStart { light, x0, densities };
        let emitted = Emitted {
            light,
            x0,
            direction,
            x1: self.surfaces[0],
            numbers: numbers(),
            throughput: Rgb::WHITE,
            densities,
        };
        let state = walker.light_state(&emitted);
        let note = |between: &[Vertex], next: &mut Vertex| {
            walker.note_mirrors(scene, &start, between, next);
        };
        walk(Walk::FromLight, state, direction, &self.events(scene), bdpt, note)
    }

    /// What a walk from the camera would aim at from surface i.
    fn images(&self, scene: &Scene, i: usize) -> Option<ImageDirections> {
        let eye_side = self.surfaces.get(i + 1)?;
        if eye_side.is_sharp() { images_for(scene, &self.surfaces[i]) } else { None }
    }

    /// Whether it would aim at any from some surface.
    pub(super) fn has_images(&self, scene: &Scene) -> bool {
        (0..self.surfaces.len()).any(|i| self.images(scene, i).is_some())
    }

    /// Whether one of the vertices that technique s joins aims at images.
    pub(super) fn aims_over_edge(&self, scene: &Scene, s: usize) -> bool {
        self.images(scene, s - 2).is_some() || self.images(scene, s - 1).is_some()
    }

    fn events(&self, scene: &Scene) -> Vec<Event> {
        let event = |i| Event {
            point: self.surfaces[i],
            is_delta: self.is_delta[i],
            images: self.images(scene, i),
        };
        (0..self.surfaces.len()).map(event).collect()
    }

    pub(super) fn camera_vertices(&self, scene: &Scene, bdpt: &Bdpt, splats: f64) -> Vec<Vertex> {
        let mut events = self.events(scene);
        events.reverse();
        let camera = scene.camera();
        let direction = (events[0].point.site.position - camera.position()).normalize();
        let state = SubpathState {
            position: camera.position(),
            is_sky: false,
            cosine: 0.0,
            pdf: camera.pdf(direction),
            is_delta: false,
            d_vcm_factor: splats,
            d_vc_factor: 0.0,
        };
        walk(Walk::FromCamera, state, direction, &events, bdpt, |_, _| {})
    }

    /// x₀ as the camera subpath would have reached it.
    fn lamp_vertex(&self, scene: &Scene, camera: &[Vertex], bdpt: &Bdpt) -> Option<Vertex> {
        if self.x0.is_point {
            return None;
        }
        let mut x1 = *camera.last()?;
        let wi = -self.first_direction();
        let event = self.events(scene)[0];
        let state = x1.go_on(Walk::FromCamera, wi, &event, bdpt);
        let sky = self.x0.is_sky.then(|| Ray::new(x1.point.site.position, wi));
        let lamp = self.lamp.or_else(|| scene.sky_behind(&sky?)).unwrap_or(SurfacePoint {
            site: self.x0.site,
            normal: self.x0.site.normal,
            shading_normal: self.x0.site.normal,
            ..x1.point
        });
        Some(state.extend_to(lamp, -wi, Rgb::WHITE, numbers(), bdpt.heuristic))
    }

    fn light_sample(&self, scene: &Scene, x1: &Vertex, bdpt: &Bdpt) -> f64 {
        let direction = self.first_direction();
        let distance_squared = self.first_distance_squared();
        let images = self.images(scene, 0);
        let scattering = x1.scattering(Walk::FromCamera, -direction, images);
        let conversion =
            solid_angle_per_area(x1.point.normal.dot(direction).abs(), distance_squared);
        let at_lamp = solid_angle_per_area(self.x0.cosine(direction), distance_squared);
        let hit_pdf =
            if self.x0.is_point { 0.0 } else { scattering.toward_light.to_area(at_lamp).0 };
        let end = End { scattering, conversion };
        let densities = self.densities(scene);
        weight::light_sample(x1, &end, &densities, hit_pdf, bdpt.techniques, bdpt.heuristic)
    }
}

fn owns(scene: &Scene, id: LightId, x0: &LightPoint) -> bool {
    let light = scene.light(id);
    if x0.is_sky || matches!(light, Light::Sky(_)) {
        return x0.is_sky && matches!(light, Light::Sky(_));
    }
    light.is_point() == x0.is_point && {
        let (point, _) = light.sample_toward(Vec3::ZERO, traylib_math::Vec2::splat(0.5));
        point.emitted == x0.emitted
    }
}

/// A vertex's end of an edge to another.
fn end(vertex: &Vertex, walk: Walk, other: &Vertex, images: Option<ImageDirections>) -> End {
    let offset = other.point.site.position - vertex.point.site.position;
    let w = offset.normalize();
    let cosine = vertex.point.normal.dot(w).abs();
    End {
        scattering: vertex.scattering(walk, w, images),
        conversion: solid_angle_per_area(cosine, offset.length_squared()),
    }
}

/// A surface of a path, and how walks go on from there.
#[derive(Clone, Copy)]
struct Event {
    point: SurfacePoint,
    is_delta: bool,
    images: Option<ImageDirections>,
}

impl Vertex {
    fn scattering(&self, walk: Walk, wi: Vec3, images: Option<ImageDirections>) -> PathScattering {
        let light_side = match walk {
            Walk::FromCamera => wi,
            Walk::FromLight => self.wo,
        };
        let mut scattering = PathScattering::by_surface(&self.point, walk, self.wo, wi);
        scattering.mix(TowardLight::of(images.as_ref()), &self.point, light_side);
        scattering
    }

    /// Goes on into a direction as if sampling had given it.
    fn go_on(&mut self, walk: Walk, wi: Vec3, event: &Event, bdpt: &Bdpt) -> SubpathState {
        let Event { is_delta, images, .. } = *event;
        let scattering = self.scattering(walk, wi, images);
        let chance = SolidAnglePdf(0.5);
        let (pdf, pdf_reverse) = match (is_delta, walk) {
            (true, Walk::FromCamera | Walk::FromLight) => (chance, chance),
            (false, Walk::FromCamera) => (scattering.toward_light, scattering.toward_camera),
            (false, Walk::FromLight) => (scattering.toward_camera, scattering.toward_light),
        };
        let weight = Rgb::WHITE;
        let sample = BsdfSample { wi, weight, pdf, pdf_reverse, is_delta, eta_scale: 1.0 };
        self.scatter(&sample, pdf_reverse, true, bdpt.heuristic)
    }
}

/// No walk here draws anything.
fn numbers() -> VertexNumbers {
    VertexNumbers::next(&mut Sampler::numbered(0, 0))
}

/// The point for a walk that came to it from `wo`, perhaps from its other side.
fn seen_from(mut point: SurfacePoint, wo: Vec3) -> SurfacePoint {
    if point.normal.dot(wo) < 0.0 {
        point.normal = -point.normal;
        point.shading_normal = -point.shading_normal;
        point.model = point.model.seen_from_behind();
    }
    point
}

fn walk(
    walk: Walk,
    mut state: SubpathState,
    first_direction: Vec3,
    events: &[Event],
    bdpt: &Bdpt,
    note: impl Fn(&[Vertex], &mut Vertex),
) -> Vec<Vertex> {
    let mut direction = first_direction;
    let mut vertices: Vec<Vertex> = Vec::new();
    for (i, event) in events.iter().enumerate() {
        let mut vertex: Vertex = state.extend_to(
            seen_from(event.point, -direction),
            -direction,
            Rgb::WHITE,
            numbers(),
            bdpt.heuristic,
        );
        note(&vertices, &mut vertex);
        if let Some(next) = events.get(i + 1) {
            direction = (next.point.site.position - event.point.site.position).normalize();
            state = vertex.go_on(walk, direction, event, bdpt);
        }
        vertices.push(vertex);
    }
    vertices
}
