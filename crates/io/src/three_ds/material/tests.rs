use super::super::tests::writer::{chunk, floats};
use super::*;

fn decoded(chunks: &[Vec<u8>]) -> Material {
    let mut warnings = Warnings::default();
    let mut remaining = Remaining::new(crate::three_ds::Limits::default());
    let material = decode(Reader::new(&chunks.concat()), &mut warnings, &mut remaining);
    assert_eq!(warnings, Warnings::default());
    material
}

fn percent(id: u16, value: u8) -> Vec<u8> {
    chunk(id, &[&chunk(0x0030, &[&[value, 0]])])
}

#[test]
fn what_is_left_out_is_the_default() {
    assert_eq!(decoded(&[]), Material::default());
    // A diffuse colour chunk without a colour in it.
    assert_eq!(decoded(&[chunk(0xa020, &[])]), Material::default());
}

#[test]
fn every_fraction_has_its_place() {
    let ids = [0xa040, 0xa041, 0xa050, 0xa052, 0xa053, 0xa084, 0xa252];
    let chunks: Vec<_> = ids.iter().zip(1..).map(|(&id, value)| percent(id, value)).collect();
    let m = decoded(&chunks);
    let plain = [m.shininess, m.shininess_strength, m.transparency, m.transparency_falloff];
    assert_eq!(plain, [0.01, 0.02, 0.03, 0.04]);
    assert_eq!(
        (m.reflection_blur, m.self_illumination, m.bump_amount),
        (0.05, Some(0.06), Some(0.07))
    );
}

#[test]
fn colours_and_marks() {
    let colour = |id, bands: [u8; 3]| chunk(id, &[&chunk(0x0011, &[&bands])]);
    let m = decoded(&[
        colour(0xa010, [255, 0, 0]),
        colour(0xa020, [0, 255, 0]),
        colour(0xa030, [0, 0, 255]),
        chunk(0xa081, &[]),
        chunk(0xa085, &[]),
        chunk(0xa087, &[&floats(&[2.5])]),
        chunk(0xa100, &[&[4, 0]]),
    ]);
    let colours = [m.ambient, m.diffuse, m.specular].map(Rgb::to_array);
    assert_eq!(colours, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert!(m.two_sided && m.flags.wire && !m.flags.decal);
    assert_eq!((m.wire_size, m.shading), (2.5, Shading::Metal));
}

#[test]
fn an_old_mark_shines_fully_and_a_percentage_as_it_says() {
    assert_eq!(decoded(&[]).glow(), 0.0);
    assert_eq!(decoded(&[chunk(0xa080, &[])]).glow(), 1.0);
    assert_eq!(decoded(&[chunk(0xa080, &[]), percent(0xa084, 30)]).glow(), 0.3);
}

#[test]
fn a_map_with_all_it_can_say() {
    let number = |id, value| chunk(id, &[&floats(&[value])]);
    let parts = [
        chunk(0x0030, &[&[75, 0]]),
        chunk(0xa300, &[b"C:\\MAPS\\WALL.GIF\0"]),
        chunk(0xa351, &[&[0x11, 0]]),
        number(0xa353, 0.07),
        number(0xa354, 2.0),
        number(0xa356, 0.0),
        number(0xa358, 0.25),
        number(0xa35a, -0.5),
        number(0xa35c, 30.0),
        chunk(0xa362, &[&[255, 0, 0]]),
    ];
    let parts = parts.concat();
    let m = decoded(&[chunk(0xa230, &[&parts]), chunk(0xa344, &[&parts])]);
    let map = m.map(MapKind::Bump).unwrap();
    assert_eq!((map.file_name(), map.strength, map.flags), ("WALL.GIF", 0.75, 0x11));
    assert_eq!((map.scale.to_array(), map.offset.to_array()), ([2.0, 1.0], [0.25, -0.5]));
    assert_eq!((map.blur, map.rotation_degrees), (0.07, 30.0));
    assert_eq!(map.tints, [None, Some(Rgb::new(1.0, 0.0, 0.0)), None, None, None]);
    assert_eq!(m.masks, m.maps);
    assert_eq!(m.map(MapKind::Opacity), None);
}

#[test]
fn the_last_map_of_a_kind_counts() {
    let named = |name: &[u8]| chunk(0xa200, &[&chunk(0xa300, &[name, &[0]])]);
    let m = decoded(&[named(b"a"), named(b"b")]);
    assert_eq!(m.maps.len(), 1);
    assert_eq!(m.map(MapKind::Texture1).unwrap().file, "b");
}
