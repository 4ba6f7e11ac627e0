use super::*;
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicU32, Ordering};

mod arrays;
mod entities;
mod hostile;
mod includes;
mod real;

/// A folder of files that lives as long as the test.
struct Folder(PathBuf);

impl Folder {
    fn new(files: &[(&str, &str)]) -> Self {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("traylib-mgf-test-{}-{number}", std::process::id());
        let folder = Self(std::env::temp_dir().join(name));
        fs::create_dir_all(&folder.0).unwrap();
        for (name, text) in files {
            folder.write(name, text.as_bytes());
        }
        folder
    }

    fn write(&self, name: &str, bytes: &[u8]) {
        let path = self.0.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }

    fn decode(&self, name: &str) -> Result<Document, Error> {
        decode(&[self.0.join(name)], &Options::default())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn read(text: &str) -> Result<Document, Error> {
    Folder::new(&[("a.mgf", text)]).decode("a.mgf")
}

/// The error of a text without the folder.
fn refused(text: &str) -> String {
    refused_with(text, &Options::default())
}

fn refused_with(text: &str, options: &Options) -> String {
    let folder = Folder::new(&[("a.mgf", text)]);
    let error = decode(&[folder.0.join("a.mgf")], options).expect_err(text);
    let folder = format!("{}/", folder.0.display());
    error.to_string().replace(&folder, "")
}

/// Four vertices of a square, and with normals.
const SQUARE: &str = "\
v a =\n\tp 0 0 0\nv b =\n\tp 1 0 0\nv c =\n\tp 1 1 0\nv d =\n\tp 0 1 0\n\
v an =\n\tp 0 0 0\n\tn 0 0 2\n";

fn with_square(text: &str) -> Document {
    read(&format!("{SQUARE}{text}")).unwrap()
}

fn only_shape(text: &str) -> Shape {
    let document = with_square(text);
    assert_eq!(document.surfaces.len(), 1, "{text}");
    document.surfaces.into_iter().next().unwrap().shape
}

fn positions(shape: &Shape) -> Vec<[f64; 3]> {
    let (Shape::Face { outline, .. } | Shape::Prism { outline, .. }) = shape else {
        panic!("no polygon: {shape:?}")
    };
    outline.iter().map(|vertex| vertex.position.to_array()).collect()
}

fn warned(document: &Document) -> Vec<String> {
    let text = |warning: &Warning| {
        let text = warning.to_string();
        text[text.find("a.mgf").unwrap_or(0)..].to_string()
    };
    document.warnings.iter().map(text).collect()
}
