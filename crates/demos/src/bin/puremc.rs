//! Pure Monte Carlo path tracing.

use std::process::ExitCode;
use traylib_integrators::Method;

fn main() -> ExitCode {
    traylib_demos::render_by(Method::PURE_MC)
}
