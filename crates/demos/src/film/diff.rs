//! `film diff`.

use super::any;
use super::bias::SIDE;
use super::comparison::{Comparison, LeftOut, Worst};
use crate::outcome::Failure;
use crate::say::{tell, tell_json};
use clap::Args;
use serde_json::{Value, json};
use std::path::PathBuf;

/// Two pictures to compare.
#[derive(Args, Clone, Debug)]
pub struct DiffOptions {
    /// Picture of any format that `film convert` reads
    #[arg(value_name = "A")]
    pub picture: PathBuf,

    /// Reference of the same size: what the picture should be
    #[arg(value_name = "B")]
    pub reference: PathBuf,

    /// Fail with status 7 if relMSE is more than this, or if a pixel of either
    /// picture is not finite
    #[arg(long, value_name = "X", value_parser = parse_positive)]
    pub max_relmse: Option<f64>,

    /// relMSE is the mean of (a-b)^2 / (b^2 + E)
    /// [default: 0.01 times the squared mean of B]
    #[arg(long, value_name = "E", value_parser = parse_positive)]
    pub epsilon: Option<f64>,

    /// Print JSON instead of text; figures that do not exist are null
    #[arg(long)]
    pub json: bool,
}

fn parse_positive(text: &str) -> Result<f64, &'static str> {
    let number = text.parse().ok().filter(|x: &f64| x.is_finite() && *x >= 0.0);
    number.ok_or("wanted a number from 0 on, as 0.01 or 1e-4")
}

pub(super) fn diff(options: &DiffOptions) -> Result<(), Failure> {
    let comparison = compare(options)?;
    if options.json {
        tell_json(&format!("{:#}", to_json(options, &comparison)))?;
    } else {
        lines(options, &comparison).iter().try_for_each(tell)?;
    }
    judge(&comparison, options.max_relmse)
}

fn compare(options: &DiffOptions) -> Result<Comparison, Failure> {
    let [a, b] = [&options.picture, &options.reference];
    let (x, r) = (any::load(a)?, any::load(b)?);
    let (a, b) = (a.display(), b.display());
    if (x.width(), x.height()) != (r.width(), r.height()) {
        return Err(Failure::scene(format_args!(
            "{a} has {}x{} pixels and {b} {}x{}: only pictures of one size can be compared",
            x.width(),
            x.height(),
            r.width(),
            r.height(),
        )));
    }
    Comparison::of(&x, &r, options.epsilon).ok_or_else(|| {
        Failure::scene(format_args!("{a} and {b} have no pixel that is finite in both"))
    })
}

fn judge(comparison: &Comparison, most: Option<f64>) -> Result<(), Failure> {
    let Some(most) = most else { return Ok(()) };
    let error = comparison.error.rel_mse;
    if error > most {
        return Err(Failure::different(format_args!(
            "relMSE {error:.4e} is more than the {most:e} of --max-relmse"
        )));
    }
    match comparison.left_out.pixels {
        [0, 0] => Ok(()),
        [a, b] => Err(Failure::different(format_args!(
            "pixels are not finite, {a} of the picture and {b} of the reference: with --max-relmse none may be"
        ))),
    }
}

fn lines(options: &DiffOptions, comparison: &Comparison) -> Vec<String> {
    let Comparison { size: [width, height], epsilon, error, bias, worst, left_out } = comparison;
    let (a, b) = (options.picture.display(), options.reference.display());
    let z = bias.z.map_or_else(|| "none".into(), |z| format!("{z:.2}"));
    let mut lines = vec![
        format!("{a} against {b}, {width}x{height} pixels"),
        format!("relMSE   {:.4e}  with epsilon {epsilon:.4e}", error.rel_mse),
        format!("trimmed  {:.4e}  without the worst 0.1 % of pixels", error.trimmed_rel_mse),
        format!("SMAPE    {:.4e}  from 0 to 1", error.smape),
        format!("MSE      {:.4e}", error.mse),
        format!(
            "bias     {:+.4} %  mean over mean of the reference, less one",
            percent(error.mean_ratio)
        ),
        format!("z        {z}  standard errors that the bias is from zero, if the errors of"),
        format!("         the {} blocks of {SIDE}x{SIDE} pixels are independent", bias.blocks),
    ];
    lines.push(worst.map_or_else(|| "worst    no pixel differs".into(), worst_line));
    lines.extend(left_out.first.map(|first| left_out_line(left_out, first)));
    lines
}

fn percent(ratio: f64) -> f64 {
    100.0 * (ratio - 1.0)
}

fn worst_line(worst: Worst) -> String {
    let [x, y] = worst.at;
    let bands = |light: [f64; 3]| light.map(|band| format!("{band:.4}")).join(" ");
    format!(
        "worst    {:.4e}  at {x},{y}: {} where {} is right",
        worst.error,
        bands(worst.picture),
        bands(worst.reference)
    )
}

fn left_out_line(left_out: &LeftOut, [x, y]: [usize; 2]) -> String {
    let [a, b] = left_out.pixels;
    format!(
        "left out  pixels that are not finite, {a} of the picture and {b} of the reference, first {x},{y}"
    )
}

fn to_json(options: &DiffOptions, comparison: &Comparison) -> Value {
    let Comparison { size, epsilon, error, bias, worst, left_out } = comparison;
    json!({
        "picture": options.picture.to_string_lossy(),
        "reference": options.reference.to_string_lossy(),
        "width": size[0],
        "height": size[1],
        "epsilon": epsilon,
        "rel_mse": error.rel_mse,
        "trimmed_rel_mse": error.trimmed_rel_mse,
        "smape": error.smape,
        "mse": error.mse,
        "bias": error.mean_ratio - 1.0,
        "bias_z": bias.z,
        "blocks": bias.blocks,
        "worst": worst.map(|worst| json!({
            "at": worst.at,
            "error": worst.error,
            "picture": worst.picture,
            "reference": worst.reference,
        })),
        "left_out": {
            "picture": left_out.pixels[0],
            "reference": left_out.pixels[1],
            "first": left_out.first,
        },
    })
}
