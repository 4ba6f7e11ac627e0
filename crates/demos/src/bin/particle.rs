//! The particle tracer.

use std::process::ExitCode;
use traylib_integrators::Method;

fn main() -> ExitCode {
    traylib_demos::render_by(Method::PARTICLE)
}
