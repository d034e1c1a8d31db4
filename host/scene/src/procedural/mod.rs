//! Procedural scenes of any size, to measure how time and memory scale.
//!
//! Each module generates one scene from its published description, and passes it object by object to a `SceneWriter`,
//! which writes one format; only the heights of the terrain are kept in memory. Numbers are computed in double precision
//! with libm, so that a scene is the same file on every machine.

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

/// The maximum number of objects of a scene: about a gigabyte of NFF.
pub const MAX_OBJECTS: u64 = 1 << 24;

choices! {
    /// A procedural scene.
    pub enum ProceduralScene {
        /// A reflective sphere with nine smaller ones around it, recursively; `balls` of the databases (size 4).
        Sphereflake = "sphereflake" | "balls",
        /// A recursive tetrahedron; `tetra` of the databases (size 6).
        Tetra = "tetra",
        /// A fractal landscape below four glass spheres, after `mount` of the databases (size 6).
        Mountain = "mountain" | "mount",
        /// A pyramid of interlocked rings; `rings` of the databases (size 7).
        Rings = "rings",
        /// A binary tree of branches; `tree` of the databases (size 11).
        Tree = "tree",
        /// A smooth torus knot; size is its minimum number of triangles (10000).
        Knot = "knot",
        /// A torus knot of that many triangles (10000) in a stadium 10,000 times as wide as a triangle: the `teapot in a
        /// stadium` case.
        Stadium = "stadium",
    }

    /// A file format of procedural scenes.
    pub enum SceneFormat {
        /// NFF, the Neutral File Format.
        Nff = "nff",
        /// TOML; the triangles of a mesh go into a PLY file next to it.
        Toml = "toml",
        /// PLY, binary, triangles only.
        Ply = "ply",
    }
}

impl ProceduralScene {
    /// The default size: that of the databases for their scenes.
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

    /// The number of objects at a size; `None` if it overflows.
    pub fn objects(self, size: u32) -> Option<u64> {
        let n = u64::from(size);
        match self {
            // 1 + 9 + 81 + ... spheres, and the ground.
            ProceduralScene::Sphereflake => Some((9_u64.checked_pow(size.checked_add(1)?)? - 1) / 8 + 1),
            ProceduralScene::Tetra => 4_u64.checked_pow(size),
            ProceduralScene::Mountain => {
                4_u64.checked_pow(size)?.checked_mul(2)?.checked_add(mountain::BALLS)
            }
            // Layers of k * k groups of six rings of five cones and five spheres, and the ground.
            ProceduralScene::Rings => {
                n.checked_mul(n + 1)?.checked_mul(2 * n + 1)?.checked_mul(10)?.checked_add(1)
            }
            // A cone and a sphere for each of 1 + 2 + 4 + ... branches, and the ground.
            ProceduralScene::Tree => Some(2_u64.checked_pow(size.checked_add(2)?)? - 1),
            ProceduralScene::Knot => Some(knot::TorusKnot::of(size).triangles().into()),
            ProceduralScene::Stadium => Some(knot::TorusKnot::of(size).triangles() as u64 + stadium::OBJECTS),
        }
    }

    /// The largest size: that with at most [`MAX_OBJECTS`].
    pub fn max_size(self) -> u32 {
        let fits = |size: u32| self.objects(size).is_some_and(|objects| objects <= MAX_OBJECTS);
        // The number of objects grows with the size: bisection.
        let (mut fit, mut unfit) = (self.min_size(), u32::MAX);
        while unfit - fit > 1 {
            let mid = fit + (unfit - fit) / 2;
            if fits(mid) { fit = mid } else { unfit = mid }
        }
        fit
    }

    /// The number of triangles of its mesh; `None` if it has no mesh.
    pub fn triangles(self, size: u32) -> Option<u64> {
        self.mesh(size).map(|mesh| mesh.triangles().into())
    }

    /// Writes the scene. With `bare` only the objects and their materials are written. `ply` is the path of the file with
    /// its triangles, for TOML.
    pub fn write(
        self,
        size: u32,
        format: SceneFormat,
        bare: bool,
        ply: &str,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let comment = format!("Made by strahl generate {self} --size {size}");
        match format {
            SceneFormat::Nff if bare => self.write_scene(size, &mut nff::NffWriter::objects_only(out)),
            SceneFormat::Nff => self.write_scene(size, &mut nff::NffWriter::new(&comment, out)?),
            SceneFormat::Toml if bare => {
                self.write_scene(size, &mut toml::TomlWriter::objects_only(ply, out))
            }
            SceneFormat::Toml => self.write_scene(size, &mut toml::TomlWriter::new(&comment, ply, out)?),
            SceneFormat::Ply => self.mesh(size).map_or(Ok(()), |mesh| ply::write(&*mesh, out)),
        }
    }

    /// Generates the scene, object by object.
    fn write_scene(self, size: u32, writer: &mut dyn SceneWriter) -> io::Result<()> {
        match self {
            ProceduralScene::Sphereflake => sphereflake::write_scene(size, writer),
            ProceduralScene::Tetra => tetra::write_scene(size, writer),
            ProceduralScene::Mountain => mountain::write_scene(size, writer),
            ProceduralScene::Rings => rings::write_scene(size, writer),
            ProceduralScene::Tree => tree::write_scene(size, writer),
            ProceduralScene::Knot => knot::write_scene(size, writer),
            ProceduralScene::Stadium => stadium::write_scene(size, writer),
        }
    }

    /// Its mesh, if it has one.
    fn mesh(self, size: u32) -> Option<Box<dyn ProceduralMesh>> {
        match self {
            ProceduralScene::Tetra => Some(Box::new(tetra::TetrahedronPyramid::of(size))),
            ProceduralScene::Mountain => Some(Box::new(mountain::FractalTerrain::of(size))),
            ProceduralScene::Knot => Some(Box::new(knot::TorusKnot::of(size))),
            ProceduralScene::Stadium => Some(Box::new(stadium::knot(size))),
            ProceduralScene::Sphereflake | ProceduralScene::Rings | ProceduralScene::Tree => None,
        }
    }

    /// Whether all of it is one mesh, so that it can be written as PLY.
    pub fn is_mesh(self) -> bool {
        matches!(self, ProceduralScene::Tetra | ProceduralScene::Mountain | ProceduralScene::Knot)
    }
}

impl SceneFormat {
    /// The format that the extension of a file selects; `None` if it is unknown.
    pub fn from_path(path: &Path) -> Option<Self> {
        SceneFormat::from_name(&path.extension()?.to_str()?.to_ascii_lowercase())
    }

    /// The extension of the format.
    pub fn extension(self) -> &'static str {
        self.name()
    }
}

#[cfg(test)]
mod tests;
