//! Our own scene format.

use super::files::vector;
use super::{Files, Placement};
use crate::relations::scene::{
    Base, BumpMap, Camera, DrawnScene, Light, Lobes, Map, Material, Object, Shape, Tiling,
};
use std::fmt::Write;
use traylib_geometry::Sides;

/// An entry of a list of objects.
pub(super) enum Entry<'a> {
    /// A surface.
    Object(&'a Object),
    /// All of a file of shapes, as it says itself.
    Whole(String),
    /// A file of shapes that says what shines, with a factor on that; all else is as
    /// of this object.
    Lamp(String, f32, &'a Object),
}

impl Files {
    /// The scene in our own format; shapes that only other formats know stand in
    /// files of theirs. All names begin with `stem`.
    pub fn of(scene: &DrawnScene, stem: &str) -> Self {
        let mut files = Self::empty(stem, None);
        let entries: Vec<Entry<'_>> = scene.objects.iter().map(Entry::Object).collect();
        files.text = self::scene(scene, &entries, &mut files);
        files
    }

    /// Writes the scene with every shape that can stand in an MGF file in one of its own, and
    /// placed from there.
    pub fn placed(scene: &DrawnScene, stem: &str, placement: Placement) -> Self {
        let mut files = Self::empty(stem, Some(placement));
        let entries: Vec<Entry<'_>> = scene.objects.iter().map(Entry::Object).collect();
        files.text = self::scene(scene, &entries, &mut files);
        files
    }
}

/// The text; pictures and shapes from other formats are added to `files`.
pub(super) fn scene(scene: &DrawnScene, entries: &[Entry<'_>], files: &mut Files) -> String {
    let mut names = Names::default();
    let mut objects = String::new();
    for entry in entries {
        let text = match entry {
            Entry::Object(object) => {
                let (shape, emission) = (shape(&object.shape, files), object.emission);
                let emits = format!(", emission: {}", vector(emission));
                let emits = if object.is_light() { emits.as_str() } else { "" };
                format!("(shape: {shape}, {}{emits})", material_and_sides(object, &mut names))
            }
            Entry::Whole(file) => format!("(shape: Mesh(file: \"{file}\"))"),
            Entry::Lamp(file, glow, object) => {
                let material_and_sides = material_and_sides(object, &mut names);
                format!("(shape: Mesh(file: \"{file}\", glow: {glow}), {material_and_sides})")
            }
        };
        let _ = writeln!(objects, "        {text},");
    }
    let mut materials = String::new();
    for (number, known) in names.0.iter().enumerate() {
        let _ = writeln!(materials, "        \"m{number}\": {},", material(known, files));
    }
    let lights: Vec<String> =
        scene.lights.iter().map(|l| format!("        {},\n", light(l))).collect();
    let sky = scene.sky.as_ref().map_or_else(String::new, |sky| super::sky::field(sky, files));
    format!(
        "(\n    {},\n    materials: {{\n{materials}    }},\n    objects: [\n{objects}    ],\n    \
         lights: [\n{}    ],\n{sky})\n",
        camera(&scene.camera),
        lights.concat(),
    )
}

/// Materials by number.
#[derive(Default)]
struct Names<'a>(Vec<&'a Material>);

impl<'a> Names<'a> {
    fn number(&mut self, material: &'a Material) -> usize {
        let known = self.0.iter().position(|&known| known == material);
        known.unwrap_or_else(|| {
            self.0.push(material);
            self.0.len() - 1
        })
    }
}

/// The fields of an object that name its material and its sides.
fn material_and_sides<'a>(object: &'a Object, names: &mut Names<'a>) -> String {
    let sides = match object.sides {
        Sides::Both => "",
        Sides::Front => ", sides: Front",
    };
    format!("material: \"m{}\"{sides}", names.number(&object.material))
}

fn camera(camera: &Camera) -> String {
    let [position, target, up] = [camera.position, camera.target, camera.up].map(vector);
    let (fov, pixels) = (camera.fov, camera.pixels);
    format!(
        "camera: (position: {position}, target: {target}, up: {up}, fov: {fov}, \
         resolution: ({pixels}, {pixels}))"
    )
}

fn shape(shape: &Shape, files: &mut Files) -> String {
    if files.places_all() && !shape.shows_pictures() {
        return files.mesh(shape);
    }
    match shape {
        Shape::Triangle(corners) => {
            let [a, b, c] = corners.map(vector);
            format!("Triangle(a: {a}, b: {b}, c: {c})")
        }
        Shape::Quad(parts) => {
            let [corner, u, v] = parts.map(vector);
            format!("Quad(corner: {corner}, edge_u: {u}, edge_v: {v})")
        }
        &Shape::Disk { centre, normal, inner: 0.0, radius } => {
            let [centre, normal] = [centre, normal].map(vector);
            format!("Disk(center: {centre}, normal: {normal}, radius: {radius})")
        }
        &Shape::Sphere { centre, radius, inward } => {
            let facing = if inward { ", facing: Inward" } else { "" };
            format!("Sphere(center: {}, radius: {radius}{facing})", vector(centre))
        }
        Shape::Box(corners) => {
            let [min, max] = corners.map(vector);
            format!("Box(min: {min}, max: {max})")
        }
        Shape::Mesh(mesh) if mesh.uvs.is_some() => {
            format!("Mesh(file: \"{}\")", files.add("3ds", super::three_ds::mesh(mesh)))
        }
        Shape::Disk { .. } | Shape::Cone { .. } | Shape::Mesh(_) => files.mesh(shape),
    }
}

fn material(material: &Material, files: &mut Files) -> String {
    let base = base(&material.base);
    if !material.has_maps() {
        return base;
    }
    let mut text = format!("Textured(base: {base}");
    let maps = [
        ("diffuse", &material.diffuse),
        ("specular", &material.specular),
        ("opacity", &material.opacity),
    ];
    for (field, layer) in maps {
        if let Some(layer) = layer {
            let _ =
                write!(text, ", {field}: ({}, strength: {})", lay(layer, files), layer.strength);
        }
    }
    if let Some(BumpMap { map, height }) = &material.bump {
        let _ = write!(text, ", bump: ({}, height: {height})", lay(map, files));
    }
    text + ")"
}

fn lay(map: &Map, files: &mut Files) -> String {
    let tiling = match map.tiling {
        Tiling::Repeat => "Repeat",
        Tiling::Mirror => "Mirror",
        Tiling::Once => "Once",
    };
    let (file, scale) = (files.add_picture(&map.picture), map.scale);
    format!("file: \"{file}\", tiling: {tiling}, scale: ({}, {})", scale.x, scale.y)
}

fn base(base: &Base) -> String {
    match *base {
        Base::Lambert(reflectance) => format!("Lambert(reflectance: {})", vector(reflectance)),
        Base::Phong(part) => format!("Phong{}", lobes(&part)),
        Base::MaxPhong(specular, exponent) => {
            format!("MaxPhong(specular: {}, exponent: {exponent})", vector(specular))
        }
        Base::Mirror(reflectance, diffuse) => {
            format!("Mirror(reflectance: {}, diffuse: {})", vector(reflectance), vector(diffuse))
        }
        Base::Sheet(reflection, transmission) => {
            let [reflection, transmission] = [reflection, transmission].map(|part| lobes(&part));
            format!("Sheet(reflection: {reflection}, transmission: {transmission})")
        }
        Base::Glass(index) => format!("Glass(index: {index})"),
        Base::Pane(reflectance, through) => {
            format!("Pane(reflectance: {}, through: {})", vector(reflectance), vector(through))
        }
    }
}

fn lobes(lobes: &Lobes) -> String {
    let [diffuse, specular] = [lobes.diffuse, lobes.specular].map(vector);
    format!("(diffuse: {diffuse}, specular: {specular}, exponent: {})", lobes.exponent)
}

fn light(light: &Light) -> String {
    let [position, intensity] = [light.position, light.intensity].map(vector);
    match light.spot {
        None => format!("Point(position: {position}, intensity: {intensity})"),
        Some(spot) => format!(
            "Spot(position: {position}, target: {}, intensity: {intensity}, full: {}, dark: {})",
            vector(spot.target),
            spot.full,
            spot.dark
        ),
    }
}
