//! Files that are written: what they replace, and what they leave.

use crate::common::{Folder, Run};
use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::process::{Command, Stdio};
use traylib_io::load_exr;

const TINY: &str = "cornell --resolution 8x6 --spp 1 -q";

/// Another user who may write to a folder could have put a link where a program writes first.
#[test]
fn nothing_is_written_through_a_link_that_waits_for_it() {
    let folder = Folder::new();
    folder.write("mine", "mine");
    let options = format!("{TINY} -o a.exr");
    let command = folder.command("bdpt", &options);
    // A shell's process becomes the program's, so the link has its number.
    let script =
        format!("ln -s mine .a.exr.$$.tmp; exec {} \"$@\"", command.get_program().display());
    let mut shell = Command::new("sh");
    shell.current_dir(folder.path()).args(["-c", &script, "sh"]).args(command.get_args());
    let run = Run::from(shell.output().unwrap());
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    assert_eq!(fs::read(folder.path().join("mine")).unwrap(), b"mine");
}

#[test]
fn a_disk_quota_is_an_error_and_leaves_nothing() {
    let folder = Folder::new();
    folder.write("small.exr", "old");
    for output in ["big.exr", "small.exr"] {
        let before = folder.names();
        let program = env!("CARGO_BIN_EXE_bdpt");
        // Files of 512 bytes at most.
        let script = format!(
            "ulimit -f 1; exec {program} cornell --resolution 64x48 --spp 1 -q -o {output}"
        );
        let mut shell = Command::new("sh");
        let run =
            Run::from(shell.current_dir(folder.path()).args(["-c", &script]).output().unwrap());
        assert_eq!((run.status, run.out.as_str()), (Some(4), ""), "{}", run.err);
        assert!(
            run.err.starts_with(&format!("error: {output}: cannot be written: ")),
            "{}",
            run.err
        );
        assert_eq!((run.err.lines().count(), folder.names()), (1, before));
    }
    assert_eq!(fs::read(folder.path().join("small.exr")).unwrap(), b"old");
}

#[test]
fn links_and_permissions_are_kept() {
    let folder = Folder::new();
    folder.write("file.exr", "old");
    let [file, link] = ["file.exr", "link.exr"].map(|name| folder.path().join(name));
    fs::set_permissions(&file, fs::Permissions::from_mode(0o600)).unwrap();
    symlink("file.exr", &link).unwrap();
    let run = folder.run("bdpt", &format!("{TINY} -o link.exr"));
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    assert!(link.is_symlink());
    assert_eq!(load_exr(&file).unwrap().width(), 8);
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o600);
}

#[test]
fn what_must_not_be_replaced_is_refused_before_the_work() {
    let folder = Folder::new();
    folder.write("kept.exr", "old");
    let kept = folder.path().join("kept.exr");
    fs::set_permissions(&kept, fs::Permissions::from_mode(0o444)).unwrap();
    symlink("nothing.exr", folder.path().join("link.exr")).unwrap();
    let before = folder.names();
    for (output, why) in
        [("kept.exr", "it is read-only"), ("link.exr", "it is a link that leads to no file")]
    {
        let run = folder.run("bdpt", &format!("cornell --time-limit 1h -q -o {output}"));
        assert_eq!((run.status, run.out.as_str()), (Some(4), ""));
        assert_eq!(run.err, format!("error: {output}: cannot be written: {why}\n"));
    }
    assert_eq!((fs::read(&kept).unwrap().as_slice(), folder.names()), (b"old".as_slice(), before));
}

#[test]
fn a_killed_run_leaves_nothing_for_longer_than_the_next() {
    let folder = Folder::new();
    folder.write(".a.exr.0123456789abcdef.part", "half");
    let run = folder.run("bdpt", &format!("{TINY} -o a.exr"));
    assert_eq!((run.status, folder.names()), (Some(0), vec!["a.exr".to_owned()]), "{}", run.err);
}

/// Figures, too, go into a pipe.
#[test]
fn a_pipe_is_written_into() {
    let folder = Folder::new();
    let pipe = folder.path().join("pipe.exr");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    for arguments in [format!("{TINY} -o pipe.exr"), "--check cornell --stats pipe.exr".to_owned()]
    {
        let mut reader = Command::new("cat");
        let reader = reader.arg(&pipe).stdout(Stdio::piped()).spawn().unwrap();
        let run = folder.run("bdpt", &arguments);
        assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
        assert!(reader.wait_with_output().unwrap().stdout.len() > 100);
        assert_eq!(folder.names(), ["pipe.exr"]);
    }
}
