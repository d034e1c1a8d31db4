//! From a place in the picture to a ray.

use super::{CameraError, Resolution, check};
use crate::geometry::Ray;
use crate::math::{
    MAX_COORDINATE, PI, Real, SobolSequence, Vec3, is_in_range, sample_disc_concentric, tan, try_normalize,
};

/// A place in the picture, in pixels from its upper left corner; the middle of the first pixel
/// is (0.5, 0.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmPoint {
    /// To the right.
    pub x: Real,
    /// Down.
    pub y: Real,
}

/// One camera ray: where it goes through the film, and its random numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraSample {
    /// Where.
    pub point: FilmPoint,
    /// The numbers from which everything is taken that the ray leaves to chance.
    pub sequence: SobolSequence,
}

/// How the scene is looked at, whatever the size of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct CameraDescriptor {
    /// The eye.
    pub position: Vec3,
    /// What is in the middle of the picture.
    pub target: Vec3,
    /// What is up; it need not be upright on the line of sight.
    pub up: Vec3,
    /// How rays run.
    pub projection: Projection,
}

/// How rays run from the eye through the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u32)]
pub enum Projection {
    /// All from one point.
    Perspective {
        /// The full angle between the middle of the first row of pixels and that of the last,
        /// in radians, more than zero and less than half a turn (the rule of NFF). A picture
        /// of one row takes it between its upper and its lower edge.
        field_of_view: Real,
    },
    /// All in one direction.
    Orthographic {
        /// From the middle of the first row of pixels to that of the last, in scene lengths.
        height: Real,
    },
    /// All from one lens, and what lies in a plane through its focus is sharp.
    ThinLens {
        /// As of [`Projection::Perspective`].
        field_of_view: Real,
        /// The radius of the lens, more than zero, at most 1e15, in scene lengths.
        lens_radius: Real,
        /// How far away from the lens everything is sharp, along the line of sight; more than
        /// zero, at most 1e15.
        focus_distance: Real,
    },
}

/// Turns places in the picture into rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    position: Vec3,
    forward: Vec3,
    /// From one pixel to the next, at a distance of one (perspective) or anywhere.
    pixel_dx: Vec3,
    pixel_dy: Vec3,
    /// The middle of the picture.
    center: FilmPoint,
    is_orthographic: bool,
    /// The radius of the lens, zero for none, and its focus.
    thin_lens: [Real; 2],
}

impl Camera {
    /// The camera of `view` for pictures of `size`.
    pub fn new(view: &CameraDescriptor, size: Resolution) -> Result<Self, CameraError> {
        if !(is_in_range(view.position) && is_in_range(view.target) && view.up.is_finite()) {
            return Err(CameraError::Coordinate);
        }
        let forward = try_normalize(view.target - view.position).ok_or(CameraError::PositionIsTarget)?;
        let up = try_normalize(view.up).ok_or(CameraError::UpParallelToView)?;
        let right = forward.cross(up);
        // Below some roundings the direction of what is left is noise.
        if right.dot(right) <= 1e-10 {
            return Err(CameraError::UpParallelToView);
        }
        let right = try_normalize(right).ok_or(CameraError::UpParallelToView)?;
        let down = forward.cross(right);
        let rows = if size.height() > 1 { size.height() - 1 } else { 1 } as Real;
        let mut lens = [0.0; 2];
        let (height, parallel) = match view.projection {
            Projection::Perspective { field_of_view: angle } => (film_height(angle)?, false),
            Projection::ThinLens { field_of_view: angle, lens_radius: radius, focus_distance: focus } => {
                positive(radius, CameraError::LensRadius)?;
                positive(focus, CameraError::FocusDistance)?;
                lens = [radius, focus];
                (film_height(angle)?, false)
            }
            Projection::Orthographic { height } => {
                positive(height, CameraError::Height)?;
                (height, true)
            }
        };
        let step = height / rows;
        let middle = FilmPoint { x: 0.5 * size.width() as Real, y: 0.5 * size.height() as Real };
        Ok(Camera {
            position: view.position,
            forward,
            pixel_dx: right * step,
            pixel_dy: down * step,
            center: middle,
            is_orthographic: parallel,
            thin_lens: lens,
        })
    }

    /// Whether only what is in focus is sharp.
    pub fn has_depth_of_field(&self) -> bool {
        self.thin_lens[0] > 0.0
    }

    /// The ray through a place, and through the point of the lens that `chance` says, a point of
    /// the unit square, whose middle stands for that of the lens.
    pub(crate) fn thin_lens_ray(&self, place: FilmPoint, chance: [Real; 2]) -> Ray {
        let [radius, focus] = self.thin_lens;
        let across = self.pixel_dx * (place.x - self.center.x) + self.pixel_dy * (place.y - self.center.y);
        let [x, y] = sample_disc_concentric(chance);
        let right = try_normalize(self.pixel_dx).unwrap_or(Vec3::ZERO);
        let down = try_normalize(self.pixel_dy).unwrap_or(Vec3::ZERO);
        let aside = (right * x + down * y) * radius;
        // All rays through a place meet in the plane of focus.
        let way = (self.forward + across) * focus - aside;
        Ray::new(self.position + aside, try_normalize(way).unwrap_or(self.forward))
    }

    /// The ray through a place, from the middle of the lens where there is one, with a direction of length one.
    pub fn ray(&self, place: FilmPoint) -> Ray {
        let across = self.pixel_dx * (place.x - self.center.x) + self.pixel_dy * (place.y - self.center.y);
        if self.is_orthographic {
            Ray::with_near_unit_direction(self.position + across, self.forward, 0.0)
        } else {
            Ray::with_near_unit_direction(
                self.position,
                try_normalize(self.forward + across).unwrap_or(self.forward),
                0.0,
            )
        }
    }
}

/// The height of the film at a distance of 1 that is seen in `angle`.
fn film_height(angle: Real) -> Result<Real, CameraError> {
    if angle > 0.0 && angle < PI {
        Ok(2.0 * tan(0.5 * angle))
    } else {
        Err(CameraError::FieldOfView(check::single(angle)))
    }
}

/// Whether a length is more than 0 and in range.
fn positive(length: Real, error: fn(f32) -> CameraError) -> Result<(), CameraError> {
    if length > 0.0 && length <= MAX_COORDINATE { Ok(()) } else { Err(error(check::single(length))) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{acos, vec3};

    const VIEW: CameraDescriptor = CameraDescriptor {
        position: vec3(1.0, 2.0, 3.0),
        target: vec3(1.0, 2.0, -4.0),
        up: vec3(0.0, 5.0, 1.0),
        projection: Projection::Perspective { field_of_view: 0.8 },
    };

    fn place(x: Real, y: Real) -> FilmPoint {
        FilmPoint { x, y }
    }

    #[test]
    fn the_angle_runs_from_the_middle_of_the_first_row_to_that_of_the_last() {
        let camera = Camera::new(&VIEW, Resolution::new(7, 5).unwrap()).unwrap();
        let (top, bottom) = (camera.ray(place(3.5, 0.5)), camera.ray(place(3.5, 4.5)));
        assert!((acos(top.direction.dot(bottom.direction)) - 0.8).abs() < 1e-6);
        assert!(top.direction.y > 0.0 && bottom.direction.y < 0.0);
        let middle = camera.ray(place(3.5, 2.5));
        assert_eq!((middle.origin, middle.direction), (VIEW.position, -Vec3::Z));
        assert!(camera.ray(place(6.5, 2.5)).direction.x > 0.0, "right is right");
    }

    #[test]
    fn parallel_rays_start_as_far_apart_as_the_height_says() {
        let view = CameraDescriptor { projection: Projection::Orthographic { height: 8.0 }, ..VIEW };
        let camera = Camera::new(&view, Resolution::new(5, 5).unwrap()).unwrap();
        let (top, bottom) = (camera.ray(place(2.5, 0.5)), camera.ray(place(2.5, 4.5)));
        assert_eq!(top.direction, bottom.direction);
        assert!((top.origin - bottom.origin - vec3(0.0, 8.0, 0.0)).abs().max_element() < 1e-5);
    }

    #[test]
    fn views_that_show_nothing_are_refused() {
        let size = Resolution::new(4, 4).unwrap();
        let fault = |view: CameraDescriptor| Camera::new(&view, size).unwrap_err();
        assert_eq!(fault(CameraDescriptor { target: VIEW.position, ..VIEW }), CameraError::PositionIsTarget);
        assert_eq!(
            fault(CameraDescriptor { up: vec3(0.0, 0.0, 2.0), ..VIEW }),
            CameraError::UpParallelToView
        );
        assert_eq!(fault(CameraDescriptor { up: Vec3::ZERO, ..VIEW }), CameraError::UpParallelToView);
        assert_eq!(
            fault(CameraDescriptor { position: vec3(Real::NAN, 0.0, 0.0), ..VIEW }),
            CameraError::Coordinate
        );
        for angle in [0.0, -1.0, PI, 4.0, Real::NAN] {
            let projection = Projection::Perspective { field_of_view: angle };
            assert!(matches!(fault(CameraDescriptor { projection, ..VIEW }), CameraError::FieldOfView(_)));
        }
        assert!(Resolution::new(0, 4).is_none() && Resolution::new(4, Resolution::MAX_SIDE + 1).is_none());
    }

    #[test]
    fn a_picture_of_one_row_or_one_column_has_finite_rays() {
        for (w, h) in [(1, 1), (1, 9), (9, 1)] {
            let camera = Camera::new(&VIEW, Resolution::new(w, h).unwrap()).unwrap();
            assert!(camera.ray(place(0.0, 0.0)).direction.is_finite());
        }
    }
}
