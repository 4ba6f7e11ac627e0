//! The techniques that take part.

/// The lamps that are aimed at from the vertices of camera paths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightSampling {
    /// None.
    Off,
    /// Point lights, which nothing else can find from the camera.
    PointLights,
    /// All.
    All,
}

/// A subset of the techniques (s, t); the weights of those that are left sum to
/// one wherever one of them finds light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each stands for a technique of its own")]
pub struct Techniques {
    /// s = 0: the camera path hits a lamp.
    pub hits: bool,
    /// s = 1: a lamp is sampled from a vertex of the camera path.
    pub light_samples: LightSampling,
    /// s ≥ 2, t ≥ 2: the subpaths are connected.
    pub connections: bool,
    /// t = 1: a vertex of the light path is joined to the camera.
    pub splats: bool,
    /// s = 2 or 3, t ≥ 2: point lights are joined by way of one mirror or two.
    pub mirror_connections: bool,
}

impl Techniques {
    /// All techniques that a pinhole allows.
    pub const ALL: Self = Self {
        hits: true,
        light_samples: LightSampling::All,
        connections: true,
        splats: true,
        mirror_connections: true,
    };
    /// The techniques of pure Monte Carlo path tracing.
    pub const PURE_MC: Self = Self {
        light_samples: LightSampling::PointLights,
        connections: false,
        splats: false,
        mirror_connections: false,
        ..Self::ALL
    };
    /// The techniques of direct light sampling combined with hits.
    pub const COMBINED: Self = Self { connections: false, splats: false, ..Self::ALL };
    /// The techniques of the particle tracer; lamps are seen directly all the same.
    pub const PARTICLE: Self = Self {
        hits: false,
        light_samples: LightSampling::Off,
        connections: false,
        splats: true,
        mirror_connections: false,
    };

    pub(crate) fn need_light_paths(self) -> bool {
        self.connections || self.splats
    }

    /// Tells whether lamps of this kind are sampled.
    pub(crate) fn samples_light(self, is_point: bool) -> bool {
        match self.light_samples {
            LightSampling::Off => false,
            LightSampling::PointLights => is_point,
            LightSampling::All => true,
        }
    }

    /// Tells whether technique (s, t) takes part for paths from such a lamp.
    pub(crate) fn allow(self, s: usize, t: usize, is_point: bool) -> bool {
        match (s, t) {
            (0, 2) => true,
            (0, _) => self.hits && !is_point,
            (_, 1) => self.splats,
            (1, _) => self.samples_light(is_point),
            _ => self.connections,
        }
    }
}

impl Default for Techniques {
    fn default() -> Self {
        Self::ALL
    }
}
