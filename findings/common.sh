# Sourced by the findings: a temporary folder that is removed at exit, and the
# installation of pinned packages in it. Exit status 2: could not be set up.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 2' INT TERM
cd "$work"

no_setup() {
    echo "not run: $1" >&2
    exit 2
}

# Python packages as name==version; afterwards `python` has them.
python_packages() {
    python3 -m venv venv || no_setup 'python3 has no venv'
    # shellcheck disable=SC1091
    . venv/bin/activate
    pip install --quiet --disable-pip-version-check "$@" || no_setup "cannot install $*"
}

# npm packages as name@version, for `node script.mjs` in this folder.
node_packages() {
    printf '{"private": true, "type": "module"}\n' > package.json
    npm install --silent --no-audit --no-fund --ignore-scripts "$@" || no_setup "cannot install $*"
}

# A Rust program from standard input with the dependencies given as lines of
# Cargo.toml; afterwards it is the file ./program.
rust_program() {
    mkdir -p src
    cat > src/main.rs
    printf '[package]\nname = "program"\nversion = "0.0.0"\nedition = "2021"\n\n[dependencies]\n' > Cargo.toml
    printf '%s\n' "$@" >> Cargo.toml
    printf '\n[workspace]\n' >> Cargo.toml
    CARGO_TARGET_DIR="$work/target" cargo build --quiet || no_setup "cannot build with $*"
    mv target/debug/program program
}
