//! What a 3DS file has and a scene has not.

use crate::three_ds::{Document, Light};

/// What is skipped, with counts.
pub(super) fn skipped(document: &Document) -> Vec<(&'static str, u32)> {
    let Document { meshes, lights, keyframer, .. } = document;
    let boxes = meshes.iter().filter(|mesh| !mesh.box_map.is_empty()).count();
    let count = |wanted: fn(&Light) -> bool| lights.iter().filter(|&light| wanted(light)).count();
    let counts = [
        (boxes, "map of the sides of a box skipped"),
        (count(|light| light.attenuated), "range of a light skipped, it shines on"),
        (count(|light| !light.excluded.is_empty()), "light that spares objects shines on all"),
        (count(|light| light.multiplier < 0.0), "light that takes light away skipped"),
        (count(is_odd_spot), "projector, rectangle or overshoot of a spot light skipped"),
        (usize::from(keyframer.is_some()), "animation skipped, everything stands as stored"),
    ];
    let met = counts.into_iter().filter(|&(count, _)| count > 0);
    met.map(|(count, what)| (what, count as u32)).collect()
}

fn is_odd_spot(light: &Light) -> bool {
    let spot = light.spot.as_ref();
    spot.is_some_and(|spot| spot.projector.is_some() || spot.rectangular || spot.overshoot)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::three_ds::{Keyframer, Mesh};

    #[test]
    fn only_what_is_there_is_said_to_be_skipped() {
        assert_eq!(skipped(&Document::default()), []);
        let mesh = Mesh { box_map: vec![String::new()], ..Mesh::default() };
        let keyframer = Some(Keyframer::default());
        let document = Document { meshes: vec![mesh], keyframer, ..Document::default() };
        let expected = [
            ("map of the sides of a box skipped", 1),
            ("animation skipped, everything stands as stored", 1),
        ];
        assert_eq!(skipped(&document), expected);
    }
}
