//! The tetrahedral pyramid: a tetrahedron of four, each of four, down to the smallest, which are
//! solid.
//!
//! Source: the procedural databases' `tetra` (Eric Haines, 1987; after Glassner), with its view,
//! light and surface. Of size n it has 4^(n-1) small tetrahedra.

use std::io;

use glam::{DVec3, dvec3};

use super::writer::{ProceduralMaterial, ProceduralMesh, SceneHeader, SceneWriter};

const SURFACE: ProceduralMaterial = ProceduralMaterial::matte("tetra", [1.0, 0.2, 0.2], 1.0);

/// Four corners of a cube of side two, of which no two share an edge.
const CORNERS: [DVec3; 4] =
    [dvec3(-1.0, -1.0, 1.0), dvec3(-1.0, 1.0, -1.0), dvec3(1.0, -1.0, -1.0), dvec3(1.0, 1.0, 1.0)];

/// The corners of its faces.
const FACES: [[u32; 3]; 4] = [[0, 1, 2], [3, 2, 1], [2, 3, 0], [1, 0, 3]];

/// Draws it; a size of 1 is one tetrahedron.
pub fn write_scene(size: u32, pen: &mut dyn SceneWriter) -> io::Result<()> {
    pen.header(&SceneHeader {
        from: dvec3(1.02285, -3.17715, -2.17451),
        at: dvec3(-0.004103, -0.004103, 0.216539),
        up: dvec3(-0.816497, -0.816497, 0.816497),
        lights: &[dvec3(2.0, -18.0, -5.0)],
    })?;
    pen.material(&SURFACE)?;
    pen.mesh(&TetrahedronPyramid::of(size))
}

/// All small tetrahedra of a size.
pub struct TetrahedronPyramid {
    halvings: u32,
}

impl TetrahedronPyramid {
    /// Of a size of 1 or more.
    pub fn of(size: u32) -> Self {
        TetrahedronPyramid { halvings: size - 1 }
    }
}

impl ProceduralMesh for TetrahedronPyramid {
    fn points(&self) -> u32 {
        self.triangles()
    }

    /// The digits of the number to the base of four are the way from the whole to the corner.
    fn point(&self, number: u32) -> (DVec3, Option<DVec3>) {
        let corner = |digit: u32| CORNERS[(number >> (2 * digit) & 3) as usize];
        let mut place = DVec3::ZERO;
        let mut half = 0.5;
        for digit in (1..=self.halvings).rev() {
            place += corner(digit) * half;
            half *= 0.5;
        }
        // The last step goes from the middle of a small one, which is as wide as the last halving.
        (place + corner(0) * (2.0 * half), None)
    }

    fn triangles(&self) -> u32 {
        4 << (2 * self.halvings)
    }

    fn triangle(&self, number: u32) -> [u32; 3] {
        FACES[(number & 3) as usize].map(|corner| (number & !3) + corner)
    }
}
