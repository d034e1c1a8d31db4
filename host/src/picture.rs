//! Linear pictures, their digest, and files of them.

use std::io::Cursor;
use std::path::Path;

use image::{ExtendedColorType, ImageEncoder, codecs};
use rayon::prelude::*;
use strahl_core::{Rgb, Size};

use crate::failure::Failure;

/// Linear light, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width and height.
    pub size: Size,
    /// One colour for each pixel.
    pub colors: Vec<Rgb>,
}

impl Picture {
    /// BLAKE3 of the bits of all channels, row by row, little endian. Equal digests are equal
    /// pictures.
    pub fn digest(&self) -> blake3::Hash {
        let mut hasher = blake3::Hasher::new();
        for row in self.colors.chunks(self.size.width() as usize) {
            let bytes: Vec<u8> =
                row.iter().flat_map(|c| [c.r, c.g, c.b]).flat_map(f32::to_le_bytes).collect();
            hasher.update(&bytes);
        }
        hasher.finalize()
    }

    /// Eight bits for each channel in the sRGB encoding.
    pub fn to_srgb8(&self) -> Vec<u8> {
        self.colors.par_iter().flat_map_iter(|color| color.to_srgb8()).collect()
    }
}

/// A format of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// PNG, eight bits.
    Png,
    /// Binary PPM, eight bits.
    Ppm,
}

impl Format {
    /// The format that the extension of `path` names; for the standard output, a pipe or a device
    /// without one PNG.
    pub fn of(path: &Path) -> Result<Self, Failure> {
        if path == Path::new("-") {
            return Ok(Format::Png);
        }
        let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
        match extension.to_ascii_lowercase().as_str() {
            "png" => Ok(Format::Png),
            "ppm" => Ok(Format::Ppm),
            "" if path.metadata().is_ok_and(|found| !found.is_file() && !found.is_dir()) => Ok(Format::Png),
            _ => Err(Failure::Usage(format!(
                "{} names no picture format; the extension must be .png or .ppm",
                path.display()
            ))),
        }
    }

    /// The bytes of a file. Equal pictures make equal files: nothing but the picture is in them.
    pub fn encode(self, picture: &Picture) -> Result<Vec<u8>, image::ImageError> {
        let (width, height) = (picture.size.width(), picture.size.height());
        let pixels = picture.to_srgb8();
        let mut file = Cursor::new(Vec::new());
        let kind = ExtendedColorType::Rgb8;
        match self {
            Format::Png => {
                codecs::png::PngEncoder::new(&mut file).write_image(&pixels, width, height, kind)?;
            }
            Format::Ppm => {
                let binary = codecs::pnm::PnmSubtype::Pixmap(codecs::pnm::SampleEncoding::Binary);
                let encoder = codecs::pnm::PnmEncoder::new(&mut file).with_subtype(binary);
                encoder.write_image(&pixels, width, height, kind)?;
            }
        }
        Ok(file.into_inner())
    }
}
