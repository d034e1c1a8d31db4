//! Encoding of picture files.
//!
//! Equal pictures give equal files: a file contains no date, name or other metadata.

use std::error::Error;
use std::fmt;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use exr::prelude::{
    Blocks, Compression, Encoding, Image, LineOrder, SpecificChannels, Vec2, WritableImage as _,
};
use image::{ExtendedColorType, ImageEncoder, ImageError, codecs};
use strahl_core::Resolution;

use crate::Picture;

/// A format of picture files.
///
/// All but EXR have 8 bits per channel, in sRGB encoding. All but JPEG are lossless.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureFormat {
    /// PNG.
    Png,
    /// Binary PPM.
    Ppm,
    /// QOI, the "Quite OK Image" format: nearly as small as PNG, and much faster.
    Qoi,
    /// JPEG of quality 95 without chroma subsampling (4:4:4); lossy.
    Jpeg,
    /// TIFF, uncompressed.
    Tiff,
    /// OpenEXR with linear 32-bit floats; scan lines, compressed with ZIP.
    Exr,
}

/// The quality of JPEG files, of 100.
const JPEG_QUALITY: u8 = 95;

/// The maximum width and height of a JPEG.
const JPEG_SIDE: u32 = u16::MAX as u32;

/// ZIP in blocks of 16 lines, which every EXR reader supports. (The run-length encoding of the crate `image` makes files
/// larger than no compression.)
pub const EXR_ENCODING: Encoding = Encoding {
    compression: Compression::ZIP16,
    blocks: Blocks::ScanLines,
    line_order: LineOrder::Increasing,
};

/// The extensions of all formats, without the dot, in lower case.
const EXTENSIONS: &[(&str, PictureFormat)] = &[
    ("png", PictureFormat::Png),
    ("ppm", PictureFormat::Ppm),
    ("qoi", PictureFormat::Qoi),
    ("jpg", PictureFormat::Jpeg),
    ("jpeg", PictureFormat::Jpeg),
    ("tif", PictureFormat::Tiff),
    ("tiff", PictureFormat::Tiff),
    ("exr", PictureFormat::Exr),
];

impl PictureFormat {
    /// The format that the extension of `path` selects; PNG for standard output (`-`), and for a pipe or device without
    /// an extension.
    pub fn from_path(path: &Path) -> Result<Self, FormatError> {
        if path == Path::new("-") {
            return Ok(PictureFormat::Png);
        }
        let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
        if let Some((_, format)) = EXTENSIONS.iter().find(|(name, _)| extension.eq_ignore_ascii_case(name)) {
            return Ok(*format);
        }
        match extension {
            "" if path.metadata().is_ok_and(|found| !found.is_file() && !found.is_dir()) => {
                Ok(PictureFormat::Png)
            }
            _ => Err(FormatError::UnknownExtension(path.to_owned())),
        }
    }

    /// Checks that the format supports pictures of this size.
    pub fn check_size(self, size: Resolution) -> Result<(), FormatError> {
        if self == PictureFormat::Jpeg && (size.width() > JPEG_SIDE || size.height() > JPEG_SIDE) {
            return Err(FormatError::TooLargeForJpeg);
        }
        Ok(())
    }

    /// Encodes a picture as the bytes of a file.
    pub fn encode(self, picture: &Picture) -> Result<Vec<u8>, ImageError> {
        let mut file = Cursor::new(Vec::new());
        match self {
            PictureFormat::Png => eight_bits(codecs::png::PngEncoder::new(&mut file), picture)?,
            PictureFormat::Ppm => {
                let binary = codecs::pnm::PnmSubtype::Pixmap(codecs::pnm::SampleEncoding::Binary);
                eight_bits(codecs::pnm::PnmEncoder::new(&mut file).with_subtype(binary), picture)?;
            }
            PictureFormat::Qoi => eight_bits(codecs::qoi::QoiEncoder::new(&mut file), picture)?,
            PictureFormat::Jpeg => {
                let encoder = codecs::jpeg::JpegEncoder::new_with_quality(&mut file, JPEG_QUALITY);
                eight_bits(encoder, picture)?;
            }
            PictureFormat::Tiff => eight_bits(codecs::tiff::TiffEncoder::new(&mut file), picture)?,
            PictureFormat::Exr => floats(&mut file, picture)?,
        }
        Ok(file.into_inner())
    }
}

/// Why a picture format cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FormatError {
    /// The extension of this file is not that of a picture format.
    UnknownExtension(PathBuf),
    /// The width or height exceeds the maximum of JPEG.
    TooLargeForJpeg,
}

impl fmt::Display for FormatError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FormatError::UnknownExtension(path) => write!(
                f,
                "{} has no known picture extension; use .png, .ppm, .qoi, .jpg, .tif or .exr",
                path.display()
            ),
            FormatError::TooLargeForJpeg => write!(f, "JPEG supports at most {JPEG_SIDE} pixels per side"),
        }
    }
}

impl Error for FormatError {}

fn eight_bits(encoder: impl ImageEncoder, picture: &Picture) -> Result<(), ImageError> {
    let (width, height) = (picture.size.width(), picture.size.height());
    encoder.write_image(&picture.to_srgb8(), width, height, ExtendedColorType::Rgb8)
}

fn floats(file: &mut Cursor<Vec<u8>>, picture: &Picture) -> Result<(), ImageError> {
    let (width, height) = (picture.size.width() as usize, picture.size.height() as usize);
    let channels = SpecificChannels::rgb(|place: Vec2<usize>| {
        let color = picture.colors[place.y() * width + place.x()];
        (color.r, color.g, color.b)
    });
    let image = Image::from_encoded_channels((width, height), EXR_ENCODING, channels);
    image.write().non_parallel().to_buffered(file).map_err(|error| {
        ImageError::Encoding(image::error::EncodingError::new(image::ImageFormat::OpenExr.into(), error))
    })
}
