//! Measures the time and the memory that reading a GLB file of a million triangles takes: `cargo
//! bench -p traylib-io --bench glb`.
#![allow(clippy::print_stdout, reason = "figures for whoever changes the reader")]
#![allow(clippy::unwrap_used, reason = "its own file is sound")]

use peak_alloc::PeakAlloc;
use std::time::Instant;
use std::{fs, slice};
use traylib_io::{Headlight, LoadOptions, gltf, inventory, load_scene_with};

/// Counts bytes as they are asked for: what is free but not given back to the system is none.
#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

/// Squares along either side: two triangles each.
const SIDE: u32 = 708;

/// A hilly ground with normals and texture coordinates.
fn ground() -> Vec<u8> {
    let mut data = Vec::new();
    let mut add = |values: &[f32]| data.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    let points = || (0..=SIDE).flat_map(|z| (0..=SIDE).map(move |x| [x as f32, z as f32]));
    for [x, z] in points() {
        add(&[x, (x * 0.1).sin() * (z * 0.1).cos(), z]);
    }
    points().for_each(|_| add(&[0.0, 1.0, 0.0]));
    for [x, z] in points() {
        add(&[x / SIDE as f32, z / SIDE as f32]);
    }
    let row = SIDE + 1;
    for corner in (0..SIDE).flat_map(|z| (0..SIDE).map(move |x| z * row + x)) {
        let square = [corner, corner + row, corner + 1, corner + 1, corner + row, corner + row + 1];
        data.extend(square.iter().flat_map(|index| index.to_le_bytes()));
    }
    let vertices = row * row;
    let [normals, uvs, indices] = [12, 24, 32].map(|bytes| bytes * vertices);
    let views = [(0, normals), (normals, uvs), (uvs, indices), (indices, data.len() as u32)];
    let views = views.map(|(from, to)| {
        format!(r#"{{"buffer":0,"byteOffset":{from},"byteLength":{}}}"#, to - from)
    });
    let accessor = |view: u32, kind: &str, component: u32, count: u32| {
        format!(
            r#"{{"bufferView":{view},"componentType":{component},"count":{count},"type":"{kind}"}}"#
        )
    };
    let accessors = [
        accessor(0, "VEC3", 5126, vertices),
        accessor(1, "VEC3", 5126, vertices),
        accessor(2, "VEC2", 5126, vertices),
        accessor(3, "SCALAR", 5125, 6 * SIDE * SIDE),
    ];
    let mut json = format!(
        r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}}}],"bufferViews":[{}],
        "accessors":[{}],"nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{"indices":3,
        "attributes":{{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2}}}}]}}]}}"#,
        data.len(),
        views.join(","),
        accessors.join(",")
    );
    json += &" ".repeat((4 - json.len() % 4) % 4);
    let chunk = |kind: &[u8], bytes: &[u8]| {
        [&u32::try_from(bytes.len()).unwrap().to_le_bytes()[..], kind, bytes].concat()
    };
    let chunks = [chunk(b"JSON", json.as_bytes()), chunk(b"BIN\0", &data)].concat();
    let length = u32::try_from(12 + chunks.len()).unwrap().to_le_bytes();
    [&b"glTF\x02\0\0\0"[..], &length, &chunks].concat()
}

fn main() {
    let name = format!("traylib-speed-{}.glb", std::process::id());
    let file = std::env::temp_dir().join(name);
    fs::write(&file, ground()).unwrap();
    let bytes = fs::metadata(&file).unwrap().len();
    println!("a file of {:.1} MB", bytes as f64 * 1e-6);
    report("decoded", bytes, || {
        let content = fs::read(&file).unwrap();
        let document = gltf::decode(&content, gltf::Limits::default(), &mut |_| Err(String::new()));
        assert!(document.unwrap().primitives[0].triangles.len() > 1_000_000);
    });
    report("as meshes", bytes, || {
        inventory(slice::from_ref(&file), LoadOptions::default()).unwrap();
    });
    report("as a scene, with its tree", bytes, || {
        let options = LoadOptions { headlight: Headlight::WithoutLight, ..LoadOptions::default() };
        load_scene_with(&file.to_string_lossy(), options).unwrap();
    });
    fs::remove_file(&file).unwrap();
}

/// Says how long this takes, and the most memory that it holds.
fn report(what: &str, file_bytes: u64, work: impl FnOnce()) {
    let before = HEAP.current_usage();
    HEAP.reset_peak_usage();
    let start = Instant::now();
    work();
    let seconds = start.elapsed().as_secs_f64();
    let peak = (HEAP.peak_usage() - before) as f64;
    let (megabytes, times) = (peak * 1e-6, peak / file_bytes as f64);
    println!("{what}: {seconds:.3} s, {megabytes:.0} MB at most, {times:.2} times the file");
}
