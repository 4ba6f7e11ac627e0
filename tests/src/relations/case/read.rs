//! Documents back into plain data.

use crate::relations::scene::{
    Base, BumpMap, Camera, DrawnScene, Light, Lobes, Map, Material, Mesh, Object, Picture, Shape,
    Sky, Spot, Tiling,
};
use std::collections::HashMap;
use std::f32::consts::PI;
use std::fs;
use std::path::Path;
use traylib_geometry::Sides;
use traylib_io::ron_scene::material as ron;
use traylib_io::ron_scene::{self, Document, Facing, decode};
use traylib_io::{TextureLimits, load_texture, mgf, three_ds};
use traylib_math::glam::DVec3;
use traylib_math::{Rgb, Vec3};

/// Lumens a watt of Radiance.
const LUMENS_PER_WATT: f32 = 179.0;

/// The scene of a text that stands in this file.
pub(super) fn scene(text: &str, path: &Path) -> Result<DrawnScene, String> {
    let document = decode(text).map_err(|error| error.to_string())?;
    let reader = Reader { folder: path.parent().unwrap_or(Path::new("")) };
    let camera = document.camera.as_ref().ok_or("no camera")?;
    let materials = reader.materials(&document)?;
    let mut objects = Vec::new();
    for object in &document.objects {
        reader.object(object, &materials, &mut objects)?;
    }
    Ok(DrawnScene {
        camera: Camera {
            position: camera.position.into(),
            target: camera.target.into(),
            up: camera.up.into(),
            fov: camera.fov,
            pixels: camera.resolution.0,
        },
        objects,
        lights: document.lights.iter().map(light).collect(),
        sky: document.sky.as_ref().map(|sky| reader.sky(sky)).transpose()?,
        max_depth: None,
    })
}

struct Reader<'a> {
    folder: &'a Path,
}

impl Reader<'_> {
    fn materials(&self, document: &Document) -> Result<HashMap<String, Material>, String> {
        let named = document.materials.0.iter();
        named.map(|(name, material)| Ok((name.clone(), self.material(material)?))).collect()
    }

    fn material(&self, material: &ron::Material) -> Result<Material, String> {
        let ron::Material::Textured(textured) = material else {
            return Ok(Material::plain(base(material)?));
        };
        let map = |texture: &Option<ron::Texture>| {
            texture.as_ref().map(|t| self.map(&t.file, t.lay, t.strength)).transpose()
        };
        let bump = |bump: &ron::BumpMap| {
            let map = self.map(&bump.file, bump.lay, 1.0)?;
            Ok::<BumpMap, String>(BumpMap { map, height: bump.height })
        };
        Ok(Material {
            base: base(&textured.base)?,
            diffuse: map(&textured.diffuse)?,
            specular: map(&textured.specular)?,
            opacity: map(&textured.opacity)?,
            bump: textured.bump.as_ref().map(bump).transpose()?,
        })
    }

    fn map(&self, file: &str, lay: ron::Lay, strength: f32) -> Result<Map, String> {
        let content = self.read(file)?;
        let ending = Path::new(file).extension().unwrap_or_default().to_string_lossy().into();
        let tiling = match lay.tiling {
            ron::Tiling::Repeat => Tiling::Repeat,
            ron::Tiling::Mirror => Tiling::Mirror,
            ron::Tiling::Once => Tiling::Once,
        };
        let picture = Picture::File { ending, content };
        Ok(Map { picture, tiling, scale: lay.scale.into(), strength })
    }

    fn sky(&self, sky: &ron_scene::Sky) -> Result<Sky, String> {
        match sky {
            ron_scene::Sky::Constant(sky) => Ok(Sky::even(sky.radiance.into())),
            ron_scene::Sky::Picture(sky) => {
                let path = self.folder.join(&sky.file);
                let picture = load_texture(&path, TextureLimits::default());
                let pixels = picture.map_err(|error| error.to_string())?.pixels;
                let texel = |light: &Rgb| Vec3::from(light.to_array()) * sky.scale;
                let texels = pixels.values().iter().map(texel).collect();
                Ok(Sky { width: pixels.width(), texels, turn: sky.turn })
            }
        }
    }

    fn read(&self, file: &str) -> Result<Vec<u8>, String> {
        fs::read(self.folder.join(file)).map_err(|error| format!("{file}: {error}"))
    }

    fn object(
        &self,
        object: &ron_scene::Object,
        materials: &HashMap<String, Material>,
        objects: &mut Vec<Object>,
    ) -> Result<(), String> {
        let named = object.material.as_ref().map(|name| materials.get(name).cloned());
        let named = named.map(|found| found.ok_or("a material is missing")).transpose()?;
        let emission = object.emission.map_or(Vec3::ZERO, Vec3::from);
        let sides = object.sides.map_or(Sides::Both, Sides::from);
        if let ron_scene::Shape::Mesh(mesh) = &object.shape {
            for mut part in self.parts(mesh)? {
                part.emission = object.emission.map_or(part.emission, Vec3::from);
                part.sides = object
                    .sides
                    .map(Sides::from)
                    .or(named.as_ref().map(|_| Sides::Both))
                    .unwrap_or(part.sides);
                part.material = named.clone().unwrap_or(part.material);
                objects.push(part);
            }
            return Ok(());
        }
        let material = named.ok_or("an object has no material")?;
        objects.push(Object { shape: shape(&object.shape)?, material, emission, sides });
        Ok(())
    }

    /// Returns the objects of a file of shapes; neither turned nor scaled.
    fn parts(&self, mesh: &ron_scene::Mesh) -> Result<Vec<Object>, String> {
        if mesh.scale != 1.0 || mesh.rotate != [0.0; 3] || !mesh.materials.0.is_empty() {
            return Err(format!("{}: only `translate` is understood here", mesh.file));
        }
        let shift = Vec3::from(mesh.translate);
        if Path::new(&mesh.file).extension().is_some_and(|ending| ending == "mgf") {
            self.mgf(&mesh.file, shift)
        } else {
            self.three_ds(&mesh.file, shift)
        }
    }

    fn three_ds(&self, file: &str, shift: Vec3) -> Result<Vec<Object>, String> {
        let document = three_ds::decode(&self.read(file)?).map_err(|error| error.to_string())?;
        let objects = document.meshes.iter().map(|mesh| {
            let triangles = mesh.faces.iter().map(|face| face.corners.map(u32::from));
            let mesh = Mesh {
                positions: mesh.vertices.iter().map(|&vertex| vertex + shift).collect(),
                triangles: triangles.collect(),
                normals: None,
                uvs: (!mesh.uvs.is_empty()).then(|| mesh.uvs.clone()),
            };
            plain(Shape::Mesh(mesh))
        });
        Ok(objects.collect())
    }

    fn mgf(&self, file: &str, shift: Vec3) -> Result<Vec<Object>, String> {
        let options = mgf::Options::default();
        let document =
            mgf::decode(&[self.folder.join(file)], &options).map_err(|error| error.to_string())?;
        let mut objects: Vec<(usize, Object)> = Vec::new();
        for surface in &document.surfaces {
            let of = &document.materials[surface.material];
            let rgb = |part: mgf::Part| Vec3::from_array(part.rgb().to_array());
            let base = if of.td.amount > 0.0 {
                Base::Sheet(Lobes::diffuse(rgb(of.rd)), Lobes::diffuse(rgb(of.td)))
            } else {
                Base::Lambert(rgb(of.rd))
            };
            let sides = if of.two_sided { Sides::Both } else { Sides::Front };
            let emission = rgb(of.ed) / (PI * LUMENS_PER_WATT);
            let object = |shape| Object { shape, material: Material::plain(base), emission, sides };
            let Some(shape) = round(&surface.shape) else {
                let flat = object(Shape::Mesh(triangles(&surface.shape)?));
                add_flat(&mut objects, surface.material, flat);
                continue;
            };
            objects.push((surface.material, object(shape)));
        }
        let moved = |(_, object): (usize, Object)| {
            let by = crate::relations::form::motion::Motion::shift(shift.as_dvec3());
            object.with_shape(by.shape(&object.shape))
        };
        Ok(objects.into_iter().map(moved).collect())
    }
}

fn plain(shape: Shape) -> Object {
    Object { shape, material: Material::grey(0.0), emission: Vec3::ZERO, sides: Sides::Both }
}

fn round(shape: &mgf::Shape) -> Option<Shape> {
    Some(match *shape {
        mgf::Shape::Sphere { centre, radius, inward } => {
            Shape::Sphere { centre: centre.as_vec3(), radius: radius as f32, inward }
        }
        mgf::Shape::Cylinder { ends, radius, inward } => Shape::Cone {
            ends: ends.map(|end: DVec3| end.as_vec3()),
            radii: [radius as f32; 2],
            inward,
        },
        mgf::Shape::Cone { ends, radii, inward } => {
            let radii = radii.map(|radius| radius as f32);
            Shape::Cone { ends: ends.map(|end: DVec3| end.as_vec3()), radii, inward }
        }
        mgf::Shape::Ring { centre, normal, radii: [inner, outer] } => Shape::Disk {
            centre: centre.as_vec3(),
            normal: normal.as_vec3(),
            inner: inner as f32,
            radius: outer as f32,
        },
        mgf::Shape::Face { .. } | mgf::Shape::Torus { .. } | mgf::Shape::Prism { .. } => {
            return None;
        }
    })
}

/// Convex polygons without holes, which all of ours are.
fn triangles(shape: &mgf::Shape) -> Result<Mesh, String> {
    let mgf::Shape::Face { outline, holes } = shape else {
        return Err("only faces and round shapes".into());
    };
    if !holes.is_empty() {
        return Err("a face with holes".into());
    }
    let positions = outline.iter().map(|vertex| vertex.position.as_vec3()).collect();
    let normals: Option<Vec<Vec3>> =
        outline.iter().map(|vertex| vertex.normal.map(|n: DVec3| n.as_vec3())).collect();
    let triangles = (1..outline.len() as u32 - 1).map(|i| [0, i, i + 1]).collect();
    Ok(Mesh { positions, triangles, normals, uvs: None })
}

/// Triangles of one material that follow one another are one mesh.
fn add_flat(objects: &mut Vec<(usize, Object)>, material: usize, flat: Object) {
    if let Some((of, Object { shape: Shape::Mesh(last), .. })) = objects.last_mut()
        && let Shape::Mesh(mesh) = &flat.shape
        && *of == material
        && last.normals.is_some() == mesh.normals.is_some()
    {
        last.join(mesh);
    } else {
        objects.push((material, flat));
    }
}

fn shape(shape: &ron_scene::Shape) -> Result<Shape, String> {
    use ron_scene::Shape as Ron;
    Ok(match shape {
        Ron::Quad(s) => Shape::Quad([s.corner.into(), s.edge_u.into(), s.edge_v.into()]),
        Ron::Sphere(s) => Shape::Sphere {
            centre: s.center.into(),
            radius: s.radius,
            inward: s.facing == Facing::Inward,
        },
        Ron::Disk(s) => Shape::Disk {
            centre: s.center.into(),
            normal: s.normal.into(),
            inner: 0.0,
            radius: s.radius,
        },
        Ron::Triangle(s) => Shape::Triangle([s.a.into(), s.b.into(), s.c.into()]),
        Ron::Box(s) => Shape::Box([s.min.into(), s.max.into()]),
        Ron::Cone(_) | Ron::Mesh(_) => {
            return Err("a shape that relations do not draw here".into());
        }
    })
}

fn base(material: &ron::Material) -> Result<Base, String> {
    let lobes = |lobes: &ron::Lobes| Lobes {
        diffuse: lobes.diffuse.into(),
        specular: lobes.specular.into(),
        exponent: lobes.exponent,
    };
    Ok(match material {
        ron::Material::Lambert(m) => Base::Lambert(m.reflectance.into()),
        ron::Material::Phong(m) => Base::Phong(Lobes {
            diffuse: m.diffuse.into(),
            specular: m.specular.into(),
            exponent: m.exponent,
        }),
        ron::Material::MaxPhong(m) => Base::MaxPhong(m.specular.into(), m.exponent),
        ron::Material::Mirror(m) => Base::Mirror(m.reflectance.into(), m.diffuse.into()),
        ron::Material::Sheet(m) => Base::Sheet(lobes(&m.reflection), lobes(&m.transmission)),
        ron::Material::Glass(m) => Base::Glass(m.index),
        ron::Material::Pane(m) => Base::Pane(m.reflectance.into(), m.through.into()),
        ron::Material::Gauze(_) | ron::Material::Textured(_) => {
            return Err("a material that relations do not draw here".into());
        }
    })
}

fn light(light: &ron_scene::Light) -> Light {
    let spot = match light {
        ron_scene::Light::Point(_) => None,
        ron_scene::Light::Spot(spot) => Some(Spot {
            target: spot.target.into(),
            full: spot.full,
            dark: spot.dark.unwrap_or(spot.full),
        }),
    };
    Light { position: light.position().into(), intensity: light.intensity().into(), spot }
}
