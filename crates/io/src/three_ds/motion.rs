//! The part of the animation that a still picture leaves out.

use super::keyframer::{Node, Track, TrackKind, Value};
use super::{Document, Mesh, pose};
use std::collections::HashSet;
use traylib_math::Vec3;

/// Vertices are stored rounded, and their pose is the product of several matrices: real
/// files that stand still are off by 5·10⁻⁵ of their meshes' extent.
const ROUNDING: f32 = 1e-3;

/// The objects that move, counted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Nodes with a track whose value changes.
    pub changing_nodes: usize,
    /// The greatest distance of a vertex in the pose of frame 0 from where it is stored, along x, y
    /// or z, in units of the file; 0 if no further than rounding explains. Further places of a mesh
    /// do not count: they are no motion.
    pub shift: f32,
}

impl Motion {
    /// Looks for what moves in a document.
    pub fn of(document: &Document) -> Self {
        let nodes = document.keyframer.as_ref().map_or(&[][..], |keyframer| &keyframer.nodes);
        let mut placed_before = HashSet::new();
        let first =
            |placed: &pose::Placed| placed.node.is_some() && placed_before.insert(placed.mesh);
        let placed = pose::at_start(document).into_iter().filter(first);
        let shift = |placed: pose::Placed| shift(&document.meshes[placed.mesh], &placed);
        Self {
            changing_nodes: nodes.iter().filter(|node| changes(node)).count(),
            shift: placed.map(shift).fold(0.0, f32::max),
        }
    }

    /// Tells whether nothing moves.
    pub fn is_none(self) -> bool {
        self == Self::default()
    }
}

fn changes(node: &Node) -> bool {
    node.tracks.iter().any(is_changing)
}

fn is_changing(track: &Track) -> bool {
    let Some((first, rest)) = track.keys.split_first() else { return false };
    match track.kind {
        // Turns are from the key before.
        TrackKind::Rotation => rest.iter().any(|key| is_turn(&key.value)),
        // Each key is a change, if it is not there from the start.
        TrackKind::Hide => track.keys.iter().any(|key| key.frame > 0),
        TrackKind::Position
        | TrackKind::Scale
        | TrackKind::FieldOfView
        | TrackKind::Roll
        | TrackKind::Colour
        | TrackKind::Morph
        | TrackKind::Hotspot
        | TrackKind::Falloff => rest.iter().any(|key| key.value != first.value),
    }
}

fn is_turn(value: &Value) -> bool {
    matches!(value, Value::Turn { angle, axis } if *angle != 0.0 && *axis != Vec3::ZERO)
}

fn shift(mesh: &Mesh, placed: &pose::Placed) -> f32 {
    let vertices = || mesh.vertices.iter().copied().filter(|vertex| vertex.is_finite());
    let shifts = vertices().map(|vertex| (placed.place.point(vertex) - vertex).abs().max_element());
    let most = shifts.fold(0.0, f32::max);
    if most > ROUNDING * extent(&vertices().collect::<Vec<_>>()) { most } else { 0.0 }
}

/// Returns the extent of the middle eight tenths of all vertices: real files have a few that belong
/// nowhere, which would hide any motion.
fn extent(vertices: &[Vec3]) -> f32 {
    let range = |axis: usize| {
        let mut values: Vec<f32> = vertices.iter().map(|vertex| vertex[axis]).collect();
        values.sort_unstable_by(f32::total_cmp);
        let aside = values.len() / 10;
        let ends = values.get(aside).zip(values.iter().rev().nth(aside));
        ends.map_or(0.0, |(low, high)| high - low)
    };
    range(0).max(range(1)).max(range(2))
}

#[cfg(test)]
mod tests {
    use super::super::decode;
    use super::super::tests::writer::{
        SQUARE, chunk, faces, floats, node, object, still, track, vertices,
    };
    use super::*;

    /// Returns the motion in a file with a square and these nodes.
    fn of(nodes: &[Vec<u8>]) -> Motion {
        let triangles = [vertices(&SQUARE), faces(&[[0, 1, 2]], &[])].concat();
        let mesh = object(b"square", &[&chunk(0x4100, &[&triangles])]);
        let file = chunk(0x4d4d, &[&mesh, &chunk(0xb000, &[&nodes.concat()])]);
        Motion::of(&decode(&file).unwrap())
    }

    fn square(tracks: &[Vec<u8>]) -> Vec<u8> {
        let tracks: Vec<&[u8]> = tracks.iter().map(Vec::as_slice).collect();
        node(b"square", 0, 0xffff, &tracks)
    }

    /// A track of keys at frames 0, 1, ….
    fn keys(id: u16, values: &[&[f32]]) -> Vec<u8> {
        let key = |(frame, value): (u32, &&[f32])| {
            [&frame.to_le_bytes()[..], &[0; 2], &floats(value)].concat()
        };
        let keys: Vec<_> = (0..).zip(values).map(key).collect();
        chunk(id, &[&track(values.len() as u32, &keys)])
    }

    #[test]
    fn what_stands_still_does_not_move() {
        assert!(of(&[]).is_none());
        let position = keys(0xb020, &[&[0.0; 3], &[0.0; 3]]);
        let rotation = keys(0xb021, &[&[0.0, 0.0, 0.0, 1.0], &[0.0, 0.0, 0.0, 1.0]]);
        assert!(of(&[square(&[position, rotation])]).is_none());
        // Off by no more than rounding.
        assert!(of(&[square(&[still(0xb020, &[5e-5, 0.0, 0.0])])]).is_none());
        // A further place of the mesh.
        let places = [[0.0; 3], [50.0, 0.0, 0.0]].map(|place| square(&[still(0xb020, &place)]));
        assert!(of(&places).is_none());
    }

    #[test]
    fn what_moves_is_measured() {
        let moving = square(&[keys(0xb020, &[&[0.0; 3], &[1.0, 0.0, 0.0]])]);
        assert_eq!(of(&[moving]), Motion { changing_nodes: 1, shift: 0.0 });
        let turning = [[0.0, 0.0, 0.0, 1.0], [0.5, 0.0, 0.0, 1.0]];
        let turning = square(&[keys(0xb021, &[&turning[0], &turning[1]])]);
        assert_eq!(of(&[turning]).changing_nodes, 1);
        let elsewhere = square(&[still(0xb020, &[0.0, -3.0, 0.0])]);
        assert_eq!(of(&[elsewhere]), Motion { changing_nodes: 0, shift: 3.0 });
        let hide = |frame: u8| chunk(0xb029, &[&track(1, &[vec![frame, 0, 0, 0, 0, 0]])]);
        assert_eq!([0, 7].map(|frame| of(&[square(&[hide(frame)])]).changing_nodes), [0, 1]);
    }
}
