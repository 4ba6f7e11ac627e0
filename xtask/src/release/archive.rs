//! Archives whose bytes depend on their files alone: in the order of names, with one time and
//! fixed owners and permissions.

use anyhow::{Context, Result};
use flate2::{Compression, GzBuilder};
use std::io::{Cursor, Write};
use tar::{EntryType, Header};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// A file of an archive.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct File {
    /// Its path below the archive's folder.
    pub(super) path: String,
    pub(super) bytes: Vec<u8>,
    pub(super) is_program: bool,
}

/// The form of an archive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    TarGz,
    Zip,
}

impl File {
    pub(super) fn plain(path: &str, bytes: Vec<u8>) -> Self {
        Self { path: path.into(), bytes, is_program: false }
    }

    pub(super) fn program(path: &str, bytes: Vec<u8>) -> Self {
        Self { path: path.into(), bytes, is_program: true }
    }

    fn mode(&self) -> u32 {
        if self.is_program { 0o755 } else { 0o644 }
    }
}

impl Form {
    /// The end of an archive's name.
    pub(super) fn ending(self) -> &'static str {
        match self {
            Self::TarGz => "tar.gz",
            Self::Zip => "zip",
        }
    }
}

/// Packs files below one folder; `time` is that of all of them, in seconds since 1970.
///
/// # Errors
/// A path is too long.
pub(super) fn pack(folder: &str, files: &[File], time: u64, form: Form) -> Result<Vec<u8>> {
    let mut sorted: Vec<&File> = files.iter().collect();
    sorted.sort_by(|a, b| a.path.cmp(&b.path));
    match form {
        Form::TarGz => tar_gz(folder, &sorted, time),
        Form::Zip => zip(folder, &sorted),
    }
}

fn tar_gz(folder: &str, files: &[&File], time: u64) -> Result<Vec<u8>> {
    // Neither a time nor a name nor a system in the head.
    let gzip = GzBuilder::new().mtime(0).operating_system(255);
    let mut archive = tar::Builder::new(gzip.write(Vec::new(), Compression::best()));
    for file in files {
        let mut header = Header::new_ustar();
        header.set_entry_type(EntryType::Regular);
        header.set_size(file.bytes.len() as u64);
        header.set_mode(file.mode());
        header.set_mtime(time);
        header.set_uid(0);
        header.set_gid(0);
        let path = format!("{folder}/{}", file.path);
        archive.append_data(&mut header, &path, &*file.bytes).context(path)?;
    }
    Ok(archive.into_inner()?.finish()?)
}

/// Times in a zip file are of no zone, so that the same one would mean another in each: all are
/// the first of its calendar.
fn zip(folder: &str, files: &[&File]) -> Result<Vec<u8>> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for file in files {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .last_modified_time(DateTime::default())
            .unix_permissions(file.mode());
        archive.start_file(format!("{folder}/{}", file.path), options)?;
        archive.write_all(&file.bytes)?;
    }
    Ok(archive.finish()?.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;

    fn files() -> Vec<File> {
        let page = File::plain("README.md", b"read\n".repeat(1000));
        vec![page, File::program("bin/bdpt", vec![1, 2, 3])]
    }

    #[test]
    fn the_same_files_give_the_same_bytes_in_any_order() {
        let mut others = files();
        others.reverse();
        for form in [Form::TarGz, Form::Zip] {
            let bytes = pack("a", &files(), 1_700_000_000, form).unwrap();
            assert!(bytes == pack("a", &others, 1_700_000_000, form).unwrap(), "{form:?}");
            assert!(bytes.len() < 2000, "{form:?}: {} bytes", bytes.len());
            others[0].bytes[0] ^= 1;
            assert!(bytes != pack("a", &others, 1_700_000_000, form).unwrap(), "{form:?}");
            others[0].bytes[0] ^= 1;
        }
    }

    #[test]
    fn a_tar_file_unpacks_to_what_was_packed() {
        let bytes = pack("a", &files(), 1_700_000_000, Form::TarGz).unwrap();
        let mut archive = tar::Archive::new(flate2::read::GzDecoder::new(&*bytes));
        let mut found = Vec::new();
        for entry in archive.entries().unwrap() {
            let mut entry = entry.unwrap();
            let mut content = Vec::new();
            entry.read_to_end(&mut content).unwrap();
            let header = entry.header();
            assert_eq!(header.mtime().unwrap(), 1_700_000_000);
            assert_eq!((header.uid().unwrap(), header.gid().unwrap()), (0, 0));
            let path = entry.path().unwrap().to_string_lossy().into_owned();
            found.push((path, header.mode().unwrap(), content.len()));
        }
        let wanted = [("a/README.md", 0o644, 5000), ("a/bin/bdpt", 0o755, 3)];
        assert_eq!(found, wanted.map(|(path, mode, size)| (String::from(path), mode, size)));
    }

    #[test]
    fn a_zip_file_unpacks_to_what_was_packed() {
        let bytes = pack("a", &files(), 0, Form::Zip).unwrap();
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
        assert_eq!(archive.len(), 2);
        let mut program = archive.by_name("a/bin/bdpt").unwrap();
        assert_eq!(program.unix_mode().unwrap() & 0o777, 0o755);
        let mut content = Vec::new();
        program.read_to_end(&mut content).unwrap();
        assert_eq!(content, [1, 2, 3]);
    }
}
