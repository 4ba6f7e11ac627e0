use super::*;
use crate::picture::tests::Folder;
use exr::image::write::WritableImage;
use exr::meta::attribute::Chromaticities;
use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, ImageAttributes, IntegerBounds, Layer,
    LayerAttributes, Vec2, f16,
};

/// A layer of 2 × 1 pixels: a name, and channels with the value of their place.
fn layer(name: &str, channels: &[&str]) -> Layer<AnyChannels<FlatSamples>> {
    let floats = |i: usize| FlatSamples::F32(vec![i as f32 + 1.0, i as f32 + 1.5]);
    layer_of(name, channels.iter().enumerate().map(|(i, &name)| (name, floats(i))))
}

fn layer_of<'a>(
    name: &str,
    channels: impl Iterator<Item = (&'a str, FlatSamples)>,
) -> Layer<AnyChannels<FlatSamples>> {
    let channels = channels.map(|(name, samples)| AnyChannel::new(name, samples)).collect();
    let attributes = LayerAttributes::named(name);
    Layer::new((2, 1), attributes, Encoding::FAST_LOSSLESS, AnyChannels::sort(channels))
}

/// Reads a file of these layers.
fn read(test: &str, layers: Vec<Layer<AnyChannels<FlatSamples>>>) -> Result<Grid<Rgb>, Error> {
    let window = IntegerBounds::from_dimensions((2, 1));
    read_windowed(test, window, layers)
}

fn read_windowed(
    test: &str,
    window: IntegerBounds,
    layers: Vec<Layer<AnyChannels<FlatSamples>>>,
) -> Result<Grid<Rgb>, Error> {
    let folder = Folder::new(test);
    let path = folder.path().join("a.exr");
    let image = Image::from_layers(ImageAttributes::new(window), layers);
    image.write().to_file(&path).unwrap();
    load_exr(&path)
}

/// The red of the first pixel: which channel it was read from.
#[track_caller]
fn first_red(test: &str, layers: Vec<Layer<AnyChannels<FlatSamples>>>) -> f32 {
    read(test, layers).unwrap().get(0, 0).r
}

#[test]
fn all_kinds_of_numbers_are_read() {
    let channels = [
        ("R", FlatSamples::F16(vec![f16::from_f32(0.25), f16::from_f32(-2.0)])),
        ("G", FlatSamples::F32(vec![0.1, f32::NAN])),
        ("B", FlatSamples::U32(vec![3, 70_000])),
    ];
    let picture = read("kinds", vec![layer_of("", channels.into_iter())]).unwrap();
    assert_eq!(*picture.get(0, 0), Rgb::new(0.25, 0.1, 3.0));
    let second = picture.get(1, 0);
    assert!(second.r == -2.0 && second.g.is_nan() && second.b == 70_000.0);
}

#[test]
fn luminance_alone_is_grey_and_with_chroma_it_is_refused() {
    let grey = read("grey", vec![layer("", &["Z", "Y"])]).unwrap();
    assert_eq!(*grey.get(1, 0), Rgb::new(2.5, 2.5, 2.5));
    assert!(read("chroma", vec![layer("", &["Y", "RY", "BY"])]).is_err());
}

/// Y of X, Y and Z is a part of a picture in colours.
#[test]
fn xyz_is_refused_with_its_channels() {
    let said = read("xyz", vec![layer("", &["X", "Y", "Z"])]).unwrap_err();
    assert!(matches!(&said, Error::NoLight { channels, .. } if channels == &["X", "Y", "Z"]));
    assert!(said.to_string().ends_with("it has `X`, `Y`, `Z`"), "{said}");
}

#[test]
fn other_primaries_are_converted() {
    let folder = Folder::new("primaries");
    let path = folder.path().join("a.exr");
    let of = |chromaticities: Option<Chromaticities>| {
        let mut image = Image::from_layers(
            ImageAttributes::new(IntegerBounds::from_dimensions((2, 1))),
            vec![layer("", &["B", "G", "R"])],
        );
        image.attributes.chromaticities = chromaticities;
        image.write().to_file(&path).unwrap();
        load_exr(&path).map(|picture| picture.get(0, 0).to_array())
    };
    let with = |white| Chromaticities {
        red: Vec2(0.708, 0.292),
        green: Vec2(0.17, 0.797),
        blue: Vec2(0.131, 0.046),
        white,
    };
    assert_eq!(of(None).unwrap(), [3.0, 2.0, 1.0]);
    let wide = of(Some(with(Vec2(0.3127, 0.329)))).unwrap();
    // 1.6605·3 − 0.5876·2 − 0.0728 and so on, ITU-R BT.2087.
    for (found, expected) in wide.into_iter().zip([3.7334, 1.8837, 0.8629]) {
        assert!((found - expected).abs() < 1e-3, "{wide:?}");
    }
    let said = of(Some(with(Vec2(0.3, 0.0)))).unwrap_err().to_string();
    assert!(said.contains("the chromaticities are not x and y"), "{said}");
}

#[test]
fn opacity_is_the_channel_of_the_same_group() {
    let folder = Folder::new("opacity");
    let path = folder.path().join("a.exr");
    let of = |channels: &[&str]| {
        let window = IntegerBounds::from_dimensions((2, 1));
        let image = Image::from_layers(ImageAttributes::new(window), vec![layer("", channels)]);
        image.write().to_file(&path).unwrap();
        load_exr_within(&path, 100).unwrap().alpha.map(|alpha| alpha.values().to_vec())
    };
    assert_eq!(of(&["A", "B", "G", "R"]), Some(vec![1.0, 1.5]));
    assert_eq!(of(&["B", "G", "R"]), None);
    assert_eq!(of(&["B", "G", "R", "x.A"]), None);
}

#[test]
fn the_whole_picture_is_found_among_others() {
    let prefixed = ["View.AO.R", "View.AO.G", "View.AO.B", "View.Combined.R"];
    let prefixed = [&prefixed[..], &["View.Combined.G", "View.Combined.B"]].concat();
    assert_eq!(first_red("prefixed", vec![layer("", &prefixed)]), 4.0);
    let error = ["se.R", "se.G", "se.B", "R", "G", "B"];
    assert_eq!(first_red("error", vec![layer("", &error)]), 4.0);
    let layers = vec![layer("depth", &["Z"]), layer("light", &["A", "R", "G", "B"])];
    assert_eq!(first_red("second", layers), 2.0);
    let layers =
        vec![layer("albedo", &["R", "G", "B"]), layer("beauty", &["x", "y", "R", "G", "B"])];
    assert_eq!(first_red("beauty", layers), 3.0);
    assert_eq!(first_red("only", vec![layer("", &["x", "glow.R", "glow.G", "glow.B"])]), 2.0);
}

#[test]
fn where_no_picture_is_found_the_channels_are_named() {
    let two = ["a.R", "a.G", "a.B", "b.R", "b.G", "b.B"];
    let said = read("two", vec![layer("", &two)]).unwrap_err().to_string();
    assert!(said.contains("a.exr: no picture found") && said.contains("`a.R`"), "{said}");
    let said = read("depth", vec![layer("far", &["Z"])]).unwrap_err();
    assert!(matches!(&said, Error::NoLight { channels, .. } if channels == &["far/Z"]), "{said}");
    assert!(!said.to_string().contains('\n'));
}

#[test]
fn data_are_shown_where_they_belong() {
    let mut data = layer("", &["B", "G", "R"]);
    data.attributes.layer_position = Vec2(-1, 5);
    let window = IntegerBounds::new((-3, 4), (3, 3));
    let shown = read_windowed("inside", window, vec![data.clone()]).unwrap();
    assert_eq!((shown.width(), shown.height()), (3, 3));
    assert_eq!(*shown.get(2, 1), Rgb::new(3.0, 2.0, 1.0));
    let lit = shown.values().iter().filter(|pixel| **pixel != Rgb::BLACK);
    assert_eq!(lit.count(), 1, "the second pixel lies outside");
}
