//! Lights and cameras of real files.

use super::super::super::Light;
use super::expected::{check, expectations, find, folder, get, list_of, text_of};
use ron::Value;

#[test]
fn every_light_and_camera_agrees() {
    let Some(folder) = folder() else { return };
    for (name, document, expected) in expectations(&folder) {
        let detail = get(&expected, "detail");
        let (lights, cameras) = (list_of(get(detail, "lights")), list_of(get(detail, "cameras")));
        assert_eq!((document.lights.len(), document.cameras.len()), (lights.len(), cameras.len()));
        for (light, expected) in document.lights.iter().zip(lights) {
            check_light(&name, light, expected);
        }
        for (camera, expected) in document.cameras.iter().zip(cameras) {
            assert_eq!(camera.name, text_of(get(expected, "name")));
            check(&name, &camera.position.to_array(), get(expected, "position"));
            check(&name, &camera.target.to_array(), get(expected, "target"));
            check(&name, &[camera.roll_degrees], get(expected, "roll"));
            check(&name, &[camera.lens], get(expected, "lens"));
        }
    }
}

fn check_light(name: &str, light: &Light, expected: &Value) {
    assert_eq!(light.name, text_of(get(expected, "name")));
    check(name, &light.position.to_array(), get(expected, "position"));
    check(name, &light.colour.to_array(), get(expected, "color"));
    check(name, &[light.multiplier], get(expected, "multiplier"));
    check(name, &[light.inner_range], get(expected, "inner"));
    check(name, &[light.outer_range], get(expected, "outer"));
    assert_eq!(light.on, find(expected, "off").is_none(), "{name}");
    assert_eq!(light.attenuated, find(expected, "attenuate").is_some(), "{name}");
    assert_eq!(*get(expected, "spot"), Value::Bool(light.spot.is_some()), "{name}");
    if let Some(spot) = &light.spot {
        let angles = [spot.hotspot_degrees, spot.falloff_degrees];
        check(name, &[&spot.target.to_array()[..], &angles].concat(), get(expected, "spot_data"));
    }
}
