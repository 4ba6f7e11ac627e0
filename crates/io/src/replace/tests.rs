use super::*;
use crate::picture::tests::Folder;

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap()
}

#[test]
fn names_may_be_as_long_as_the_system_lets_them() {
    let folder = Folder::new("long");
    let path = folder.path().join("ä".repeat(127));
    write_file(&path, b"one").unwrap();
    write_file(&path, b"two").unwrap();
    assert_eq!((read(&path).as_str(), folder.files().len()), ("two", 1));
}

#[test]
fn a_folder_that_is_missing_is_named_as_such() {
    let folder = Folder::new("missing");
    let path = folder.path().join("none").join("a.txt");
    for refused in [check_file(&path), write_file(&path, b"new")] {
        let said = refused.unwrap_err().to_string();
        assert!(said.ends_with("a.txt: cannot be written: there is no such folder"), "{said}");
    }
    assert!(!folder.path().join("none").exists());
}

/// Files that a killed run left are removed; those that another is writing, or that only look
/// alike, stay.
#[test]
fn only_what_nobody_holds_is_tidied_up() {
    let folder = Folder::new("leftovers");
    let path = |name: &str| folder.path().join(name);
    let held = ".a.txt.00000000000000ff.part";
    let lock = File::create(path(held)).unwrap();
    lock.lock().unwrap();
    let others =
        [".a.txt.0123456789abcde.part", ".a.txt.notes.part", ".b.txt.0123456789abcdef.part"];
    for name in others.iter().chain(&[".a.txt.0123456789abcdef.part"]) {
        fs::write(path(name), "").unwrap();
    }
    write_file(&path("a.txt"), b"new").unwrap();
    let mut left = folder.files();
    left.sort();
    let mut expected = [held, others[0], others[1], others[2], "a.txt"];
    expected.sort_unstable();
    assert_eq!(left, expected);
    drop(lock);
    check_file(&path("a.txt")).unwrap();
    assert!(!path(held).exists() && read(&path("a.txt")) == "new");
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
    use std::process::Command;

    fn cause(path: &Path) -> String {
        let refused = [check_file(path), write_file(path, b"new")].map(|done| done.unwrap_err());
        let [checked, written] = refused.map(|error| error.to_string());
        assert_eq!(checked, written);
        checked.rsplit(": ").next().unwrap().to_owned()
    }

    #[test]
    fn permissions_are_kept() {
        let folder = Folder::new("mode");
        let path = folder.path().join("a");
        fs::write(&path, "old").unwrap();
        for mode in [0o600, 0o640, 0o777] {
            fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
            write_file(&path, b"new").unwrap();
            assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o7777, mode);
        }
    }

    #[test]
    fn a_link_stays_and_its_file_is_replaced() {
        let folder = Folder::new("link");
        let [link, file] = ["link", "there/file"].map(|name| folder.path().join(name));
        fs::create_dir(folder.path().join("there")).unwrap();
        fs::write(&file, "old").unwrap();
        symlink("there/file", &link).unwrap();
        write_file(&link, b"new").unwrap();
        assert!(link.is_symlink());
        assert_eq!((read(&file).as_str(), folder.files().len()), ("new", 2));
        fs::remove_file(&file).unwrap();
        assert_eq!(cause(&link), "it is a link that leads to no file");
    }

    /// The permissions decide, even where the system lets its administrator.
    #[test]
    fn what_is_read_only_is_refused() {
        let folder = Folder::new("read-only");
        let path = folder.path().join("a");
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
        assert_eq!(cause(&path), "it is read-only");
        assert_eq!((read(&path).as_str(), folder.files().len()), ("old", 1));
    }

    #[test]
    fn a_pipe_is_written_into() {
        let folder = Folder::new("pipe");
        let pipe = folder.path().join("pipe");
        assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        check_file(&pipe).unwrap();
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || read(&pipe)
        });
        write_file(&pipe, b"new").unwrap();
        assert_eq!(reader.join().unwrap(), "new");
        assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
        let _listener = std::os::unix::net::UnixListener::bind(folder.path().join("socket"));
        assert_eq!(cause(&folder.path().join("socket")), "it is neither a file nor a pipe");
    }
}
