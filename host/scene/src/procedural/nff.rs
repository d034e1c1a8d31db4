//! Scenes in the neutral file format.

use std::io::{self, Write};

use glam::DVec3;

use super::pen::{Head, Mesh, Pen, Surface, rounded};

/// Writes NFF.
pub struct Nff<'o> {
    out: &'o mut dyn Write,
    bare: bool,
    surface: Option<Surface>,
}

impl<'o> Nff<'o> {
    /// A whole scene, after a comment.
    pub fn new(comment: &str, out: &'o mut dyn Write) -> io::Result<Self> {
        writeln!(out, "# {comment}")?;
        Ok(Nff { out, bare: false, surface: None })
    }

    /// Objects only.
    pub fn bare(out: &'o mut dyn Write) -> Self {
        Nff { out, bare: true, surface: None }
    }

    /// A corner, with its normal where it has one.
    fn corner(&mut self, point: DVec3, normal: Option<DVec3>) -> io::Result<()> {
        let [x, y, z] = rounded(point);
        match normal.map(rounded) {
            Some([nx, ny, nz]) => writeln!(self.out, "{x} {y} {z} {nx} {ny} {nz}"),
            None => writeln!(self.out, "{x} {y} {z}"),
        }
    }
}

impl Pen for Nff<'_> {
    fn head(&mut self, head: &Head<'_>) -> io::Result<()> {
        if self.bare {
            return Ok(());
        }
        let out = &mut self.out;
        let [r, g, b] = Head::BACKGROUND;
        writeln!(out, "b {r} {g} {b}\nv")?;
        for (word, [x, y, z]) in
            [("from", rounded(head.from)), ("at", rounded(head.at)), ("up", rounded(head.up))]
        {
            writeln!(out, "{word} {x} {y} {z}")?;
        }
        let (angle, size) = (Head::ANGLE, Head::SIZE);
        writeln!(out, "angle {angle}\nhither 0.01\nresolution {size} {size}")?;
        for light in head.lights {
            let [x, y, z] = rounded(*light);
            writeln!(out, "l {x} {y} {z}")?;
        }
        Ok(())
    }

    fn surface(&mut self, surface: &Surface) -> io::Result<()> {
        if self.surface == Some(*surface) {
            return Ok(());
        }
        self.surface = Some(*surface);
        let Surface { color: [r, g, b], kd, ks, shine, glass, .. } = surface;
        let (transmitted, index) = glass.unwrap_or((0.0, 1.0));
        writeln!(self.out, "f {r} {g} {b} {kd} {ks} {shine} {transmitted} {index}")
    }

    fn sphere(&mut self, center: DVec3, radius: f64) -> io::Result<()> {
        let [x, y, z] = rounded(center);
        writeln!(self.out, "s {x} {y} {z} {}", radius as f32)
    }

    fn cone(&mut self, base: (DVec3, f64), end: (DVec3, f64)) -> io::Result<()> {
        let ([x0, y0, z0], [x1, y1, z1]) = (rounded(base.0), rounded(end.0));
        writeln!(self.out, "c {x0} {y0} {z0} {} {x1} {y1} {z1} {}", base.1 as f32, end.1 as f32)
    }

    fn polygon(&mut self, corners: &[DVec3]) -> io::Result<()> {
        writeln!(self.out, "p {}", corners.len())?;
        corners.iter().try_for_each(|corner| self.corner(*corner, None))
    }

    fn mesh(&mut self, mesh: &dyn Mesh) -> io::Result<()> {
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
