//! Writes meshes in binary little-endian PLY.

use std::io::{self, Write};

use super::writer::{ProceduralMesh, to_float3};

/// Writes a mesh.
pub fn write(mesh: &dyn ProceduralMesh, out: &mut dyn Write) -> io::Result<()> {
    let (points, triangles) = (mesh.points(), mesh.triangles());
    let smooth = mesh.point(0).1.is_some();
    writeln!(out, "ply\nformat binary_little_endian 1.0\nelement vertex {points}")?;
    for name in ["x", "y", "z", "nx", "ny", "nz"].iter().take(if smooth { 6 } else { 3 }) {
        writeln!(out, "property float {name}")?;
    }
    writeln!(out, "element face {triangles}\nproperty list uchar uint vertex_indices\nend_header")?;
    for point in 0..points {
        let (position, normal) = mesh.point(point);
        for number in to_float3(position).into_iter().chain(normal.into_iter().flat_map(to_float3)) {
            out.write_all(&number.to_le_bytes())?;
        }
    }
    for triangle in 0..triangles {
        out.write_all(&[3])?;
        for corner in mesh.triangle(triangle) {
            out.write_all(&corner.to_le_bytes())?;
        }
    }
    Ok(())
}
