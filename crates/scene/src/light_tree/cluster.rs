//! Clusters: what light sampling knows of one lamp, or of many together.

use super::cone::Cone;
use crate::{Light, PointLight};
use traylib_geometry::Aabb;

/// A cluster of lamps: their bounds, the directions in which they shine, and their power together.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cluster {
    pub(super) bounds: Aabb,
    pub(super) cone: Cone,
    /// Sum of the greatest intensities, over that of the scene's strongest lamp.
    pub(super) intensity: f64,
}

impl Cluster {
    /// One lamp of this share; `None` of the sky, which is nowhere.
    pub(super) fn of(light: &Light, intensity: f64) -> Option<Self> {
        let (bounds, cone) = match light {
            Light::Area { primitive, .. } => {
                (primitive.bounds(), Cone::around_normals(primitive.normals()))
            }
            Light::Point(PointLight { position, cone, .. }) => {
                let cone = cone.map_or(Cone::SPHERE, |c| Cone::filled(c.axis, c.cos_dark));
                (Aabb::around([*position]), cone)
            }
            Light::Sky(_) => return None,
        };
        Some(Self { bounds, cone, intensity })
    }

    /// All lamps of both.
    #[must_use]
    pub(super) fn join(self, other: Self) -> Self {
        Self {
            bounds: self.bounds.union(other.bounds),
            cone: self.cone.join(other.cone),
            intensity: self.intensity + other.intensity,
        }
    }

    /// Returns how poorly the cluster stands for its lamps: the stronger, the further apart, the
    /// less of one mind, the worse. The square of the diagonal takes the place of the surface,
    /// which vanishes for lamps in a row.
    pub(super) fn cost(&self) -> f64 {
        let diagonal_squared = self.bounds.extent().as_dvec3().length_squared();
        self.intensity * diagonal_squared * self.cone.measure()
    }
}
