//! Writes scenes in NFF, the Neutral File Format.

use std::io::{self, Write};

use glam::DVec3;

use super::writer::{ProceduralMaterial, ProceduralMesh, SceneHeader, SceneWriter, to_float3};

/// Writes a scene in NFF.
pub struct NffWriter<'o> {
    out: &'o mut dyn Write,
    objects_only: bool,
    material: Option<ProceduralMaterial>,
}

impl<'o> NffWriter<'o> {
    /// Writes a whole scene, after a comment.
    pub fn new(comment: &str, out: &'o mut dyn Write) -> io::Result<Self> {
        writeln!(out, "# {comment}")?;
        Ok(NffWriter { out, objects_only: false, material: None })
    }

    /// Writes objects and their materials only.
    pub fn objects_only(out: &'o mut dyn Write) -> Self {
        NffWriter { out, objects_only: true, material: None }
    }

    /// Writes a vertex, with its normal if any.
    fn corner(&mut self, point: DVec3, normal: Option<DVec3>) -> io::Result<()> {
        let [x, y, z] = to_float3(point);
        match normal.map(to_float3) {
            Some([nx, ny, nz]) => writeln!(self.out, "{x} {y} {z} {nx} {ny} {nz}"),
            None => writeln!(self.out, "{x} {y} {z}"),
        }
    }
}

impl SceneWriter for NffWriter<'_> {
    fn header(&mut self, header: &SceneHeader<'_>) -> io::Result<()> {
        if self.objects_only {
            return Ok(());
        }
        let out = &mut self.out;
        let [r, g, b] = SceneHeader::BACKGROUND;
        writeln!(out, "b {r} {g} {b}\nv")?;
        for (word, [x, y, z]) in
            [("from", to_float3(header.from)), ("at", to_float3(header.at)), ("up", to_float3(header.up))]
        {
            writeln!(out, "{word} {x} {y} {z}")?;
        }
        let (angle, size) = (SceneHeader::ANGLE, SceneHeader::SIZE);
        writeln!(out, "angle {angle}\nhither 0.01\nresolution {size} {size}")?;
        for light in header.lights {
            let [x, y, z] = to_float3(*light);
            writeln!(out, "l {x} {y} {z}")?;
        }
        Ok(())
    }

    fn material(&mut self, material: &ProceduralMaterial) -> io::Result<()> {
        if self.material == Some(*material) {
            return Ok(());
        }
        self.material = Some(*material);
        let ProceduralMaterial { color: [r, g, b], kd, ks, shine, glass, .. } = material;
        let (transmitted, index) = glass.unwrap_or((0.0, 1.0));
        writeln!(self.out, "f {r} {g} {b} {kd} {ks} {shine} {transmitted} {index}")
    }

    fn sphere(&mut self, center: DVec3, radius: f64) -> io::Result<()> {
        let [x, y, z] = to_float3(center);
        writeln!(self.out, "s {x} {y} {z} {}", radius as f32)
    }

    fn cone(&mut self, base: (DVec3, f64), end: (DVec3, f64)) -> io::Result<()> {
        let ([x0, y0, z0], [x1, y1, z1]) = (to_float3(base.0), to_float3(end.0));
        writeln!(self.out, "c {x0} {y0} {z0} {} {x1} {y1} {z1} {}", base.1 as f32, end.1 as f32)
    }

    fn polygon(&mut self, corners: &[DVec3]) -> io::Result<()> {
        writeln!(self.out, "p {}", corners.len())?;
        corners.iter().try_for_each(|corner| self.corner(*corner, None))
    }

    fn mesh(&mut self, mesh: &dyn ProceduralMesh) -> io::Result<()> {
        for triangle in 0..mesh.triangles() {
            let corners = mesh.triangle(triangle).map(|corner| mesh.point(corner));
            let smooth = corners.iter().all(|(_, normal)| normal.is_some());
            writeln!(self.out, "{} 3", if smooth { "pp" } else { "p" })?;
            for (point, normal) in corners {
                self.corner(point, normal)?;
            }
        }
        Ok(())
    }
}
