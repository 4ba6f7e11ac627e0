use super::*;
use crate::{Lambert, Material, Phong};
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

/// Colours are linear in what a picture shows: a mean of them is the colour of the mean.
#[test]
fn an_averaged_material_has_the_mean_colour_and_its_bumps() {
    let model = SurfaceModel::Lambert(Lambert::new(Rgb::splat(0.2)).unwrap());
    let diffuse = Some(Layer { strength: 0.5, ..layer([0.9, 0.1, 0.4, 0.2]) });
    let bump = Some(Bump { layer: layer([0.0, 1.0, 0.0, 1.0]), height: 0.1 });
    let maps = Maps { diffuse, bump: bump.clone(), ..Maps::default() };
    let material = Material { maps: Some(Box::new(maps)), ..Material::from(model) };
    let shown = |material: &Material, u| {
        let site = Site { uv: place(u), tangents: None };
        let SurfaceModel::Lambert(shown) = material.at(Vec3::Z, || Some(site)).model else {
            panic!()
        };
        shown.reflectance().g
    };
    let mean = (0..64).map(|i| shown(&material, (i as f32 + 0.5) / 64.0)).sum::<f32>() / 64.0;
    let averaged = material.averaged();
    assert!((shown(&averaged, 0.3) - mean).abs() < 1e-6, "{mean}");
    assert_eq!(averaged.maps, Some(Box::new(Maps { bump, ..Maps::default() })));
    assert!(material.has_pictures() && !averaged.has_pictures());
    assert!(averaged.has_bumps() && !averaged.without_bumps().has_bumps());
    assert_eq!(averaged.without_bumps().maps, None);
}

/// A hole has its mean opacity, and a picture that is there once keeps its edges.
#[test]
fn averaged_pictures_stay_where_they_were() {
    let once = Layer { tiling: Tiling::Once, ..layer([1.0, 0.0, 0.0, 1.0]) };
    let maps = Maps { opacity: Some(once), ..Maps::default() };
    let model = SurfaceModel::Lambert(Lambert::BLACK);
    let material = Material { maps: Some(Box::new(maps)), ..Material::from(model) }.averaged();
    let opacity = |u| material.opacity(|| Some(Site { uv: place(u), tangents: None }));
    assert_eq!([opacity(0.1), opacity(0.5), opacity(1.5)], [0.5, 0.5, 1.0]);
}
