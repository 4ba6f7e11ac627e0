//! Renderings that are disturbed at any moment, again and again, and have the bytes of one that
//! was not.

use crate::checkpoints::{assert_same, undisturbed};
use crate::common::{Dice, Folder, MODES, Run, file, files};
use std::fs;
use std::process::{Command, Stdio};
use std::time::Duration;
use traylib_io::load_film;

/// An event that disturbs a program at work.
#[derive(Clone, Copy, Debug)]
enum Disturbance {
    /// It is killed, and hears nothing of it.
    Kill,
    /// It is told to end.
    Terminate,
    /// Its files can grow no further, as on a full disk.
    FullDisk,
}

impl Disturbance {
    const ALL: [Self; 3] = [Self::Kill, Self::Terminate, Self::FullDisk];

    /// Runs a program with it, at a moment or a size up to those given.
    fn disturb(self, dice: &mut Dice, worst: &Worst, folder: &Folder, words: (&str, &str)) -> Run {
        let (program, options) = words;
        let blocks = dice.below(worst.blocks);
        let limit =
            if matches!(self, Self::FullDisk) { blocks.to_string() } else { "unlimited".into() };
        let program = file(program);
        let script = format!("ulimit -f {limit}; exec {} {options}", program.display());
        let mut shell = Command::new("sh");
        shell.current_dir(folder.path()).args(["-c", &script]);
        let mut child = shell.stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
        let wait = Duration::from_micros(dice.below(worst.wait.as_micros() as u64));
        match self {
            Self::Kill => {
                std::thread::sleep(wait);
                child.kill().unwrap();
            }
            Self::Terminate => {
                std::thread::sleep(wait);
                // It may be done, and not yet waited for.
                let kill = Command::new("kill").args(["-TERM", &child.id().to_string()]).status();
                assert!(kill.unwrap().success());
            }
            Self::FullDisk => {}
        }
        Run::from(child.wait_with_output().unwrap())
    }

    /// Tells whether a run that it met ended as it should; `None` if it met none.
    fn ended(self, run: &Run) -> Option<bool> {
        let lines = run.err.lines().count();
        match (self, run.status) {
            (_, Some(0)) => None,
            (Self::Kill, status) => Some(status.is_none()),
            // Without a word while it starts.
            (Self::Terminate, None) => Some(lines == 0),
            (Self::Terminate, Some(status)) => Some(status == 143 && lines == 1),
            (Self::FullDisk, status) => {
                Some(status == Some(4) && lines == 1 && run.err.contains(": cannot be written: "))
            }
        }
    }
}

/// The bounds on how late and how large a disturbance may be.
#[derive(Clone, Copy)]
struct Worst {
    wait: Duration,
    /// The largest bound on the size of files, in blocks of 512 bytes.
    blocks: u64,
}

/// Films that are there are whole, and none is lost.
fn check_films(folder: &Folder, had_one: &mut bool, what: &str) {
    let names = folder.names();
    for name in ["a.film", "a.film.previous"] {
        if names.iter().any(|found| found == name) {
            load_film(&folder.path().join(name)).unwrap_or_else(|error| panic!("{what}: {error}"));
            *had_one = true;
        } else if name == "a.film.previous" {
            assert!(!*had_one || names.iter().any(|found| found == "a.film"), "{what}: {names:?}");
        }
    }
}

/// Disturbs a program so many times by each, most of the times while it writes a checkpoint, and
/// lets it go on; the last run is left alone. Counts those that met it, and files half-written.
fn survive(program: &str, options: &str, times: u64, worst: &Worst) -> [u64; 4] {
    let mut dice = Dice(times);
    let (mut counts, mut had_one) = ([0; 4], false);
    let expected = undisturbed(program, options);
    let folder = Folder::new();
    let all = format!("{options} --checkpoint a.film --resume --checkpoint-every 0.001s");
    for time in 0..times {
        for (disturbance, count) in Disturbance::ALL.into_iter().zip(0..) {
            let run = disturbance.disturb(&mut dice, worst, &folder, (program, &all));
            let what = format!("{program} {options}, {disturbance:?} {time}: {run:?}");
            let met: Option<bool> = disturbance.ended(&run);
            assert!(met != Some(false), "{what}");
            counts[count] += u64::from(met.is_some());
            counts[3] += u64::from(folder.names().iter().any(|name| name.contains(".part")));
            check_films(&folder, &mut had_one, &what);
        }
    }
    let run = folder.run(program, &all);
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""), "{program} {options}");
    assert_same(files(folder.path()), &expected, &format!("{program} {options}"));
    counts
}

/// [`survive`] of all programs, one by a plan among them.
#[expect(clippy::print_stdout, reason = "how hard the test was")]
fn all_survive(times: u64, spp: u32, worst: &Worst) {
    let size = "-q -o a.exr -o a.png";
    let small = |mode| format!("spheres --resolution 48x36 {size} {mode} --spp {spp}");
    let modes = MODES.map(|(program, mode)| (program, small(mode)));
    let planned = format!("plates --resolution 96x72 {size} --auto --spp 64");
    // The plan takes its time before the first pass.
    let later = Worst { wait: 5 * worst.wait, ..*worst };
    let modes = modes.into_iter().map(|(program, options)| (program, options, worst));
    for (program, options, worst) in modes.chain([("bdpt", planned, &later)]) {
        let [killed, terminated, full, half] = survive(program, &options, times, worst);
        println!(
            "{program} {options}: met by {killed} kills, {terminated} requests to end and {full} \
             full disks of {times} each; {half} times a file half-written beside its place"
        );
    }
}

#[test]
fn whoever_is_disturbed_goes_on() {
    all_survive(3, 40, &Worst { wait: Duration::from_millis(60), blocks: 400 });
}

/// Some minutes.
#[test]
#[ignore = "long"]
fn whoever_is_disturbed_a_hundred_times_goes_on() {
    all_survive(100, 1200, &Worst { wait: Duration::from_millis(400), blocks: 800 });
}

/// A disk of its own: it fills up while checkpoints are written, and is freed.
#[cfg(target_os = "linux")]
#[test]
fn a_disk_that_is_full_and_freed() {
    const RENDERING: &str = "cornell --resolution 64x48 -q -o a.png";
    let folder = Folder::new();
    fs::create_dir(folder.path().join("disk")).unwrap();
    let bdpt = file("bdpt");
    let run = format!("{} {RENDERING} --checkpoint a.film --resume", bdpt.display());
    let script = format!(
        "mount -t tmpfs -o size=2m none disk || exit 77
        cd disk
        {run} --spp 2 && cp a.film ../before || exit 3
        cat /dev/zero > ballast 2> ../ballast
        {run} --spp 1000000 --checkpoint-every 0.001s 2> ../said
        echo $? > ../status
        ls -A > ../names
        cp a.film ../after
        rm ballast
        {run} --spp 9 && cp a.film a.png .."
    );
    let mut shell = Command::new("unshare");
    shell.args(["--map-root-user", "--mount", "sh", "-c", &script]).current_dir(folder.path());
    let output = shell.output();
    let mounted = |output: &std::process::Output| matches!(output.status.code(), Some(0 | 3));
    let Some(output) = output.as_ref().ok().filter(|output| mounted(output)) else {
        println!("skipped, no disk can be mounted here: {output:?}");
        return;
    };
    assert!(output.status.success(), "{output:?}");
    let text = |name| String::from_utf8(folder.bytes(name)).unwrap();
    let said = text("said");
    assert_eq!(text("status"), "4\n", "{said}");
    assert!(said.starts_with("error: a.film: cannot be written: "), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    assert_eq!(text("names"), "a.film\na.film.previous\na.png\nballast\n");
    assert!(folder.bytes("after") == folder.bytes("before"));
    let expected = undisturbed("bdpt", &format!("{RENDERING} --spp 9"));
    assert!(["a.film", "a.png"].iter().all(|name| folder.bytes(name) == expected[*name]));
}
