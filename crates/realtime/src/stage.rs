//! The scene as each method needs it.

use crate::options::Options;
use std::sync::OnceLock;
use traylib_demos::{Failure, announce};
use traylib_integrators::Method;
use traylib_io::{Headlight, Loaded, load_scene_with};
use traylib_math::Vec2;

/// A scene, loaded as often as methods need another light in it.
#[derive(Debug)]
pub(crate) struct Stage {
    options: Options,
    /// For `trace`, which sees by point lights alone.
    by_points: Loaded,
    /// For all others, if `by_points` got a light that they do without.
    by_all: OnceLock<Loaded>,
}

impl Stage {
    /// Loads the scene as `trace` needs it, which serves all in most scenes.
    ///
    /// # Errors
    /// The scene cannot be read or makes no sense.
    pub(crate) fn load(options: &Options) -> Result<Self, Failure> {
        let options = options.clone();
        let load = options.load_options(Headlight::WithoutPointLight);
        let by_points = load_scene_with(&options.scene, load)?;
        Ok(Self { options, by_points, by_all: OnceLock::new() })
    }

    /// The scene for this method. Loads it where that one is another and wanted for the first
    /// time.
    ///
    /// # Errors
    /// The file has changed meanwhile, so that it cannot be read any more.
    pub(crate) fn of(&self, method: Method) -> Result<&Loaded, Failure> {
        let sees_points_alone = matches!(method, Method::Trace(_));
        if sees_points_alone || !self.by_points.headlight {
            return Ok(&self.by_points);
        }
        if let Some(loaded) = self.by_all.get() {
            return Ok(loaded);
        }
        let load = self.options.load_options(Headlight::WithoutLight);
        let loaded = load_scene_with(&self.options.scene, load)?;
        Ok(self.by_all.get_or_init(|| loaded))
    }

    /// Says what is to be known before it is rendered by this method.
    ///
    /// # Errors
    /// As [`of`](Self::of).
    pub(crate) fn announce(&self, method: Method) -> Result<(), Failure> {
        let limits = method.limits().unwrap_or_default();
        announce(method.name(), self.of(method)?, &*method.build(), limits);
        Ok(())
    }

    /// The command line.
    pub(crate) fn options(&self) -> &Options {
        &self.options
    }

    /// The scene as it was loaded at first.
    pub(crate) fn loaded(&self) -> &Loaded {
        &self.by_points
    }

    /// Returns the distance of the surface in the middle of the picture, in metres.
    pub(crate) fn focus(&self) -> Option<f32> {
        let scene = &self.by_points.scene;
        let camera = scene.camera();
        let middle = 0.5 * Vec2::new(camera.width() as f32, camera.height() as f32);
        let ray = camera.ray(middle);
        let point = scene.intersect(&ray)?;
        Some((point.site.position - ray.origin).length()).filter(|distance| *distance > 0.0)
    }
}
