//! Scenes in the neutral file format.

use std::io::{self, Write};

use glam::DVec3;

use super::writer::{ProceduralMaterial, ProceduralMesh, SceneHeader, SceneWriter, to_float3};

/// Writes NFF.
pub struct NffWriter<'o> {
    out: &'o mut dyn Write,
    objects_only: bool,
    surface: Option<ProceduralMaterial>,
}

impl<'o> NffWriter<'o> {
    /// A whole scene, after a comment.
    pub fn new(comment: &str, out: &'o mut dyn Write) -> io::Result<Self> {
        writeln!(out, "# {comment}")?;
        Ok(NffWriter { out, objects_only: false, surface: None })
    }

    /// Objects only.
    pub fn objects_only(out: &'o mut dyn Write) -> Self {
        NffWriter { out, objects_only: true, surface: None }
    }

    /// A corner, with its normal where it has one.
    fn corner(&mut self, point: DVec3, normal: Option<DVec3>) -> io::Result<()> {
        let [x, y, z] = to_float3(point);
        match normal.map(to_float3) {
            Some([nx, ny, nz]) => writeln!(self.out, "{x} {y} {z} {nx} {ny} {nz}"),
            None => writeln!(self.out, "{x} {y} {z}"),
        }
    }
}

impl SceneWriter for NffWriter<'_> {
    fn header(&mut self, head: &SceneHeader<'_>) -> io::Result<()> {
        if self.objects_only {
            return Ok(());
        }
        let out = &mut self.out;
        let [r, g, b] = SceneHeader::BACKGROUND;
        writeln!(out, "b {r} {g} {b}\nv")?;
        for (word, [x, y, z]) in
            [("from", to_float3(head.from)), ("at", to_float3(head.at)), ("up", to_float3(head.up))]
        {
            writeln!(out, "{word} {x} {y} {z}")?;
        }
        let (angle, size) = (SceneHeader::ANGLE, SceneHeader::SIZE);
        writeln!(out, "angle {angle}\nhither 0.01\nresolution {size} {size}")?;
        for light in head.lights {
            let [x, y, z] = to_float3(*light);
            writeln!(out, "l {x} {y} {z}")?;
        }
        Ok(())
    }

    fn material(&mut self, surface: &ProceduralMaterial) -> io::Result<()> {
        if self.surface == Some(*surface) {
            return Ok(());
        }
        self.surface = Some(*surface);
        let ProceduralMaterial { color: [r, g, b], kd, ks, shine, glass, .. } = surface;
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
