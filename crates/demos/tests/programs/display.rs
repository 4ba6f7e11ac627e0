//! The picture in a viewer: one that is played here, and understands what tev does.

use crate::common::{Folder, Run, programs};
use std::io::Read;
use std::net::{TcpListener, TcpStream};
use std::thread::{self, JoinHandle};
use traylib_io::{load_exr, open_exr};
use traylib_math::Grid;

const SIZE: &str = "cornell --resolution 70x50 --sampler independent -q";

/// The number of a command of vector graphics, and its floats.
type Command = (u8, Vec<f32>);

/// What a packet says, as far as these tests want it.
#[derive(Debug, PartialEq)]
enum Packet {
    Create { shown: bool, name: String, size: [usize; 2], channels: Vec<String> },
    Update { name: String, channels: Vec<String>, place: [usize; 4], pixels: Vec<Vec<f32>> },
    Graphics { name: String, added: bool, commands: Vec<Command> },
}

/// The bytes of a packet that are not read yet.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn array<const N: usize>(&mut self) -> [u8; N] {
        let (head, rest) = self.0.split_at(N);
        self.0 = rest;
        head.try_into().unwrap()
    }

    fn flag(&mut self) -> bool {
        let [flag] = self.array();
        assert!(flag < 2);
        flag == 1
    }

    fn text(&mut self) -> String {
        let end = self.0.iter().position(|&byte| byte == 0).unwrap();
        let text = String::from_utf8(self.0[..end].to_vec()).unwrap();
        self.0 = &self.0[end + 1..];
        text
    }

    fn int(&mut self) -> usize {
        usize::try_from(i32::from_le_bytes(self.array())).unwrap()
    }

    fn long(&mut self) -> usize {
        usize::try_from(i64::from_le_bytes(self.array())).unwrap()
    }

    fn float(&mut self) -> f32 {
        f32::from_le_bytes(self.array())
    }

    fn several<T>(&mut self, count: usize, mut one: impl FnMut(&mut Self) -> T) -> Vec<T> {
        (0..count).map(|_| one(self)).collect()
    }
}

fn read_packet(bytes: &[u8]) -> Packet {
    let mut bytes = Bytes(bytes);
    let [kind] = bytes.array();
    let (shown, name) = (bytes.flag(), bytes.text());
    let packet = match kind {
        4 => {
            let size = [bytes.int(), bytes.int()];
            let count = bytes.int();
            Packet::Create { shown, name, size, channels: bytes.several(count, Bytes::text) }
        }
        6 => {
            let count = bytes.int();
            let channels = bytes.several(count, Bytes::text);
            let place = [bytes.int(), bytes.int(), bytes.int(), bytes.int()];
            let offsets = bytes.several(count, Bytes::long);
            let strides = bytes.several(count, Bytes::long);
            let area = place[2] * place[3];
            let floats = bytes.several(count * area, Bytes::float);
            let bands = || offsets.iter().zip(&strides);
            let pixel = |at| bands().map(|(offset, stride)| floats[offset + at * stride]).collect();
            Packet::Update { name, channels, place, pixels: (0..area).map(pixel).collect() }
        }
        8 => {
            let (added, count) = (bytes.flag(), bytes.int());
            let command = |bytes: &mut Bytes<'_>| {
                let [kind] = bytes.array();
                let floats = match kind {
                    4 | 18 => 4,
                    5 | 6 => 0,
                    kind => panic!("command {kind}"),
                };
                (kind, bytes.several(floats, Bytes::float))
            };
            Packet::Graphics { name, added, commands: bytes.several(count, command) }
        }
        kind => panic!("packet {kind}"),
    };
    assert_eq!(bytes.0, [0_u8; 0], "bytes after {packet:?}");
    packet
}

fn next_packet(stream: &mut TcpStream) -> Option<Packet> {
    let mut length = [0; 4];
    stream.read_exact(&mut length).ok()?;
    let mut bytes = vec![0; u32::from_le_bytes(length) as usize - 4];
    stream.read_exact(&mut bytes).unwrap();
    Some(read_packet(&bytes))
}

/// A viewer that does this with the program that finds it, and its address.
fn viewer<T: Send + 'static>(
    view: impl FnOnce(TcpStream) -> T + Send + 'static,
) -> (String, JoinHandle<T>) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    (address, thread::spawn(move || view(listener.accept().unwrap().0)))
}

/// All that a program says to a viewer.
fn shown(folder: &Folder, program: &str, options: &str) -> Vec<Packet> {
    let (address, packets) = viewer(|mut stream| {
        std::iter::from_fn(move || next_packet(&mut stream)).collect::<Vec<Packet>>()
    });
    let run = folder.run(program, &format!("{options} --display-server {address}"));
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    packets.join().unwrap()
}

/// What is seen of the packets after the first, which makes the image; and the commands that
/// were drawn last.
fn look(packets: &[Packet], image: &str) -> (Grid<[f32; 3]>, Vec<Command>) {
    let Packet::Create { shown, name, size: [width, height], channels } = &packets[0] else {
        panic!("{:?}", packets[0]);
    };
    assert_eq!((*shown, name.as_str(), channels.concat().as_str()), (true, image, "RGB"));
    let mut seen = Grid::filled(*width, *height, [0.0; 3]);
    let mut drawn = Vec::new();
    for packet in &packets[1..] {
        match packet {
            Packet::Create { .. } => panic!("a second image"),
            Packet::Update { name, channels, place: [left, top, columns, rows], pixels } => {
                assert_eq!((name.as_str(), channels.concat().as_str()), (image, "RGB"));
                assert!(left + columns <= *width && top + rows <= *height);
                for (at, light) in pixels.iter().enumerate() {
                    let (x, y) = (left + at % columns, top + at / columns);
                    seen.values_mut()[y * width + x] = light[..].try_into().unwrap();
                }
            }
            Packet::Graphics { name, added, commands } => {
                assert_eq!((name.as_str(), *added), (image, false));
                drawn.clone_from(commands);
            }
        }
    }
    (seen, drawn)
}

/// The rectangles of commands that draw nothing else, each by a line.
fn rectangles(commands: &[Command]) -> Vec<[usize; 4]> {
    let (boxes, rest) = commands.as_chunks::<4>();
    assert!(rest.is_empty());
    let rectangle = |path: &[Command; 4]| {
        assert_eq!(path.each_ref().map(|(kind, _)| *kind), [6, 18, 4, 5]);
        [0, 1, 2, 3].map(|side| path[1].1[side] as usize)
    };
    boxes.iter().map(rectangle).collect()
}

#[test]
fn a_viewer_sees_the_picture_that_is_written() {
    let folder = Folder::new();
    for program in programs() {
        let options = format!("{SIZE} --spp 5 -o a.exr");
        let (seen, _) = look(&shown(&folder, program, &options), &format!("{program} cornell"));
        let written = load_exr(&folder.path().join("a.exr")).unwrap();
        assert!(seen == written.map(|light| light.to_array()), "{program}");
        let with_viewer = folder.bytes("a.exr");
        assert_eq!(folder.run(program, &options).status, Some(0));
        assert!(folder.bytes("a.exr") == with_viewer, "{program}");
    }
}

/// The variance is that of the file: no place of the size of a box has more.
#[test]
fn boxes_are_where_the_variance_is() {
    let folder = Folder::new();
    let options = format!("{SIZE} --spp 4 -o a.exr --aov variance");
    let (_, drawn) = look(&shown(&folder, "puremc", &options), "puremc cornell");
    let boxes = rectangles(&drawn);
    let file = open_exr(&folder.path().join("a.exr")).unwrap();
    let channels = file.layers.iter().flat_map(|layer| &layer.channels);
    let bands: Vec<&Vec<f32>> = channels
        .filter(|channel| channel.name.starts_with("variance."))
        .map(|channel| &channel.values)
        .collect();
    assert_eq!(bands.len(), 3);
    let variance = |[x, y, width, height]: [usize; 4]| -> f64 {
        let pixels = (y..y + height).flat_map(|y| (x..x + width).map(move |x| 70 * y + x));
        pixels.flat_map(|pixel| bands.iter().map(move |band| f64::from(band[pixel]))).sum()
    };
    // Tiles of 8x8 and what remains of 70x50.
    let tiles = (0..50).step_by(8).flat_map(|y| (0..70).step_by(8).map(move |x| [x, y]));
    let mut tiles: Vec<[usize; 4]> =
        tiles.map(|[x, y]| [x, y, 8.min(70 - x), 8.min(50 - y)]).collect();
    tiles.sort_by(|&a, &b| variance(b).total_cmp(&variance(a)));
    assert_eq!(boxes, tiles[..4]);
}

#[test]
fn a_part_of_the_picture_is_an_image_of_its_own_size() {
    let folder = Folder::new();
    let options = format!("{SIZE} --spp 1 --pixelbounds 10,31,5,16 -o a.exr");
    let (seen, drawn) = look(&shown(&folder, "bdpt", &options), "bdpt cornell");
    assert_eq!((seen.width(), seen.height()), (21, 11));
    // The file has it in its place of the frame.
    let frame = load_exr(&folder.path().join("a.exr")).unwrap();
    let is_the_same = |at: usize| {
        let (x, y) = (at % 21, at / 21);
        *seen.get(x, y) == frame.get(10 + x, 5 + y).to_array()
    };
    assert!((0..21 * 11).all(is_the_same));
    // Of one pass nothing is known of the error.
    assert_eq!(drawn, []);
}

/// Renders with a viewer at this address, which is warned of, and without.
fn assert_told_once(address: &str, options: &str, why: &str) {
    let folder = Folder::new();
    let expected = folder.run("trace", &format!("{options} -o a.png"));
    let alone = folder.bytes("a.png");
    let loud = options.replace(" -q", "");
    let run = folder.run("trace", &format!("{loud} -o a.png --display-server {address}"));
    assert_eq!((expected.status, run.status), (Some(0), Some(0)), "{}", run.err);
    let start = format!("warning: --display-server {address}: the picture is not shown there: ");
    let warnings: Vec<&str> = run.err.lines().filter(|line| line.starts_with(&start)).collect();
    assert!(warnings.len() == 1 && warnings[0].contains(why), "{}", run.err);
    assert_eq!(run.err.matches("--display-server").count(), 1, "{}", run.err);
    assert!(folder.bytes("a.png") == alone);
}

/// More light than lies in sockets while nobody reads.
const LARGE: &str = "cornell --resolution 1500x1500 --spp 1 -q";

#[test]
fn nobody_there_is_one_warning() {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    drop(listener);
    assert_told_once(&address, SIZE, "");
    let folder = Folder::new();
    let run = folder.run("trace", &format!("{SIZE} --spp 1 --display-server {address}"));
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""), "quiet is quiet");
}

#[test]
fn a_viewer_that_goes_away_is_one_warning() {
    let (address, gone) = viewer(|mut stream| drop(next_packet(&mut stream).unwrap()));
    assert_told_once(&address, LARGE, "");
    gone.join().unwrap();
}

/// Takes the seconds after which it is given up.
#[test]
fn a_viewer_that_reads_nothing_is_one_warning() {
    let (done, wait) = std::sync::mpsc::channel::<()>();
    let (address, stalled) = viewer(move |stream| {
        let _ = wait.recv();
        drop(stream);
    });
    assert_told_once(&address, LARGE, "it t");
    drop(done);
    stalled.join().unwrap();
}

#[test]
fn addresses_are_understood_or_refused() {
    let run: Run = Folder::new().run("bdpt", "cornell --display-server localhost:port");
    assert_eq!(run.status, Some(2));
    assert!(run.err.contains("wanted as localhost:14158"), "{}", run.err);
}
