//! Warnings about what a 3DS file has and a scene has not.

use crate::three_ds::{Document, Light, Motion};

/// Lists the kinds of things that are skipped, with counts.
pub(super) fn skipped(document: &Document) -> Vec<(String, u32)> {
    let Document { meshes, lights, .. } = document;
    let boxes = meshes.iter().filter(|mesh| !mesh.box_map.is_empty()).count();
    let count = |wanted: fn(&Light) -> bool| lights.iter().filter(|&light| wanted(light)).count();
    let counts = [
        (boxes, "map of the sides of a box skipped"),
        (count(|light| light.attenuated), "range of a light skipped, it shines on"),
        (count(|light| !light.excluded.is_empty()), "light that spares objects shines on all"),
        (count(|light| light.multiplier < 0.0), "light that takes light away skipped"),
        (count(is_odd_spot), "projector, rectangle or overshoot of a spot light skipped"),
    ];
    let met = counts.into_iter().filter(|&(count, _)| count > 0);
    let met = met.map(|(count, what)| (what.to_string(), count as u32));
    let once = |what: String| (what, 1);
    met.chain(motion(Motion::of(document)).map(once)).chain(scale(document).map(once)).collect()
}

fn is_odd_spot(light: &Light) -> bool {
    let spot = light.spot.as_ref();
    spot.is_some_and(|spot| spot.projector.is_some() || spot.rectangular || spot.overshoot)
}

fn motion(Motion { changing_nodes: nodes, shift }: Motion) -> Option<String> {
    let over_time = match nodes {
        0 => None,
        1 => Some("1 node moves or changes over time".to_string()),
        _ => Some(format!("{nodes} nodes move or change over time")),
    };
    let at_start =
        (shift > 0.0).then(|| format!("frame 0 has vertices up to {shift} units elsewhere"));
    let what: Vec<String> = over_time.into_iter().chain(at_start).collect();
    let what = what.join(", ");
    (!what.is_empty()).then(|| format!("animation skipped, everything stands as stored: {what}"))
}

/// Programs disagree on whether it multiplies, divides, or is for display alone.
fn scale(document: &Document) -> Option<String> {
    let scale = document.master_scale.filter(|&scale| scale != 1.0 && scale > 0.0)?;
    Some(format!(
        "master scale {scale} not applied, a unit stays 1 m: a scene file can have `scale: {scale}`"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::three_ds::Mesh;

    #[test]
    fn only_what_is_there_is_said_to_be_skipped() {
        assert_eq!(skipped(&Document::default()), []);
        let mesh = Mesh { box_map: vec![String::new()], ..Mesh::default() };
        let document =
            Document { meshes: vec![mesh], master_scale: Some(0.5), ..Document::default() };
        let expected = [
            "map of the sides of a box skipped",
            "master scale 0.5 not applied, a unit stays 1 m: a scene file can have `scale: 0.5`",
        ];
        assert_eq!(skipped(&document), expected.map(|what| (what.to_string(), 1)));
    }

    #[test]
    fn motion_is_told_with_how_much_of_it() {
        let said = |changing_nodes, shift| motion(Motion { changing_nodes, shift });
        assert_eq!(said(0, 0.0), None);
        let both = "animation skipped, everything stands as stored: 2 nodes move or change over \
                    time, frame 0 has vertices up to 1.5 units elsewhere";
        assert_eq!(said(2, 1.5).as_deref(), Some(both));
        assert!(said(1, 0.0).unwrap().ends_with(": 1 node moves or changes over time"));
        assert!(said(0, 2.0).unwrap().ends_with(": frame 0 has vertices up to 2 units elsewhere"));
    }
}
