//! The hierarchy of nodes, and the places that it gives them.

use super::super::affine::Affine;
use super::super::{WarningKind, Warnings};
use super::Node;
use std::collections::HashMap;

/// Finds the parents of all nodes. A parent that does not exist is none; a
/// chain that would come back to itself is opened.
pub(in super::super) fn link(nodes: &mut [Node], warnings: &mut Warnings) {
    let places = places(nodes);
    for node in nodes.iter_mut() {
        node.parent = node.parent_id.and_then(|id| places.get(&id).copied());
        if node.parent_id.is_some() && node.parent.is_none() {
            warnings.add(WarningKind::ParentUnknown);
        }
    }
    open_loops(nodes, warnings);
}

/// The first node of each number.
fn places(nodes: &[Node]) -> HashMap<u16, usize> {
    let mut places = HashMap::new();
    for (place, node) in nodes.iter().enumerate() {
        if let Some(id) = node.id.or_else(|| u16::try_from(place).ok()) {
            places.entry(id).or_insert(place);
        }
    }
    places
}

/// The state of following a node up to its root.
#[derive(Clone, Copy, PartialEq)]
enum Followed {
    No,
    Now,
    Done,
}

fn open_loops(nodes: &mut [Node], warnings: &mut Warnings) {
    let mut state = vec![Followed::No; nodes.len()];
    for start in 0..nodes.len() {
        let mut chain = Vec::new();
        let mut next = Some(start);
        while let Some(place) = next.filter(|&place| state[place] == Followed::No) {
            state[place] = Followed::Now;
            chain.push(place);
            next = nodes[place].parent;
        }
        let comes_back = next.is_some_and(|place| state[place] == Followed::Now);
        if let (true, Some(&last)) = (comes_back, chain.last()) {
            nodes[last].parent = None;
            warnings.add(WarningKind::ParentLoop);
        }
        for place in chain {
            state[place] = Followed::Done;
        }
    }
}

/// From each node's coordinates to the world's at frame 0.
///
/// A node whose numbers leave what can be computed with is put where its parent
/// is. So is one in a chain without end, which no decoded file has.
pub fn at_start(nodes: &[Node]) -> Vec<Affine> {
    let mut found: Vec<Option<Affine>> = vec![None; nodes.len()];
    for start in 0..nodes.len() {
        let (chain, mut world) = unknown_chain(start, nodes, &found);
        for node in chain.into_iter().rev() {
            let next = world.after(&nodes[node].local_at_start());
            world = if next.is_finite() { next } else { world };
            found[node] = Some(world);
        }
    }
    found.into_iter().map(|world| world.unwrap_or(Affine::IDENTITY)).collect()
}

/// The nodes from one up to where it is known where they are, and that place.
fn unknown_chain(start: usize, nodes: &[Node], found: &[Option<Affine>]) -> (Vec<usize>, Affine) {
    let mut chain = Vec::new();
    let mut next = Some(start);
    while let Some(place) = next {
        match found.get(place) {
            Some(None) if chain.len() < nodes.len() => chain.push(place),
            Some(Some(world)) => return (chain, *world),
            _ => break,
        }
        next = nodes[place].parent;
    }
    (chain, Affine::IDENTITY)
}

#[cfg(test)]
mod tests {
    use super::super::{Key, NodeKind, Spline, Track, TrackKind, Value};
    use super::*;
    use traylib_math::Vec3;

    fn track(kind: TrackKind, value: Value) -> Track {
        Track { kind, flags: 0, keys: vec![Key { frame: 0, spline: Spline::default(), value }] }
    }

    /// A node that moves by one along x.
    fn step(id: Option<u16>, parent_id: Option<u16>) -> Node {
        let tracks = vec![track(TrackKind::Position, Value::Vector(Vec3::X))];
        Node { id, parent_id, tracks, ..Node::new(NodeKind::Object) }
    }

    /// Returns the x of each node, with the warnings.
    fn linked(mut nodes: Vec<Node>) -> (Vec<f32>, Warnings) {
        let mut warnings = Warnings::default();
        link(&mut nodes, &mut warnings);
        (at_start(&nodes).iter().map(|world| world.point(Vec3::ZERO).x).collect(), warnings)
    }

    #[test]
    fn children_move_with_their_parents_in_any_order() {
        let nodes = vec![step(Some(7), Some(3)), step(Some(5), Some(7)), step(Some(3), None)];
        assert_eq!(linked(nodes), (vec![2.0, 3.0, 1.0], Warnings::default()));
    }

    #[test]
    fn without_numbers_the_order_counts_and_of_equal_ones_the_first() {
        let nodes = vec![step(None, None), step(None, Some(0)), step(None, Some(1))];
        assert_eq!(linked(nodes).0, [1.0, 2.0, 3.0]);
        let twins = vec![step(Some(4), None), step(Some(4), Some(4)), step(Some(9), Some(4))];
        assert_eq!(linked(twins).0, [1.0, 2.0, 2.0]);
    }

    #[test]
    fn a_turned_and_stretched_parent_takes_its_children_along() {
        let axis = Vec3::Z;
        let quarter = Value::Turn { angle: std::f32::consts::FRAC_PI_2, axis };
        let scale = track(TrackKind::Scale, Value::Vector(Vec3::splat(2.0)));
        let mut parent = step(Some(0), None);
        parent.tracks.extend([track(TrackKind::Rotation, quarter), scale]);
        let mut nodes = vec![parent, step(Some(1), Some(0))];
        link(&mut nodes, &mut Warnings::default());
        // Clockwise: x goes to −y.
        let place = at_start(&nodes)[1].point(Vec3::ZERO);
        assert!((place - Vec3::new(1.0, -2.0, 0.0)).length() < 1e-6, "{place}");
    }

    #[test]
    fn missing_parents_and_loops_are_opened() {
        let (places, warnings) = linked(vec![step(Some(0), Some(8))]);
        assert_eq!((places, warnings.count(&WarningKind::ParentUnknown)), (vec![1.0], 1));
        let ring = vec![step(Some(0), Some(1)), step(Some(1), Some(2)), step(Some(2), Some(0))];
        let (places, warnings) = linked(ring);
        assert_eq!((places, warnings.count(&WarningKind::ParentLoop)), (vec![3.0, 2.0, 1.0], 1));
        let (places, warnings) = linked(vec![step(Some(0), Some(0))]);
        assert_eq!((places, warnings.count(&WarningKind::ParentLoop)), (vec![1.0], 1));
    }

    #[test]
    fn a_loop_made_by_hand_and_a_long_chain_come_to_an_end() {
        let mut ring = vec![step(None, None), step(None, None)];
        (ring[0].parent, ring[1].parent) = (Some(1), Some(0));
        assert_eq!(at_start(&ring).len(), 2);
        let chain = (0..60_000).map(|i: u16| step(Some(i), i.checked_add(1)));
        assert_eq!(linked(chain.collect()).0[0], 60_000.0);
    }

    #[test]
    fn numbers_too_large_are_not_followed() {
        let far = |parent_id| Node {
            tracks: vec![track(TrackKind::Scale, Value::Vector(Vec3::splat(f32::MAX)))],
            ..step(None, parent_id)
        };
        let nodes = (0..20).map(|i: u16| far(i.checked_sub(1))).collect();
        let mut nodes: Vec<Node> = nodes;
        link(&mut nodes, &mut Warnings::default());
        assert!(at_start(&nodes).iter().all(Affine::is_finite));
    }
}
