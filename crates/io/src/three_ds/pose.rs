//! Meshes where the keyframer puts them.
//!
//! The vertices of a file are in world space already, and for a still picture
//! best left there. The keyframer may have the same mesh in several places, and
//! may have it elsewhere at frame 0 than where it was modelled.
//!
//! A vertex v of a mesh with local axes M, moved by a node with pivot p and
//! place N in the world, is at N·T(−p)·M⁻¹·v.

use super::keyframer::{Node, NodeKind, hierarchy};
use super::{Affine, Document, Mesh};
use std::collections::{HashMap, HashSet};

/// The most vertices and faces, together, of meshes that have been placed once
/// already. What nodes would multiply beyond it is left out: a small file could
/// otherwise fill any memory.
pub const MOST_MULTIPLIED: usize = 1 << 21;

/// A mesh in a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// Index into the document's meshes.
    pub mesh: usize,
    /// Index of the node that puts it there, if one does.
    pub node: Option<usize>,
    /// From the mesh as stored to where it is.
    pub place: Affine,
}

/// Every mesh where the keyframer has it at frame 0, once for each node that
/// moves it, and then those that no node moves, where they are stored. Hidden
/// ones are among them.
pub fn at_start(document: &Document) -> Vec<Placed> {
    let placed = moved_by_nodes(document);
    with_the_others(document, placed)
}

/// Every mesh where it is stored, and where several nodes move a mesh, once more
/// for each after the first: as far from the stored one as its node is from the
/// first at frame 0. Left out are those that this does not place, since the
/// first node flattens the mesh.
pub fn stored_with_instances(document: &Document) -> Vec<Placed> {
    let mut first: HashMap<usize, Option<Affine>> = HashMap::new();
    let mut placed = Vec::new();
    for instance in moved_by_nodes(document) {
        let place = if let Some(back) = first.get(&instance.mesh) {
            back.map(|back| instance.place.after(&back)).filter(Affine::is_finite)
        } else {
            first.insert(instance.mesh, instance.place.inverse());
            Some(Affine::IDENTITY)
        };
        placed.extend(place.map(|place| Placed { place, ..instance }));
    }
    with_the_others(document, placed)
}

/// Tells whether a placed mesh is to be seen: neither it nor its node is hidden at
/// frame 0.
pub fn is_shown(document: &Document, placed: &Placed) -> bool {
    let node_is_hidden = |node: usize| nodes(document)[node].is_hidden();
    !document.meshes[placed.mesh].flags.hidden && !placed.node.is_some_and(node_is_hidden)
}

fn nodes(document: &Document) -> &[Node] {
    document.keyframer.as_ref().map_or(&[], |keyframer| &keyframer.nodes)
}

fn moved_by_nodes(document: &Document) -> Vec<Placed> {
    let mut by_name: HashMap<&str, usize> = HashMap::new();
    for (index, mesh) in document.meshes.iter().enumerate() {
        by_name.entry(&mesh.name).or_insert(index);
    }
    let nodes = nodes(document);
    let worlds = hierarchy::at_start(nodes);
    let mut multiplied = Multiplied::default();
    let mut placed = Vec::new();
    for (index, (node, world)) in nodes.iter().zip(&worlds).enumerate() {
        let named = by_name.get(&*node.name).filter(|_| node.kind == NodeKind::Object);
        let Some(&number) = named else { continue };
        let mesh = &document.meshes[number];
        if multiplied.allow(number, mesh) {
            let place = place(world, node, mesh);
            placed.push(Placed { mesh: number, node: Some(index), place });
        }
    }
    placed
}

/// The measure that [`MOST_MULTIPLIED`] bounds.
#[derive(Default)]
struct Multiplied {
    placed: HashSet<usize>,
    size: usize,
}

impl Multiplied {
    fn allow(&mut self, number: usize, mesh: &Mesh) -> bool {
        if self.placed.insert(number) {
            return true;
        }
        let size = self.size + mesh.vertices.len() + mesh.faces.len();
        if size > MOST_MULTIPLIED {
            return false;
        }
        self.size = size;
        true
    }
}

/// Returns the map that places a mesh; if it cannot be computed, the identity, which leaves the
/// mesh where it is stored.
fn place(world: &Affine, node: &Node, mesh: &Mesh) -> Affine {
    let to_local = mesh.local_to_world().inverse().unwrap_or(Affine::IDENTITY);
    let pivoted = Affine::translation(-node.pivot).after(&to_local);
    Some(world.after(&pivoted)).filter(Affine::is_finite).unwrap_or(Affine::IDENTITY)
}

fn with_the_others(document: &Document, mut placed: Vec<Placed>) -> Vec<Placed> {
    let moved: HashSet<usize> = placed.iter().map(|placed| placed.mesh).collect();
    let others = (0..document.meshes.len()).filter(|mesh| !moved.contains(mesh));
    placed.extend(others.map(|mesh| Placed { mesh, node: None, place: Affine::IDENTITY }));
    placed
}

#[cfg(test)]
mod tests;
