use super::*;
use traylib_math::glam::DVec3;

fn none(_: &str) -> Result<Included, String> {
    Err("there is none".to_string())
}

fn read(text: &str) -> Result<Document, Error> {
    decode("a.xml", text.as_bytes(), Limits::default(), &mut none)
}

fn sound(inner: &str) -> Document {
    read(&format!("<scene version='3.0.0'>{inner}</scene>")).unwrap()
}

fn refused(inner: &str) -> String {
    read(&format!("<scene version='3.0.0'>\n {inner}</scene>")).unwrap_err().to_string()
}

fn property<'a>(document: &'a Document, object: usize, name: &str) -> &'a Value {
    let all = &document.objects[object].properties;
    &all.iter().find(|property| property.name == name).unwrap().value
}

#[test]
fn objects_have_properties_and_objects_within() {
    let document = sound(
        "<shape type='sphere' id='ball'><float name='radius' value='2'/><point name='center' x='1' z='3'/>
         <bsdf type='diffuse'><rgb name='reflectance' value='.1 .2 .3'/></bsdf></shape>",
    );
    assert_eq!((document.roots.as_slice(), document.objects.len()), (&[0][..], 2));
    let ball = &document.objects[0];
    assert_eq!(
        (ball.class, ball.kind.as_str(), ball.id.as_str()),
        (Class::Shape, "sphere", "ball")
    );
    assert_eq!(ball.children, [Child { name: String::new(), object: 1 }]);
    assert_eq!(property(&document, 0, "center"), &Value::Vector([1.0, 0.0, 3.0]));
    assert_eq!(property(&document, 1, "reflectance"), &Value::Colour([0.1, 0.2, 0.3]));
    assert_eq!(document.objects[1].place, Place { file: 0, line: 2, column: 10 });
}

#[test]
fn references_lead_to_what_stands_before_or_behind() {
    let document = sound(
        "<shape type='a'><ref id='late' name='x'/><ref id='other'/></shape><bsdf type='b' id='late'/>
         <alias id='late' as='other'/>",
    );
    let to = |object, name: &str| Child { name: name.to_string(), object };
    assert_eq!(document.objects[0].children, [to(1, "x"), to(1, "")]);
    assert_eq!(
        refused("<shape type='a'><ref id='b'/></shape>"),
        "a.xml:2:18: nothing has the id `b`"
    );
    let twice = refused("<bsdf type='a' id='b'/><bsdf type='a' id='b'/>");
    assert!(twice.ends_with("a second object has the id `b`"), "{twice}");
}

#[test]
fn old_names_become_new_ones() {
    let old =
        "<scene version='0.5.0'><shape type='a'><transform name='toWorld'><lookAt origin='0,0,1'
        target='0,0,0' up='0,1,0'/></transform><float name='intIOR' value='1.3'/></shape></scene>";
    let document = read(old).unwrap();
    assert_eq!(property(&document, 0, "int_ior"), &Value::Number(1.3));
    assert!(matches!(property(&document, 0, "to_world"), Value::Transform(_)));
    assert!(document.objects[0].is_old && document.warnings.iter().count() == 0);
}

#[test]
fn steps_of_a_transform_follow_each_other() {
    let document = sound(
        "<shape type='a'><transform name='t'><translate value='1 2 3'/><scale value='2'/>
         <rotate x='1' angle='90'/></transform></shape>",
    );
    let Value::Transform(found) = property(&document, 0, "t") else { panic!() };
    assert_eq!(found.transform_point3(DVec3::ZERO), DVec3::new(2.0, -6.0, 4.0));
    assert_eq!(found.transform_vector3(DVec3::X), DVec3::new(2.0, 0.0, 0.0));
}

#[test]
fn defaults_are_put_in_where_they_are_named() {
    let document = sound(
        "<default name='r' value='4'/><shape type='sphere'><float name='radius' value='$r'/></shape>",
    );
    assert_eq!(property(&document, 0, "radius"), &Value::Number(4.0));
    assert_eq!(refused("<shape type='$x'/>"), "a.xml:2:2: no `default` gives a value to `$x`");
}

/// Files by name, for a reader that includes them.
fn with_files(main: &str, files: &[(&str, &str)]) -> Result<Document, Error> {
    let mut load = |name: &str| {
        let found = files.iter().find(|(known, _)| *known == name);
        let (name, text) = found.ok_or("there is none")?;
        Ok(Included { name: (*name).to_string(), bytes: text.as_bytes().to_vec() })
    };
    decode("a.xml", main.as_bytes(), Limits::default(), &mut load)
}

#[test]
fn included_files_stand_where_they_are_named() {
    let main = "<scene version='3.0.0'><default name='k' value='c'/><include filename='b.xml'/>
        <shape type='x'><include filename='$k.xml'/></shape></scene>";
    let files = [
        (
            "b.xml",
            "<scene version='0.6.0'><shape type='y'><float name='aB' value='1'/></shape></scene>",
        ),
        ("c.xml", "<bsdf type='z' version='3.0.0'/>"),
    ];
    let document = with_files(main, &files).unwrap();
    let kinds: Vec<&str> = document.objects.iter().map(|object| object.kind.as_str()).collect();
    assert_eq!((kinds, document.roots.as_slice()), (vec!["y", "x", "z"], &[0, 1][..]));
    assert_eq!(property(&document, 0, "a_b"), &Value::Number(1.0));
    assert_eq!(document.objects[2].place.file, 2);
}

#[test]
fn files_that_include_themselves_or_too_many_are_refused() {
    let include =
        |name: &str| format!("<scene version='3.0.0'><include filename='{name}'/></scene>");
    let circle = [("b.xml", &*include("c.xml")), ("c.xml", &*include("b.xml"))];
    let error = with_files(&include("b.xml"), &circle).unwrap_err();
    assert_eq!((error.file.as_str(), error.line), ("c.xml", 1));
    assert!(error.to_string().contains("directly or through others"), "{error}");
    let missing = with_files(&include("d.xml"), &[]).unwrap_err();
    assert!(
        missing.to_string().ends_with("`d.xml` cannot be included: there is none"),
        "{missing}"
    );
    // Names that differ each time: the depth ends it.
    let mut count = 0;
    let mut load = |_: &str| {
        count += 1;
        Ok(Included { name: count.to_string(), bytes: include("x").into_bytes() })
    };
    let error = decode("a.xml", include("x").as_bytes(), Limits::default(), &mut load).unwrap_err();
    assert!(matches!(error.fault, Fault::Limit { option: crate::Limit::Depth, .. }), "{error}");
}

#[test]
fn bytes_and_elements_have_bounds() {
    let many = format!("<scene version='3.0.0'>{}</scene>", "<float value='1'/> ".repeat(100));
    let within = |limits| decode("a.xml", many.as_bytes(), limits, &mut none);
    let usual = Limits::default();
    assert!(within(Limits { elements: 100, ..usual }).is_ok());
    for (limits, option) in [
        (Limits { elements: 99, ..usual }, crate::Limit::Items),
        (Limits { elements: 9, ..usual }, crate::Limit::Items),
        (Limits { bytes: 1000, ..usual }, crate::Limit::Bytes),
    ] {
        let error = within(limits).unwrap_err();
        assert!(
            matches!(error.fault, Fault::Limit { option: found, .. } if found == option),
            "{error}"
        );
    }
}

#[test]
fn what_is_no_scene_is_refused_with_its_place() {
    for (text, expected) in [
        ("", "a.xml:1:1: "),
        ("<html/>", "a.xml:1:1: `html` where `scene` was expected: it is no scene of Mitsuba"),
        ("<scene>\n<a></b></scene>", "a.xml:2:4: "),
        ("<!DOCTYPE a [<!ENTITY b 'c'>]><scene>&b;</scene>", "a.xml:1:1: a document type"),
        ("<scene><shape/></scene>", "a.xml:1:8: `shape` has no `type`"),
        (
            "<scene>\n\n <shape type='a'><float name='x' value='y'/></shape></scene>",
            "a.xml:3:18: `y` is not a finite number",
        ),
    ] {
        let error = read(text).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{error}");
    }
    let error = decode("a.xml", b"<scene>\n\xff", Limits::default(), &mut none).unwrap_err();
    assert_eq!((error.line, error.fault), (2, Fault::NotText));
}

#[test]
fn what_is_skipped_is_counted() {
    let document = sound(
        "<path value='x'/><path value='y'/><float value='1'/><shape type='a'><tensor/>
         <transform name='t'><shear/><rotate y='2' angle='90'/></transform></shape>",
    );
    let warnings: Vec<(String, u32)> = document.warnings.iter().collect();
    let said: Vec<&str> = warnings.iter().map(|(what, _)| what.as_str()).collect();
    let expected = [
        "element `path` skipped",
        "element `tensor` skipped",
        "`float` that belongs to no object skipped",
        "`shear` in a transform skipped",
        "axis of a `rotate` that is not of length one, brought there",
    ];
    assert_eq!((said.as_slice(), warnings[0].1), (&expected[..], 2));
}
