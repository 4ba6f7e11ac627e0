//! Commands on picture files: their contents, how far two are apart, one format made another, and
//! one film of many.

use clap::Parser;
use std::process::ExitCode;
use traylib_demos::{FilmCommand, parse};

const EXAMPLES: &str = "\
Examples:
  film info bdpt.exr                             size, channels, how it was made
  film diff noisy.exr reference.exr              the second is taken for the truth
  film diff a.exr b.exr --max-relmse 1e-3        status 7 if they differ by more
  film info bdpt.png                             PNG says how it was made, too
  film convert bdpt.exr bdpt.png --exposure 2    formats by content and by ending
  film merge part-*.film -o all.film             of `bdpt --shard 0/7` and so on
  film denoise bdpt.film quiet.png               of `bdpt --checkpoint bdpt.film`

Light is channels R, G and B, or Y alone: without a prefix, or of a layer named
as beauty or Combined, or the only ones there are. Pixels that are not finite in
one of two pictures are left out of all figures and counted.

Numbers of other formats than EXR and HDR are on the sRGB curve; as light, which
`info` and `diff` tell of, they go from 0 to 1.

Ends with 0, 2 if the command line was not understood, 3 if a picture cannot be
read or sizes differ, 4 if the result cannot be written, 6 if films do not fit
together or passes are missing, 7 if pictures differ by
more than --max-relmse, 130 after Ctrl-C.";

/// Looks into pictures of any renderer, compares and converts them
#[derive(Parser)]
#[command(
    name = "film",
    version = traylib_demos::VERSION,
    max_term_width = 80,
    after_long_help = EXAMPLES
)]
struct Options {
    #[command(subcommand)]
    command: FilmCommand,
}

fn main() -> ExitCode {
    parse::<Options>().command.run()
}
