//! The first surface that the camera sees: its albedo, normal and depth.

use crate::tracer::SurfaceHit;
use crate::{BlindSpot, Chunk, ChunkOutput, Integrator, SceneFacts};
use traylib_math::Rgb;
use traylib_scene::Scene;

/// Pictures of the surfaces that the camera sees first, for whoever composes or denoises its
/// picture: means over the pixel, black where nothing is seen. It finds no light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FirstHits;

/// A picture of first surfaces: a layer of the film that [`FirstHits`] makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FirstHit {
    /// The part of the light from the camera that the surface scatters, band by band.
    Albedo = 0,
    /// The shading normal, unit before the mean is formed, on the side of the camera.
    Normal = 1,
    /// The distance from the pinhole in metres, the same in all bands.
    Depth = 2,
}

impl FirstHit {
    /// The number of its layer.
    pub fn layer(self) -> u16 {
        self as u16
    }
}

impl Integrator for FirstHits {
    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        let mut found = Vec::new();
        chunk.sample_each_pixel(scene, out, |tracer, pixel, film_point, sampler| {
            let ray = scene.camera().ray(film_point);
            let numbers = sampler.vertex();
            if let Some(SurfaceHit { point, .. }) = tracer.camera_ray(&ray, numbers.pass_through) {
                // The weight of a sample has the albedo as its mean.
                let albedo = point.sample(-ray.direction, numbers.bsdf);
                let albedo = albedo.map_or(Rgb::BLACK, |sample| sample.weight);
                let normal = Rgb::from(point.shading_normal.to_array());
                let depth = Rgb::splat((point.site.position - ray.origin).length());
                let layers = [
                    (FirstHit::Albedo, albedo),
                    (FirstHit::Normal, normal),
                    (FirstHit::Depth, depth),
                ];
                found.extend(layers.map(|(kind, value)| (kind.layer(), pixel, value)));
            }
            Rgb::BLACK
        });
        out.layers.extend(found);
    }

    fn blind_spots(&self, _facts: &SceneFacts) -> Vec<BlindSpot> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Settings, render_to_end};
    use traylib_geometry::{Primitive, Quad, Sides};
    use traylib_materials::{Lambert, Phong, SurfaceModel};
    use traylib_math::Vec3;
    use traylib_scene::{Camera, CameraSettings, Object, ObjectShape, SceneBuilder};

    /// A wall of two colours two metres before the camera, and nothing above it.
    #[test]
    fn a_wall_is_where_it_is() {
        let camera = CameraSettings {
            position: Vec3::new(0.0, 0.0, 2.0),
            target: Vec3::ZERO,
            up: Vec3::Y,
            fov_degrees: 20.0,
            width: 4,
            height: 4,
        };
        let mut builder = SceneBuilder::new(Camera::new(camera).unwrap());
        let reflectance = Rgb::new(0.2, 0.4, 0.8);
        let chalk = SurfaceModel::Lambert(Lambert::new(reflectance).unwrap());
        let gloss = Phong::new(Rgb::splat(0.3), Rgb::splat(0.5), 5.0).unwrap();
        for (left, model) in [(-1.0, chalk), (0.0, SurfaceModel::Phong(gloss))] {
            let material = builder.add_material(model);
            let corner = Vec3::new(left, -1.0, 0.0);
            let wall = Quad::new(corner, Vec3::X, Vec3::Y).unwrap();
            let shape = ObjectShape::Primitive(Primitive::Quad(wall));
            let (sides, emission) = (Sides::Both, Rgb::BLACK);
            builder.add_object(Object { shape, sides, material, emission }).unwrap();
        }
        builder.add_point_light(Vec3::Z, Rgb::WHITE).unwrap();
        let scene = builder.build().unwrap();
        let settings = Settings { spp: 64, ..Settings::default() };
        let film = render_to_end(&scene, &FirstHits, &settings).unwrap().film;
        let layers = film.develop_layers();
        let at = |kind: FirstHit, x, y| *layers[&kind.layer()].get(x, y);
        // Above the wall there is nothing.
        assert_eq!(at(FirstHit::Depth, 0, 0), Rgb::BLACK);
        assert_eq!(at(FirstHit::Normal, 0, 3), Rgb::new(0.0, 0.0, 1.0));
        assert!((at(FirstHit::Albedo, 0, 3).b - reflectance.b).abs() < 1e-6);
        // What dips below the surface is lost.
        let albedo = at(FirstHit::Albedo, 3, 3).g;
        assert!((0.5..=0.8).contains(&albedo), "{albedo}");
        // From the middle of the pixel to its corners.
        let depth = at(FirstHit::Depth, 1, 2).r;
        assert!((2.0..2.02).contains(&depth), "{depth}");
        assert!(film.develop().values().iter().all(|light| light.is_black()));
    }
}
