use super::*;
use injection::inject;
use std::collections::BTreeSet;

const CLEAN: &str = "one\ntwo\nthree\nfour\nfive\nsix\nseven\n";

/// A fault that puts a line behind the line with this number.
fn fault(name: &str, line: usize) -> Fault {
    let mut lines: Vec<String> = CLEAN.lines().map(|line| format!("{line}\n")).collect();
    lines.insert(line, format!("injected!({name})\n"));
    let patch = diffy::create_patch(CLEAN, &lines.concat()).to_string();
    let patch = patch.replace("--- original", "--- a/file").replace("+++ modified", "+++ b/file");
    Fault::parse(name, &format!("All is wrong.\n\n{patch}")).unwrap()
}

/// All of the project's Rust, by file.
fn sources() -> Vec<(String, String)> {
    let files = copy::files(root()).unwrap().into_iter();
    let rust = files.filter(|file| Path::new(file).extension().is_some_and(|e| e == "rs"));
    rust.map(|file| (file.clone(), injection::read(root(), &file).unwrap())).collect()
}

#[test]
fn all_patches_apply() {
    let faults = Fault::all().unwrap();
    assert!(!faults.is_empty());
    if let Err(error) = injection::inject_all(root(), &faults) {
        panic!("\n{error}");
    }
}

#[test]
fn the_sources_say_nothing_of_faults() {
    for (file, text) in sources().iter().filter(|(file, _)| file.starts_with("crates/")) {
        assert!(!text.contains("injected!"), "{file}");
    }
}

#[test]
fn the_page_on_proofs_lists_every_fault_with_tests_that_are_there() {
    let page = fs::read_to_string(root().join("docs/proofs.md")).unwrap();
    let (_, section) = page.split_once("## Fault injection").unwrap();
    let rows = section.lines().filter_map(|line| line.strip_prefix("| "));
    let rows: Vec<Vec<&str>> = rows.skip(1).map(|row| row.split(" | ").collect()).collect();
    let listed: BTreeSet<&str> = rows.iter().map(|row| row[0]).collect();
    let faults = Fault::all().unwrap();
    let there: BTreeSet<&str> = faults.iter().map(|fault| fault.name.as_str()).collect();
    assert_eq!(listed, there);

    let sources: String = sources().into_iter().map(|(_, text)| text).collect();
    for test in rows.iter().flat_map(|row| row[2].split('`')).filter(|part| part.contains("::")) {
        let name = test.rsplit("::").next().unwrap();
        assert!(sources.contains(&format!("fn {name}(")), "there is no test {test}");
    }
}

#[test]
fn faults_are_chosen_by_name() {
    let faults = [fault("Some", 2), fault("Other", 3)];
    let names = |names: &[&str]| -> Result<Vec<String>> {
        Ok(chosen(&faults, names)?.iter().map(|fault| fault.name.clone()).collect())
    };
    assert_eq!(names(&[]).unwrap(), ["Some", "Other"]);
    assert_eq!(names(&["Other"]).unwrap(), ["Other"]);
    let error = names(&["NoSuch"]).unwrap_err().to_string();
    assert_eq!(error, "no fault `NoSuch`; there are Some, Other");
}

#[test]
fn neighbouring_faults_apply_together() {
    let (a, b) = (fault("First", 3), fault("Second", 4));
    let one = inject(CLEAN, CLEAN, "First", &a.changes().unwrap()[0]).unwrap();
    let both = inject(CLEAN, &one, "Second", &b.changes().unwrap()[0]).unwrap();
    let order = "three\ninjected!(First)\nfour\ninjected!(Second)\nfive\n";
    assert!(both.contains(order), "{both}");
}

#[test]
fn a_patch_that_does_not_apply_is_refused_in_one_line() {
    let fault = fault("Lost", 3);
    let change = &fault.changes().unwrap()[0];
    // Further down is no hindrance.
    let moved = format!("zero\n{CLEAN}");
    assert!(inject(&moved, &moved, "Lost", change).is_ok());
    let text = CLEAN.replace("four", "4");
    assert_eq!(
        inject(&text, &text, "Lost", change).unwrap_err(),
        "Lost.patch no longer applies to file: `cargo xtask faults --edit Lost`, make the \
         change there, then `cargo xtask faults --save Lost`"
    );
    let taken = CLEAN.replace("three\n", "three\nanother\n");
    let refusal = inject(CLEAN, &taken, "Lost", change).unwrap_err();
    assert!(refusal.contains("changes lines of file that another does"), "{refusal}");
}

#[test]
fn a_fault_says_what_is_wrong_and_asks_for_itself_alone() {
    let text = fault("Sound", 3).text();
    let why = |name: &str, text: &str| Fault::parse(name, text).unwrap_err().to_string();
    assert_eq!(Fault::parse("Sound", &text).unwrap().text(), text);
    assert!(why("Sound", text.split_once("\n\n").unwrap().1).contains("what is wrong"));
    assert_eq!(why("Other", &text), "asks for another fault, Sound");
    assert!(why("no-name", &text).contains("not a name"));
    let silent = text.replace("injected!(Sound)", "four and a half");
    assert_eq!(why("Sound", &silent), "changes file without asking for `injected!(Sound)`");
}

/// The patch that is saved from a changed copy is the change.
#[test]
fn a_patch_is_saved_from_a_changed_copy() {
    let folder = tempfile::tempdir().unwrap();
    let (clean, tree) = (folder.path().join("clean"), folder.path().join("tree"));
    fs::create_dir_all(clean.join("crates/math/src")).unwrap();
    fs::write(clean.join(support::CRATE), CLEAN).unwrap();
    fs::write(clean.join("other"), "left alone").unwrap();
    let fault = fault("Kept", 3);
    let text = inject(CLEAN, CLEAN, "Kept", &fault.changes().unwrap()[0]).unwrap();
    let mut changed = injection::Texts::from([(support::CRATE.to_owned(), text)]);
    support::add(&clean, &mut changed, ["Kept"].into_iter()).unwrap();
    copy::write(&clean, &tree, &changed).unwrap();
    let patch = edit::difference(&clean, &tree).unwrap();
    let added = fs::read_to_string(tree.join(support::MODULE)).unwrap();
    assert!(added.ends_with("faults! { Kept }\n"), "{added}");
    assert_eq!(patch, fault.text().split_once("\n\n").unwrap().1.replace("file", support::CRATE));
}

#[test]
fn a_fault_that_nothing_finds_stands_out() {
    let missed = Catch { fault: "PowerByPowf", extent: Extent::Whole, outcome: Outcome::default() };
    assert_eq!(row(&missed), "| PowerByPowf | **nothing** | 0 | - |  |\n");
}
