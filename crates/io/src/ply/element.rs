//! The body of a file, element after element.

mod faces;
mod vertices;

use super::body::Body;
use super::declaration::{Element, Property};
use super::header::Header;
use super::{Cause, Document, Error, Limits, WarningKind};
use crate::polygon_limits::PolygonBudget;
use crate::suggest::shown;

pub(super) fn read(header: Header, body: Body<'_>, limits: Limits) -> Result<Document, Error> {
    let Header { elements, textures, warnings } = header;
    let document = Document { textures, warnings, ..Document::default() };
    let mut reader = Reader { document, body, budget: PolygonBudget::new(limits), number: 0 };
    for element in &elements {
        reader.element(element).map_err(|cause| Error::Data {
            place: reader.body.place(),
            element: element.name.clone(),
            number: reader.number,
            cause,
        })?;
    }
    check_vertices(&reader.document)?;
    Ok(reader.document)
}

/// Refuses corners that name no vertex; faces may stand before the vertices.
fn check_vertices(document: &Document) -> Result<(), Error> {
    let count = document.positions.len();
    for (face, (_, corners)) in document.faces().enumerate() {
        if let Some(&vertex) = corners.iter().find(|&&corner| corner as usize >= count) {
            return Err(Error::NoVertex { face, vertex, count });
        }
    }
    Ok(())
}

/// Reads elements into a document.
struct Reader<'a> {
    document: Document,
    body: Body<'a>,
    budget: PolygonBudget,
    /// The number of the item that is read within its element.
    number: usize,
}

impl Reader<'_> {
    fn element(&mut self, element: &Element) -> Result<(), Cause> {
        self.number = 0;
        let count = self.body.check_count(element)?;
        let Element { name, properties, .. } = element;
        match name.as_str() {
            "vertex" => self.vertices(properties, count),
            // They take no bytes, so that nothing bounds how many there are.
            _ if properties.is_empty() => {
                self.warn(WarningKind::Element(shown(name)), count);
                Ok(())
            }
            "face" => self.faces(properties, count),
            "tristrips" => self.strips(properties, count),
            _ => {
                self.warn(WarningKind::Element(shown(name)), count);
                self.each(count, |reader| {
                    properties.iter().try_for_each(|property| reader.body.skip(property.kind))
                })
            }
        }
    }

    /// Reads items one after the other.
    fn each(
        &mut self,
        count: usize,
        mut item: impl FnMut(&mut Self) -> Result<(), Cause>,
    ) -> Result<(), Cause> {
        for number in 0..count {
            self.number = number;
            item(self)?;
        }
        Ok(())
    }

    fn warn(&mut self, kind: WarningKind, times: usize) {
        self.document.warnings.add_many(kind, times);
    }
}

/// Tells whether a property is a band of a colour.
fn is_colour(property: &Property) -> bool {
    let name = property.name.as_str();
    let band = ["diffuse_", "ambient_", "specular_"]
        .into_iter()
        .find_map(|prefix| name.strip_prefix(prefix))
        .unwrap_or(name);
    matches!(band, "red" | "green" | "blue" | "alpha" | "r" | "g" | "b" | "a")
}
