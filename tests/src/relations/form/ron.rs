//! Our own scene format.

use super::Files;
use crate::relations::scene::{
    Base, Camera, DrawnScene, Light, Lobes, Map, Material, Object, Relief, Shape, Tiling,
};
use std::fmt::Write;
use traylib_geometry::Sides;
use traylib_math::Vec3;

/// The text; pictures and shapes from other formats are added to `files`.
pub(super) fn scene(scene: &DrawnScene, files: &mut Files) -> String {
    let mut names: Vec<&Material> = Vec::new();
    let mut objects = String::new();
    for object in &scene.objects {
        let number = names.iter().position(|&known| *known == object.material);
        let number = number.unwrap_or_else(|| {
            names.push(&object.material);
            names.len() - 1
        });
        let _ = writeln!(objects, "        {},", object_text(object, number, files));
    }
    let mut materials = String::new();
    for (number, known) in names.iter().enumerate() {
        let _ = writeln!(materials, "        \"m{number}\": {},", material(known, files));
    }
    let lights: Vec<String> = scene
        .lights
        .iter()
        .map(|l| {
            format!(
                "        {},
",
                light(l)
            )
        })
        .collect();
    let lights = lights.concat();
    format!(
        "(\n    {},\n    materials: {{\n{materials}    }},\n    objects: [\n{objects}    ],\n    \
         lights: [\n{lights}    ],\n)\n",
        camera(&scene.camera),
    )
}

fn camera(camera: &Camera) -> String {
    let [position, target, up] = [camera.position, camera.target, camera.up].map(vector);
    let (fov, pixels) = (camera.fov, camera.pixels);
    format!(
        "camera: (position: {position}, target: {target}, up: {up}, fov: {fov}, \
         resolution: ({pixels}, {pixels}))"
    )
}

/// Three numbers, as short as they can be read back to the last bit.
pub(super) fn vector(v: Vec3) -> String {
    format!("({}, {}, {})", v.x, v.y, v.z)
}

fn object_text(object: &Object, material: usize, files: &mut Files) -> String {
    let mut text = format!("(shape: {}, material: \"m{material}\"", shape(&object.shape, files));
    if object.is_lamp() {
        let _ = write!(text, ", emission: {}", vector(object.emission));
    }
    // A file of shapes has a word of its own on sides.
    if object.sides == Sides::Front {
        text += ", sides: Front";
    }
    text + ")"
}

fn shape(shape: &Shape, files: &mut Files) -> String {
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
        Shape::Disk { .. } | Shape::Cone { .. } | Shape::Mesh(_) => {
            format!("Mesh(file: \"{}\")", files.add("mgf", super::mgf::single(shape).into_bytes()))
        }
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
    if let Some(Relief { map, height }) = &material.bump {
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
