//! Tests whether a picture fits into memory, before it is begun.

use crate::job::Job;
use crate::outcome::Failure;
use crate::plan::Plan;
use std::fs;
use std::path::{Path, PathBuf};
use traylib_integrators::PointSet;
use traylib_io::Loaded;
use traylib_scene::Camera;

/// Bytes of a pixel of the pictures that a viewer is sent: one on its way, one that waits, and the
/// variance while it is looked for where it is the largest.
const BYTES_SHOWN: u64 = 2 * 12 + 24;

/// Refuses a picture that needs more memory than there is.
///
/// An estimate, of what grows with the picture; the scene is in memory already. If it is the
/// time that ends the passes, a first pass must have room; [`has_room`] asks for more.
///
/// # Errors
/// It does not fit.
pub(crate) fn check(job: &Job<'_>, loaded: &Loaded, plan: &Plan) -> Result<(), Failure> {
    let camera = loaded.scene.camera();
    let (width, height) = (camera.width(), camera.height());
    let passes = if job.options.time_limit.is_some() { 1 } else { plan.passes.len() as u32 };
    // Those of a part wait on both sides of what has been added up.
    let passes = if plan.passes.start == 0 { passes } else { passes.saturating_mul(passes) };
    let shown = job.options.display_server.as_ref().map_or(0, |_| BYTES_SHOWN);
    let per_pixel = bytes_per_pixel(passes, job.options.sampler, job.layers) + shown;
    let needed = u64::from(width) * u64::from(height) * per_pixel;
    match available() {
        Some(available) if needed > available => Err(Failure::output(format_args!(
            "{width}x{height} pixels need about {} of memory, {per_pixel} bytes each, and {} are free; \
             a smaller --resolution needs less, and so do fewer --spp",
            gigabytes(needed),
            gigabytes(available),
        ))),
        _ => Ok(()),
    }
}

/// Tells whether another pass has room after this many; it may need more than the one before only
/// where their number doubles.
pub(crate) fn has_room(job: &Job<'_>, camera: &Camera, passes: u32) -> bool {
    let pixels = u64::from(camera.width()) * u64::from(camera.height());
    let points = job.options.sampler;
    let of = |passes| bytes_per_pixel(passes, points, job.layers);
    let more = of(2 * points.sequences()) - of(points.sequences());
    !passes.is_power_of_two() || available().is_none_or(|available| pixels * more <= available)
}

/// Returns the most bytes that a pixel of a [`Film`](traylib_scene::Film) takes, with the pass
/// under way or the pictures that are developed: three bands of 8 bytes in a sum, of 4 in a
/// picture. Independent passes have sums of squares, too.
fn bytes_per_pixel(passes: u32, points: PointSet, layers: u64) -> u64 {
    let (pass, pictures) = (24 * (1 + layers), 12 * (1 + layers));
    let sequences = points.sequences().min(passes.max(1));
    let waiting = u64::from(passes.max(1).div_ceil(sequences).ilog2());
    match points {
        PointSet::Independent => waiting * (pass + 24) + pass + pictures,
        PointSet::Sobol => u64::from(sequences) * (waiting + 1) * pass + pictures,
    }
}

/// The most bytes of memory that this process has had at once; `None` where the system does not
/// say, which Linux does.
pub(crate) fn peak() -> Option<u64> {
    kilobytes(&fs::read_to_string("/proc/self/status").ok()?, "VmHWM:")
}

fn gigabytes(bytes: u64) -> String {
    format!("{:.2} GB", bytes as f64 / 1e9)
}

/// Bytes that this process can still take: what the system has, less where a limit of
/// the process or of its group ends it sooner. `None` where the system does not say,
/// which Linux does, in text.
fn available() -> Option<u64> {
    let limits = [of_the_system(), of_the_process(), of_the_groups()];
    limits.into_iter().flatten().min()
}

fn of_the_system() -> Option<u64> {
    kilobytes(&fs::read_to_string("/proc/meminfo").ok()?, "MemAvailable:")
}

/// Returns the rest of the address space (`ulimit -v`), if it has a limit.
fn of_the_process() -> Option<u64> {
    let limit = address_space(&fs::read_to_string("/proc/self/limits").ok()?)?;
    let taken = kilobytes(&fs::read_to_string("/proc/self/status").ok()?, "VmSize:")?;
    Some(limit.saturating_sub(taken))
}

/// The least that the control groups leave which this process is in.
fn of_the_groups() -> Option<u64> {
    let groups = fs::read_to_string("/proc/self/cgroup").ok()?;
    groups.lines().flat_map(memory_folders).filter_map(|folder| of_a_group(&folder)).min()
}

/// The number of kilobytes after a name, in bytes.
fn kilobytes(text: &str, name: &str) -> Option<u64> {
    let rest = text.lines().find_map(|line| line.strip_prefix(name))?;
    Some(1024 * rest.split_whitespace().next()?.parse::<u64>().ok()?)
}

/// The soft limit in bytes; `None` if it is unlimited.
fn address_space(limits: &str) -> Option<u64> {
    let rest = limits.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    rest.split_whitespace().next()?.parse().ok()
}

/// The folders that may limit the memory of a group, given as a line
/// `NUMBER:CONTROLLERS:PATH`: its own and all above it. One list of controllers is
/// empty, that of groups by the second version.
fn memory_folders(line: &str) -> Vec<PathBuf> {
    let mut parts = line.splitn(3, ':').skip(1);
    let (Some(controllers), Some(path)) = (parts.next(), parts.next()) else { return Vec::new() };
    let root = match controllers {
        "" => Path::new("/sys/fs/cgroup"),
        _ if controllers.split(',').any(|name| name == "memory") => {
            Path::new("/sys/fs/cgroup/memory")
        }
        _ => return Vec::new(),
    };
    Path::new(path.trim_start_matches('/')).ancestors().map(|below| root.join(below)).collect()
}

fn of_a_group(folder: &Path) -> Option<u64> {
    let read = |names: [&str; 2]| {
        names.into_iter().find_map(|name| fs::read_to_string(folder.join(name)).ok())
    };
    let limit = read(["memory.max", "memory.limit_in_bytes"])?.trim().parse().ok()?;
    let taken: u64 = read(["memory.current", "memory.usage_in_bytes"])?.trim().parse().ok()?;
    let statistics = fs::read_to_string(folder.join("memory.stat")).unwrap_or_default();
    Some(group_leaves(limit, taken, &statistics))
}

/// Copies of files that nobody has used lately are given up for whoever wants more.
fn group_leaves(limit: u64, taken: u64, statistics: &str) -> u64 {
    let value = |name: &str| {
        let line = statistics.lines().find_map(|line| line.strip_prefix(name))?;
        line.trim().parse::<u64>().ok()
    };
    let files = value("total_inactive_file ").or_else(|| value("inactive_file ")).unwrap_or(0);
    limit.saturating_sub(taken.saturating_sub(files))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Memory is counted as the film holds sums when all but the last pass are there.
    #[test]
    fn sums_wait_for_their_other_half() {
        let of = |passes, layers| bytes_per_pixel(passes, PointSet::Independent, layers);
        let known = [(1, 36), (2, 84), (3, 84), (4, 132), (1024, 516)];
        assert_eq!(known.map(|(passes, _)| (passes, of(passes, 0))), known);
        assert_eq!(of(2, 3), 84 + 2 * 3 * 24 + 3 * 12);
    }

    /// The first passes of two sequences are a sum each; later as many wait in each of them.
    #[test]
    fn sequences_wait_apart() {
        let of = |passes| bytes_per_pixel(passes, PointSet::Sobol, 0);
        assert_eq!([1, 2, 4, 5, 8, 1024].map(of), [36, 60, 108, 108, 156, 492]);
    }

    #[test]
    fn the_system_is_understood() {
        let text = "MemTotal:       24684084 kB\nMemAvailable:   23747652 kB\n";
        assert_eq!(kilobytes(text, "MemAvailable:"), Some(24_317_595_648));
        assert_eq!(kilobytes(text, "VmSize:"), None);
        let limits = |soft: &str| {
            format!("Max processes  9 9\nMax address space  {soft}  unlimited  bytes\n")
        };
        assert_eq!(address_space(&limits("409600000")), Some(409_600_000));
        assert_eq!(address_space(&limits("unlimited")), None);
    }

    #[test]
    fn all_groups_of_a_process_are_asked() {
        let second = ["/sys/fs/cgroup/a/b", "/sys/fs/cgroup/a", "/sys/fs/cgroup/"];
        assert_eq!(memory_folders("0::/a/b"), second.map(PathBuf::from));
        let first = ["/sys/fs/cgroup/memory/a", "/sys/fs/cgroup/memory/"].map(PathBuf::from);
        assert_eq!(memory_folders("4:hugetlb,memory:/a"), first);
        assert!(memory_folders("8:pids:/a").is_empty());
        assert_eq!(group_leaves(100, 70, "inactive_file 20\nanon 5\n"), 50);
        assert_eq!(group_leaves(100, 70, "inactive_file 20\ntotal_inactive_file 30\n"), 60);
        assert_eq!(group_leaves(100, 170, ""), 0);
    }
}
