//! F11: the same scene at four sizes.

use crate::stability::column::Column;
use crate::still_life::still_life;
use std::ops::ControlFlow;
use traylib_integrators::{Control, Settings, render};
use traylib_math::{Grid, Rgb};

/// Powers of two by which [`still_life`] is scaled.
pub const SCALES: [i32; 3] = [-14, 10, 20];

/// The powers of two at which a program's picture is not the same, bit for bit,
/// as that of the scene as it is.
pub fn differences(column: Column) -> Vec<i32> {
    let unscaled = picture(column, 1.0);
    SCALES.into_iter().filter(|&power| picture(column, 2.0_f32.powi(power)) != unscaled).collect()
}

fn picture(column: Column, scale: f32) -> Grid<Rgb> {
    let integrator = column.integrator(None);
    let settings = Settings { spp: 4, seed: 11, threads: 1 };
    let rendering = render(
        &still_life(scale),
        integrator.as_ref(),
        &settings,
        &Control::default(),
        &mut |_| ControlFlow::Continue(()),
    );
    rendering.expect("one thread").film.develop()
}
