use super::*;
use crate::picture::tests::Folder;
use exr::image::write::WritableImage;
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

/// What is read of a file of these layers.
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
