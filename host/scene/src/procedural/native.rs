//! Scenes in TOML.

use std::io::{self, Write};

use glam::DVec3;

use super::pen::{Head, Mesh, Pen, Surface, rounded};

/// Writes TOML.
pub struct Toml<'o> {
    out: &'o mut dyn Write,
    /// The name of the PLY file that has the triangles.
    ply: &'o str,
    bare: bool,
    /// The names of materials that have been written.
    known: Vec<&'static str>,
    /// That of the objects to come.
    material: &'static str,
}

impl<'o> Toml<'o> {
    /// A whole scene, after a comment; the triangles of its mesh are in the file `ply`.
    pub fn new(comment: &str, ply: &'o str, out: &'o mut dyn Write) -> io::Result<Self> {
        writeln!(out, "# {comment}")?;
        Ok(Toml { bare: false, ..Toml::bare(ply, out) })
    }

    /// Objects only, with their materials.
    pub fn bare(ply: &'o str, out: &'o mut dyn Write) -> Self {
        Toml { out, ply, bare: true, known: Vec::new(), material: "" }
    }

    /// Ends an object.
    fn made_of(&mut self) -> io::Result<()> {
        writeln!(self.out, "material = {:?}", self.material)
    }
}

impl Pen for Toml<'_> {
    fn head(&mut self, head: &Head<'_>) -> io::Result<()> {
        if self.bare {
            return Ok(());
        }
        let out = &mut self.out;
        writeln!(out, "\n[camera]")?;
        for (key, place) in [("from", head.from), ("at", head.at), ("up", head.up)] {
            writeln!(out, "{key} = {:?}", rounded(place))?;
        }
        let (angle, size, background) = (Head::ANGLE, Head::SIZE, Head::BACKGROUND);
        writeln!(out, "angle = {angle}\n\n[render]\nsize = [{size}, {size}]")?;
        writeln!(out, "\n[background]\ncolor = {background:?}")?;
        let intensity = head.intensity();
        writeln!(out, "\n[ambient_light]\ncolor = {intensity}")?;
        for light in head.lights {
            writeln!(out, "\n[[point_light]]\nposition = {:?}\ncolor = {intensity}", rounded(*light))?;
        }
        Ok(())
    }

    fn surface(&mut self, surface: &Surface) -> io::Result<()> {
        self.material = surface.name;
        if self.known.contains(&surface.name) {
            return Ok(());
        }
        self.known.push(surface.name);
        let Surface { name, color, kd, ks, shine, glass } = *surface;
        let out = &mut self.out;
        writeln!(out, "\n[[material]]\nname = {name:?}\ncolor = {color:?}\ndiffuse = {kd}")?;
        if ks > 0.0 {
            writeln!(out, "mirror = {ks}")?;
            if shine > 0.0 {
                writeln!(out, "highlight = {ks}\nshininess = {shine}")?;
            }
        }
        if let Some((transmitted, index)) = glass {
            writeln!(out, "transmission = {transmitted}\nindex = {index}")?;
        }
        Ok(())
    }

    fn sphere(&mut self, center: DVec3, radius: f64) -> io::Result<()> {
        let center = rounded(center);
        writeln!(self.out, "\n[[sphere]]\ncenter = {center:?}\nradius = {}", radius as f32)?;
        self.made_of()
    }

    fn cone(&mut self, base: (DVec3, f64), end: (DVec3, f64)) -> io::Result<()> {
        writeln!(self.out, "\n[[cone]]\nbase = {:?}\nend = {:?}", rounded(base.0), rounded(end.0))?;
        writeln!(self.out, "radius = {}\nend_radius = {}\nopen = true", base.1 as f32, end.1 as f32)?;
        self.made_of()
    }

    fn polygon(&mut self, corners: &[DVec3]) -> io::Result<()> {
        let corners: Vec<_> = corners.iter().map(|corner| rounded(*corner)).collect();
        writeln!(self.out, "\n[[polygon]]\ncorners = {corners:?}")?;
        self.made_of()
    }

    fn mesh(&mut self, _: &dyn Mesh) -> io::Result<()> {
        writeln!(self.out, "\n[[mesh]]\nfile = {:?}", self.ply)?;
        self.made_of()
    }
}
