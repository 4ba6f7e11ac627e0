//! Path tracing with lamps sampled at every vertex.

use std::process::ExitCode;
use traylib_integrators::Method;

fn main() -> ExitCode {
    traylib_demos::render_by(Method::DIRECT_LIGHT)
}
