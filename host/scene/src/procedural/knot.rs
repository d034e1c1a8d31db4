//! A torus knot: a tube that winds three times round a torus while it goes twice round its hole.
//!
//! The middle of the tube lies on a torus, and the torus's normal gives the tube its frame, so
//! that it closes without a twist. Normals are those of the tube and not of the triangles.

use std::io;

use glam::{DVec3, dvec3};

use super::writer::{
    ProceduralMaterial, ProceduralMesh, SceneHeader, SceneWriter, ellipse_point, turns_to_radians,
};

/// From the middle of the torus to that of its tube, and the radius of that tube.
const TORUS: (f64, f64) = (2.0, 1.0);
/// The radius of the knot's own tube.
const TUBE: f64 = 0.42;
/// How often it goes round the hole, and round the torus's tube.
const TURNS: (f64, f64) = (2.0, 3.0);
/// How much longer than round the knot is, so that its triangles are about as long as wide.
const LONG: u32 = 12;

const SURFACE: ProceduralMaterial = ProceduralMaterial {
    name: "knot",
    color: [0.9, 0.62, 0.35],
    kd: 0.8,
    ks: 0.15,
    shine: 40.0,
    glass: None,
};

/// Draws it, of at least as many triangles as its size.
pub fn write_scene(size: u32, pen: &mut dyn SceneWriter) -> io::Result<()> {
    pen.header(&SceneHeader {
        from: dvec3(1.0, -7.5, 5.5),
        at: DVec3::ZERO,
        up: dvec3(0.0, 0.0, 1.0),
        lights: &[dvec3(-6.0, -8.0, 12.0), dvec3(9.0, -2.0, 6.0)],
    })?;
    pen.material(&SURFACE)?;
    pen.mesh(&TorusKnot::of(size))
}

/// A knot as a net of squares, each of two triangles.
pub struct TorusKnot {
    /// Squares along the tube and round it.
    along: u32,
    around: u32,
    scale: f64,
    center: DVec3,
}

impl TorusKnot {
    /// Of at least so many triangles, and of the fewest more that make whole rounds.
    pub fn of(triangles: u32) -> Self {
        let squares = triangles.div_ceil(2);
        let around = (squares / LONG).isqrt().max(3);
        let along = squares.div_ceil(around).max(3 * LONG);
        TorusKnot { along, around, scale: 1.0, center: DVec3::ZERO }
    }

    /// The same, smaller and somewhere else.
    pub fn transformed(self, middle: DVec3, scale: f64) -> Self {
        TorusKnot { scale, center: middle, ..self }
    }

    /// How far it reaches from its middle.
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

        // The middle of the tube, and the way it goes: the derivative by `share`.
        let away = ellipse_point(tube, out, up);
        let middle = out * TORUS.0 + away * TORUS.1;
        let way = onward * (TURNS.0 * (TORUS.0 + TORUS.1 * libm::cos(tube)))
            + ellipse_point(tube, up, -out) * (TURNS.1 * TORUS.1);
        let side = way.cross(away);
        let side = side / side.dot(side).sqrt();

        let normal = ellipse_point(
            turns_to_radians(f64::from(number % self.around) / f64::from(self.around)),
            away,
            side,
        );
        (self.center + (middle + normal * TUBE) * self.scale, Some(normal))
    }

    fn triangles(&self) -> u32 {
        self.along.saturating_mul(self.around).saturating_mul(2)
    }

    fn triangle(&self, number: u32) -> [u32; 3] {
        let square = number / 2;
        let (step, place) = (square / self.around, square % self.around);
        let corner = |step: u32, place: u32| step % self.along * self.around + place % self.around;
        match number % 2 {
            0 => [corner(step, place), corner(step, place + 1), corner(step + 1, place + 1)],
            _ => [corner(step + 1, place + 1), corner(step + 1, place), corner(step, place)],
        }
    }
}
