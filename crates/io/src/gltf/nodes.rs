//! Nodes in their places.

use super::accessor::item;
use super::json::{Node, Root};
use super::{Cause, Error, WarningKind};
use crate::warning_counts::WarningCounts;
use traylib_math::glam::{DAffine3, DMat3, DMat4, DQuat, DVec3};

/// A node and where it is.
pub(super) struct Placed<'a> {
    pub(super) index: usize,
    pub(super) node: &'a Node,
    pub(super) place: DAffine3,
}

/// Places every node of the scene that is shown, parents before children and in the order of the
/// file.
pub(super) fn placed<'a>(
    root: &'a Root,
    warnings: &mut WarningCounts<WarningKind>,
) -> Result<Vec<Placed<'a>>, Error> {
    let mut open: Vec<(u64, DAffine3, String)> = Vec::new();
    let push = |open: &mut Vec<_>, nodes: &[u64], place: DAffine3, parent: &str| {
        let named = |&node| (node, place, parent.to_string());
        open.extend(nodes.iter().rev().map(named));
    };
    let (first, name) = first(root, warnings)?;
    push(&mut open, &first, DAffine3::IDENTITY, &name);
    let mut is_reached = vec![false; root.nodes.len()];
    let mut placed = Vec::new();
    while let Some((number, above, parent)) = open.pop() {
        let node = item(&root.nodes, number, "node").map_err(|cause| Error::at(parent, cause))?;
        let (index, name) = (number as usize, format!("nodes[{number}]"));
        if std::mem::replace(&mut is_reached[index], true) {
            return Err(Error::at(name, Cause::TwoParents));
        }
        let place = above * own(node);
        if !place.is_finite() {
            return Err(Error::at(name, Cause::NotFinite));
        }
        placed.push(Placed { index, node, place });
        push(&mut open, &node.children, place, &name);
    }
    Ok(placed)
}

/// Finds the nodes that the scene begins with; of a file without scenes those without a parent.
fn first(
    root: &Root,
    warnings: &mut WarningCounts<WarningKind>,
) -> Result<(Vec<u64>, String), Error> {
    if root.scenes.is_empty() {
        let mut has_parent = vec![false; root.nodes.len()];
        for &child in root.nodes.iter().flat_map(|node| &node.children) {
            if let Some(has_parent) = has_parent.get_mut(child as usize) {
                *has_parent = true;
            }
        }
        let free = (0..).zip(&has_parent).filter(|(_, has_parent)| !**has_parent);
        return Ok((free.map(|(node, _)| node).collect(), "nodes".to_string()));
    }
    let number = root.scene.unwrap_or(0);
    let scene = item(&root.scenes, number, "scene").map_err(|cause| Error::at("scene", cause))?;
    warnings.add_many(WarningKind::Scene, root.scenes.len() - 1);
    Ok((scene.nodes.clone(), format!("scenes[{number}]")))
}

/// Returns the way from a node's space to that of its parent.
fn own(node: &Node) -> DAffine3 {
    if let Some(matrix) = &node.matrix {
        return DAffine3::from_mat4(DMat4::from_cols_array(matrix));
    }
    composed(node.translation, node.rotation, node.scale)
}

/// Sizes, then turns, then moves.
pub(super) fn composed(
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
) -> DAffine3 {
    let vector = |given: Option<[f64; 3]>, usual| given.map_or(usual, DVec3::from);
    let scale = DMat3::from_diagonal(vector(scale, DVec3::ONE));
    let rotation = rotation.map_or(DMat3::IDENTITY, |rotation| {
        let rotation = DQuat::from_array(rotation);
        // What turns nothing, as some writers put for no turn.
        let is_none = rotation.length_squared() == 0.0;
        DMat3::from_quat(if is_none { DQuat::IDENTITY } else { rotation.normalize() })
    });
    let matrix3 = rotation * scale;
    DAffine3 { matrix3, translation: vector(translation, DVec3::ZERO) }
}
