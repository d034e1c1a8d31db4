//! Scenes that formulas make, of any size.
//!
//! They serve for measuring how time and memory grow. Each room makes one scene from its published
//! description and hands it, piece by piece, to a `Pen`, which writes one format; nothing but a
//! landscape's heights is kept in memory. The numbers are computed in double precision with
//! libm, so that a scene is the same file on every machine.

mod knot;
mod mountain;
mod native;
mod nff;
mod pen;
mod ply;
mod rings;
mod sphereflake;
mod stadium;
mod tetra;
mod tree;

use std::fmt;
use std::io::{self, Write};
use std::path::Path;

use clap::ValueEnum;

use pen::{Mesh, Pen};

/// The most objects of a scene: about a gigabyte of NFF.
pub const MOST_OBJECTS: u64 = 1 << 24;

/// What can be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum What {
    /// A mirroring sphere with nine smaller ones round it, and so on; the databases' `balls` (size
    /// 4).
    #[value(alias = "balls")]
    Sphereflake,
    /// A tetrahedron of tetrahedra; the databases' `tetra` (size 6).
    Tetra,
    /// A fractal landscape under four glass balls, after the databases' `mount` (size 6).
    #[value(alias = "mount")]
    Mountain,
    /// A pyramid of interlocked rings; the databases' `rings` (size 7).
    Rings,
    /// A tree whose branches fork in two; the databases' `tree` (size 11).
    Tree,
    /// A smooth torus knot of at least as many triangles as its size says (10000).
    Knot,
    /// A knot as dense as its size says (10000 triangles) in a stadium ten thousand times as wide
    /// as a triangle: little in much space.
    Stadium,
}

impl What {
    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            What::Sphereflake => "sphereflake",
            What::Tetra => "tetra",
            What::Mountain => "mountain",
            What::Rings => "rings",
            What::Tree => "tree",
            What::Knot => "knot",
            What::Stadium => "stadium",
        }
    }

    /// Its size when none is asked for: where the databases have it, theirs.
    pub fn usual_size(self) -> u32 {
        match self {
            What::Sphereflake => 4,
            What::Tetra | What::Mountain => 6,
            What::Rings => 7,
            What::Tree => 11,
            What::Knot | What::Stadium => 10_000,
        }
    }

    /// The smallest size.
    pub fn least_size(self) -> u32 {
        match self {
            What::Sphereflake | What::Tree => 0,
            What::Tetra | What::Mountain | What::Rings | What::Knot | What::Stadium => 1,
        }
    }

    /// How many objects it has at a size; none when they are more than can be counted.
    pub fn objects(self, size: u32) -> Option<u64> {
        let n = u64::from(size);
        match self {
            // One and nine and eighty-one ..., and the ground.
            What::Sphereflake => Some((9_u64.checked_pow(size.checked_add(1)?)? - 1) / 8 + 1),
            What::Tetra => 4_u64.checked_pow(size),
            What::Mountain => 4_u64.checked_pow(size)?.checked_mul(2)?.checked_add(mountain::BALLS),
            // Squares of groups of six rings of five tubes and five balls, and the ground.
            What::Rings => n.checked_mul(n + 1)?.checked_mul(2 * n + 1)?.checked_mul(10)?.checked_add(1),
            // A tube and a ball for one branch and two and four ..., and the ground.
            What::Tree => Some(2_u64.checked_pow(size.checked_add(2)?)? - 1),
            What::Knot => Some(knot::Knot::of(size).triangles().into()),
            What::Stadium => Some(knot::Knot::of(size).triangles() as u64 + stadium::OBJECTS),
        }
    }

    /// The largest size that is made.
    pub fn most_size(self) -> u32 {
        let fits = |size: u32| self.objects(size).is_some_and(|objects| objects <= MOST_OBJECTS);
        // Objects grow with the size: halve the range that holds the last one that fits.
        let (mut fit, mut unfit) = (self.least_size(), u32::MAX);
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
        form: Form,
        bare: bool,
        beside: &str,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        let head = format!("Made by strahl generate {self} --size {size}");
        match form {
            Form::Nff if bare => self.draw(size, &mut nff::Nff::bare(out)),
            Form::Nff => self.draw(size, &mut nff::Nff::new(&head, out)?),
            Form::Toml if bare => self.draw(size, &mut native::Toml::bare(beside, out)),
            Form::Toml => self.draw(size, &mut native::Toml::new(&head, beside, out)?),
            Form::Ply => self.mesh(size).map_or(Ok(()), |mesh| ply::write(&*mesh, out)),
        }
    }

    /// Makes it, piece by piece.
    fn draw(self, size: u32, pen: &mut dyn Pen) -> io::Result<()> {
        match self {
            What::Sphereflake => sphereflake::draw(size, pen),
            What::Tetra => tetra::draw(size, pen),
            What::Mountain => mountain::draw(size, pen),
            What::Rings => rings::draw(size, pen),
            What::Tree => tree::draw(size, pen),
            What::Knot => knot::draw(size, pen),
            What::Stadium => stadium::draw(size, pen),
        }
    }

    /// Its triangles, where they are what it is made of.
    fn mesh(self, size: u32) -> Option<Box<dyn Mesh>> {
        match self {
            What::Tetra => Some(Box::new(tetra::Tetra::of(size))),
            What::Mountain => Some(Box::new(mountain::Mountain::of(size))),
            What::Knot => Some(Box::new(knot::Knot::of(size))),
            What::Stadium => Some(Box::new(stadium::knot(size))),
            What::Sphereflake | What::Rings | What::Tree => None,
        }
    }

    /// Whether nothing but its triangles counts, so that a file of triangles can hold it.
    pub fn is_mesh(self) -> bool {
        matches!(self, What::Tetra | What::Mountain | What::Knot)
    }
}

impl fmt::Display for What {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// How a scene is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Form {
    /// The neutral file format of the databases.
    Nff,
    /// strahl's own; triangles of a mesh go into a PLY file beside it.
    Toml,
    /// The triangles only, binary.
    Ply,
}

impl Form {
    /// What the extension of a file names.
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?;
        Form::from_str(extension, true).ok()
    }

    /// The extension of such files.
    pub fn extension(self) -> &'static str {
        match self {
            Form::Nff => "nff",
            Form::Toml => "toml",
            Form::Ply => "ply",
        }
    }
}

#[cfg(test)]
mod tests;
