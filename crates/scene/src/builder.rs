//! From parts to a scene.

use crate::LightId;
use crate::coincidence;
use crate::images::MirroredLights;
use crate::light::check_emission;
use crate::light::sky::{Sky, SkyPicture};
use crate::light_choice::LightForPoint;
use crate::scene::Stage;
use crate::seat::seats;
use crate::surfaces::{ObjectShape, Surfaces};
use crate::{Camera, Error, Light, PointLight, Scene, SpotCone};
use std::sync::Arc;
use traylib_geometry::{Bvh, Primitive, Sides};
use traylib_materials::Material;
use traylib_math::{DiscreteDistribution, Grid, Rgb, Vec3};

/// A lamp starts no fewer light paths than this part of what it would if all were
/// alike. It costs the others at most as much of theirs, and a lamp that outshines
/// all by far, but elsewhere, leaves enough for those that matter.
const RAREST: f64 = 1.0 / 16.0;

/// Names a material of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialId(u32);

/// An object of the scene: a surface with its material, perhaps a lamp.
#[derive(Clone, Debug)]
pub struct Object {
    /// Its shape.
    pub shape: ObjectShape,
    /// The sides it has. Through a side it does not have, rays pass.
    pub sides: Sides,
    /// The material that it is made of.
    pub material: MaterialId,
    /// Radiance of its front in W/m²/sr; black for an object that is no lamp.
    pub emission: Rgb,
}

/// Collects the parts of a [`Scene`] and checks them.
#[derive(Debug)]
pub struct SceneBuilder {
    camera: Camera,
    surfaces: Surfaces,
    materials: Vec<Material>,
    lights: Vec<Light>,
    sky: Option<SkyPicture>,
}

impl SceneBuilder {
    /// An empty scene seen by `camera`.
    pub fn new(camera: Camera) -> Self {
        Self {
            camera,
            surfaces: Surfaces::default(),
            materials: Vec::new(),
            lights: Vec::new(),
            sky: None,
        }
    }

    /// Adds a material for objects to name.
    pub fn add_material(&mut self, material: impl Into<Material>) -> MaterialId {
        self.materials.push(material.into());
        MaterialId(self.materials.len() as u32 - 1)
    }

    /// Adds an object.
    ///
    /// # Errors
    /// [`Error::Emission`] for radiance that is negative or not finite,
    /// [`Error::EmptyMesh`] for a mesh without area.
    pub fn add_object(&mut self, object: Object) -> Result<(), Error> {
        check_emission("emission", object.emission)?;
        let shape = match object.shape {
            ObjectShape::Primitive(primitive) => ObjectShape::Primitive(primitive),
            ObjectShape::Mesh(mesh) => ObjectShape::Mesh(mesh.without_degenerate()),
        };
        if let ObjectShape::Mesh(mesh) = &shape
            && mesh.triangle_count() == 0
        {
            return Err(Error::EmptyMesh);
        }
        let first_light = self.add_lights(&shape, object.emission);
        self.surfaces.add(shape, object.sides, object.material.0, first_light);
        Ok(())
    }

    /// A lamp for each shape that shines; the first.
    fn add_lights(&mut self, shape: &ObjectShape, radiance: Rgb) -> Option<LightId> {
        if radiance.is_black() {
            return None;
        }
        let first = LightId(self.lights.len() as u32);
        let light = |primitive| Light::Area { primitive, radiance };
        match shape {
            ObjectShape::Primitive(primitive) => self.lights.push(light(*primitive)),
            ObjectShape::Mesh(mesh) => {
                let triangles = (0..mesh.triangle_count()).filter_map(|i| mesh.triangle(i));
                self.lights.extend(triangles.map(Primitive::Triangle).map(light));
            }
        }
        Some(first)
    }

    /// Adds a point light of this intensity in W/sr.
    ///
    /// # Errors
    /// [`Error::Position`] or [`Error::Emission`] for values that are not finite
    /// or negative.
    pub fn add_point_light(&mut self, position: Vec3, intensity: Rgb) -> Result<(), Error> {
        self.add_point(PointLight { position, intensity, cone: None })
    }

    /// Adds a point light that shines into a cone, of this intensity in W/sr where
    /// it is full.
    ///
    /// # Errors
    /// Those of [`add_point_light`](Self::add_point_light) and [`SpotCone::new`].
    pub fn add_spot_light(
        &mut self,
        position: Vec3,
        intensity: Rgb,
        cone: SpotCone,
    ) -> Result<(), Error> {
        let cone = Some(SpotCone::new(cone.axis, cone.cos_full, cone.cos_dark)?);
        self.add_point(PointLight { position, intensity, cone })
    }

    fn add_point(&mut self, light: PointLight) -> Result<(), Error> {
        if !light.position.is_finite() {
            return Err(Error::Position(light.position.to_array()));
        }
        check_emission("intensity", light.intensity)?;
        if !light.intensity.is_black() {
            self.lights.push(Light::Point(light));
        }
        Ok(())
    }

    /// Gives the scene a sky of this radiance in W/(m²·sr), in place of any before: a
    /// latitude-longitude picture, of one texel for the same all around.
    ///
    /// Its top row is up, +y, the middle of the picture is where −z points, and its right half is
    /// to the right of who looks there; then it is turned about y, counter-clockwise seen from
    /// above. Column and row (u, v) in [0, 1)² are the direction
    /// (sin πv·sin φ, cos πv, −sin πv·cos φ) with φ = 2π(u − ½) − turn. Each texel has one
    /// radiance all over.
    ///
    /// # Errors
    /// [`Error::Emission`] for radiance that is negative or not finite.
    pub fn set_sky(&mut self, radiance: Grid<Rgb>, turn_degrees: f32) -> Result<(), Error> {
        radiance.values().iter().try_for_each(|&texel| check_emission("radiance", texel))?;
        self.sky = SkyPicture::new(radiance, turn_degrees.to_radians());
        Ok(())
    }

    /// The scene.
    ///
    /// # Errors
    /// [`Error::Dark`] if nothing emits light, [`Error::Geometry`] if the shapes
    /// cannot be stored.
    pub fn build(self) -> Result<Scene, Error> {
        let Self { mut lights, .. } = self;
        let power = |light: &Light| light.power().luminance();
        let mut powers: Vec<f32> = lights.iter().map(power).collect();
        let tree = Bvh::of_shapes(self.surfaces)?;
        let (tree, lifted_lights) = coincidence::lift_lights(tree, &mut lights)?;
        let seats = seats(&lights, &self.materials, tree.shapes());
        if let Some(picture) = self.sky {
            let sky = Light::Sky(Arc::new(Sky::new(picture, &tree.bounds())));
            powers.push(power(&sky));
            lights.push(sky);
        }
        let light_by_power =
            DiscreteDistribution::with_floor(&powers, RAREST).ok_or(Error::Dark)?;
        let light_for_point = LightForPoint::new(&lights, &powers);
        let mirrored_lights = MirroredLights::new(tree.shapes(), &self.materials, &lights);
        let see_through = self.materials.iter().any(Material::is_see_through);
        let stage = Stage {
            tree,
            materials: self.materials,
            see_through,
            has_points: lights.iter().any(Light::is_point),
            lights,
            seats,
            lifted_lights,
            light_by_power,
            light_for_point,
            mirrored_lights,
        };
        Ok(Scene::new(Arc::new(stage), self.camera))
    }
}
