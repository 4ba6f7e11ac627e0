//! From JSON and buffers to a document.

use super::accessor::{Arrays, item};
use super::budget::Budget;
use super::buffers::{self, Load};
use super::json::Root;
use super::nodes::{self, Placed};
use super::primitive::Reader;
use super::{
    Cause, Document, Error, Instance, Limits, WarningKind, extensions, fixture, instancing,
    material,
};
use crate::Limit;
use crate::warning_counts::WarningCounts;
use std::ops::Range;

pub(super) fn build(
    root: &Root,
    binary: Option<&[u8]>,
    limits: Limits,
    load: Load<'_>,
) -> Result<Document, Error> {
    let mut warnings = WarningCounts::default();
    extensions::check(root, &mut warnings)?;
    check_items(root, limits)?;
    let arrays = Arrays::new(root, buffers::all(root, binary, limits, load)?);
    warnings.add_many(WarningKind::Animation, root.animations.len());
    let materials = material::all(root, &mut warnings)?;
    let placed = nodes::placed(root, &mut warnings)?;
    let document = Document {
        images: material::images(root, &arrays, &materials)?,
        materials,
        ..Document::default()
    };
    let mut builder = Builder {
        root,
        document,
        warnings,
        meshes: vec![None; root.meshes.len()],
        vertices: Budget::new("vertices", Limit::Surfaces, limits.triangles),
        triangles: Budget::new("triangles", Limit::Surfaces, limits.triangles),
        places: Budget::new("places of meshes", Limit::Items, limits.items as u64),
    };
    for node in &placed {
        builder.add(node, &arrays)?;
    }
    Ok(Document { warnings: builder.warnings, ..builder.document })
}

fn check_items(root: &Root, limits: Limits) -> Result<(), Error> {
    for (what, count) in [
        ("nodes", root.nodes.len()),
        ("meshes", root.meshes.len()),
        ("materials", root.materials.len()),
        ("images", root.images.len()),
    ] {
        if count > limits.items {
            let (most, limit) = (limits.items as u64, Limit::Items);
            return Err(Error::at(what, Cause::TooMany { what, most, limit }));
        }
    }
    Ok(())
}

struct Builder<'a> {
    root: &'a Root,
    document: Document,
    warnings: WarningCounts<WarningKind>,
    /// The primitives of the meshes that have been read.
    meshes: Vec<Option<Range<usize>>>,
    vertices: Budget,
    triangles: Budget,
    /// Places of nodes that have several.
    places: Budget,
}

impl Builder<'_> {
    /// Adds what a node has.
    fn add(&mut self, placed: &Placed<'_>, arrays: &Arrays<'_>) -> Result<(), Error> {
        let here = |cause| Error::at(format!("nodes[{}]", placed.index), cause);
        if let Some(mesh) = placed.node.mesh {
            self.instance(mesh, placed, arrays)?;
        }
        if let Some(light) = &placed.node.extensions.light {
            let lights = &self.root.extensions.lights.lights;
            let light = item(lights, light.light, "light").map_err(here)?;
            let light = fixture::light(light, placed, &mut self.warnings);
            self.document.lights.extend(light);
        }
        if let Some(camera) = placed.node.camera {
            let camera = item(&self.root.cameras, camera, "camera").map_err(here)?;
            let camera = fixture::camera(camera, placed, &mut self.warnings);
            self.document.cameras.extend(camera);
        }
        self.warnings.add_many(WarningKind::Skin, usize::from(placed.node.skin.is_some()));
        Ok(())
    }

    fn instance(
        &mut self,
        mesh: u64,
        placed: &Placed<'_>,
        arrays: &Arrays<'_>,
    ) -> Result<(), Error> {
        let here = |cause| Error::at(format!("nodes[{}]", placed.index), cause);
        item(&self.root.meshes, mesh, "mesh").map_err(here)?;
        let places = match &placed.node.extensions.instancing {
            None => vec![placed.place],
            Some(instancing) => {
                let name = format!("nodes[{}]", placed.index);
                let within = instancing::places(instancing, arrays, &mut self.places, &name)?;
                within.into_iter().map(|place| placed.place * place).collect()
            }
        };
        for primitive in self.mesh(mesh as usize, arrays)? {
            let triangles = self.document.primitives[primitive].triangles.len() as u64;
            if triangles == 0 {
                continue;
            }
            let of_all = triangles.saturating_mul(places.len() as u64);
            self.triangles.take(of_all).map_err(here)?;
            let standing = |&place| Instance { primitive, place };
            self.document.instances.extend(places.iter().map(standing));
        }
        Ok(())
    }

    /// Returns the primitives of a mesh, which is read once.
    fn mesh(&mut self, mesh: usize, arrays: &Arrays<'_>) -> Result<Range<usize>, Error> {
        if let Some(known) = &self.meshes[mesh] {
            return Ok(known.clone());
        }
        let first = self.document.primitives.len();
        for (index, primitive) in self.root.meshes[mesh].primitives.iter().enumerate() {
            let place = format!("meshes[{mesh}].primitives[{index}]");
            let material = primitive
                .material
                .map(|material| item(&self.document.materials, material, "material"));
            let material = material.transpose().map_err(|cause| Error::at(&*place, cause))?;
            let picture = material.and_then(|material| material.base_colour_picture);
            let set = picture.map_or(0, |picture| picture.set);
            let (vertices, warnings) = (&mut self.vertices, &mut self.warnings);
            let mut reader = Reader { arrays, vertices, warnings };
            self.document.primitives.extend(reader.primitive(primitive, &place, set)?);
        }
        let primitives = first..self.document.primitives.len();
        self.meshes[mesh] = Some(primitives.clone());
        Ok(primitives)
    }
}
