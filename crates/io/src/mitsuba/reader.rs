//! From elements to objects.

use super::document::{Child, Class, Document, Object, Place, Property, Value};
use super::lines::Lines;
use super::parameters::Parameters;
use super::values;
use super::{Error, Fault, Included, Limits, WarningKind, bounds, names, transform};
use crate::Limit;
use crate::suggest::shown;
use roxmltree::{Node, ParsingOptions};
use std::borrow::Cow;
use std::collections::HashMap;
use traylib_math::glam::DAffine3;

type Load<'a> = dyn FnMut(&str) -> Result<Included, String> + 'a;

pub(super) fn read(
    name: &str,
    bytes: &[u8],
    limits: Limits,
    load: &mut Load<'_>,
) -> Result<Document, Error> {
    let mut reader = Reader {
        limits,
        load,
        document: Document::default(),
        parameters: Parameters::default(),
        ids: HashMap::new(),
        references: Vec::new(),
        aliases: Vec::new(),
        open: Vec::new(),
        bytes: 0,
        elements: 0,
    };
    reader.file(name, bytes, None)?;
    reader.resolve()?;
    Ok(reader.document)
}

/// A `ref` that waits for the object that it names.
struct Reference {
    /// The object that it stands in, and the place among its children.
    within: usize,
    child: usize,
    id: String,
    place: Place,
}

struct Reader<'a> {
    limits: Limits,
    load: &'a mut Load<'a>,
    document: Document,
    parameters: Parameters,
    ids: HashMap<String, usize>,
    references: Vec<Reference>,
    /// Further ids, each with that which it stands for, and where.
    aliases: Vec<(String, String, Place)>,
    /// Files under way, in the order in which they include one another.
    open: Vec<String>,
    /// Bytes and elements so far.
    bytes: usize,
    elements: usize,
}

/// A file while it is read.
struct Source<'a> {
    file: usize,
    lines: Lines<'a>,
    is_old: bool,
}

impl Source<'_> {
    fn place(&self, byte: usize) -> Place {
        let (line, column) = self.lines.at(byte);
        Place { file: self.file, line, column }
    }

    fn place_of(&self, node: Node<'_, '_>) -> Place {
        self.place(node.range().start)
    }
}

impl Reader<'_> {
    fn file(&mut self, name: &str, bytes: &[u8], parent: Option<usize>) -> Result<(), Error> {
        let file = self.document.files.len();
        self.document.files.push(name.to_string());
        let start = Place { file, line: 1, column: 1 };
        self.count_bytes(bytes.len()).map_err(|fault| self.document.error(start, fault))?;
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let line = bytes[..error.valid_up_to()].split(|&byte| byte == b'\n').count();
            self.document.error(Place { line: line as u32, ..start }, Fault::NotText)
        })?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut source = Source { file, lines: Lines::of(text), is_old: false };
        bounds::check(text)
            .map_err(|(byte, fault)| self.document.error(source.place(byte), fault))?;
        let options =
            ParsingOptions { nodes_limit: self.nodes_left(), ..ParsingOptions::default() };
        let tree = roxmltree::Document::parse_with_options(text, options)
            .map_err(|error| self.malformed(&error, file))?;
        let root = tree.root_element();
        source.is_old = is_old(root);
        self.open.push(name.to_string());
        if root.has_tag_name("scene") {
            self.children(root, parent, &source)?;
        } else if file == 0 {
            let fault = Fault::NoScene(shown(root.tag_name().name()));
            return Err(self.document.error(source.place_of(root), fault));
        } else {
            self.element(root, parent, &source)?;
        }
        self.open.pop();
        Ok(())
    }

    fn count_bytes(&mut self, bytes: usize) -> Result<(), Fault> {
        self.bytes = self.bytes.saturating_add(bytes);
        let limit = self.limits.bytes;
        if self.bytes > limit {
            let (what, limit) = ("bytes of scene files", limit as u64);
            return Err(Fault::Limit { what, limit, option: Limit::Bytes });
        }
        Ok(())
    }

    /// Elements with blanks and comments between them, of which the tree has nodes, too.
    fn nodes_left(&self) -> u32 {
        let left = self.limits.elements.saturating_sub(self.elements).saturating_mul(3);
        u32::try_from(left).unwrap_or(u32::MAX).saturating_add(64)
    }

    fn too_many_elements(&self) -> Fault {
        let (what, limit) = ("elements of scene files", self.limits.elements as u64);
        Fault::Limit { what, limit, option: Limit::Items }
    }

    fn malformed(&self, error: &roxmltree::Error, file: usize) -> Error {
        let position = error.pos();
        let place = Place { file, line: position.row, column: position.col };
        let fault = if matches!(error, roxmltree::Error::NodesLimitReached) {
            self.too_many_elements()
        } else {
            let text = error.to_string();
            // Where it is stands before it already.
            let text = text.rsplit_once(" at ").map_or(text.as_str(), |(text, _)| text);
            Fault::Xml(shown(text))
        };
        self.document.error(place, fault)
    }

    fn children(
        &mut self,
        node: Node<'_, '_>,
        parent: Option<usize>,
        source: &Source<'_>,
    ) -> Result<(), Error> {
        node.children()
            .filter(Node::is_element)
            .try_for_each(|child| self.element(child, parent, source))
    }

    /// Reads an element of the scene, or of the object `parent`.
    fn element(
        &mut self,
        node: Node<'_, '_>,
        parent: Option<usize>,
        source: &Source<'_>,
    ) -> Result<(), Error> {
        let place = source.place_of(node);
        self.elements += 1;
        if self.elements > self.limits.elements {
            return Err(self.document.error(place, self.too_many_elements()));
        }
        let tag = node.tag_name().name();
        if let Some(class) = Class::of(tag) {
            return self.object(class, node, parent, source);
        }
        let done = match tag {
            "default" => self.parameter(node),
            "alias" => self.alias(node, place),
            "ref" => self.reference(node, parent, place, source.is_old),
            "include" => return self.include(node, parent, place),
            _ => self.property(node, parent, source.is_old),
        };
        done.map_err(|fault| self.document.error(place, fault))
    }

    fn object(
        &mut self,
        class: Class,
        node: Node<'_, '_>,
        parent: Option<usize>,
        source: &Source<'_>,
    ) -> Result<(), Error> {
        let place = source.place_of(node);
        let number = self.document.objects.len();
        let opened = self.opened(class, node, place, source.is_old);
        let (object, name) = opened.map_err(|fault| self.document.error(place, fault))?;
        if !object.id.is_empty() && self.ids.insert(object.id.clone(), number).is_some() {
            return Err(self.document.error(place, Fault::SecondId(shown(&object.id))));
        }
        self.document.objects.push(object);
        match parent {
            Some(parent) => {
                self.document.objects[parent].children.push(Child { name, object: number });
            }
            None => self.document.roots.push(number),
        }
        self.children(node, Some(number), source)
    }

    fn opened(
        &self,
        class: Class,
        node: Node<'_, '_>,
        place: Place,
        is_old: bool,
    ) -> Result<(Object, String), Fault> {
        let object = Object {
            class,
            kind: self.needed(node, "type")?.into_owned(),
            id: self.optional(node, "id")?.unwrap_or_default().into_owned(),
            place,
            is_old,
            properties: Vec::new(),
            children: Vec::new(),
        };
        Ok((object, self.name(node, is_old)?))
    }

    /// Returns the name by which the object around uses a value or an object.
    fn name(&self, node: Node<'_, '_>, is_old: bool) -> Result<String, Fault> {
        let name = self.optional(node, "name")?.unwrap_or_default();
        Ok(if is_old { names::modern(&name) } else { name.into_owned() })
    }

    fn optional<'n>(
        &self,
        node: Node<'n, '_>,
        attribute: &str,
    ) -> Result<Option<Cow<'n, str>>, Fault> {
        node.attribute(attribute).map(|text| self.parameters.filled(text)).transpose()
    }

    fn needed<'n>(
        &self,
        node: Node<'n, '_>,
        attribute: &'static str,
    ) -> Result<Cow<'n, str>, Fault> {
        let element = || shown(node.tag_name().name());
        let text = self.optional(node, attribute)?;
        text.ok_or_else(|| Fault::Missing { element: element(), attribute })
    }

    fn parameter(&mut self, node: Node<'_, '_>) -> Result<(), Fault> {
        let (name, value) = (self.needed(node, "name")?, self.needed(node, "value")?);
        self.parameters.give(&name, &value);
        Ok(())
    }

    fn alias(&mut self, node: Node<'_, '_>, place: Place) -> Result<(), Fault> {
        let (id, other) = (self.needed(node, "id")?, self.needed(node, "as")?);
        self.aliases.push((other.into_owned(), id.into_owned(), place));
        Ok(())
    }

    fn reference(
        &mut self,
        node: Node<'_, '_>,
        parent: Option<usize>,
        place: Place,
        is_old: bool,
    ) -> Result<(), Fault> {
        let (id, name) = (self.needed(node, "id")?.into_owned(), self.name(node, is_old)?);
        let Some(within) = parent else {
            self.document.warnings.add(WarningKind::Stray("ref".to_string()));
            return Ok(());
        };
        let children = &mut self.document.objects[within].children;
        self.references.push(Reference { within, child: children.len(), id, place });
        children.push(Child { name, object: within });
        Ok(())
    }

    fn include(
        &mut self,
        node: Node<'_, '_>,
        parent: Option<usize>,
        place: Place,
    ) -> Result<(), Error> {
        let included = self.included(node);
        let Included { name, bytes } =
            included.map_err(|fault| self.document.error(place, fault))?;
        self.file(&name, &bytes, parent)
    }

    fn included(&mut self, node: Node<'_, '_>) -> Result<Included, Fault> {
        let name = self.needed(node, "filename")?;
        if self.open.len() >= self.limits.depth {
            let (what, limit) = ("files that include each other", self.limits.depth as u64);
            return Err(Fault::Limit { what, limit, option: Limit::Depth });
        }
        let refused = |why| Fault::Include { name: shown(&name), why };
        let included = (self.load)(&name).map_err(refused)?;
        if self.open.contains(&included.name) {
            return Err(refused("it includes this file, directly or through others".to_string()));
        }
        Ok(included)
    }

    fn property(
        &mut self,
        node: Node<'_, '_>,
        parent: Option<usize>,
        is_old: bool,
    ) -> Result<(), Fault> {
        let tag = node.tag_name().name();
        let Some(value) = self.value(tag, node)? else {
            self.document.warnings.add(WarningKind::Element(shown(tag)));
            return Ok(());
        };
        let Some(parent) = parent else {
            self.document.warnings.add(WarningKind::Stray(shown(tag)));
            return Ok(());
        };
        let name = self.name(node, is_old)?;
        self.document.objects[parent].properties.push(Property { name, value });
        Ok(())
    }

    /// The value of an element; `None` of one that is none.
    fn value(&mut self, tag: &str, node: Node<'_, '_>) -> Result<Option<Value>, Fault> {
        Ok(Some(match tag {
            "float" | "integer" => Value::Number(values::number(&self.needed(node, "value")?)?),
            "boolean" => Value::Boolean(values::boolean(&self.needed(node, "value")?)?),
            "string" => Value::Text(self.needed(node, "value")?.into_owned()),
            "point" | "vector" => Value::Vector(self.vector(node, 0.0)?),
            "rgb" | "color" => values::colour(&self.needed(node, "value")?, false)?,
            "srgb" => values::colour(&self.needed(node, "value")?, true)?,
            "spectrum" => match self.optional(node, "value")? {
                Some(text) => values::spectrum(&text)?,
                None => Value::OtherSpectrum,
            },
            "blackbody" => Value::OtherSpectrum,
            "transform" => Value::Transform(self.transform(node)?),
            _ => return Ok(None),
        }))
    }

    /// Three numbers of `value`, or of `x`, `y` and `z`, each `usual` if it is not there.
    fn vector(&self, node: Node<'_, '_>, usual: f64) -> Result<[f64; 3], Fault> {
        if let Some(text) = self.optional(node, "value")? {
            return values::vector(&text);
        }
        let axis =
            |name| self.optional(node, name)?.map_or(Ok(usual), |text| values::number(&text));
        Ok([axis("x")?, axis("y")?, axis("z")?])
    }

    fn transform(&mut self, node: Node<'_, '_>) -> Result<DAffine3, Fault> {
        let mut whole = DAffine3::IDENTITY;
        for step in node.children().filter(Node::is_element) {
            self.elements += 1;
            if let Some(next) = self.step(step)? {
                whole = next * whole;
            }
        }
        let is_sound = whole.is_finite();
        is_sound.then_some(whole).ok_or_else(|| values::unreadable("transform", "finite"))
    }

    /// A step of a transform; `None` of one that is none.
    fn step(&mut self, node: Node<'_, '_>) -> Result<Option<DAffine3>, Fault> {
        let tag = node.tag_name().name();
        Ok(Some(match tag {
            "translate" => transform::translate(self.vector(node, 0.0)?),
            "scale" => transform::scale(match self.optional(node, "value")? {
                Some(text) => values::one_or_three(&text)?,
                None => self.vector(node, 1.0)?,
            }),
            "rotate" => {
                let angle = values::number(&self.needed(node, "angle")?)?;
                let axis = self.vector(node, 0.0)?;
                if !transform::is_unit(axis) {
                    self.document.warnings.add(WarningKind::Axis);
                }
                transform::rotate(axis, angle)?
            }
            "matrix" => {
                let text = self.needed(node, "value")?;
                transform::matrix(&values::numbers(&text)?, &shown(&text))?
            }
            "lookat" | "lookAt" | "look_at" => {
                let [origin, target] = ["origin", "target"].map(|name| self.needed(node, name));
                let up = self.optional(node, "up")?.unwrap_or(Cow::Borrowed("0 1 0"));
                let vector = |text: &str| values::vector(text);
                transform::look_at(vector(&origin?)?, vector(&target?)?, vector(&up)?)?
            }
            _ => {
                self.document.warnings.add(WarningKind::Step(shown(tag)));
                return Ok(None);
            }
        }))
    }

    /// Finds what references lead to.
    fn resolve(&mut self) -> Result<(), Error> {
        for (other, id, place) in std::mem::take(&mut self.aliases) {
            let found = self.ids.get(&id).copied();
            let number = found.ok_or_else(|| self.no_such_id(&id, place))?;
            self.ids.entry(other).or_insert(number);
        }
        for Reference { within, child, id, place } in std::mem::take(&mut self.references) {
            let found = self.ids.get(&id).copied();
            let number = found.ok_or_else(|| self.no_such_id(&id, place))?;
            self.document.objects[within].children[child].object = number;
        }
        Ok(())
    }

    fn no_such_id(&self, id: &str, place: Place) -> Error {
        self.document.error(place, Fault::NoSuchId(shown(id)))
    }
}

/// Tells whether a file is of a version before 2, whose properties have other names.
fn is_old(root: Node<'_, '_>) -> bool {
    let major = |version: &str| version.split('.').next()?.trim().parse::<u32>().ok();
    root.attribute("version").and_then(major).is_some_and(|major| major < 2)
}
