//! Meshes and materials of real files.

use super::super::super::{Document, MapKind, Material, Mesh};
use super::expected::{check, expectations, find, folder, get, list_of, numbers, text_of};
use ron::Value;

#[test]
fn every_mesh_agrees() {
    let Some(folder) = folder() else { return };
    for (name, document, expected) in expectations(&folder) {
        let expected = list_of(get(get(&expected, "detail"), "meshes"));
        assert_eq!(document.meshes.len(), expected.len(), "{name}");
        for (mesh, expected) in document.meshes.iter().zip(expected) {
            check_mesh(&format!("{name}: {}", mesh.name), mesh, expected, &document);
        }
    }
}

fn check_mesh(name: &str, mesh: &Mesh, expected: &Value, document: &Document) {
    assert_eq!(mesh.name, text_of(get(expected, "name")));
    check(name, &[mesh.vertices.len() as f32], get(expected, "vertices"));
    check(name, &[(mesh.faces.len() + mesh.dropped_faces) as f32], get(expected, "faces"));
    check(name, &[mesh.uvs.len() as f32], get(expected, "uvs"));
    if let Some(axes) = find(expected, "matrix") {
        check(name, &mesh.axes.unwrap().map(|axis| axis.to_array()).concat(), axes);
        check(name, &[mesh.local_to_world().determinant() as f32], get(expected, "matrix_det"));
    }
    let materials = find(expected, "materials").map_or(&[][..], list_of);
    let materials: Vec<String> = materials.iter().map(text_of).collect();
    for face in &mesh.faces {
        let named = face.material.map(|index| &document.materials[index].name);
        assert!(named.is_none_or(|named| materials.contains(named)), "{name}: {named:?}");
    }
    // Of dropped faces neither masks nor materials are kept.
    if mesh.dropped_faces == 0 {
        let without = mesh.faces.iter().filter(|face| face.material.is_none()).count();
        let smooth = mesh.faces.iter().filter(|face| face.smoothing != 0).count();
        for (key, found) in [("unassigned_faces", without), ("smoothing_nonzero", smooth)] {
            let expected = find(expected, key).map_or(0.0, |value| numbers(value)[0]);
            assert_eq!(found as f64, expected, "{name}: {key}");
        }
    }
}

#[test]
fn every_material_agrees() {
    let Some(folder) = folder() else { return };
    for (name, document, expected) in expectations(&folder) {
        let expected = list_of(get(get(&expected, "detail"), "materials"));
        assert_eq!(document.materials.len(), expected.len(), "{name}");
        for (material, expected) in document.materials.iter().zip(expected) {
            check_material(&format!("{name}: {}", material.name), material, expected);
        }
    }
}

/// Compares a material with its list. Properties that are not stored are not in the list, so only
/// those there are compared.
fn check_material(name: &str, material: &Material, expected: &Value) {
    assert_eq!(material.name, text_of(get(expected, "name")));
    let stored = [
        ("ambient", material.ambient.to_array().to_vec()),
        ("diffuse", material.diffuse.to_array().to_vec()),
        ("specular", material.specular.to_array().to_vec()),
        ("shininess", vec![material.shininess]),
        ("shin_strength", vec![material.shininess_strength]),
        ("transparency", vec![material.transparency]),
        ("falloff", vec![material.transparency_falloff]),
        ("refblur", vec![material.reflection_blur]),
        ("self_illum_pct", material.self_illumination.into_iter().collect()),
        ("shading", vec![f32::from(material.shading as u8)]),
    ];
    for (key, found) in stored {
        if let Some(expected) = find(expected, key) {
            check(&format!("{name}: {key}"), &found, expected);
        }
    }
    assert_eq!(material.two_sided, find(expected, "two_sided").is_some(), "{name}");
    assert_eq!(material.self_illuminated, find(expected, "self_illum_flag").is_some(), "{name}");
    check_maps(name, material, get(expected, "maps"));
}

const MAPS: [(MapKind, &str); 8] = [
    (MapKind::Texture1, "texture1"),
    (MapKind::Texture2, "texture2"),
    (MapKind::Opacity, "opacity"),
    (MapKind::Bump, "bump"),
    (MapKind::Specular, "specular"),
    (MapKind::Shininess, "shininess"),
    (MapKind::SelfIllumination, "self_illum"),
    (MapKind::Reflection, "reflection"),
];

fn check_maps(name: &str, material: &Material, expected: &Value) {
    for (kind, key) in MAPS {
        let (found, expected) = (material.map(kind), find(expected, key));
        assert_eq!(found.is_some(), expected.is_some(), "{name}: {key}");
        let Some((map, expected)) = found.zip(expected) else { continue };
        assert_eq!(map.file, text_of(get(expected, "file")), "{name}");
        let stored = [
            ("amount", map.strength),
            ("tiling", f32::from(map.flags)),
            ("u_scale", map.scale.x),
            ("v_scale", map.scale.y),
            ("u_offset", map.offset.x),
            ("v_offset", map.offset.y),
            ("rotation", map.rotation_degrees),
        ];
        for (key, found) in stored {
            if let Some(expected) = find(expected, key) {
                check(&format!("{name}: {key}"), &[found], expected);
            }
        }
    }
}
