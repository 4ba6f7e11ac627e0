//! A closed room with everything that weights must take into account.

use traylib_geometry::{Facing, Primitive, Quad, Sides, Sphere};
use traylib_materials::{
    Dielectric, Lambert, Material, MaxPhong, Mirror, Phong, Sheet, SurfaceModel,
};
use traylib_math::{Grid, Rgb, Vec3};
use traylib_scene::{
    Camera, CameraSettings, MaterialId, Object, ObjectShape, Scene, SceneBuilder, SpotCone,
};

fn wall(corner: Vec3, edge_u: Vec3, edge_v: Vec3) -> Primitive {
    Primitive::Quad(Quad::new(corner, edge_u, edge_v).unwrap())
}

fn ball(centre: Vec3, radius: f32) -> Primitive {
    Primitive::Sphere(Sphere::new(centre, radius, Facing::Outward).unwrap())
}

fn materials(builder: &mut SceneBuilder) -> [MaterialId; 4] {
    let grey = Rgb::splat(0.7);
    let mixed = Mirror::new(Rgb::splat(0.5), Rgb::splat(0.4)).unwrap();
    let gloss = Phong::new(Rgb::splat(0.3), Rgb::splat(0.5), 20.0).unwrap();
    let metal = MaxPhong::new(Rgb::splat(0.9), 200.0).unwrap();
    [
        SurfaceModel::Lambert(Lambert::new(grey).unwrap()),
        SurfaceModel::Mirror(mixed),
        SurfaceModel::Phong(gloss),
        SurfaceModel::MaxPhong(metal),
    ]
    .map(|model| builder.add_material(model))
}

/// What light goes through: a ball of glass, frosted glass, a clear pane that
/// mirrors a little.
fn transparent(builder: &mut SceneBuilder) -> [MaterialId; 3] {
    let part = |kd, ks| Phong::new(Rgb::splat(kd), Rgb::splat(ks), 30.0).unwrap();
    let frosted = Sheet::new(part(0.1, 0.2), part(0.2, 0.4)).unwrap();
    let faint = Mirror::new(Rgb::splat(0.1), Rgb::BLACK).unwrap();
    let pane = Material { through: Rgb::splat(0.8), ..SurfaceModel::Mirror(faint).into() };
    [
        builder.add_material(SurfaceModel::Dielectric(Dielectric::new(1.5).unwrap())),
        builder.add_material(SurfaceModel::Sheet(frosted)),
        builder.add_material(pane),
    ]
}

/// A room 2 × 2 × 2 m: a floor that is half a mirror, a pure mirror, a glossy
/// and a metal ball, three kinds of glass, a spherical lamp, a small quad lamp, a
/// point lamp and a spot light.
pub(crate) fn room() -> Scene {
    let mut builder = empty();
    let grey = furnish(&mut builder);
    add(&mut builder, (wall(Vec3::splat(1.0), -2.0 * Vec3::X, -2.0 * Vec3::Z), grey, Rgb::BLACK));
    builder.build().unwrap()
}

/// The same without a ceiling, under a sky with a sun and a dark half.
pub(crate) fn room_under_sky() -> Scene {
    let mut builder = empty();
    furnish(&mut builder);
    let radiance = |index| match index {
        11 => Rgb::splat(100.0),
        0..32 => Rgb::new(0.5, 1.0, 1.0 + index as f32 / 8.0),
        _ => Rgb::BLACK,
    };
    builder.set_sky(Grid::from_fn(8, 8, radiance), 20.0).unwrap();
    builder.build().unwrap()
}

fn empty() -> SceneBuilder {
    let settings = CameraSettings {
        position: Vec3::new(0.0, 0.1, 0.9),
        target: Vec3::new(0.0, 0.0, -1.0),
        up: Vec3::Y,
        fov_degrees: 80.0,
        width: 32,
        height: 32,
    };
    SceneBuilder::new(Camera::new(settings).unwrap())
}

fn add(builder: &mut SceneBuilder, (primitive, material, emission): (Primitive, MaterialId, Rgb)) {
    let shape = ObjectShape::Primitive(primitive);
    builder.add_object(Object { shape, sides: Sides::Both, material, emission }).unwrap();
}

/// All but the ceiling; what that is made of.
fn furnish(builder: &mut SceneBuilder) -> MaterialId {
    let [grey, mixed, gloss, metal] = materials(builder);
    let mirror = Mirror::new(Rgb::splat(0.9), Rgb::BLACK).unwrap();
    let mirror = builder.add_material(SurfaceModel::Mirror(mirror));
    let [glass, frosted, pane] = transparent(builder);
    let (x, y, z) = (Vec3::X * 2.0, Vec3::Y * 2.0, Vec3::Z * 2.0);
    let (low, high) = (Vec3::splat(-1.0), Vec3::splat(1.0));
    let dark = Rgb::BLACK;
    let parts = [
        (wall(low, z, x), mixed, dark),
        (wall(low, x, y), grey, dark),
        (wall(high, -y, -x), grey, dark),
        (wall(low, y, z), gloss, dark),
        (wall(high, -z, -y), grey, dark),
        (wall(Vec3::new(0.5, -0.8, -0.9), x * 0.2, y * 0.4), mirror, dark),
        (ball(Vec3::new(-0.4, -0.6, -0.3), 0.3), metal, dark),
        (ball(Vec3::new(0.3, -0.7, 0.0), 0.2), gloss, dark),
        (ball(Vec3::new(-0.5, 0.3, -0.6), 0.2), glass, dark),
        (wall(Vec3::new(0.0, -0.4, -0.6), x * 0.2, y * 0.2), frosted, dark),
        (wall(Vec3::new(-0.3, 0.1, 0.1), x * 0.2, y * 0.3), pane, dark),
        (ball(Vec3::new(0.3, 0.6, -0.4), 0.15), grey, Rgb::splat(5.0)),
        (wall(Vec3::new(-0.5, 0.95, -0.5), x * 0.1, z * 0.1), grey, Rgb::splat(20.0)),
    ];
    for part in parts {
        add(builder, part);
    }
    builder.add_point_light(Vec3::new(-0.6, 0.5, 0.3), Rgb::splat(2.0)).unwrap();
    let cone = SpotCone { axis: Vec3::new(0.6, -0.8, 0.0), cos_full: 0.9, cos_dark: 0.6 };
    builder.add_spot_light(Vec3::new(-0.7, 0.8, -0.6), Rgb::splat(8.0), cone).unwrap();
    grey
}
