//! Pictures of one colour in place of numbers.

use crate::relations::scene::{Base, Coding, DrawnScene, Map, Material, Picture};
use traylib_math::Vec3;

/// The scene with the diffuse colours of what shows pictures in 256ths, and the same
/// with these colours as pictures; `None` if nothing does.
pub fn colours_as_pictures(scene: &DrawnScene) -> Option<(DrawnScene, DrawnScene)> {
    both(scene, |material| {
        let Base::Lambert(colour) = material.base else { return None };
        let picture = of_one_colour(colour)?;
        let rounded = Material::plain(Base::Lambert(value(&picture)));
        // What is below a picture of full strength is not to be seen.
        let hidden = Base::Lambert(Vec3::splat(0.25));
        Some([rounded, Material { diffuse: Some(Map::of(picture)), ..Material::plain(hidden) }])
    })
}

/// The scene with what panes let through in grey 256ths, and the same with mirrors in
/// place of panes, of which as much is not there; `None` if there are none.
pub fn panes_as_holes(scene: &DrawnScene) -> Option<(DrawnScene, DrawnScene)> {
    both(scene, |material| {
        let Base::Pane(mirrored, through) = material.base else { return None };
        let picture = of_one_colour(Vec3::splat(1.0 - through.x))?;
        let there = value(&picture).x;
        let mirrored = mirrored.min(Vec3::splat(0.9 * there));
        let pane = Material::plain(Base::Pane(mirrored, Vec3::splat(1.0 - there)));
        let mirror = Material::plain(Base::Mirror(mirrored / there, Vec3::ZERO));
        Some([pane, Material { opacity: Some(Map::of(picture)), ..mirror }])
    })
}

/// Both forms of each material that has them, on shapes where pictures lie.
fn both(
    scene: &DrawnScene,
    forms: impl Fn(&Material) -> Option<[Material; 2]>,
) -> Option<(DrawnScene, DrawnScene)> {
    let (mut plain, mut pictured) = (scene.clone(), scene.clone());
    let mut any = false;
    for (index, object) in scene.objects.iter().enumerate() {
        if object.material.has_maps() || !object.shape.shows_pictures() {
            continue;
        }
        if let Some([number, picture]) = forms(&object.material) {
            plain.objects[index].material = number;
            pictured.objects[index].material = picture;
            any = true;
        }
    }
    any.then_some((plain, pictured))
}

/// `None` for black, which needs no picture, and for what one picture cannot hold.
fn of_one_colour(colour: Vec3) -> Option<Picture> {
    let texel = colour.to_array().map(|band| (band * 256.0).round().min(255.0) as u8 & !1);
    let texels = vec![texel];
    (texel != [0; 3]).then_some(Picture::Texels { width: 1, texels, coding: Coding::Hdr })
}

fn value(picture: &Picture) -> Vec3 {
    match picture {
        Picture::Texels { texels, .. } => {
            Vec3::from_array(texels[0].map(|band| f32::from(band) / 256.0))
        }
        Picture::File { .. } => Vec3::ONE,
    }
}
