//! What a 3DS file has and an imported mesh has not.

use crate::three_ds::Document;

/// What is skipped, with counts.
pub(super) fn skipped(document: &Document) -> Vec<(String, u32)> {
    let Document { meshes, materials, lights, cameras, keyframer, .. } = document;
    let boxes = meshes.iter().filter(|mesh| !mesh.box_map.is_empty()).count();
    let maps = boxes + materials.iter().map(|m| m.maps.len()).sum::<usize>();
    let transparent = materials.iter().filter(|m| m.transparency > 0.0).count();
    let glowing = materials.iter().filter(|m| m.glow() > 0.0).count();
    let counts = [
        (maps, "texture or other map skipped (maps are not read)"),
        (transparent, "transparency skipped (surfaces are opaque)"),
        (glowing, "self-illumination skipped (it has no unit)"),
        (lights.len(), "light skipped (lights are not read)"),
        (cameras.len(), "camera skipped (cameras are not read)"),
        (usize::from(keyframer.is_some()), "keyframer section skipped (animation is not read)"),
    ];
    let met = counts.into_iter().filter(|&(count, _)| count > 0);
    met.map(|(count, what)| (what.to_string(), count as u32)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::three_ds::{Keyframer, Map, MapKind, Material};

    #[test]
    fn only_what_is_there_is_said_to_be_skipped() {
        assert_eq!(skipped(&Document::default()), []);
        let maps = vec![(MapKind::Bump, Map::default()), (MapKind::Texture1, Map::default())];
        let material = Material { maps, transparency: 0.5, ..Material::default() };
        let keyframer = Some(Keyframer::default());
        let document = Document { materials: vec![material], keyframer, ..Document::default() };
        let expected = [
            ("texture or other map skipped (maps are not read)".to_string(), 2),
            ("transparency skipped (surfaces are opaque)".to_string(), 1),
            ("keyframer section skipped (animation is not read)".to_string(), 1),
        ];
        assert_eq!(skipped(&document), expected);
    }
}
