//! Writes scenes in TOML.

use std::io::{self, Write};

use glam::DVec3;

use super::writer::{ProceduralMaterial, ProceduralMesh, SceneHeader, SceneWriter, to_float3};

/// Writes a scene in TOML.
pub struct TomlWriter<'o> {
    out: &'o mut dyn Write,
    /// The path of the PLY file with the triangles of the mesh.
    ply: &'o str,
    objects_only: bool,
    /// The names of the materials written so far.
    written_materials: Vec<&'static str>,
    /// The name of the current material.
    material: &'static str,
}

impl<'o> TomlWriter<'o> {
    /// Writes a whole scene, after a comment; the triangles of its mesh are in the file `ply`.
    pub fn new(comment: &str, ply: &'o str, out: &'o mut dyn Write) -> io::Result<Self> {
        writeln!(out, "# {comment}")?;
        Ok(TomlWriter { objects_only: false, ..TomlWriter::objects_only(ply, out) })
    }

    /// Writes objects and their materials only.
    pub fn objects_only(ply: &'o str, out: &'o mut dyn Write) -> Self {
        TomlWriter { out, ply, objects_only: true, written_materials: Vec::new(), material: "" }
    }

    /// Writes the last key of an object: its material.
    fn end_object(&mut self) -> io::Result<()> {
        writeln!(self.out, "material = {:?}", self.material)
    }
}

impl SceneWriter for TomlWriter<'_> {
    fn header(&mut self, header: &SceneHeader<'_>) -> io::Result<()> {
        if self.objects_only {
            return Ok(());
        }
        let out = &mut self.out;
        writeln!(out, "\n[camera]")?;
        for (key, position) in [("from", header.from), ("at", header.at), ("up", header.up)] {
            writeln!(out, "{key} = {:?}", to_float3(position))?;
        }
        let (angle, size, background) = (SceneHeader::ANGLE, SceneHeader::SIZE, SceneHeader::BACKGROUND);
        writeln!(out, "angle = {angle}\n\n[render]\nsize = [{size}, {size}]")?;
        writeln!(out, "\n[background]\ncolor = {background:?}")?;
        let intensity = header.intensity();
        writeln!(out, "\n[ambient_light]\ncolor = {intensity}")?;
        for light in header.lights {
            writeln!(out, "\n[[point_light]]\nposition = {:?}\ncolor = {intensity}", to_float3(*light))?;
        }
        Ok(())
    }

    fn material(&mut self, material: &ProceduralMaterial) -> io::Result<()> {
        self.material = material.name;
        if self.written_materials.contains(&material.name) {
            return Ok(());
        }
        self.written_materials.push(material.name);
        let ProceduralMaterial { name, color, kd, ks, shine, glass } = *material;
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
        let center = to_float3(center);
        writeln!(self.out, "\n[[sphere]]\ncenter = {center:?}\nradius = {}", radius as f32)?;
        self.end_object()
    }

    fn cone(&mut self, base: (DVec3, f64), end: (DVec3, f64)) -> io::Result<()> {
        writeln!(self.out, "\n[[cone]]\nbase = {:?}\nend = {:?}", to_float3(base.0), to_float3(end.0))?;
        writeln!(self.out, "radius = {}\nend_radius = {}\nopen = true", base.1 as f32, end.1 as f32)?;
        self.end_object()
    }

    fn polygon(&mut self, corners: &[DVec3]) -> io::Result<()> {
        let corners: Vec<_> = corners.iter().map(|corner| to_float3(*corner)).collect();
        writeln!(self.out, "\n[[polygon]]\ncorners = {corners:?}")?;
        self.end_object()
    }

    fn mesh(&mut self, _: &dyn ProceduralMesh) -> io::Result<()> {
        writeln!(self.out, "\n[[mesh]]\nfile = {:?}", self.ply)?;
        self.end_object()
    }
}
