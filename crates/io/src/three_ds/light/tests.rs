use super::super::tests::writer::{chunk, floats};
use super::*;

fn decoded(numbers: &[f32], chunks: &[Vec<u8>]) -> (Option<Light>, Warnings) {
    let mut warnings = Warnings::default();
    let bytes = [floats(numbers), chunks.concat()].concat();
    (decode("lamp".to_string(), Reader::new(&bytes), &mut warnings), warnings)
}

fn number(id: u16, value: f32) -> Vec<u8> {
    chunk(id, &[&floats(&[value])])
}

#[test]
fn a_light_to_all_sides() {
    let (light, warnings) = decoded(&[1.0, 2.0, 3.0], &[]);
    let light = light.unwrap();
    assert_eq!(light, Light::new("lamp".to_string(), Vec3::new(1.0, 2.0, 3.0)));
    assert!(light.on && light.direction().is_none());
    assert_eq!(warnings, Warnings::default());
}

#[test]
fn what_a_light_can_say() {
    let chunks = [
        chunk(0x0010, &[&floats(&[0.5, 0.25, 1.0])]),
        chunk(0x4620, &[]),
        chunk(0x4625, &[]),
        chunk(0x4654, &[b"floor\0"]),
        chunk(0x4654, &[b"wall\0"]),
        number(0x4659, 10.0),
        number(0x465a, 80.0),
        number(0x465b, -1.5),
    ];
    let light = decoded(&[0.0; 3], &chunks).0.unwrap();
    assert_eq!(light.colour, Rgb::new(0.5, 0.25, 1.0));
    assert!(!light.on && light.attenuated);
    assert_eq!((light.inner_range, light.outer_range, light.multiplier), (10.0, 80.0, -1.5));
    assert_eq!(light.excluded, ["floor", "wall"]);
}

#[test]
fn what_a_spot_light_can_say() {
    let inside = [
        number(0x4656, 15.0),
        number(0x4657, 2.0),
        chunk(0x4651, &[]),
        chunk(0x4652, &[]),
        chunk(0x4653, &[b"GOBO.TGA\0"]),
        chunk(0x4627, &[]),
        number(0x4658, 0.2),
        chunk(0x4641, &[&floats(&[1.0, 3.0]), &[0, 2]]),
    ];
    let body = floats(&[0.0, 0.0, -4.0, 40.0, 55.0]);
    let light = decoded(&[0.0; 3], &[chunk(0x4610, &[&body, &inside.concat()])]).0.unwrap();
    assert_eq!(light.direction(), Some(Vec3::NEG_Z));
    let shadow = Shadow { ray_traced: true, ray_bias: Some(0.2), map: Some((1.0, 3.0, 512)) };
    let expected = Spot {
        target: Vec3::new(0.0, 0.0, -4.0),
        hotspot_degrees: 40.0,
        falloff_degrees: 55.0,
        roll_degrees: 15.0,
        rectangular: true,
        aspect: 2.0,
        overshoot: true,
        projector: Some("GOBO.TGA".to_string()),
        shadow: Some(shadow),
    };
    assert_eq!(light.spot, Some(expected));
}

#[test]
fn damaged_lights_lose_what_is_damaged() {
    let chunks = [
        chunk(0x0010, &[&floats(&[f32::NAN, 0.0, 0.0])]),
        chunk(0x4610, &[&floats(&[0.0; 4])]),
        number(0x465b, f32::INFINITY),
    ];
    let (light, warnings) = decoded(&[0.0; 3], &chunks);
    assert_eq!(light.unwrap(), Light::new("lamp".to_string(), Vec3::ZERO));
    let kinds =
        [WarningKind::ColourNotFinite, WarningKind::RecordCut, WarningKind::NumberNotFinite];
    assert_eq!(kinds.map(|kind| warnings.count(&kind)), [1; 3]);
    for numbers in [&[0.0, 1.0][..], &[0.0, f32::NAN, 0.0]] {
        let (light, warnings) = decoded(numbers, &[]);
        assert_eq!((light, warnings.count(&WarningKind::LightWithoutPlace)), (None, 1));
    }
}
