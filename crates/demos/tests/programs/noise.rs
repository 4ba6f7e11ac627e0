//! `--noise`: rendering until the error is small enough.

use crate::common::Folder;
use serde_json::Value;

const SCENE: &str = "cornell --resolution 16x12";

/// Returns the work that was done, by the file that says it.
fn stats(folder: &Folder) -> Value {
    serde_json::from_slice(&folder.bytes("done.json")).unwrap()
}

#[test]
fn it_ends_a_rendering_and_is_named() {
    let folder = Folder::new();
    let words = format!("{SCENE} --spp 4000 --noise 5% --stats done.json -o a.exr");
    let run = folder.run("bdpt", &words);
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert!(run.err.contains("ended by --noise"), "{}", run.err);
    let stats = stats(&folder);
    assert_eq!(stats["endedBy"], "--noise");
    assert!(stats["relativeError"].as_f64().unwrap() <= 0.05, "{stats}");
    let spp = stats["spp"].as_u64().unwrap();
    assert!((17..4000).contains(&spp), "{stats}");
    // One look before it was not so good, and the picture is that of so many samples.
    let step = 1 << (spp.ilog2() - 4);
    let before = format!("{SCENE} --spp {} --stats done.json -q -o b.exr", spp - step);
    assert_eq!(folder.run("bdpt", &before).status, Some(0));
    assert!(self::stats(&folder)["relativeError"].as_f64().unwrap() > 0.05);
    let again = format!("{SCENE} --spp {spp} --checkpoint a.film -q -o b.exr");
    assert_eq!(folder.run("bdpt", &again).status, Some(0));
    let resumed = format!(
        "{SCENE} --spp 4000 --noise 5% --checkpoint a.film --resume --stats done.json -q -o c.exr"
    );
    assert_eq!(folder.run("bdpt", &resumed).status, Some(0));
    assert_eq!(self::stats(&folder)["rays"]["camera"], 0, "nothing was left to do");
    assert_eq!(folder.bytes("b.exr"), folder.bytes("c.exr"));
}

#[test]
fn who_does_not_get_there_says_so() {
    let folder = Folder::new();
    let run = folder.run("bdpt", &format!("{SCENE} --spp 20 --noise 0.0001 -q"));
    assert_eq!(run.status, Some(5));
    assert!(run.err.contains("--noise 0.0001 is not reached"), "{}", run.err);
    assert!(folder.names().contains(&"bdpt.png".to_string()));
    let endless = folder.run("bdpt", &format!("{SCENE} --noise 1%"));
    assert_eq!(endless.status, Some(2));
    assert!(endless.err.contains("needs --spp or --time-limit"), "{}", endless.err);
}
