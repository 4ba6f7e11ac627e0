//! Commands of pages that no test runs.

/// How a command begins, and why no test runs it.
pub(super) const UNRUN: [(&str, &str); 12] = [
    ("cargo test --workspace", "this test is one of them"),
    ("bdpt my.ron --spp 4096 --plan \"METHOD\"", "METHOD is what the command before it prints"),
    ("parallel --jobs", "`cargo xtask engines` runs it where GNU parallel is installed"),
    ("J=$(sbatch", "`cargo xtask engines` runs it where Slurm is installed"),
    ("sbatch --dependency", "of the same queue"),
    ("openjd run", "`cargo xtask engines` runs it where it is installed"),
    ("compare", "a function of a shell; crates/compare/tests/program/parts.rs runs these parts"),
    ("apt-get install", "changes the machine"),
    ("pip install", "changes the machine"),
    ("cargo install", "builds for minutes, into the home of its user"),
    ("tar -xzf", "its archive is one of a release; xtask/src/release/archive.rs unpacks one"),
    ("PATH=", "of the shell that is typed into"),
];

/// Returns the number of the entry that a command begins with.
pub(super) fn number(command: &str) -> Option<usize> {
    UNRUN.iter().position(|(start, _)| command.trim_start().starts_with(start))
}
