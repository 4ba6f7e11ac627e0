//! F11: the same scene at four sizes.

use crate::still_life::still_life;
use std::ops::ControlFlow;
use traylib_integrators::{Control, Method, Settings, render};
use traylib_math::{Grid, Rgb};

/// Powers of two by which [`still_life`] is scaled.
pub const SCALES: [i32; 3] = [-14, 10, 20];

/// The powers of two at which a method's picture is not the same, bit for bit,
/// as that of the scene as it is.
pub fn differences(method: Method) -> Vec<i32> {
    let unscaled = picture(method, 1.0);
    SCALES.into_iter().filter(|&power| picture(method, 2.0_f32.powi(power)) != unscaled).collect()
}

fn picture(method: Method, scale: f32) -> Grid<Rgb> {
    let integrator = method.build();
    let settings = Settings { spp: 4, seed: 11, threads: 1, ..Settings::default() };
    let rendering = render(
        &still_life(scale),
        integrator.as_ref(),
        &settings,
        &Control::default(),
        &mut |_| ControlFlow::Continue(()),
    );
    rendering.expect("one thread").film.develop()
}
