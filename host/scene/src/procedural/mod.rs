//! Scenes that formulas make, of any size.
//!
//! They serve for measuring how time and memory grow. Each room makes one scene from its published
//! description and hands it, piece by piece, to a `Pen`, which writes one format; nothing but a
//! landscape's heights is kept in memory. The numbers are computed in double precision with
//! libm, so that a scene is the same file on every machine.

mod knot;
mod mountain;
mod nff;
mod ply;
mod rings;
mod sphereflake;
mod stadium;
mod tetra;
mod toml;
mod tree;
mod writer;

use std::io::{self, Write};
use std::path::Path;

use strahl_settings::{Choice as _, choices};

use writer::{ProceduralMesh, SceneWriter};

/// The most objects of a scene: about a gigabyte of NFF.
pub const MAX_OBJECTS: u64 = 1 << 24;

choices! {
    /// A scene that a formula makes.
    pub enum ProceduralScene {
        /// A mirroring sphere with nine smaller ones around it, and so on; the databases' `balls` (size 4).
        Sphereflake = "sphereflake" | "balls",
        /// A tetrahedron of tetrahedra; the databases' `tetra` (size 6).
        Tetra = "tetra",
        /// A fractal landscape under four glass balls, after the databases' `mount` (size 6).
        Mountain = "mountain" | "mount",
        /// A pyramid of interlocked rings; the databases' `rings` (size 7).
        Rings = "rings",
        /// A tree whose branches fork in two; the databases' `tree` (size 11).
        Tree = "tree",
        /// A smooth torus knot of at least as many triangles as its size says (10000).
        Knot = "knot",
        /// A knot as dense as its size says (10000 triangles) in a stadium ten thousand times as wide as a triangle:
        /// little in much space.
        Stadium = "stadium",
    }

    /// How a scene is written.
    pub enum SceneFormat {
        /// The neutral file format of the databases.
        Nff = "nff",
        /// strahl's own; triangles of a mesh go into a PLY file beside it.
        Toml = "toml",
        /// The triangles only, binary.
        Ply = "ply",
    }
}

impl ProceduralScene {
    /// Its size when none is asked for: where the databases have it, theirs.
    pub fn default_size(self) -> u32 {
        match self {
            ProceduralScene::Sphereflake => 4,
            ProceduralScene::Tetra | ProceduralScene::Mountain => 6,
            ProceduralScene::Rings => 7,
            ProceduralScene::Tree => 11,
            ProceduralScene::Knot | ProceduralScene::Stadium => 10_000,
        }
    }

    /// The smallest size.
    pub fn min_size(self) -> u32 {
        match self {
            ProceduralScene::Sphereflake | ProceduralScene::Tree => 0,
            ProceduralScene::Tetra
            | ProceduralScene::Mountain
            | ProceduralScene::Rings
            | ProceduralScene::Knot
            | ProceduralScene::Stadium => 1,
        }
    }

    /// How many objects it has at a size; none when they are more than can be counted.
    pub fn objects(self, size: u32) -> Option<u64> {
        let n = u64::from(size);
        match self {
            // One and nine and eighty-one ..., and the ground.
            ProceduralScene::Sphereflake => Some((9_u64.checked_pow(size.checked_add(1)?)? - 1) / 8 + 1),
            ProceduralScene::Tetra => 4_u64.checked_pow(size),
            ProceduralScene::Mountain => {
                4_u64.checked_pow(size)?.checked_mul(2)?.checked_add(mountain::BALLS)
            }
            // Squares of groups of six rings of five tubes and five balls, and the ground.
            ProceduralScene::Rings => {
                n.checked_mul(n + 1)?.checked_mul(2 * n + 1)?.checked_mul(10)?.checked_add(1)
            }
            // A tube and a ball for one branch and two and four ..., and the ground.
            ProceduralScene::Tree => Some(2_u64.checked_pow(size.checked_add(2)?)? - 1),
            ProceduralScene::Knot => Some(knot::TorusKnot::of(size).triangles().into()),
            ProceduralScene::Stadium => Some(knot::TorusKnot::of(size).triangles() as u64 + stadium::OBJECTS),
        }
    }

    /// The largest size that is made.
    pub fn max_size(self) -> u32 {
        let fits = |size: u32| self.objects(size).is_some_and(|objects| objects <= MAX_OBJECTS);
        // Objects grow with the size: halve the range that holds the last one that fits.
        let (mut fit, mut unfit) = (self.min_size(), u32::MAX);
        while unfit - fit > 1 {
            let middle = fit + (unfit - fit) / 2;
            if fits(middle) { fit = middle } else { unfit = middle }
        }
        fit
    }

    /// How many triangles it has, where they are what it is made of.
    pub fn triangles(self, size: u32) -> Option<u64> {
        self.mesh(size).map(|mesh| mesh.triangles().into())
    }

    /// Writes it in one form; all of it, or the objects alone. `beside` names the file that has its
    /// triangles, for a form that cannot have them itself.
    pub fn write(
        self,
        size: u32,
        form: SceneFormat,
        bare: bool,
        beside: &str,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let head = format!("Made by strahl generate {self} --size {size}");
        match form {
            SceneFormat::Nff if bare => self.write_scene(size, &mut nff::NffWriter::objects_only(out)),
            SceneFormat::Nff => self.write_scene(size, &mut nff::NffWriter::new(&head, out)?),
            SceneFormat::Toml if bare => {
                self.write_scene(size, &mut toml::TomlWriter::objects_only(beside, out))
            }
            SceneFormat::Toml => self.write_scene(size, &mut toml::TomlWriter::new(&head, beside, out)?),
            SceneFormat::Ply => self.mesh(size).map_or(Ok(()), |mesh| ply::write(&*mesh, out)),
        }
    }

    /// Makes it, piece by piece.
    fn write_scene(self, size: u32, pen: &mut dyn SceneWriter) -> io::Result<()> {
        match self {
            ProceduralScene::Sphereflake => sphereflake::write_scene(size, pen),
            ProceduralScene::Tetra => tetra::write_scene(size, pen),
            ProceduralScene::Mountain => mountain::write_scene(size, pen),
            ProceduralScene::Rings => rings::write_scene(size, pen),
            ProceduralScene::Tree => tree::write_scene(size, pen),
            ProceduralScene::Knot => knot::write_scene(size, pen),
            ProceduralScene::Stadium => stadium::write_scene(size, pen),
        }
    }

    /// Its triangles, where they are what it is made of.
    fn mesh(self, size: u32) -> Option<Box<dyn ProceduralMesh>> {
        match self {
            ProceduralScene::Tetra => Some(Box::new(tetra::TetrahedronPyramid::of(size))),
            ProceduralScene::Mountain => Some(Box::new(mountain::FractalTerrain::of(size))),
            ProceduralScene::Knot => Some(Box::new(knot::TorusKnot::of(size))),
            ProceduralScene::Stadium => Some(Box::new(stadium::knot(size))),
            ProceduralScene::Sphereflake | ProceduralScene::Rings | ProceduralScene::Tree => None,
        }
    }

    /// Whether nothing but its triangles counts, so that a file of triangles can hold it.
    pub fn is_mesh(self) -> bool {
        matches!(self, ProceduralScene::Tetra | ProceduralScene::Mountain | ProceduralScene::Knot)
    }
}

impl SceneFormat {
    /// The format that the extension of a file names.
    pub fn from_path(path: &Path) -> Option<Self> {
        SceneFormat::from_name(&path.extension()?.to_str()?.to_ascii_lowercase())
    }

    /// The extension of such files.
    pub fn extension(self) -> &'static str {
        self.name()
    }
}

#[cfg(test)]
mod tests;
