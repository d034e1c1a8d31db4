//! A torus knot: a tube that winds three times around the tube of a torus and twice around its hole.
//!
//! The center line of the tube is on a torus, and the normal of the torus gives the tube its frame, so that it closes
//! without a twist. The vertex normals are those of the tube.

use std::io;

use glam::{DVec3, dvec3};

use super::writer::{
    ProceduralMaterial, ProceduralMesh, SceneHeader, SceneWriter, ellipse_point, turns_to_radians,
};

/// The major and the minor radius of the torus.
const TORUS: (f64, f64) = (2.0, 1.0);
/// The radius of the tube of the knot.
const TUBE: f64 = 0.42;
/// The number of turns around the hole, and around the tube of the torus.
const TURNS: (f64, f64) = (2.0, 3.0);
/// The ratio of squares along the tube to those around it, so that triangles are about as long as wide.
const LONG: u32 = 12;

const SURFACE: ProceduralMaterial = ProceduralMaterial {
    name: "knot",
    color: [0.9, 0.62, 0.35],
    kd: 0.8,
    ks: 0.15,
    shine: 40.0,
    glass: None,
};

/// Writes the scene, with at least `size` triangles.
pub fn write_scene(size: u32, writer: &mut dyn SceneWriter) -> io::Result<()> {
    writer.header(&SceneHeader {
        from: dvec3(1.0, -7.5, 5.5),
        at: DVec3::ZERO,
        up: dvec3(0.0, 0.0, 1.0),
        lights: &[dvec3(-6.0, -8.0, 12.0), dvec3(9.0, -2.0, 6.0)],
    })?;
    writer.material(&SURFACE)?;
    writer.mesh(&TorusKnot::of(size))
}

/// A torus knot as a grid of squares, each of two triangles.
pub struct TorusKnot {
    /// The number of squares along the tube, and around it.
    along: u32,
    around: u32,
    scale: f64,
    center: DVec3,
}

impl TorusKnot {
    /// The smallest knot with at least this many triangles.
    pub fn of(triangles: u32) -> Self {
        let squares = triangles.div_ceil(2);
        let around = (squares / LONG).isqrt().max(3);
        let along = squares.div_ceil(around).max(3 * LONG);
        TorusKnot { along, around, scale: 1.0, center: DVec3::ZERO }
    }

    /// Moves and scales the knot.
    pub fn transformed(self, center: DVec3, scale: f64) -> Self {
        TorusKnot { scale, center, ..self }
    }

    /// The distance from its center to its outermost point.
    pub const OUTER_RADIUS: f64 = TORUS.0 + TORUS.1 + TUBE;
}

impl ProceduralMesh for TorusKnot {
    fn points(&self) -> u32 {
        self.along * self.around
    }

    fn point(&self, number: u32) -> (DVec3, Option<DVec3>) {
        let share = turns_to_radians(f64::from(number / self.around) / f64::from(self.along));
        let (hole, tube) = (TURNS.0 * share, TURNS.1 * share);
        let up = dvec3(0.0, 0.0, 1.0);
        let out = ellipse_point(hole, dvec3(1.0, 0.0, 0.0), dvec3(0.0, 1.0, 0.0));
        let onward = ellipse_point(hole, dvec3(0.0, 1.0, 0.0), dvec3(-1.0, 0.0, 0.0));

        // The center line of the tube, and its tangent: the derivative with respect to `share`.
        let away = ellipse_point(tube, out, up);
        let on_axis = out * TORUS.0 + away * TORUS.1;
        let tangent = onward * (TURNS.0 * (TORUS.0 + TORUS.1 * libm::cos(tube)))
            + ellipse_point(tube, up, -out) * (TURNS.1 * TORUS.1);
        let side = tangent.cross(away);
        let side = side / side.dot(side).sqrt();

        let normal = ellipse_point(
            turns_to_radians(f64::from(number % self.around) / f64::from(self.around)),
            away,
            side,
        );
        (self.center + (on_axis + normal * TUBE) * self.scale, Some(normal))
    }

    fn triangles(&self) -> u32 {
        self.along.saturating_mul(self.around).saturating_mul(2)
    }

    fn triangle(&self, number: u32) -> [u32; 3] {
        let square = number / 2;
        let (step, segment) = (square / self.around, square % self.around);
        let corner = |step: u32, segment: u32| step % self.along * self.around + segment % self.around;
        match number % 2 {
            0 => [corner(step, segment), corner(step, segment + 1), corner(step + 1, segment + 1)],
            _ => [corner(step + 1, segment + 1), corner(step + 1, segment), corner(step, segment)],
        }
    }
}
