//! From parts to a scene.

use crate::coincidence::{self, Coincidences};
use crate::light::check_emission;
use crate::light_tree::LightTree;
use crate::scene::{LightId, Surface};
use crate::seat::{self, Seat};
use crate::{Camera, Error, Light, PointLight, Scene, SpotCone};
use traylib_geometry::{Bvh, Mesh, Primitive, SidedPrimitive, Sides, SurfaceSite};
use traylib_materials::Material;
use traylib_math::{Defect, DiscreteDistribution, Rgb, Vec3, planted};

/// A lamp starts no fewer light paths than this part of what it would if all were
/// alike. It costs the others at most as much of theirs, and a lamp that outshines
/// all by far, but elsewhere, leaves enough for those that matter.
const RAREST: f64 = 1.0 / 16.0;

/// Names a material of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialId(u32);

/// What an object looks like.
#[derive(Clone, Debug)]
pub enum ObjectShape {
    /// One shape.
    Primitive(Primitive),
    /// Triangles; those without area are left out.
    Mesh(Mesh),
}

/// A thing in the scene.
#[derive(Clone, Debug)]
pub struct Object {
    /// Its shape.
    pub shape: ObjectShape,
    /// The sides it has. Through a side it does not have, rays pass.
    pub sides: Sides,
    /// What it is made of.
    pub material: MaterialId,
    /// Radiance of its front in W/m²/sr; black for a thing that is no lamp.
    pub emission: Rgb,
}

/// Collects the parts of a [`Scene`] and checks them.
#[derive(Debug)]
pub struct SceneBuilder {
    camera: Camera,
    shapes: Vec<SidedPrimitive>,
    surfaces: Vec<Surface>,
    materials: Vec<Material>,
    meshes: Vec<Mesh>,
    lights: Vec<Light>,
}

impl SceneBuilder {
    /// An empty scene seen by `camera`.
    pub fn new(camera: Camera) -> Self {
        Self {
            camera,
            shapes: Vec::new(),
            surfaces: Vec::new(),
            materials: Vec::new(),
            meshes: Vec::new(),
            lights: Vec::new(),
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
        let (material, sides, emission) = (object.material, object.sides, object.emission);
        match object.shape {
            ObjectShape::Primitive(primitive) => {
                self.add_primitive(primitive, sides, material, emission, None);
            }
            ObjectShape::Mesh(mesh) => {
                let before = self.shapes.len();
                let id = self.meshes.len() as u32;
                for index in 0..mesh.triangle_count() {
                    let Some(triangle) = mesh.triangle(index) else { continue };
                    let primitive = Primitive::Triangle(triangle);
                    let of_mesh = mesh.has_attributes().then_some((id, index as u32));
                    self.add_primitive(primitive, sides, material, emission, of_mesh);
                }
                if self.shapes.len() == before {
                    return Err(Error::EmptyMesh);
                }
                self.meshes.push(mesh);
            }
        }
        Ok(())
    }

    fn add_primitive(
        &mut self,
        primitive: Primitive,
        sides: Sides,
        material: MaterialId,
        radiance: Rgb,
        of_mesh: Option<(u32, u32)>,
    ) {
        let light = (!radiance.is_black()).then(|| {
            self.lights.push(Light::Area { primitive, radiance });
            LightId(self.lights.len() as u32 - 1)
        });
        self.shapes.push(SidedPrimitive { primitive, sides });
        self.surfaces.push(Surface { material: material.0, light, of_mesh });
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

    /// The scene.
    ///
    /// # Errors
    /// [`Error::Dark`] if nothing emits light, [`Error::Geometry`] if the shapes
    /// cannot be stored.
    pub fn build(self) -> Result<Scene, Error> {
        let Self { mut lights, surfaces, .. } = self;
        let powers: Vec<f32> = lights.iter().map(|l| l.power().luminance()).collect();
        let rarest = if planted(Defect::FaintLampUnchosen) { 0.0 } else { RAREST };
        let light_by_power =
            DiscreteDistribution::with_floor(&powers, rarest).ok_or(Error::Dark)?;
        let mut shapes = Bvh::of_shapes(self.shapes)?;
        let lifted_lamps = coincidence::lift_lamps(&mut shapes, &surfaces, &mut lights)?;
        let seats = seats(&lights, &surfaces, &self.materials, shapes.shapes());
        let is_within = |seat: &&Seat| matches!(seat, Seat::Within(_));
        let points_in_surfaces = seats.iter().filter(is_within).count();
        let light_tree = LightTree::new(&lights);
        let camera_in: Vec<SurfaceSite> =
            seat::touching(self.camera.position(), shapes.shapes()).collect();
        let see_through = self.materials.iter().any(Material::is_see_through);
        Ok(Scene {
            camera: camera_in.iter().fold(self.camera, Camera::lifted),
            shapes,
            surfaces,
            materials: self.materials,
            see_through,
            meshes: self.meshes,
            lights,
            seats,
            coincidences: Coincidences {
                lifted_lamps,
                points_in_surfaces,
                surfaces_at_camera: camera_in.len(),
            },
            light_by_power,
            light_tree,
        })
    }
}

/// What each lamp lies on; nothing if that matters for none.
fn seats(
    lights: &[Light],
    surfaces: &[Surface],
    materials: &[Material],
    shapes: &[SidedPrimitive],
) -> Vec<Seat> {
    let of_light = |light: &Light| match light {
        Light::Area { .. } => Seat::Plain,
        Light::Point(point) => Seat::of_point(point.position, shapes),
    };
    let mut seats: Vec<Seat> = lights.iter().map(of_light).collect();
    for (index, surface) in (0..).zip(surfaces) {
        if let Some(id) = surface.light
            && materials[surface.material as usize].has_opacity()
        {
            seats[id.0 as usize] = Seat::Masked(index);
        }
    }
    if seats.iter().all(|seat| matches!(seat, Seat::Plain)) {
        seats.clear();
    }
    seats
}
