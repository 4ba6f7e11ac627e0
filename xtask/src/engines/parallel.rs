//! GNU parallel on this machine.

use super::{OPTIONS, PARTS, PROGRAM, Place, SCENE};
use crate::workspace;
use anyhow::{Result, ensure};
use std::fs::File;

/// Seven tasks, two at a time, one of which is killed.
pub(super) fn run(place: &Place) -> Result<String> {
    let task = format!(
        "{PROGRAM} {SCENE} {OPTIONS} --shard {{}}/{PARTS} --checkpoint part-{{}}.film --resume"
    );
    let mut command = place.command("parallel");
    command.args(["--jobs", "2", "--retries", "3", "--halt", "soon,fail=1", &task, ":::"]);
    command.args((0..PARTS).map(|part| part.to_string()));
    let log = File::create(place.folder.join("log"))?;
    let mut child = command.stdout(log.try_clone()?).stderr(log).spawn()?;
    let killed = place.wait_for_part(1).and_then(|()| place.kill_part(1));
    ensure!(child.wait()?.success(), "a part failed");
    killed?;
    ensure!(place.went_on("log")?, "no part went on");
    let parts: Vec<String> = (0..PARTS).map(|part| format!("part-{part}.film")).collect();
    let merge = ["merge", "-o", "all.film"];
    workspace::finish(place.command("film").args(merge).args(parts))?;
    workspace::finish(place.command("film").args(["convert", "all.film", "all.exr"]))?;
    Ok(format!("{PARTS} tasks, one killed"))
}
