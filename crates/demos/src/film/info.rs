//! `film info`.

use super::any::{self, is_film};
use super::merge::{passes as range_words, ranges};
use crate::outcome::Failure;
use crate::say::{tell, tell_json};
use clap::Args;
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};
use traylib_io::{ExrChannel, ExrFile, ExrLayer, FilmAbout, FilmReader};

/// Files to look into.
#[derive(Args, Clone, Debug)]
pub struct InfoOptions {
    /// Pictures of any format that `film convert` reads, and films
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,

    /// Print JSON instead of text; figures that do not exist are null
    #[arg(long)]
    pub json: bool,
}

pub(super) fn info(options: &InfoOptions) -> Result<(), Failure> {
    if options.json {
        let files: Result<Vec<Value>, Failure> =
            options.files.iter().map(|path| file_json(path)).collect();
        return tell_json(&format!("{:#}", Value::from(files?)));
    }
    options.files.iter().try_for_each(|path| {
        if is_film(path) {
            return film_lines(&FilmReader::open(path)?).into_iter().try_for_each(tell);
        }
        let file = any::open(path)?;
        tell(format_args!("{}: {}x{} pixels", path.display(), file.width, file.height))?;
        file.layers.iter().flat_map(lines).try_for_each(tell)
    })
}

/// Lists the description of a film; its sums are not looked at.
fn film_lines(film: &FilmReader) -> Vec<String> {
    let [width, height] = film.size();
    let passes = ranges(film.shape().pass_numbers().into_iter());
    let passes = passes.iter().map(range_words).collect::<Vec<_>>().join(", ");
    let FilmAbout { settings, notes, counters } = film.about();
    let mut lines = vec![
        format!("{}: film of {width}x{height} pixels", film.path().display()),
        format!("  {} passes: {passes}", film.shape().passes()),
    ];
    let text = |(name, text): &(String, String)| format!("    {} = {}", plain(name), plain(text));
    lines.extend(settings.iter().chain(notes).map(text));
    lines.extend(counters.iter().map(|(name, counter)| format!("    {} = {counter}", plain(name))));
    lines
}

fn file_json(path: &Path) -> Result<Value, Failure> {
    if is_film(path) {
        Ok(film_json(&FilmReader::open(path)?))
    } else {
        Ok(to_json(path, &any::open(path)?))
    }
}

fn film_json(film: &FilmReader) -> Value {
    let [width, height] = film.size();
    let FilmAbout { settings, notes, counters } = film.about();
    let texts = |texts: &[(String, String)]| -> Map<String, Value> {
        texts.iter().cloned().map(|(name, text)| (name, text.into())).collect()
    };
    let passes = ranges(film.shape().pass_numbers().into_iter());
    json!({
        "file": film.path().to_string_lossy(),
        "width": width,
        "height": height,
        "passes": passes.iter().map(|range| [range.start, range.end]).collect::<Vec<_>>(),
        "settings": texts(settings),
        "notes": texts(notes),
        "counters": counters.iter().cloned().map(|(name, n)| (name, n.into())).collect::<Map<String, Value>>(),
    })
}

fn lines(layer: &ExrLayer) -> Vec<String> {
    let ([x, y], width, height) = (layer.at, layer.width, layer.height);
    let name = layer.name.as_deref().map_or_else(String::new, |name| format!(" {}", plain(name)));
    let mut lines = vec![format!("  layer{name}: {width}x{height} pixels at {x},{y}")];
    lines.extend(layer.channels.iter().map(channel_line));
    let attribute =
        |(name, value): &(String, String)| format!("    {} = {}", plain(name), plain(value));
    lines.extend(layer.attributes.iter().map(attribute));
    lines
}

/// Text of a file, which is to stay on its line.
fn plain(text: &str) -> String {
    text.replace(['\n', '\t'], " ")
}

fn channel_line(channel: &ExrChannel) -> String {
    let found = Summary::of(&channel.values);
    let range = found.range.map_or_else(
        || "no finite value".into(),
        |[mean, min, max]| format!("mean {mean:.4e}, min {min:.4e}, max {max:.4e}"),
    );
    let Summary { not_finite, negative, .. } = found;
    let (name, kind) = (plain(&channel.name), channel.kind);
    format!("    {name} {kind}: {range}; {not_finite} not finite, {negative} negative")
}

/// The statistics of a channel's values.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Summary {
    /// Mean, least and greatest of those that are finite, if any is.
    range: Option<[f64; 3]>,
    not_finite: usize,
    negative: usize,
}

impl Summary {
    fn of(values: &[f32]) -> Self {
        let finite = || values.iter().filter(|value| value.is_finite()).map(|&x| f64::from(x));
        let count = finite().count();
        let range = (count > 0).then(|| {
            let mean = finite().sum::<f64>() / count as f64;
            [
                mean,
                finite().fold(f64::INFINITY, f64::min),
                finite().fold(f64::NEG_INFINITY, f64::max),
            ]
        });
        let negative = values.iter().filter(|&&value| value < 0.0).count();
        Self { range, not_finite: values.len() - count, negative }
    }
}

fn to_json(path: &Path, file: &ExrFile) -> Value {
    json!({
        "file": path.to_string_lossy(),
        "width": file.width,
        "height": file.height,
        "layers": file.layers.iter().map(layer_json).collect::<Vec<_>>(),
    })
}

fn layer_json(layer: &ExrLayer) -> Value {
    let attributes = layer.attributes.iter().cloned().map(|(name, text)| (name, text.into()));
    json!({
        "name": layer.name,
        "at": layer.at,
        "width": layer.width,
        "height": layer.height,
        "channels": layer.channels.iter().map(channel_json).collect::<Vec<_>>(),
        "attributes": attributes.collect::<Map<String, Value>>(),
    })
}

fn channel_json(channel: &ExrChannel) -> Value {
    let Summary { range, not_finite, negative } = Summary::of(&channel.values);
    let [mean, min, max] = range.map_or([None; 3], |range| range.map(Some));
    json!({
        "name": channel.name,
        "kind": channel.kind,
        "mean": mean,
        "min": min,
        "max": max,
        "not_finite": not_finite,
        "negative": negative,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_finite_values_have_a_mean() {
        let found = Summary::of(&[1.0, f32::NAN, -3.0, f32::NEG_INFINITY, 5.0]);
        let expected = Summary { range: Some([1.0, -3.0, 5.0]), not_finite: 2, negative: 2 };
        assert_eq!(found, expected);
        let nothing = Summary { range: None, not_finite: 1, negative: 0 };
        assert_eq!(Summary::of(&[f32::NAN]), nothing);
    }
}
