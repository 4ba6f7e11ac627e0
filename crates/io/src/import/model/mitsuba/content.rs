//! The contents of a scene, wherever it goes.

use super::form::Form;
use crate::import::counter::Counter;
use crate::import::model_camera::ModelCamera;
use crate::import::model_part::{ModelPart, ModelSide};
use crate::import::placement::Placement;
use crate::import::sky_light::SkyLight;
use std::rc::Rc;
use traylib_math::glam::DAffine3;
use traylib_scene::{PointLight, SpotCone};

/// The contents of a file before they are placed.
#[derive(Debug, Default)]
pub(in crate::import::model) struct Content {
    pub(super) items: Vec<Item>,
    pub(in crate::import::model) lights: Vec<PointLight>,
    pub(in crate::import::model) sky: Option<SkyLight>,
    pub(in crate::import::model) camera: Option<ModelCamera>,
    /// Samples per pixel, if the file says.
    pub(in crate::import::model) samples: Option<u32>,
}

/// A shape in its place.
#[derive(Clone, Debug)]
pub(super) struct Item {
    pub(super) form: Rc<Form>,
    pub(super) place: DAffine3,
    /// Whether its front is where its back would be.
    pub(super) is_flipped: bool,
    /// The material of its front, or of all of it.
    pub(super) front: usize,
    /// The material of its back, if it has one of its own.
    pub(super) back: Option<usize>,
    /// Whether there are pictures on it.
    pub(super) is_textured: bool,
}

impl Content {
    pub(super) fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Puts every shape where it goes.
    pub(in crate::import::model) fn parts(
        &self,
        placement: &Placement,
        counter: &mut Counter,
    ) -> Vec<ModelPart> {
        let placement = placement.affine();
        let mut parts = Vec::with_capacity(self.items.len());
        for item in &self.items {
            let place = placement * item.place;
            let sides: &[_] = match item.back {
                None => &[(ModelSide::Whole, item.front)],
                Some(back) => &[(ModelSide::Front, item.front), (ModelSide::Back, back)],
            };
            for &(side, material) in sides {
                let is_turned = item.is_flipped != (side == ModelSide::Back);
                match item.form.shapes(&place, is_turned, item.is_textured) {
                    Ok(shapes) => {
                        parts.extend(shapes.into_iter().map(|shape| ModelPart {
                            shape,
                            material,
                            side,
                        }));
                    }
                    Err(_) => counter.add("shape dropped: it has no area, or is too large"),
                }
            }
        }
        parts
    }

    /// Lets go of its shapes.
    pub(in crate::import::model) fn forget_shapes(&mut self) {
        self.items = Vec::new();
    }

    /// Puts its lights where they go; in W/sr they are as strong at any scale.
    pub(in crate::import::model) fn lights(&self, placement: &Placement) -> Vec<PointLight> {
        let placed = |light: &PointLight| {
            let position = placement.point(light.position);
            let cone =
                light.cone.map(|cone| SpotCone { axis: placement.direction(cone.axis), ..cone });
            PointLight { position, cone, ..*light }
        };
        self.lights.iter().map(placed).collect()
    }
}
