//! MTL, the materials of OBJ files.
//!
//! | keyword | meaning |
//! |---|---|
//! | `Kd` | diffuse and ambient reflectance, linear; `Ka` is ignored, because its values are unreliable |
//! | `Ks`, `Ns` | specular highlight and its exponent, unless `illum` is 0 or 1; also the mirror reflectance if `illum` is at least 3 |
//! | `d`, `Tr` | opacity, or one minus the opacity: the rest is transmitted, colored by `Tf` |
//! | `Ni` | index of refraction if `illum` is 4, 6, 7 or 9 (glass); otherwise light is not refracted |
//! | `illum` | illumination model, as above; 7 uses the Fresnel equations |
//!
//! Textures are ignored; one warning counts them, and their paths are recorded.

use std::iter;

use strahl_core::scene::FresnelModel;
use strahl_core::{Material, Rgb};

use super::builder::MeshBuilder;
use super::error::LineError;
use super::lines::{LogicalLine, lines, text_of};
use crate::quote::quoted;

/// The contents of a material library.
#[derive(Default)]
pub struct MtlLibrary {
    pub materials: Vec<MtlMaterial>,
    /// Possible names of textures: the text after the keyword, and, because options may precede the name, its last word.
    pub textures: Vec<String>,
}

/// A material of a library.
pub struct MtlMaterial {
    pub name: String,
    pub line: usize,
    pub material: Material,
}

/// The values of one material.
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
pub fn read(bytes: &[u8], builder: &mut MeshBuilder) -> Result<MtlLibrary, LineError> {
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
            builder.skip("textures are ignored", None);
            textures.extend(iter::once(line.rest).chain(line.words().last()).map(str::to_owned));
            continue;
        }
        let is_known = matches!(line.keyword, "Kd" | "Ks" | "Ns" | "d" | "Tr" | "Tf" | "Ni" | "illum");
        match &mut open {
            _ if !is_known => {}
            Some(words) => words.set(line)?,
            None => return line.error(format!("{} comes before the first `newmtl`", quoted(line.keyword))),
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
                self.illumination_model = line.number(word, "the illumination model")?;
            }
        }
        Ok(())
    }

    fn finish(self) -> MtlMaterial {
        let is_glass = matches!(self.illumination_model, 4 | 6 | 7 | 9);
        let passes = 1.0 - self.opacity;
        let diffuse = self.diffuse * self.opacity;
        let it = Material {
            ambient: diffuse,
            diffuse,
            highlight: if self.illumination_model >= 2 { self.specular } else { Rgb::BLACK },
            highlight_exponent: if self.illumination_model >= 2 { self.exponent } else { 0.0 },
            reflection: if self.illumination_model >= 3 { self.specular.clamp_max(1.0) } else { Rgb::BLACK },
            transmission: (self.transmission_filter * passes).clamp_max(1.0),
            // Files have a zero if the index is unused.
            refractive_index: if is_glass && passes > 0.0 && self.index >= 0.01 { self.index } else { 1.0 },
            fresnel: if self.illumination_model == 7 { FresnelModel::Dielectric } else { FresnelModel::None },
            ..Material::MATTE
        };
        MtlMaterial { name: self.name, line: self.line, material: it }
    }
}

/// A color; a single number is a gray, as in the format.
fn color(line: LogicalLine<'_>) -> Result<Rgb, LineError> {
    if matches!(line.words().next(), Some("spectral" | "xyz")) {
        return line.error("only RGB colors are supported");
    }
    let [r, g, b] = match line.words().count() {
        1 => line.numbers::<1>("a color").map(|[gray]| [gray; 3])?,
        _ => line.numbers::<3>("a color")?,
    };
    match [r, g, b].iter().find(|x| !(**x >= 0.0 && **x <= Rgb::MAX_CHANNEL)) {
        Some(x) => line.error(format!("a color must be 0 to {}, not {x}", Rgb::MAX_CHANNEL)),
        None => Ok(Rgb::new(r, g, b)),
    }
}

fn number_in(low: f32, high: f32, line: LogicalLine<'_>) -> Result<f32, LineError> {
    // `d -halo 0.5` fades towards the edge; only the number is used.
    let Some(word) = line.words().find(|word| *word != "-halo") else {
        return line.error(format!("{} needs a number", quoted(line.keyword)));
    };
    let number: f32 = line.number(word, "its value")?;
    if number >= low && number <= high {
        Ok(number)
    } else {
        line.error(format!("`{}` must be {low} to {high}, not {number}", line.keyword))
    }
}
