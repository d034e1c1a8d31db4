//! The tetrahedral pyramid: a tetrahedron of four smaller ones, recursively.
//!
//! Size n has 4^(n-1) solid tetrahedra.
//!
//! Source: `tetra` of the Standard Procedural Databases (Eric Haines, 1987; after Glassner), with its view, light and
//! material.

use std::io;

use glam::{DVec3, dvec3};

use super::writer::{ProceduralMaterial, ProceduralMesh, SceneHeader, SceneWriter};

const SURFACE: ProceduralMaterial = ProceduralMaterial::matte("tetra", [1.0, 0.2, 0.2], 1.0);

/// Four corners of a cube of side 2, no two of which share an edge.
const CORNERS: [DVec3; 4] =
    [dvec3(-1.0, -1.0, 1.0), dvec3(-1.0, 1.0, -1.0), dvec3(1.0, -1.0, -1.0), dvec3(1.0, 1.0, 1.0)];

/// The vertices of the faces.
const FACES: [[u32; 3]; 4] = [[0, 1, 2], [3, 2, 1], [2, 3, 0], [1, 0, 3]];

/// Writes the scene; size 1 is one tetrahedron.
pub fn write_scene(size: u32, writer: &mut dyn SceneWriter) -> io::Result<()> {
    writer.header(&SceneHeader {
        from: dvec3(1.02285, -3.17715, -2.17451),
        at: dvec3(-0.004103, -0.004103, 0.216539),
        up: dvec3(-0.816497, -0.816497, 0.816497),
        lights: &[dvec3(2.0, -18.0, -5.0)],
    })?;
    writer.material(&SURFACE)?;
    writer.mesh(&TetrahedronPyramid::of(size))
}

/// All solid tetrahedra of a size.
pub struct TetrahedronPyramid {
    halvings: u32,
}

impl TetrahedronPyramid {
    /// The pyramid of a size, at least 1.
    pub fn of(size: u32) -> Self {
        TetrahedronPyramid { halvings: size - 1 }
    }
}

impl ProceduralMesh for TetrahedronPyramid {
    fn points(&self) -> u32 {
        self.triangles()
    }

    /// The base-4 digits of the number select the corner at each level, from the whole to the vertex.
    fn point(&self, number: u32) -> (DVec3, Option<DVec3>) {
        let corner = |digit: u32| CORNERS[(number >> (2 * digit) & 3) as usize];
        let mut position = DVec3::ZERO;
        let mut half = 0.5;
        for digit in (1..=self.halvings).rev() {
            position += corner(digit) * half;
            half *= 0.5;
        }
        // From the center of a solid tetrahedron, whose size is that of the last halving, to its corner.
        (position + corner(0) * (2.0 * half), None)
    }

    fn triangles(&self) -> u32 {
        4 << (2 * self.halvings)
    }

    fn triangle(&self, number: u32) -> [u32; 3] {
        FACES[(number & 3) as usize].map(|corner| (number & !3) + corner)
    }
}
