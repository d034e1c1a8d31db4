//! Decoding of picture files.
//!
//! The format is detected from the content of a file, not from its name. Color profiles are ignored: 8-bit and 16-bit
//! values are read as sRGB, floats as linear light.

use std::error::Error;
use std::fmt;
use std::io::Cursor;

use exr::meta::{BlockDescription, MetaData};
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};
use strahl_core::{Resolution, Rgb};

/// The pixels of a file, without loss.
#[derive(Clone, Debug, PartialEq)]
pub struct DecodedPicture {
    /// Width and height.
    pub size: Resolution,
    /// The pixels, row by row.
    pub values: PixelValues,
}

/// Red, green and blue of each pixel.
#[derive(Clone, Debug, PartialEq)]
pub enum PixelValues {
    /// sRGB-encoded, 255 is 1.
    U8(Vec<[u8; 3]>),
    /// sRGB-encoded, 65535 is 1.
    U16(Vec<[u16; 3]>),
    /// Linear light.
    Linear(Vec<Rgb>),
}

impl PixelValues {
    /// For each pixel, whether the mean of its encoded channels is closer to white than to black.
    pub fn are_white(&self) -> Vec<bool> {
        match self {
            PixelValues::U8(pixels) => {
                pixels.iter().map(|p| p.iter().map(|c| u32::from(*c)).sum::<u32>() > 3 * 127).collect()
            }
            PixelValues::U16(pixels) => {
                pixels.iter().map(|p| p.iter().map(|c| u32::from(*c)).sum::<u32>() > 3 * 32_767).collect()
            }
            PixelValues::Linear(pixels) => pixels
                .iter()
                .map(|p| p.to_srgb8().iter().map(|c| u32::from(*c)).sum::<u32>() > 3 * 127)
                .collect(),
        }
    }
}

/// The supported formats.
const READABLE_FORMATS: &str = "PNG, PPM, QOI, JPEG, TIFF, EXR";

/// The maximum number of decoded bytes per byte of a file: LZW has the highest compression ratio in these formats, with
/// strings of at most 4096 bytes that take more than one byte each.
///
/// A file whose header claims more is rejected before memory is allocated.
const MAX_COMPRESSION_RATIO: u64 = 4096;

/// Why a picture file cannot be decoded.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecodeError {
    /// The format is unknown.
    UnknownFormat,
    /// The format, with this extension, is known but not supported.
    UnreadFormat(String),
    /// The file is corrupt, for this reason.
    Corrupt(String),
    /// The picture has no pixels, or too many.
    Size {
        /// The width in the file.
        width: u32,
        /// The height in the file.
        height: u32,
        /// The maximum number of pixels.
        most: u64,
    },
    /// Some pixels are transparent, and thus have no defined color.
    Transparent,
}

impl DecodeError {
    /// An error of a decoder, without control characters, which some decoders quote from the file.
    fn corrupt(error: impl Error) -> Self {
        let printable = |c: char| if c.is_control() { ' ' } else { c };
        DecodeError::Corrupt(error.to_string().chars().map(printable).collect())
    }
}

impl fmt::Display for DecodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DecodeError::UnknownFormat => {
                write!(f, "not a picture in a supported format ({READABLE_FORMATS})")
            }
            DecodeError::UnreadFormat(name) => {
                write!(f, "{name} is not supported; supported formats: {READABLE_FORMATS}")
            }
            DecodeError::Corrupt(reason) => write!(f, "corrupt: {reason}"),
            DecodeError::Size { width, height, most } => write!(
                f,
                "{width} x {height} pixels; the limit is {most} pixels and {} per side",
                Resolution::MAX_SIDE
            ),
            DecodeError::Transparent => f.write_str("some pixels are transparent and cannot be compared"),
        }
    }
}

impl Error for DecodeError {}

/// Decodes a file of at most `most` pixels.
pub fn decode(bytes: &[u8], most: u64) -> Result<DecodedPicture, DecodeError> {
    let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format().map_err(DecodeError::corrupt)?;
    let Some(format) = reader.format() else {
        return Err(DecodeError::UnknownFormat);
    };
    if !format.reading_enabled() {
        let extension = format.extensions_str().first().unwrap_or(&"this");
        return Err(DecodeError::UnreadFormat(extension.to_ascii_uppercase()));
    }
    let cannot_hold =
        |what: String| DecodeError::Corrupt(format!("{} bytes cannot hold {what}", bytes.len()));
    if reader.format() == Some(ImageFormat::OpenExr)
        && exr_needs(bytes)? / MAX_COMPRESSION_RATIO > bytes.len() as u64
    {
        return Err(DecodeError::Corrupt(format!(
            "the header claims more than {} bytes can hold",
            bytes.len()
        )));
    }
    let mut decoder = reader.into_decoder().map_err(DecodeError::corrupt)?;

    // Check the size before memory is allocated for it.
    let (width, height) = decoder.dimensions();
    let size = Resolution::new(width, height)
        .filter(|_| u64::from(width) * u64::from(height) <= most)
        .ok_or(DecodeError::Size { width, height, most })?;
    let needed = decoder.total_bytes();
    if needed / MAX_COMPRESSION_RATIO > bytes.len() as u64 {
        return Err(cannot_hold(format!("{width} x {height} pixels")));
    }
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(2 * needed + (1 << 20));
    decoder.set_limits(limits).map_err(DecodeError::corrupt)?;

    let image = DynamicImage::from_decoder(decoder).map_err(DecodeError::corrupt)?;
    if !is_opaque(&image) {
        return Err(DecodeError::Transparent);
    }
    Ok(DecodedPicture { size, values: values(image) })
}

/// The size in bytes of the largest layer or block of an EXR file, which may be larger than its picture.
fn exr_needs(bytes: &[u8]) -> Result<u64, DecodeError> {
    let meta = MetaData::read_from_buffered(bytes, false).map_err(DecodeError::corrupt)?;
    let needed = meta.headers.iter().map(|header| {
        let (layer, lines) = (header.layer_size, header.compression.scan_lines_per_block());
        let block = match header.blocks {
            BlockDescription::Tiles(tiles) => (tiles.tile_size.width(), tiles.tile_size.height()),
            BlockDescription::ScanLines => (layer.width(), lines),
        };
        let bytes = |(width, height): (usize, usize)| {
            (width as u64)
                .saturating_mul(height as u64)
                .saturating_mul(header.channels.bytes_per_pixel as u64)
        };
        bytes(block).max(bytes((layer.width(), layer.height())))
    });
    Ok(needed.max().unwrap_or(0))
}

fn values(image: DynamicImage) -> PixelValues {
    match image {
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_) => {
            let linear = image.into_rgb32f();
            PixelValues::Linear(linear.pixels().map(|p| Rgb::new(p.0[0], p.0[1], p.0[2])).collect())
        }
        DynamicImage::ImageLuma16(_)
        | DynamicImage::ImageLumaA16(_)
        | DynamicImage::ImageRgb16(_)
        | DynamicImage::ImageRgba16(_) => {
            PixelValues::U16(image.into_rgb16().pixels().map(|p| p.0).collect())
        }
        _ => PixelValues::U8(image.into_rgb8().pixels().map(|p| p.0).collect()),
    }
}

fn is_opaque(image: &DynamicImage) -> bool {
    match image {
        DynamicImage::ImageLumaA8(image) => image.pixels().all(|p| p.0[1] == u8::MAX),
        DynamicImage::ImageRgba8(image) => image.pixels().all(|p| p.0[3] == u8::MAX),
        DynamicImage::ImageLumaA16(image) => image.pixels().all(|p| p.0[1] == u16::MAX),
        DynamicImage::ImageRgba16(image) => image.pixels().all(|p| p.0[3] == u16::MAX),
        DynamicImage::ImageRgba32F(image) => image.pixels().all(|p| p.0[3] == 1.0),
        _ => true,
    }
}
