//! Writes the page of a made-up comparison, to look at: `sample_page FILE`.

use std::error::Error;
use traylib_compare::{page, sample};

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).ok_or("which file? give its name")?;
    let (results, pictures) = sample::sample();
    Ok(std::fs::write(file, page::page(&results, &pictures))?)
}
