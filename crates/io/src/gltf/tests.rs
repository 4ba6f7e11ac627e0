use super::*;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use traylib_math::glam::DVec3;

/// Three corners of a square, four indices of 16 bits, three texture coordinates of 8.
fn buffer() -> Vec<u8> {
    let mut bytes: Vec<u8> = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0]
        .iter()
        .flat_map(|value| value.to_le_bytes())
        .collect();
    bytes.extend([0_u16, 1, 2, 3].iter().flat_map(|index| index.to_le_bytes()));
    bytes.extend([0, 0, 255, 51, 255, 255, 0, 255]);
    bytes
}

fn json(rest: &str) -> String {
    let uri = STANDARD.encode(buffer());
    format!(
        r#"{{"asset":{{"version":"2.0"}},
        "buffers":[{{"byteLength":64,"uri":"data:application/octet-stream;base64,{uri}"}}],
        "bufferViews":[{{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":8}},
            {{"buffer":0,"byteOffset":56,"byteLength":8}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}},
            {{"bufferView":1,"componentType":5123,"count":4,"type":"SCALAR"}},
            {{"bufferView":2,"componentType":5121,"normalized":true,"count":4,"type":"VEC2"}},
            {{"bufferView":2,"componentType":5121,"count":4,"type":"VEC2"}}]{rest}}}"#
    )
}

fn decoded(text: &str) -> Result<Document, Error> {
    decode(text.as_bytes(), Limits::default(), &mut |name| Err(format!("no {name}")))
}

fn fault(rest: &str) -> String {
    decoded(&json(rest)).unwrap_err().to_string()
}

const SQUARE: &str = r#","meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2,
    "_OWN":1},"indices":1,"mode":6}]}]"#;

#[test]
fn colours_of_vertices_are_counted() {
    let square = SQUARE.replace("_OWN", "COLOR_0");
    let text = json(&format!(r#"{square},"nodes":[{{"mesh":0}}]"#));
    let warnings = decoded(&text).unwrap().warnings;
    let told: Vec<_> = warnings.iter().collect();
    assert_eq!(told, [("colour of a vertex skipped".to_string(), 4)]);
}

#[test]
fn text_and_binary_files_hold_the_same() {
    let text = json(&format!(r#"{SQUARE},"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}]"#));
    let document = decoded(&text).unwrap();
    let [square] = &document.primitives[..] else { panic!("{document:?}") };
    assert_eq!(square.positions[2], Vec3::new(1.0, 1.0, 0.0));
    assert_eq!(square.triangles, [[1, 2, 0], [2, 3, 0]]);
    assert_eq!(square.uvs[1], Vec2::new(1.0, 0.2));
    assert_eq!(document.instances.len(), 1);
    assert_eq!(document.warnings, WarningCounts::default());
    let uri = STANDARD.encode(buffer());
    let inner =
        text.replace(&format!(r#","uri":"data:application/octet-stream;base64,{uri}""#), "");
    let glb = binary(inner.as_bytes(), &buffer());
    let found = decode(&glb, Limits::default(), &mut |_| Err(String::new()));
    assert_eq!(found.as_ref(), Ok(&document));
    let beside = text.replace(&format!("data:application/octet-stream;base64,{uri}"), "a%20b.bin");
    let mut load = |name: &str| Ok(if name == "a b.bin" { buffer() } else { Vec::new() });
    assert_eq!(decode(beside.as_bytes(), Limits::default(), &mut load), Ok(document));
}

fn binary(json: &[u8], data: &[u8]) -> Vec<u8> {
    let chunk = |kind: &[u8], bytes: &[u8]| {
        let length = u32::try_from(bytes.len()).unwrap().to_le_bytes();
        [&length[..], kind, bytes].concat()
    };
    let chunks = [chunk(b"JSON", json), chunk(b"BIN\0", data)].concat();
    let length = u32::try_from(12 + chunks.len()).unwrap().to_le_bytes();
    [&b"glTF\x02\0\0\0"[..], &length, &chunks].concat()
}

#[test]
fn strips_and_lists_are_triangles() {
    let mode = |mode: &str| {
        let square = SQUARE.replace(r#""mode":6"#, mode);
        let document = decoded(&json(&format!(r#"{square},"nodes":[{{"mesh":0}}]"#))).unwrap();
        document.primitives.first().map(|primitive| primitive.triangles.clone())
    };
    assert_eq!(mode(r#""mode":5"#), Some(vec![[0, 1, 2], [1, 3, 2]]));
    assert_eq!(mode(r#""mode":4"#), Some(vec![[0, 1, 2]]));
    assert_eq!(mode(r#""mode":1"#), None);
}

/// The place of the only instance of each of these nodes.
fn places(nodes: &str) -> Vec<DAffine3> {
    let document = decoded(&json(&format!(r#"{SQUARE},"nodes":[{nodes}]"#))).unwrap();
    document.instances.iter().map(|instance| instance.place).collect()
}

#[test]
fn nodes_stand_where_their_parents_put_them() {
    let [child, parent] = places(
        r#"{"mesh":0,"translation":[1,0,0]},
           {"mesh":0,"children":[0],"rotation":[0,0,0.7071067811865476,0.7071067811865476],
            "scale":[2,3,4],"translation":[0,0,5]}"#,
    )[..] else {
        panic!()
    };
    // The parent comes first.
    let (parent, child) = (child, parent);
    let close = |a: DVec3, b: DVec3| assert!(a.distance(b) < 1e-9, "{a} {b}");
    close(parent.transform_point3(DVec3::X), DVec3::new(0.0, 2.0, 5.0));
    close(child.transform_point3(DVec3::X), DVec3::new(0.0, 4.0, 5.0));
    let matrix = places(r#"{"mesh":0,"matrix":[0,2,0,0,-3,0,0,0,0,0,4,0,0,0,5,1]}"#);
    close(matrix[0].transform_point3(DVec3::ONE), parent.transform_point3(DVec3::ONE));
}

#[test]
fn a_mesh_in_several_places_is_read_once() {
    let nodes = r#"{"mesh":0},{"mesh":0,"translation":[1,2,3]},{"mesh":0}"#;
    let scenes = r#""scene":1,"scenes":[{},{"nodes":[0,1]}]"#;
    let text = json(&format!(r#"{SQUARE},"nodes":[{nodes}],{scenes}"#));
    let document = decoded(&text).unwrap();
    assert_eq!((document.primitives.len(), document.instances.len()), (1, 2));
    assert_eq!(document.warnings.count(&WarningKind::Scene), 1);
    let tight = Limits { triangles: 3, ..Limits::default() };
    let fault = decode(text.as_bytes(), tight, &mut |_| Err(String::new())).unwrap_err();
    assert!(fault.to_string().contains("`--limit surfaces=6`"), "{fault}");
}

/// As the example of `EXT_mesh_gpu_instancing` has it: each place is within the node.
#[test]
fn a_node_puts_its_mesh_in_many_places() {
    let extension = |attributes: &str| {
        format!(
            r#"{SQUARE},"extensionsRequired":["EXT_mesh_gpu_instancing"],"nodes":[{{"mesh":0,
            "scale":[2,2,2],"extensions":{{"EXT_mesh_gpu_instancing":{{"attributes":{attributes}}}}}}}]"#
        )
    };
    let document = decoded(&json(&extension(r#"{"TRANSLATION":0,"_ID":1}"#))).unwrap();
    let corner = |instance: &Instance| instance.place.transform_point3(DVec3::ONE);
    let found: Vec<DVec3> = document.instances.iter().map(corner).collect();
    let wanted = [(2, 2, 2), (4, 2, 2), (4, 4, 2), (2, 4, 2)];
    assert_eq!(found, wanted.map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into())));
    assert_eq!(document.primitives.len(), 1);
    let told = fault(&extension(r#"{"ROTATION":0}"#));
    assert!(told.contains("wanted is a `VEC4`"), "{told}");
    let few = Limits { items: 3, ..Limits::default() };
    let text = json(&extension(r#"{"SCALE":0}"#));
    let told = decode(text.as_bytes(), few, &mut |_| Err(String::new())).unwrap_err().to_string();
    assert!(told.contains("more than 3 places of meshes"), "{told}");
}

#[test]
fn sparse_accessors_replace_some() {
    let accessor = r#"{"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,
        "indices":{"bufferView":1,"byteOffset":4,"componentType":5123},
        "values":{"bufferView":0,"byteOffset":24}}}"#;
    let text =
        json(r#","meshes":[{"primitives":[{"attributes":{"POSITION":4}}]}],"nodes":[{"mesh":0}]"#);
    let text = text.replace(r#""type":"VEC2"}]"#, &format!(r#""type":"VEC2"}},{accessor}]"#));
    let document = decoded(&text).unwrap();
    let wanted = [Vec3::ZERO, Vec3::ZERO, Vec3::new(1.0, 1.0, 0.0), Vec3::ZERO];
    assert_eq!(document.primitives[0].positions, wanted);
}

/// Without a view all elements are zero, more of them than there are bytes.
#[test]
fn sparse_accessors_need_no_view() {
    let accessor = r#"{"componentType":5126,"count":999,"type":"VEC3","sparse":{"count":1,
        "indices":{"bufferView":1,"byteOffset":6,"componentType":5121},
        "values":{"bufferView":0,"byteOffset":24}}}"#;
    let text = json(
        r#","meshes":[{"primitives":[{"attributes":{"POSITION":4},"indices":1}]}],
        "nodes":[{"mesh":0}]"#,
    );
    let text = text.replace(r#""type":"VEC2"}]"#, &format!(r#""type":"VEC2"}},{accessor}]"#));
    let document = decoded(&text).unwrap();
    let positions = &document.primitives[0].positions;
    assert_eq!((positions.len(), positions[3]), (999, Vec3::new(1.0, 1.0, 0.0)));
    let fault = decoded(&text.replace("999", "99999999999")).unwrap_err().to_string();
    assert!(fault.contains("--limit surfaces="), "{fault}");
}

#[test]
fn materials_lights_and_cameras_are_read() {
    let text = json(
        r#","extensionsUsed":["KHR_lights_punctual","KHR_materials_clearcoat"],
        "animations":[{"channels":[],"samplers":[]}],
        "materials":[{},{"name":"m","alphaMode":"MASK","doubleSided":true,
            "emissiveFactor":[1,0.5,0],"normalTexture":{"index":0},
            "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":4}},
            "pbrMetallicRoughness":{"baseColorFactor":[0.5,2,0,0.25],"metallicFactor":0,
                "baseColorTexture":{"index":0,"texCoord":1,"extensions":{"KHR_texture_transform":
                    {"offset":[0.5,0],"scale":[2,2],"texCoord":3}}}}}],
        "textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33648}],
        "images":[{"bufferView":1}],
        "cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":1,"aspectRatio":2}},
            {"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0,"zfar":1}}],
        "nodes":[{"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}},"scale":[2,2,2]},
            {"camera":1,"extensions":{"KHR_lights_punctual":{"light":1}}},
            {"rotation":[0,1,0,0],"extensions":{"KHR_lights_punctual":{"light":2}}}],
        "extensions":{"KHR_lights_punctual":{"lights":[
            {"type":"point","intensity":3,"color":[1,0.5,0],"range":9},{"type":"directional"},
            {"type":"spot","spot":{"innerConeAngle":0.25}}]}}"#,
    );
    let document = decoded(&text).unwrap();
    let [plain, m] = &document.materials[..] else { panic!() };
    assert_eq!((plain.metallic, plain.roughness, plain.base_colour), (1.0, 1.0, Rgb::WHITE));
    assert_eq!((m.base_colour, m.alpha), (Rgb::new(0.5, 1.0, 0.0), 0.25));
    assert_eq!((m.alpha_mode, m.alpha_cutoff, m.double_sided), (AlphaMode::Mask, 0.5, true));
    assert_eq!(m.emission, Rgb::new(4.0, 2.0, 0.0));
    assert_eq!(m.has_normal_occlusion_emission, [true, false, false]);
    let picture = m.base_colour_picture.unwrap();
    assert_eq!((picture.image, picture.set), (Some(0), 3));
    assert_eq!(picture.wrap, [Wrap::Mirror, Wrap::Repeat]);
    assert_eq!(picture.transform.transform_point2(Vec2::ONE), Vec2::new(2.5, 2.0));
    assert_eq!(document.images, [Image::Bytes(buffer()[48..56].to_vec())]);
    let [point, spot] = &document.lights[..] else { panic!() };
    assert_eq!((point.intensity, point.cone), (Rgb::new(3.0, 1.5, 0.0), None));
    assert_eq!(spot.cone, Some([0.25, std::f32::consts::FRAC_PI_4]));
    assert!(spot.direction.distance(Vec3::Z) < 1e-6);
    let [camera] = &document.cameras[..] else { panic!() };
    assert_eq!((camera.direction, camera.up), (Vec3::NEG_Z, Vec3::Y));
    assert_eq!((camera.yfov, camera.aspect), (0.5, Some(2.0)));
    let found: Vec<_> = document.warnings.iter().map(|(what, _)| what).collect();
    let wanted = [
        "animation skipped, everything stands as stored",
        "light from far away (`directional`) skipped",
        "range of a light skipped, it shines on",
        "camera without perspective skipped",
        "number of a material not from 0 to 1, brought there",
        "extension `KHR_materials_clearcoat` skipped",
    ];
    assert_eq!(found, wanted);
}

/// A camera without sense is no reason to refuse what can be seen; an aspect without is none.
#[test]
fn cameras_without_sense_are_skipped() {
    let camera = |numbers: &str, node: &str| {
        decoded(&json(&format!(
            r#","cameras":[{{"type":"perspective","perspective":{{"znear":1,{numbers}}}}}],
            "nodes":[{{"camera":0{node}}}]"#
        )))
        .unwrap()
    };
    for (numbers, node) in [
        (r#""yfov":0"#, ""),
        (r#""yfov":-1"#, ""),
        (r#""yfov":3.2"#, ""),
        (r#""yfov":1"#, r#","scale":[0,0,0]"#),
    ] {
        let document = camera(numbers, node);
        assert_eq!(document.warnings.count(&WarningKind::OddCamera), 1, "{numbers} {node}");
        assert!(document.cameras.is_empty());
    }
    let document = camera(r#""yfov":1,"aspectRatio":-2"#, "");
    assert_eq!(document.cameras[0].aspect, None);
}

#[test]
fn faults_are_told_with_their_places() {
    let node = |rest: &str| fault(&format!(r#","nodes":[{rest}]"#));
    let mesh = |rest: &str| {
        fault(&format!(r#","meshes":[{{"primitives":[{rest}]}}],"nodes":[{{"mesh":0}}]"#))
    };
    for (found, wanted) in [
        (node(r#"{"mesh":0}"#), "nodes[0]: there is no mesh 0: there are 0"),
        (node(r#"{"children":[7]}"#), "nodes[0]: there is no node 7: there are 1"),
        (node(r#"{"children":[1,1]},{}"#), "nodes[1]: it is reached twice: nodes must be trees"),
        (
            mesh(r#"{"attributes":{"POSITION":9}}"#),
            "meshes[0].primitives[0]: there is no accessor 9: there are 4",
        ),
        (mesh(r#"{"attributes":{"POSITION":2}}"#), "accessors[2]: wanted is a `VEC3`"),
        (
            mesh(r#"{"attributes":{"POSITION":0},"indices":0}"#),
            "accessors[0]: wanted is a `SCALAR` of unsigned whole numbers",
        ),
        (
            mesh(r#"{"attributes":{"POSITION":0},"material":0}"#),
            "meshes[0].primitives[0]: there is no material 0: there are 0",
        ),
        (
            mesh(r#"{"attributes":{"POSITION":0},"mode":7}"#),
            "meshes[0].primitives[0]: wanted is a `mode` from 0 to 6",
        ),
        (
            fault(r#","extensionsRequired":["KHR_draco_mesh_compression"]"#),
            "it needs the extension `KHR_draco_mesh_compression`, which is not read",
        ),
        (fault(r#","scene":3,"scenes":[{}]"#), "scene: there is no scene 3: there are 1"),
        (fault(r#","buffers":1"#), "line 8, column 84 of its JSON: duplicate field `buffers`"),
    ] {
        assert_eq!(found, wanted);
    }
    // A circle is reached from nowhere, or from itself.
    let circle = r#","nodes":[{"children":[1]},{"children":[0]}],"scenes":[{"nodes":[0]}]"#;
    assert!(fault(circle).ends_with("nodes must be trees"));
    for (sound, damaged, wanted) in [
        (
            r#""count":4,"type":"VEC3""#,
            r#""count":5,"type":"VEC3""#,
            "bufferViews[0]: it needs 60 bytes where there are 48",
        ),
        (
            r#""byteLength":48}"#,
            r#""byteLength":48,"byteStride":4}"#,
            "bufferViews[0]: a stride of 4 bytes is less than an element",
        ),
        (
            r#""byteOffset":56"#,
            r#""byteOffset":18446744073709551615"#,
            "bufferViews[2]: it needs 18446744073709551615 bytes where there are 64",
        ),
        (
            r#""byteLength":64"#,
            r#""byteLength":99"#,
            "buffers[0]: it needs 99 bytes where there are 64",
        ),
        ("data:application/octet-stream;base64,", "../x.bin?", "buffers[0]: no ../x.bin?"),
        (r#""version":"2.0""#, r#""version":"1.0""#, "it is glTF of version 1.0: 2 is read"),
        (
            r#""asset":{"version":"2.0"}"#,
            r#""asset":{"version":"1.0"},"nodes":{}"#,
            "it is glTF of version 1.0: 2 is read",
        ),
    ] {
        let text = json(&format!(r#"{SQUARE},"nodes":[{{"mesh":0}}]"#)).replace(sound, damaged);
        let found = decoded(&text).unwrap_err().to_string();
        assert!(found.starts_with(wanted), "{found}");
    }
}

#[test]
fn binary_files_that_make_no_sense_are_refused() {
    let said = |bytes: &[u8]| {
        let found = decode(bytes, Limits::default(), &mut |_| Err(String::new()));
        found.unwrap_err().to_string()
    };
    assert_eq!(said(b"glTX"), "it is no glTF: it begins neither with `{` nor with `glTF`");
    assert_eq!(said(b"glTF\x01\0\0\0"), "it is glTF of version 1: 2 is read");
    assert_eq!(said(b"glTF\x02\0\0\0\x0d\0\0\0"), "byte 8: the file is shorter than it says");
    assert_eq!(said(b"glTF\x02\0\0\0\x0c\0\0\0"), "byte 12: it has no JSON");
    let glb = binary(b"{}", b"");
    assert!(said(&glb).contains("of its JSON: missing field `asset`"), "{}", said(&glb));
    let mut long = glb.clone();
    long[12] = 99;
    assert_eq!(said(&long), "byte 12: the chunk is longer than the file");
    assert!(said(&glb[..11]).starts_with("byte "));
}
