use super::*;
use traylib_materials::Shading;
use traylib_math::Vec3;

fn part(amount: f32) -> Part {
    Part { amount, colour: Rgb::WHITE }
}

fn black() -> mgf::Material {
    mgf::Material {
        name: "x".into(),
        two_sided: true,
        rd: part(0.0),
        td: part(0.0),
        rs: part(0.0),
        rs_roughness: 0.0,
        ts: part(0.0),
        ts_roughness: 0.0,
        ed: part(0.0),
        ir: [1.0, 0.0],
    }
}

fn made(material: &mgf::Material) -> (ImportedMaterial, Vec<String>) {
    let mut counter = Counter::default();
    let material = imported(material, &mut counter).unwrap();
    let warnings = counter.into_warnings("f").map(|warning| warning.to_string()).collect();
    (material, warnings)
}

fn of(material: &mgf::Material) -> (SurfaceModel, Rgb) {
    let (material, warnings) = made(material);
    assert_eq!(warnings, Vec::<String>::new());
    (material.surface.model, material.surface.through)
}

fn lambert(kd: f32) -> SurfaceModel {
    SurfaceModel::Lambert(Lambert::new(Rgb::splat(kd)).unwrap())
}

fn phong(kd: f32, ks: f32, n: f32) -> Phong {
    Phong::new(Rgb::splat(kd), Rgb::splat(ks), n).unwrap()
}

#[test]
fn reflection_is_diffuse_a_lobe_or_a_mirror() {
    let none = Rgb::BLACK;
    assert_eq!(of(&black()), (lambert(0.0), none));
    let dull = mgf::Material { rd: part(0.5), ..black() };
    assert_eq!(of(&dull), (lambert(0.5), none));
    // n = 1/(2a²): 2 for ½, 8 for ¼; the broadest is 1.
    for (roughness, n) in [(0.5, 2.0), (0.25, 8.0), (4.0, 1.0)] {
        let glossy = mgf::Material { rs: part(0.25), rs_roughness: roughness, ..dull.clone() };
        assert_eq!(of(&glossy), (SurfaceModel::Phong(phong(0.5, 0.25, n)), none));
    }
    for roughness in [0.0, 0.0049] {
        let mirror = mgf::Material { rs: part(0.25), rs_roughness: roughness, ..dull.clone() };
        let model = Mirror::new(Rgb::splat(0.25), Rgb::splat(0.5)).unwrap();
        assert_eq!(of(&mirror), (SurfaceModel::Mirror(model), none));
    }
}

#[test]
fn transmission_passes_straight_or_through_a_sheet() {
    let clear = mgf::Material { rs: part(0.25), ts: part(0.5), ..black() };
    let mirror = Mirror::new(Rgb::splat(0.25), Rgb::BLACK).unwrap();
    assert_eq!(of(&clear), (SurfaceModel::Mirror(mirror), Rgb::splat(0.5)));
    // A pane, whatever its index.
    let pane = mgf::Material { ir: [1.5, 0.0], ..clear.clone() };
    assert_eq!(of(&pane), of(&clear));
    let sheet = |reflection, transmission| {
        SurfaceModel::Sheet(Sheet::new(reflection, transmission).unwrap())
    };
    let paper = mgf::Material { rd: part(0.5), td: part(0.25), ..black() };
    let model = sheet(phong(0.5, 0.0, SHARPEST), phong(0.25, 0.0, SHARPEST));
    assert_eq!(of(&paper), (model, Rgb::BLACK));
    let frosted = mgf::Material { ts_roughness: 0.25, ..clear };
    let model = sheet(phong(0.0, 0.25, SHARPEST), phong(0.0, 0.5, 8.0));
    assert_eq!(of(&frosted), (model, Rgb::BLACK));
    let curtain = mgf::Material { td: part(0.25), ts: part(0.5), ..black() };
    let model = sheet(phong(0.0, 0.0, SHARPEST), phong(0.25, 0.0, SHARPEST));
    assert_eq!(of(&curtain), (model, Rgb::splat(0.5)));
}

#[test]
fn a_one_sided_clear_material_with_an_index_is_solid_glass() {
    let glass = mgf::Material { two_sided: false, ts: part(0.9), ir: [1.5, 0.0], ..black() };
    let (material, warnings) = made(&glass);
    let model = SurfaceModel::Dielectric(Dielectric::new(1.5).unwrap());
    assert_eq!((material.surface.model, material.sides), (model, Sides::Both));
    assert_eq!(warnings, ["f: material `x` taken for clear glass, with its index alone"]);
    let metal = mgf::Material { ir: [1.5, 2.0], ..glass };
    assert_eq!(made(&metal).0.sides, Sides::Front);
}

#[test]
fn a_colour_that_would_make_light_is_scaled_down_in_its_band() {
    let red = Part { amount: 0.5, colour: Rgb::new(3.0, 0.5, 0.5) };
    let (material, warnings) = made(&mgf::Material { rd: red, td: part(0.5), ..black() });
    assert_eq!(warnings.len(), 1);
    let Shading { model, .. } = material.surface.at(Vec3::Z, || None);
    let parts = [Rgb::new(0.75, 0.25, 0.25), Rgb::new(0.25, 0.5, 0.5)];
    let [reflection, transmission] = parts.map(|kd| Phong::new(kd, Rgb::BLACK, SHARPEST).unwrap());
    assert_eq!(model, SurfaceModel::Sheet(Sheet::new(reflection, transmission).unwrap()));
}

#[test]
fn emittance_becomes_radiance_and_keeps_reflection() {
    let lamp = mgf::Material { rd: part(0.5), ed: part(140.586_28), two_sided: false, ..black() };
    let (material, _) = made(&lamp);
    assert!((material.emission.g - 0.25).abs() < 1e-6, "{}", material.emission.g);
    assert_eq!((material.surface.model, material.sides), (lambert(0.5), Sides::Front));
}
