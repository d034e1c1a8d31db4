//! Cameras: rays from points on the film.
//!
//! A [`CameraDescriptor`] describes a pinhole, orthographic or thin-lens camera for pictures of any
//! resolution. A [`Camera`] is the checked camera of one resolution; it generates the rays.
//!
//! Source: Cook, Porter and Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984, for the thin lens.

use super::check::FieldChecks;
use super::{CameraError, Field, Resolution};
use crate::geometry::Ray;
use crate::math::{
    MAX_COORDINATE, PI, Real, SobolSequence, Vec3, sample_disc_concentric, tan, try_normalize,
};

/// A point on the film, in pixels from the upper left corner of the picture.
///
/// The center of the first pixel is (0.5, 0.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmPoint {
    /// Distance to the right of the left edge, in pixels.
    pub x: Real,
    /// Distance below the upper edge, in pixels.
    pub y: Real,
}

/// One camera ray to be traced: its film point, and the source of all its other random numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraSample {
    /// Point on the film that the ray passes through.
    pub point: FilmPoint,
    /// Sequence from which the time, the point on the lens, the points on lights and the glossy directions
    /// of the ray tree are drawn.
    pub sequence: SobolSequence,
}

/// Position, orientation and projection of a camera, independent of the resolution.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(C)]
pub struct CameraDescriptor {
    /// Position of the camera, world space, coordinates in `-1e15..=1e15`.
    pub position: Vec3,
    /// Point at the center of the picture, world space, coordinates in `-1e15..=1e15`. Differs from
    /// `position`.
    pub target: Vec3,
    /// Direction that points up in the picture, of any length above zero. It need not be perpendicular to
    /// the view direction, but must not be parallel to it.
    pub up: Vec3,
    /// Projection onto the film: perspective, orthographic or thin lens.
    pub projection: Projection,
}

impl CameraDescriptor {
    /// A pinhole camera at `position` that looks at `target`, with +Y up.
    ///
    /// `field_of_view`: vertical angle between the centers of the first and the last row of pixels, in
    /// radians, in `(0, pi)`.
    ///
    /// ```
    /// use strahl_core::{Camera, CameraDescriptor, Resolution, Vec3, vec3};
    ///
    /// let descriptor = CameraDescriptor::perspective(vec3(0.0, 0.0, 5.0), Vec3::ZERO, 0.8);
    /// assert!(Camera::new(&descriptor, Resolution::new(320, 240).unwrap()).is_ok());
    /// ```
    pub const fn perspective(position: Vec3, target: Vec3, field_of_view: Real) -> Self {
        CameraDescriptor {
            position,
            target,
            up: Vec3::Y,
            projection: Projection::Perspective { field_of_view },
        }
    }
}

/// How a camera projects the scene onto the film.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "baked", derive(zerocopy::TryFromBytes, zerocopy::KnownLayout, zerocopy::Immutable))]
#[repr(u32)]
pub enum Projection {
    /// Pinhole camera: all rays start at the camera's position.
    Perspective {
        /// Vertical angle between the centers of the first and the last row of pixels, in radians, in `(0,
        /// pi)`.
        ///
        /// This is the convention of NFF. In a picture of one row it is the angle between the edges of the
        /// row.
        #[doc(alias = "fov")]
        field_of_view: Real,
    },
    /// Orthographic camera: all rays are parallel.
    Orthographic {
        /// Distance between the centers of the first and the last row of pixels, in scene lengths, in `(0,
        /// 1e15]`.
        height: Real,
    },
    /// Thin lens: rays start on a disc, and only the plane of focus is sharp.
    ThinLens {
        /// As for [`Projection::Perspective`].
        field_of_view: Real,
        /// Radius of the lens, in scene lengths, in `(0, 1e15]`.
        lens_radius: Real,
        /// Distance from the lens to the plane of focus along the view direction, in scene lengths, in `(0,
        /// 1e15]`.
        focus_distance: Real,
    },
}

impl Projection {
    fn validate(&self, fields: &mut FieldChecks) {
        let mut length = |field, length| {
            fields.require(field, length, length > 0.0 && length <= MAX_COORDINATE);
        };
        let field_of_view = match *self {
            Projection::Perspective { field_of_view } => field_of_view,
            Projection::ThinLens { field_of_view, lens_radius, focus_distance } => {
                length(Field::LensRadius, lens_radius);
                length(Field::FocusDistance, focus_distance);
                field_of_view
            }
            Projection::Orthographic { height } => return length(Field::Height, height),
        };
        fields.require(Field::FieldOfView, field_of_view, field_of_view > 0.0 && field_of_view < PI);
    }
}

/// Generates the rays of a perspective, orthographic or thin-lens camera, for pictures of one resolution.
///
/// It has no shutter: the time of a ray follows from [`CameraSample::sequence`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    position: Vec3,
    /// Unit vector, view direction.
    forward: Vec3,
    /// Offset from one pixel to the next on its right: on the plane at distance 1 (perspective) or in the
    /// scene (orthographic).
    pixel_dx: Vec3,
    /// Offset from one pixel to the next below it.
    pixel_dy: Vec3,
    /// Center of the picture.
    center: FilmPoint,
    is_orthographic: bool,
    /// Radius of the lens, zero without a lens, and focus distance.
    thin_lens: [Real; 2],
}

impl Camera {
    /// The camera that `descriptor` describes, for pictures of `resolution`.
    ///
    /// # Errors
    ///
    /// * [`CameraError::Field`] for a field that is out of range.
    /// * [`CameraError::PositionIsTarget`] if there is no view direction.
    /// * [`CameraError::UpParallelToView`] if `up` does not determine the orientation.
    ///
    /// ```
    /// use strahl_core::scene::FilmPoint;
    /// use strahl_core::{Camera, CameraDescriptor, Resolution, Vec3, vec3};
    ///
    /// let descriptor = CameraDescriptor::perspective(vec3(0.0, 0.0, 5.0), Vec3::ZERO, 0.8);
    /// let camera = Camera::new(&descriptor, Resolution::new(4, 4).unwrap())?;
    /// assert_eq!(camera.ray(FilmPoint { x: 2.0, y: 2.0 }).direction, vec3(0.0, 0.0, -1.0));
    ///
    /// let wide = CameraDescriptor::perspective(Vec3::ZERO, Vec3::X, 4.0);
    /// let error = Camera::new(&wide, Resolution::new(4, 4).unwrap()).unwrap_err().to_string();
    /// assert_eq!(error, "`field_of_view` is 4, must be more than 0 and less than pi (radians)");
    /// # Ok::<(), strahl_core::scene::CameraError>(())
    /// ```
    pub fn new(descriptor: &CameraDescriptor, resolution: Resolution) -> Result<Self, CameraError> {
        let CameraDescriptor { position, target, up, projection } = *descriptor;
        FieldChecks::run(|fields| {
            fields.point(Field::Position, &position);
            fields.point(Field::Target, &target);
            projection.validate(fields);
        })?;
        let forward = try_normalize(target - position).ok_or(CameraError::PositionIsTarget)?;
        let up = try_normalize(up).ok_or(CameraError::UpParallelToView)?;
        let right = forward.cross(up);
        // If a few roundings could have made it, its direction is noise.
        if right.dot(right) <= 1e-10 {
            return Err(CameraError::UpParallelToView);
        }
        let right = try_normalize(right).ok_or(CameraError::UpParallelToView)?;
        let down = forward.cross(right);
        let rows = if resolution.height() > 1 { resolution.height() - 1 } else { 1 } as Real;
        let mut thin_lens = [0.0; 2];
        let (height, is_orthographic) = match projection {
            Projection::Perspective { field_of_view } => (film_height(field_of_view), false),
            Projection::ThinLens { field_of_view, lens_radius, focus_distance } => {
                thin_lens = [lens_radius, focus_distance];
                (film_height(field_of_view), false)
            }
            Projection::Orthographic { height } => (height, true),
        };
        let step = height / rows;
        Ok(Camera {
            position,
            forward,
            pixel_dx: right * step,
            pixel_dy: down * step,
            center: FilmPoint { x: 0.5 * resolution.width() as Real, y: 0.5 * resolution.height() as Real },
            is_orthographic,
            thin_lens,
        })
    }

    /// Whether the projection is a [`Projection::ThinLens`], so that only the plane of focus is sharp.
    pub fn has_depth_of_field(&self) -> bool {
        self.thin_lens[0] > 0.0
    }

    /// The ray through a point on the film and a point on the lens.
    ///
    /// `u`: point of the unit square that is mapped to the lens, (0.5, 0.5) to its center.
    pub(crate) fn thin_lens_ray(&self, point: FilmPoint, u: [Real; 2]) -> Ray {
        let [lens_radius, focus_distance] = self.thin_lens;
        let film_offset = self.film_offset(point);
        let [x, y] = sample_disc_concentric(u);
        let right = try_normalize(self.pixel_dx).unwrap_or(Vec3::ZERO);
        let down = try_normalize(self.pixel_dy).unwrap_or(Vec3::ZERO);
        let lens_offset = (right * x + down * y) * lens_radius;
        // All rays through one point on the film intersect in the plane of focus.
        let direction = (self.forward + film_offset) * focus_distance - lens_offset;
        Ray::new(self.position + lens_offset, try_normalize(direction).unwrap_or(self.forward))
    }

    /// The ray through a point on the film, and through the center of the lens if there is one. Its
    /// direction is a unit vector; its time is 0.
    pub fn ray(&self, point: FilmPoint) -> Ray {
        let film_offset = self.film_offset(point);
        if self.is_orthographic {
            Ray::with_near_unit_direction(self.position + film_offset, self.forward, 0.0)
        } else {
            let direction = try_normalize(self.forward + film_offset).unwrap_or(self.forward);
            Ray::with_near_unit_direction(self.position, direction, 0.0)
        }
    }

    /// Offset of a point on the film from the center of the picture.
    fn film_offset(&self, point: FilmPoint) -> Vec3 {
        self.pixel_dx * (point.x - self.center.x) + self.pixel_dy * (point.y - self.center.y)
    }
}

/// Height of the film at distance 1 for a vertical field of view.
fn film_height(field_of_view: Real) -> Real {
    2.0 * tan(0.5 * field_of_view)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{acos, vec3};
    use crate::scene::FieldError;

    const DESCRIPTOR: CameraDescriptor = CameraDescriptor {
        position: vec3(1.0, 2.0, 3.0),
        target: vec3(1.0, 2.0, -4.0),
        up: vec3(0.0, 5.0, 1.0),
        projection: Projection::Perspective { field_of_view: 0.8 },
    };

    fn point(x: Real, y: Real) -> FilmPoint {
        FilmPoint { x, y }
    }

    #[test]
    fn the_field_of_view_is_between_the_centers_of_the_first_and_the_last_row() {
        let camera = Camera::new(&DESCRIPTOR, Resolution::new(7, 5).unwrap()).unwrap();
        let (top, bottom) = (camera.ray(point(3.5, 0.5)), camera.ray(point(3.5, 4.5)));
        assert!((acos(top.direction.dot(bottom.direction)) - 0.8).abs() < 1e-6);
        assert!(top.direction.y > 0.0 && bottom.direction.y < 0.0);
        let center = camera.ray(point(3.5, 2.5));
        assert_eq!((center.origin, center.direction), (DESCRIPTOR.position, -Vec3::Z));
        assert!(camera.ray(point(6.5, 2.5)).direction.x > 0.0, "right is right");
    }

    #[test]
    fn the_height_is_between_the_origins_of_the_first_and_the_last_row() {
        let descriptor =
            CameraDescriptor { projection: Projection::Orthographic { height: 8.0 }, ..DESCRIPTOR };
        let camera = Camera::new(&descriptor, Resolution::new(5, 5).unwrap()).unwrap();
        let (top, bottom) = (camera.ray(point(2.5, 0.5)), camera.ray(point(2.5, 4.5)));
        assert_eq!(top.direction, bottom.direction);
        assert!((top.origin - bottom.origin - vec3(0.0, 8.0, 0.0)).abs().max_element() < 1e-5);
    }

    #[test]
    fn degenerate_cameras_are_errors() {
        let resolution = Resolution::new(4, 4).unwrap();
        let error = |descriptor: CameraDescriptor| Camera::new(&descriptor, resolution).unwrap_err();
        let field = |descriptor| match error(descriptor) {
            CameraError::Field(FieldError { field, .. }) => field,
            other => panic!("{other:?}"),
        };
        let with_up = |up| error(CameraDescriptor { up, ..DESCRIPTOR });
        assert_eq!(
            error(CameraDescriptor { target: DESCRIPTOR.position, ..DESCRIPTOR }),
            CameraError::PositionIsTarget
        );
        for up in [vec3(0.0, 0.0, 2.0), Vec3::ZERO, Vec3::splat(Real::NAN), vec3(0.0, Real::INFINITY, 0.0)] {
            assert_eq!(with_up(up), CameraError::UpParallelToView);
        }
        let invalid = vec3(Real::NAN, 0.0, 0.0);
        assert_eq!(field(CameraDescriptor { position: invalid, ..DESCRIPTOR }), Field::Position);
        assert_eq!(field(CameraDescriptor { target: vec3(0.0, 2e15, 0.0), ..DESCRIPTOR }), Field::Target);
        for field_of_view in [0.0, -1.0, PI, 4.0, Real::NAN] {
            let projection = Projection::Perspective { field_of_view };
            assert_eq!(field(CameraDescriptor { projection, ..DESCRIPTOR }), Field::FieldOfView);
        }
        for (lens_radius, focus_distance, wrong) in
            [(0.0, 1.0, Field::LensRadius), (1.0, Real::INFINITY, Field::FocusDistance)]
        {
            let projection = Projection::ThinLens { field_of_view: 0.5, lens_radius, focus_distance };
            assert_eq!(field(CameraDescriptor { projection, ..DESCRIPTOR }), wrong);
        }
        let projection = Projection::Orthographic { height: -1.0 };
        assert_eq!(field(CameraDescriptor { projection, ..DESCRIPTOR }), Field::Height);
        assert!(Resolution::new(0, 4).is_none() && Resolution::new(4, Resolution::MAX_SIDE + 1).is_none());
    }

    #[test]
    fn a_picture_of_one_row_or_one_column_has_finite_rays() {
        for (width, height) in [(1, 1), (1, 9), (9, 1)] {
            let camera = Camera::new(&DESCRIPTOR, Resolution::new(width, height).unwrap()).unwrap();
            assert!(camera.ray(point(0.0, 0.0)).direction.is_finite());
        }
    }
}
