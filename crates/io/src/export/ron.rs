//! The text of a scene file, and the files that belong to it.

use super::number::{colour, number, quoted, vector};
use super::picture::Pictures;
use super::{PartObject, PartSky, exact, mesh, picture, surface};
use crate::import::SceneParts;
use crate::ron_scene;
use std::collections::HashSet;
use std::fmt::Write;
use std::sync::Arc;
use traylib_geometry::{Cone, Disk, Facing, Mesh, Primitive, Quad, Sides, Sphere, Triangle};
use traylib_materials::Texture;
use traylib_math::Vec3;
use traylib_scene::{ObjectShape, PointLight, SpotCone};

/// A scene file with its meshes and pictures, of which none is on disk yet.
pub(super) struct Written<'a> {
    pub(super) text: String,
    meshes: Vec<&'a Mesh>,
    pictures: Vec<Arc<Texture>>,
}

type Fault = Box<dyn std::error::Error + Send + Sync>;

impl<'a> Written<'a> {
    /// Writes a scene whose meshes and pictures will be in `folder`.
    pub(super) fn of(parts: &'a SceneParts, folder: &str) -> Self {
        let mut writer = Writer {
            folder,
            text: String::new(),
            meshes: Vec::new(),
            pictures: Pictures::default(),
        };
        writer.scene(parts);
        let Writer { text, meshes, pictures, .. } = writer;
        Self { text, meshes, pictures: pictures.into_all() }
    }

    /// Every file of the folder, by name, encoded when it is asked for.
    pub(super) fn files(&self) -> impl Iterator<Item = (String, Result<Vec<u8>, Fault>)> {
        let meshes = (1..).zip(&self.meshes);
        let meshes =
            meshes.map(|(index, mesh)| (format!("mesh-{index}.ply"), Ok(mesh::encode(mesh))));
        let pictures = (1..).zip(&self.pictures);
        let picture = |(index, texture): (u32, &Arc<Texture>)| {
            (format!("picture-{index}.exr"), picture::encode(texture))
        };
        meshes.chain(pictures.map(picture))
    }

    /// Tells whether there are any.
    pub(super) fn has_files(&self) -> bool {
        !(self.meshes.is_empty() && self.pictures.is_empty())
    }
}

struct Writer<'a, 'f> {
    folder: &'f str,
    text: String,
    meshes: Vec<&'a Mesh>,
    pictures: Pictures,
}

impl<'a> Writer<'a, '_> {
    fn scene(&mut self, parts: &'a SceneParts) {
        self.line("(");
        self.line(&format!("    {},", ron_scene::Camera::of(&parts.camera)));
        self.line(&format!("    exposure: {},", number(parts.settings.exposure)));
        self.line(&format!("    spp: {},", parts.settings.spp));
        let names = names(parts);
        self.line("    materials: {");
        for (name, (_, material)) in names.iter().zip(&parts.materials) {
            let text = surface::material(material, self.folder, &mut self.pictures);
            self.line(&format!("        {}: {text},", quoted(name)));
        }
        self.line("    },");
        self.line("    objects: [");
        for object in &parts.objects {
            let text = self.object(object, &names[object.material]);
            self.line(&format!("        {text},"));
        }
        self.line("    ],");
        self.line("    lights: [");
        for one in &parts.lights {
            self.line(&format!("        {},", light(one)));
        }
        self.line("    ],");
        if let Some(sky) = &parts.sky {
            let text = self.sky(sky);
            self.line(&format!("    sky: {text},"));
        }
        self.line(")");
    }

    fn sky(&mut self, PartSky { radiance, turn_degrees }: &PartSky) -> String {
        if let [light] = radiance.pixels().values() {
            return format!("Constant(radiance: {})", colour(*light));
        }
        let file = format!("{}/picture-{}.exr", self.folder, self.pictures.number(radiance));
        format!("Picture(file: {}, turn: {})", quoted(&file), number(*turn_degrees))
    }

    fn line(&mut self, line: &str) {
        _ = writeln!(self.text, "{line}");
    }

    fn object(&mut self, object: &'a PartObject, material: &str) -> String {
        let shape = match &object.shape {
            ObjectShape::Primitive(shape) => primitive(shape),
            ObjectShape::Mesh(mesh) => {
                self.meshes.push(mesh);
                let file = format!("{}/mesh-{}.ply", self.folder, self.meshes.len());
                format!("Mesh(file: {})", quoted(&file))
            }
        };
        let mut text = format!("(shape: {shape}, material: {}", quoted(material));
        if !object.emission.is_black() {
            _ = write!(text, ", emission: {}", colour(object.emission));
        }
        match object.sides {
            Sides::Both => {}
            Sides::Front => text += ", sides: Front",
        }
        text + ")"
    }
}

/// A name for each material that no other has.
fn names(parts: &SceneParts) -> Vec<String> {
    let mut taken = HashSet::new();
    let mut numbers = std::collections::HashMap::new();
    let name = |(name, _): &(String, _)| {
        let name: &str = if name.is_empty() { "material" } else { name };
        if taken.insert(name.to_string()) {
            return name.to_string();
        }
        let number = numbers.entry(name.to_string()).or_insert(1_u32);
        loop {
            *number += 1;
            let numbered = format!("{name} {number}");
            if taken.insert(numbered.clone()) {
                return numbered;
            }
        }
    };
    parts.materials.iter().map(name).collect()
}

fn primitive(primitive: &Primitive) -> String {
    match primitive {
        Primitive::Triangle(shape) => triangle(shape),
        Primitive::Quad(shape) => quad(shape),
        Primitive::Sphere(shape) => sphere(shape),
        Primitive::Disk(shape) => disk(shape),
        Primitive::Cone(shape) => cone(shape),
    }
}

fn triangle(triangle: &Triangle) -> String {
    let [a, b, c] = triangle.corners().map(vector);
    format!("Triangle(a: {a}, b: {b}, c: {c})")
}

fn quad(quad: &Quad) -> String {
    let [u, v] = quad.edges().map(vector);
    format!("Quad(corner: {}, edge_u: {u}, edge_v: {v})", vector(quad.corner()))
}

fn sphere(sphere: &Sphere) -> String {
    let (centre, radius) = (vector(sphere.centre()), number(sphere.radius()));
    format!("Sphere(center: {centre}, radius: {radius}{})", facing(sphere.facing()))
}

fn disk(disk: &Disk) -> String {
    let (inner, outer) = (disk.inner_radius(), disk.radius());
    let make =
        |normal| Disk::ring(disk.centre(), normal, inner, outer).ok().map(|made| made.normal());
    let normal = vector(exact::vector(disk.normal(), 1.0, exact::MANY, make));
    let hole = if inner == 0.0 { String::new() } else { format!(", inner: {}", number(inner)) };
    format!(
        "Disk(center: {}, normal: {normal}, radius: {}{hole})",
        vector(disk.centre()),
        number(outer)
    )
}

fn cone(cone: &Cone) -> String {
    let [one, other] = cone.ends().map(vector);
    let radii = super::number::tuple(&cone.radii());
    format!("Cone(ends: ({one}, {other}), radii: {radii}{})", facing(cone.facing()))
}

fn facing(facing: Facing) -> &'static str {
    match facing {
        Facing::Outward => "",
        Facing::Inward => ", facing: Inward",
    }
}

fn light(light: &PointLight) -> String {
    let (position, intensity) = (vector(light.position), colour(light.intensity));
    match light.cone {
        None => format!("Point(position: {position}, intensity: {intensity})"),
        Some(cone) => {
            let [full, dark] = [cone.cos_full, cone.cos_dark].map(whole_angle).map(number);
            let target = vector(target(light.position, &cone));
            format!(
                "Spot(position: {position}, target: {target}, intensity: {intensity}, full: {full}, dark: {dark})"
            )
        }
    }
}

/// A point in the middle of a spot light, of which its axis comes out again.
fn target(position: Vec3, cone: &SpotCone) -> Vec3 {
    let make = |offset: Vec3| {
        let axis = (position + offset) - position;
        SpotCone::new(axis, cone.cos_full, cone.cos_dark).ok().map(|made| made.axis)
    };
    let far = position.abs().max_element().max(1.0);
    position + exact::vector(cone.axis, far, exact::MANY, make)
}

/// The angle of a cone, from side to side in degrees, of whose half this is the cosine.
fn whole_angle(cosine: f32) -> f32 {
    let near = 2.0 * f64::from(cosine).acos().to_degrees();
    exact::number(cosine, near as f32, |whole| (0.5 * whole).to_radians().cos())
}
