//! Scenes that are one step simpler.

use crate::relations::scene::sides_of_box;
use crate::relations::scene::{
    Camera, DrawnScene, Light, Material, Mesh, Object, Picture, Shape, Sky,
};
use traylib_geometry::Sides;
use traylib_math::Vec3;

/// All of them, the greatest steps first.
pub(super) fn than(scene: &DrawnScene) -> Vec<DrawnScene> {
    let mut simpler = Vec::new();
    for index in 0..scene.objects.len() {
        let mut without = scene.clone();
        without.objects.remove(index);
        simpler.push(without);
    }
    for index in 0..scene.lights.len() {
        let mut without = scene.clone();
        without.lights.remove(index);
        simpler.push(without);
    }
    if let Some(sky) = &scene.sky {
        simpler.push(DrawnScene { sky: None, ..scene.clone() });
        let even = Sky::even(sky.texels[0]);
        simpler.push(DrawnScene { sky: Some(even), ..scene.clone() });
    }
    let shorter = 1..scene.max_depth.unwrap_or(4);
    simpler.extend(shorter.map(|depth| DrawnScene { max_depth: Some(depth), ..scene.clone() }));
    for (index, object) in scene.objects.iter().enumerate() {
        for object in plainer(object) {
            let mut changed = scene.clone();
            changed.objects[index] = object;
            simpler.push(changed);
        }
    }
    for digits in [0, 1, 2, 3] {
        simpler.push(DrawnScene { camera: rounded_camera(&scene.camera, digits), ..scene.clone() });
        for (index, object) in scene.objects.iter().enumerate() {
            let mut changed = scene.clone();
            changed.objects[index] = object.with_shape(rounded(&object.shape, digits));
            simpler.push(changed);
        }
        for (index, light) in scene.lights.iter().enumerate() {
            let mut changed = scene.clone();
            let position = round(light.position, digits);
            changed.lights[index] =
                Light { position, intensity: round(light.intensity, digits), ..*light };
            simpler.push(changed);
        }
    }
    let kind =
        |scene: &DrawnScene| [scene.is_clear(), scene.fronts_are_alike(), scene.glass_is_solid()];
    let of_scene = kind(scene);
    simpler.retain(|candidate| {
        // What relations leave out must not come in by the back door.
        let keeps = kind(candidate).iter().zip(of_scene).all(|(&new, old)| new || !old);
        candidate != scene && can_be_seen(candidate) && keeps
    });
    simpler
}

fn can_be_seen(scene: &DrawnScene) -> bool {
    let shines = !scene.lights.is_empty()
        || scene.sky.is_some()
        || scene.objects.iter().any(Object::is_light);
    let Camera { position, target, up, fov, .. } = scene.camera;
    shines && !scene.objects.is_empty() && (target - position).cross(up) != Vec3::ZERO && fov > 0.0
}

/// Materials without pictures or of one number, light of one colour, fewer
/// triangles.
fn plainer(object: &Object) -> Vec<Object> {
    let with = |material: Material| Object { material, ..object.clone() };
    let mut plainer = vec![
        with(Material::grey(0.0)),
        with(Material::grey(0.5)),
        with(Material::plain(object.material.base)),
        with(Material { diffuse: None, ..object.material.clone() }),
        with(Material { specular: None, ..object.material.clone() }),
        with(Material { bump: None, ..object.material.clone() }),
        with(Material { opacity: None, ..object.material.clone() }),
        Object { sides: Sides::Both, ..object.clone() },
    ];
    // What is black is not made grey again.
    plainer.retain(|plain| {
        object.material != Material::grey(0.0) || plain.material == object.material
    });
    if let Some(map) = &object.material.opacity {
        let texels = vec![[128; 3]];
        let picture =
            Picture::Texels { width: 1, texels, coding: crate::relations::scene::Coding::Hdr };
        if map.picture != picture {
            let opacity = Some(crate::relations::scene::Map::of(picture));
            plainer.push(with(Material { opacity, ..object.material.clone() }));
        }
    }
    if object.is_light() {
        plainer.push(Object { emission: Vec3::ZERO, ..object.clone() });
        plainer.push(Object { emission: Vec3::ONE, ..object.clone() });
    }
    plainer.extend(fewer(&object.shape).into_iter().map(|shape| object.with_shape(shape)));
    plainer
}

fn fewer(shape: &Shape) -> Vec<Shape> {
    match shape {
        Shape::Mesh(mesh) => fewer_triangles(mesh),
        Shape::Box(_) => sides_of_box(shape),
        &Shape::Quad([corner, u, v]) => {
            vec![Shape::Triangle([corner, corner + u, corner + v])]
        }
        &Shape::Disk { centre, normal, inner, radius } if inner > 0.0 => {
            vec![Shape::Disk { centre, normal, inner: 0.0, radius }]
        }
        &Shape::Cone { ends, radii: [a, b], inward } => {
            let mut fewer = vec![Shape::Cone { ends, radii: [a, a], inward }];
            if inward {
                fewer.push(Shape::Cone { ends, radii: [a, b], inward: false });
            }
            fewer
        }
        Shape::Disk { .. } | Shape::Sphere { .. } | Shape::Triangle(_) => Vec::new(),
    }
}

fn fewer_triangles(mesh: &Mesh) -> Vec<Shape> {
    let mut fewer = Vec::new();
    let with = |triangles: Vec<[u32; 3]>| Shape::Mesh(Mesh { triangles, ..mesh.clone() });
    if mesh.normals.is_some() {
        fewer.push(Shape::Mesh(Mesh { normals: None, ..mesh.clone() }));
    }
    if mesh.uvs.is_some() {
        fewer.push(Shape::Mesh(Mesh { uvs: None, ..mesh.clone() }));
    }
    if mesh.triangles.len() == 1 {
        fewer.extend(mesh.corners().map(Shape::Triangle));
        return fewer;
    }
    let half = mesh.triangles.len() / 2;
    fewer.push(with(mesh.triangles[..half].to_vec()));
    fewer.push(with(mesh.triangles[half..].to_vec()));
    for index in 0..mesh.triangles.len() {
        let mut triangles = mesh.triangles.clone();
        triangles.remove(index);
        fewer.push(with(triangles));
    }
    fewer
}

fn rounded_camera(camera: &Camera, digits: i32) -> Camera {
    Camera {
        position: round(camera.position, digits),
        target: round(camera.target, digits),
        fov: round_number(camera.fov, 0).max(1.0),
        ..*camera
    }
}

fn rounded(shape: &Shape, digits: i32) -> Shape {
    let r = |v: Vec3| round(v, digits);
    let positive = |number: f32| {
        let rounded = round_number(number, digits);
        if rounded > 0.0 { rounded } else { number }
    };
    match shape {
        Shape::Triangle(corners) => Shape::Triangle(corners.map(r)),
        Shape::Quad(parts) => Shape::Quad(parts.map(r)),
        Shape::Box(corners) => Shape::Box(corners.map(r)),
        &Shape::Disk { centre, normal, inner, radius } => {
            let inner = if inner > 0.0 { positive(inner) } else { 0.0 };
            Shape::Disk { centre: r(centre), normal, inner, radius: positive(radius) }
        }
        &Shape::Cone { ends, radii, inward } => {
            let radius = |radius: f32| if radius > 0.0 { positive(radius) } else { 0.0 };
            Shape::Cone { ends: ends.map(r), radii: radii.map(radius), inward }
        }
        &Shape::Sphere { centre, radius, inward } => {
            Shape::Sphere { centre: r(centre), radius: positive(radius), inward }
        }
        Shape::Mesh(mesh) => {
            let positions = mesh.positions.iter().map(|&position| r(position)).collect();
            Shape::Mesh(Mesh { positions, ..mesh.clone() })
        }
    }
}

fn round(v: Vec3, digits: i32) -> Vec3 {
    Vec3::from_array(v.to_array().map(|number| round_number(number, digits)))
}

/// To so many digits after the point; large numbers to as many in all.
fn round_number(number: f32, digits: i32) -> f32 {
    let unit = 10.0_f64.powi(digits);
    let rounded = ((f64::from(number) * unit).round() / unit) as f32;
    // No minus before a zero.
    rounded + 0.0
}
