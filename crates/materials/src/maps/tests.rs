use super::*;
use crate::{Lambert, Phong};
use traylib_math::Grid;

fn layer(values: [f32; 4]) -> Layer {
    let pixels = values.map(Rgb::splat).to_vec();
    Layer::new(Arc::new(Texture::new(Grid::from_values(4, 1, pixels).unwrap()).unwrap()))
}

fn place(u: f32) -> Vec2 {
    Vec2::new(u, 0.5)
}

#[test]
fn a_texture_covers_the_diffuse_part_as_far_as_it_is_strong() {
    let lambert = SurfaceModel::Lambert(Lambert::new(Rgb::splat(0.2)).unwrap());
    let half = Layer { strength: 0.5, ..layer([1.0, 0.0, 0.0, 0.0]) };
    let maps = Maps { diffuse: Some(half), ..Maps::default() };
    let SurfaceModel::Lambert(shown) = maps.apply(lambert, place(0.125)) else { panic!() };
    assert!((shown.reflectance().g - 0.6).abs() < 1e-6);
}

#[test]
fn textures_never_reflect_more_than_arrives() {
    let phong = Phong::new(Rgb::splat(0.1), Rgb::splat(0.1), 5.0).unwrap();
    let bright = || Some(layer([3.0, 1.0, 1.0, 1.0]));
    let maps = Maps { diffuse: bright(), specular: bright(), ..Maps::default() };
    let SurfaceModel::Phong(shown) = maps.apply(SurfaceModel::Phong(phong), place(0.125)) else {
        panic!()
    };
    assert_eq!(shown.diffuse() + shown.specular(), Rgb::WHITE);
}

#[test]
fn beyond_a_picture_that_is_there_once_the_base_shows() {
    let once = Layer { tiling: Tiling::Once, ..layer([0.0; 4]) };
    let maps = Maps { opacity: Some(once), ..Maps::default() };
    assert_eq!((maps.opacity(place(0.5)), maps.opacity(place(1.5))), (0.0, 1.0));
}

/// A slope of height along u in a picture over a square of side 2.
#[test]
fn a_bump_map_leans_against_its_slope() {
    // Between the middles of the second and third pixel, height grows by 0.1 on
    // a quarter of u.
    let bump = Bump { layer: layer([0.0, 0.0, 0.1, 0.1]), height: 1.0 };
    let tangents = [Vec3::X * 2.0, Vec3::Y * 2.0];
    let n = bump.normal(Vec3::Z, place(0.5), tangents);
    let expected = Vec3::new(-0.4, 0.0, 1.0).normalize();
    assert!((n - expected).length() < 1e-6, "{n}");
    // The same hill seen on the other face of the surface is a hill there too.
    let below = bump.normal(-Vec3::Z, place(0.5), tangents);
    assert!((below - Vec3::new(-0.4, 0.0, -1.0).normalize()).length() < 1e-6, "{below}");
    // Independent of scale, and level where the picture is.
    for power in [-45, 10, 45] {
        let scaled = tangents.map(|t| t * 2.0_f32.powi(power));
        assert_eq!(bump.normal(Vec3::Z, place(0.5), scaled), n, "2^{power}");
    }
    assert_eq!(bump.normal(Vec3::Z, place(0.75), tangents), Vec3::Z);
}
