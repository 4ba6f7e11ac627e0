//! `film merge`.

use crate::checkpoint::{SHARD, shard, spp};
use crate::outcome::Failure;
use crate::say::{say_line, tell_name};
use crate::shard::Shard;
use clap::Args;
use std::collections::BTreeSet;
use std::ops::Range;
use std::path::PathBuf;
use traylib_io::{FilmReader, check_file, check_films_fit, merge_films};
use traylib_scene::Film;

/// Films to make one.
#[derive(Args, Clone, Debug)]
pub struct MergeOptions {
    /// Films of parts of one rendering, in any order
    #[arg(value_name = "FILM", required = true)]
    pub films: Vec<PathBuf>,

    /// Film to write; the same bytes as if all had been rendered at once
    #[arg(short, long = "outfile", visible_alias = "output", value_name = "FILE")]
    pub outfile: PathBuf,

    /// Write it also if passes are missing, and only warn of them
    #[arg(long)]
    pub partial: bool,
}

pub(super) fn merge(options: &MergeOptions) -> Result<(), Failure> {
    let MergeOptions { films, outfile, partial } = options;
    if !outfile.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("film")) {
        return Err(Failure::usage(format_args!(
            "{}: merged films are written as .film; `film convert` makes a picture of one",
            outfile.display()
        )));
    }
    check_file(outfile)?;
    let mut films =
        films.iter().map(|file| FilmReader::open(file)).collect::<Result<Vec<_>, _>>()?;
    let whole = check_films_fit(&mut films)?;
    if let Some(missing) = missing(&films, &whole) {
        if !partial {
            return Err(Failure::unfit(missing));
        }
        say_line("warning", missing);
    }
    // It is no part any more.
    let notes = films[0].about().notes.iter().filter(|(name, _)| name != SHARD).cloned().collect();
    merge_films(outfile, &mut films, notes)?;
    tell_name(outfile)
}

/// Names the passes and parts that are missing, if any.
fn missing(films: &[FilmReader], whole: &Film) -> Option<String> {
    let spp = films.iter().filter_map(|film| spp(film.about())).max()?;
    let has: BTreeSet<u32> = whole.pass_numbers().into_iter().collect();
    let missing = ranges((0..spp).filter(|pass| !has.contains(pass)));
    if missing.is_empty() {
        return None;
    }
    let names: Vec<String> = missing.iter().map(passes).collect();
    let parts: Vec<String> = shards_of(films)
        .map(|shard| (shard, shard.passes(spp)))
        .filter_map(|(shard, range)| {
            match range.clone().filter(|pass| has.contains(pass)).count() {
                done if done == range.len() => None,
                0 => Some(format!("part {shard} is missing")),
                done => Some(format!("part {shard} has {done} of {} passes", range.len())),
            }
        })
        .collect();
    let count: usize = missing.iter().map(ExactSizeIterator::len).sum();
    let parts = if parts.is_empty() { parts } else { [vec![String::new()], parts].concat() };
    Some(format!("{count} of {spp} passes are missing: {}{}", listed(&names), parts.join("; ")))
}

/// All parts, if the films are parts of as many.
fn shards_of(films: &[FilmReader]) -> impl Iterator<Item = Shard> {
    let shards: Option<Vec<Shard>> = films.iter().map(|film| shard(film.about())).collect();
    let shards = shards.unwrap_or_default();
    let first = shards.first().copied();
    let first = first.filter(|first| shards.iter().all(|shard| shard.is_beside(*first)));
    first.into_iter().flat_map(Shard::all)
}

/// Numbers that rise, as ranges.
pub(super) fn ranges(numbers: impl Iterator<Item = u32>) -> Vec<Range<u32>> {
    let mut ranges: Vec<Range<u32>> = Vec::new();
    for number in numbers {
        match ranges.last_mut() {
            Some(range) if range.end == number => range.end += 1,
            _ => ranges.push(number..number + 1),
        }
    }
    ranges
}

pub(super) fn passes(range: &Range<u32>) -> String {
    match range.len() {
        1 => range.start.to_string(),
        _ => format!("{} to {}", range.start, range.end - 1),
    }
}

/// The first of them; a line is no place for thousands.
fn listed(words: &[String]) -> String {
    const MOST: usize = 8;
    let more = words.len().saturating_sub(MOST);
    let first = words[..words.len() - more].join(", ");
    if more == 0 { first } else { format!("{first} and {more} more places") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_are_named_in_ranges() {
        let found = ranges([0, 1, 2, 5, 7, 8].into_iter());
        assert_eq!(found.iter().map(passes).collect::<Vec<_>>(), ["0 to 2", "5", "7 to 8"]);
        let words: Vec<String> = (0..10).map(|n| n.to_string()).collect();
        assert_eq!(listed(&words), "0, 1, 2, 3, 4, 5, 6, 7 and 2 more places");
    }
}
