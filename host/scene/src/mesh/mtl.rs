//! MTL, the materials of OBJ files.
//!
//! | word | meaning here |
//! |---|---|
//! | `Kd` | diffuse and ambient share, as linear numbers; `Ka` is left alone, because writers put anything there |
//! | `Ks`, `Ns` | highlight and its exponent, unless `illum` is 0 or 1; the mirrored share too, from `illum` 3 on |
//! | `d`, `Tr` | opacity, or one minus it: what the surface does not keep passes, coloured by `Tf` |
//! | `Ni` | index of refraction where `illum` is 4, 6, 7 or 9 (glass); else light passes straight on |
//! | `illum` | what there is, as above; 7 parts light by Fresnel's formulas |
//!
//! Textures are left out; one warning counts them, and their names are kept.

use std::iter;

use strahl_core::scene::FresnelModel;
use strahl_core::{Material, Rgb};

use super::builder::MeshBuilder;
use super::error::LineError;
use super::lines::{LogicalLine, lines, text_of};
use crate::quote::quoted;

/// What a library has.
#[derive(Default)]
pub struct MtlLibrary {
    pub materials: Vec<MtlMaterial>,
    /// What may be the names of textures: all that follows the word, and, as options may stand
    /// there, the last of it.
    pub textures: Vec<String>,
}

/// A material of the library.
pub struct MtlMaterial {
    pub name: String,
    pub line: usize,
    pub material: Material,
}

/// The words of one material.
struct MtlBuilder {
    name: String,
    line: usize,
    diffuse: Rgb,
    specular: Rgb,
    exponent: f32,
    opacity: f32,
    transmission_filter: Rgb,
    index: f32,
    illumination_model: u8,
}

/// Reads the bytes of a library.
pub fn read(bytes: &[u8], gather: &mut MeshBuilder) -> Result<MtlLibrary, LineError> {
    let text = text_of(bytes)?;
    let MtlLibrary { mut materials, mut textures } = MtlLibrary::default();
    let mut open: Option<MtlBuilder> = None;
    for line in lines(&text) {
        if line.keyword == "newmtl" {
            if line.rest.is_empty() {
                return line.error("the material has no name");
            }
            materials.extend(open.replace(MtlBuilder::new(line)).map(MtlBuilder::finish));
            continue;
        }
        if line.keyword.starts_with("map_")
            || matches!(line.keyword, "bump" | "disp" | "decal" | "refl" | "norm")
        {
            gather.skip("textures of materials are left out", None);
            textures.extend(iter::once(line.rest).chain(line.words().last()).map(str::to_owned));
            continue;
        }
        let is_known = matches!(line.keyword, "Kd" | "Ks" | "Ns" | "d" | "Tr" | "Tf" | "Ni" | "illum");
        match &mut open {
            _ if !is_known => {}
            Some(words) => words.set(line)?,
            None => return line.error(format!("{} stands before the first `newmtl`", quoted(line.keyword))),
        }
    }
    materials.extend(open.map(MtlBuilder::finish));
    Ok(MtlLibrary { materials, textures })
}

impl MtlBuilder {
    fn new(line: LogicalLine<'_>) -> Self {
        MtlBuilder {
            name: line.rest.to_owned(),
            line: line.number,
            diffuse: Rgb::gray(0.8),
            specular: Rgb::BLACK,
            exponent: 0.0,
            opacity: 1.0,
            transmission_filter: Rgb::WHITE,
            index: 1.0,
            illumination_model: 2,
        }
    }

    fn set(&mut self, line: LogicalLine<'_>) -> Result<(), LineError> {
        match line.keyword {
            "Kd" => self.diffuse = color(line)?,
            "Ks" => self.specular = color(line)?,
            "Tf" => self.transmission_filter = color(line)?,
            "Ns" => self.exponent = number_in(0.0, 1e6, line)?,
            "Ni" => self.index = number_in(0.0, 100.0, line)?,
            "d" => self.opacity = number_in(0.0, 1.0, line)?,
            "Tr" => self.opacity = 1.0 - number_in(0.0, 1.0, line)?,
            _ => {
                let word = line.words().next().unwrap_or_default();
                self.illumination_model = line.number(word, "the model of illumination")?;
            }
        }
        Ok(())
    }

    fn finish(self) -> MtlMaterial {
        let is_glass = matches!(self.illumination_model, 4 | 6 | 7 | 9);
        let passes = 1.0 - self.opacity;
        let kept = self.diffuse * self.opacity;
        let it = Material {
            ambient: kept,
            diffuse: kept,
            highlight: if self.illumination_model >= 2 { self.specular } else { Rgb::BLACK },
            highlight_exponent: if self.illumination_model >= 2 { self.exponent } else { 0.0 },
            reflection: if self.illumination_model >= 3 { self.specular.clamp_max(1.0) } else { Rgb::BLACK },
            transmission: (self.transmission_filter * passes).clamp_max(1.0),
            // Files have a zero where the index has no meaning.
            refractive_index: if is_glass && passes > 0.0 && self.index >= 0.01 { self.index } else { 1.0 },
            fresnel: if self.illumination_model == 7 {
                FresnelModel::Dielectric
            } else {
                FresnelModel::Constant
            },
            ..Material::MATTE
        };
        MtlMaterial { name: self.name, line: self.line, material: it }
    }
}

/// A colour; a single number is a gray, as the format has it.
fn color(line: LogicalLine<'_>) -> Result<Rgb, LineError> {
    if matches!(line.words().next(), Some("spectral" | "xyz")) {
        return line.error("only colours as red, green and blue are read");
    }
    let [r, g, b] = match line.words().count() {
        1 => line.numbers::<1>("a colour").map(|[gray]| [gray; 3])?,
        _ => line.numbers::<3>("a colour")?,
    };
    match [r, g, b].iter().find(|x| !(**x >= 0.0 && **x <= Rgb::MAX_CHANNEL)) {
        Some(x) => line.error(format!("a colour must be between 0 and {}, not {x}", Rgb::MAX_CHANNEL)),
        None => Ok(Rgb::new(r, g, b)),
    }
}

fn number_in(low: f32, high: f32, line: LogicalLine<'_>) -> Result<f32, LineError> {
    // `d -halo 0.5` fades towards the rim; the number is what matters.
    let Some(word) = line.words().find(|word| *word != "-halo") else {
        return line.error(format!("{} has no number", quoted(line.keyword)));
    };
    let number: f32 = line.number(word, "one")?;
    if number >= low && number <= high {
        Ok(number)
    } else {
        line.error(format!("`{}` must be between {low} and {high}, not {number}", line.keyword))
    }
}
