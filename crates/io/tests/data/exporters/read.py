"""What other programs find in the files here, as `expected.json`.

    pip install trimesh==4.6.8 plyfile==1.1.5 mitsuba==3.9.1 numpy==2.4.6 pillow==13.0.0
    python read.py

Of each file: who read it; triangles, with polygons cut; their area; the box around their corners;
the box of texture coordinates, v upward, or zeros; of Mitsuba's scenes rays, as far as the first
surface in lengths of their directions, or null. Of materials, where a reader has them, the
colours by what the files say and `docs/scene-models.md`: of OBJ kd, of glTF 0.96 (1 - metal) times
the base colour, as much of it as is there, and 0.5 of what has none.
"""
import json, os, pathlib, subprocess, tempfile
import mitsuba, numpy as np, plyfile, trimesh

HERE = pathlib.Path(__file__).parent
numbers = lambda values: [float("%.6g" % float(v)) for v in np.ravel(values)]


def figures(reader, parts):
    """Of triangles as arrays of corners, and texture coordinates as arrays of pairs."""
    corners = np.concatenate([triangles.reshape(-1, 3, 3) for triangles, _ in parts])
    uvs = [uv for _, uv in parts if uv is not None and len(uv)]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
    box = np.concatenate([corners.min((0, 1)), corners.max((0, 1))])
    uv = np.concatenate(uvs) if uvs else np.zeros((1, 2))
    return {"reader": reader, "triangles": len(corners), "area": numbers(area)[0], "bbox": numbers(box),
            "uv_box": numbers([uv.min(0), uv.max(0)])}


def by_trimesh(file):
    scene = trimesh.load(file, process=False, force="scene", maintain_order=True)
    meshes = [m for m in scene.dump() if isinstance(m, trimesh.Trimesh)]
    return figures("trimesh 4.6.8", [(m.vertices[m.faces], getattr(m.visual, "uv", None)) for m in meshes])


def by_gltf_transform(file):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "plain.glb"
        subprocess.run(["node", "plain.mjs", str(file), str(out)], cwd=HERE, check=True)
        return dict(by_trimesh(out), reader="gltf-transform 4.5.1, trimesh 4.6.8")


def by_plyfile(file):
    """Polygons cut as fans, which these are good for."""
    data = plyfile.PlyData.read(file)
    vertex = data["vertex"].data
    positions = np.stack([vertex[name] for name in "xyz"], 1).astype(float)
    face = data["face"].data
    name = next(n for n in face.dtype.names if n in ("vertex_index", "vertex_indices"))
    fans = [[f[0], f[i], f[i + 1]] for f in face[name] for i in range(1, len(f) - 1)]
    uv = np.stack([vertex["s"], vertex["t"]], 1) if "s" in vertex.dtype.names else None
    if "texcoord" in face.dtype.names:
        uv = np.concatenate([t.reshape(-1, 2) for t in face["texcoord"]])
    return figures("plyfile 1.1.5", [(positions[np.array(fans)], uv)])


def by_mitsuba(file):
    mitsuba.set_variant("scalar_rgb")
    mitsuba.set_log_level(mitsuba.LogLevel.Error)
    with tempfile.TemporaryDirectory() as folder:
        # Where its meshes are: the writer had a folder of its own.
        text = file.read_text().replace("/home/someone/scenes", str(file.parent.resolve()))
        copy = os.path.join(folder, "scene.xml")
        open(copy, "w").write(text)
        scene = mitsuba.load_file(copy, optimize=False)
    box = scene.bbox()
    middle, reach = np.array(box.center()), np.linalg.norm(np.array(box.extents()))
    random, rays = np.random.default_rng(11), []
    for _ in range(30):
        to = random.normal(size=3)
        end = middle + (random.random(3) - 0.5) * np.array(box.extents())
        origin, direction = numbers(end + to / np.linalg.norm(to) * reach), numbers(-to)
        hit = scene.ray_intersect(mitsuba.Ray3f(mitsuba.Point3f(origin), mitsuba.Vector3f(direction)))
        rays.append([origin, direction, numbers(hit.t)[0] if hit.is_valid() else None])
    return {"reader": "mitsuba 3.9.1", "lamps": len(scene.emitters()), "bbox": numbers([box.min, box.max]), "rays": rays}


def materials(file):
    """Colours of the materials by what the file itself says, in its order."""
    if file.suffix == ".obj":
        names = [l.split(None, 1)[1].strip() for l in file.read_text().splitlines() if l.startswith("mtllib ")]
        found, used = {}, []
        for name in names:
            for line in (file.parent / name).read_text().splitlines():
                words = line.split()
                if words[:1] == ["newmtl"]:
                    current = found.setdefault(words[1], {})
                elif words[:1] in (["Kd"], ["Ks"], ["illum"], ["map_Kd"]):
                    current[words[0]] = words[1:]
        current = None
        for line in file.read_text().splitlines():
            if line.startswith("usemtl "):
                current = line.split(None, 1)[1].strip()
            elif line.startswith("f ") and current not in used:
                used.append(current)
        # That of what has none is the last.
        used.sort(key=lambda name: name is None)
        colours = []
        for name in used:
            said = found.get(name, {"Kd": [0.5] * 3})
            if "map_Kd" in said:
                return None
            kd = np.array(said["Kd"], float)
            ks = np.array(said.get("Ks", [0] * 3), float) if said.get("illum") not in (["0"], ["1"]) else 0 * kd
            colours.append(kd / max(1, (kd + ks).max()))
        return numbers(colours) if colours else None
    return None


def by_json(file):
    raw = file.read_bytes()
    text = raw[20:20 + int.from_bytes(raw[12:16], "little")] if raw[:4] == b"glTF" else raw
    root, colours = json.loads(text), []
    primitives = [p for mesh in root["meshes"] for p in mesh["primitives"] if p.get("mode", 4) >= 4]
    used = sorted({p.get("material", len(root.get("materials", []))) for p in primitives})
    plain = {"pbrMetallicRoughness": {"baseColorFactor": [0.5 / 0.96] * 3 + [1], "metallicFactor": 0}}
    for material in [(root.get("materials", []) + [plain])[number] for number in used]:
        pbr = material.get("pbrMetallicRoughness", {})
        if "baseColorTexture" in pbr:
            return None
        metal = 0 if "KHR_materials_unlit" in material.get("extensions", {}) else pbr.get("metallicFactor", 1)
        colour = np.array(pbr.get("baseColorFactor", [1] * 4))
        share = colour[3] if material.get("alphaMode") == "BLEND" else 1
        colours.append(0.96 * (1 - metal) * share * colour[:3])
    return numbers(colours) if colours else None


def obj_uvs(file):
    """Texture coordinates of corners as they stand in the file: trimesh leaves some out."""
    lines = [line.split() for line in file.read_text().splitlines()]
    uvs = [[float(v) for v in words[1:3]] for words in lines if words[:1] == ["vt"]]
    corners = [corner.split("/") for words in lines if words[:1] == ["f"] for corner in words[1:]]
    named = [uvs[int(corner[1]) - 1] for corner in corners if len(corner) > 1 and corner[1]]
    return numbers([np.min(named, 0), np.max(named, 0)]) if named else [0.0] * 4


# Left out: texture coordinates where trimesh drops those beside colours, materials of a scene that
# is not shown, and colours of VTK's library, whose `Tr 1` means opaque there and clear elsewhere.
UNSAID = {"gltf/bl sep.gltf": "uv_box", "gltf/three-scenes.gltf": "colours", "obj/vtk.obj": "colours"}
# Those that trimesh refuses, or reads against the format.
PLAIN = ["bl sep.gltf", "three-instances.glb", "transform-modes.gltf", "transform-quantized.glb", "transform-sparse.glb"]
# Compressed: not read here.
REFUSED = ["gltf/transform-draco.glb", "gltf/transform-meshopt.glb"]
found = {}
for file in sorted(p for folder in ("obj", "ply", "gltf", "mitsuba") for p in (HERE / folder).iterdir()):
    name = str(file.relative_to(HERE))
    if file.suffix not in (".obj", ".ply", ".gltf", ".glb", ".xml") or name in REFUSED or (file.parent.name == "mitsuba" and file.suffix != ".xml"):
        continue
    if file.suffix == ".xml":
        found[name] = by_mitsuba(file)
        continue
    try:
        of = by_plyfile(file) if file.suffix == ".ply" else by_gltf_transform(file) if file.name in PLAIN else by_trimesh(file)
    except Exception as error:
        print(name, "not read:", error)
        continue
    colours = materials(file) if file.suffix == ".obj" else by_json(file) if file.suffix in (".gltf", ".glb") else None
    if colours is not None:
        of["colours"] = colours
    if file.suffix == ".obj":
        of["uv_box"] = obj_uvs(file)
    of.pop(UNSAID.get(name), None)
    found[name] = of
rows = [f"{json.dumps(name)}: {json.dumps(of)}" for name, of in found.items()]
open(HERE / "expected.json", "w").write("{\n" + ",\n".join(rows) + "\n}\n")
print(len(found), "files")
