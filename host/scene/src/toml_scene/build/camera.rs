//! How the scene is looked at, and what is chosen when the file does not say it.

use strahl_core::geometry::Aabb;
use strahl_core::math::try_normalize;
use strahl_core::scene::CameraError;
use strahl_core::{Camera, Resolution, Rgb, Vec3};

use super::builder::{DEFAULT_UP, DEFAULT_VIEW_ANGLE, SceneBuilder};
use crate::bounds::bounding_boxes;
use crate::description::{
    CameraDescription, LightDescription, LightSourceDescription, Located, ProjectionDescription, vec3_of,
};
use crate::diagnostics::Diagnostic;
use crate::framing::{CameraFrame, Vec3d, larger};
use crate::toml_scene::format::SceneFile;

/// From what is seen to the eye: from the front, a little from the right and from above.
const TO_EYE: Vec3d = [0.35, 0.3, 1.0];
/// The share of the picture's half side that may be taken, so that nothing touches its edge.
const FILL: f64 = 0.91;

impl SceneBuilder<'_> {
    /// The camera, and the light that comes with it when the file has none at all.
    pub fn camera(&mut self, file: &SceneFile) {
        let camera = file.camera.0.as_ref();
        let it = camera.map(|at| &at.value);
        let (from, at) = (it.and_then(|it| it.from.as_ref()), it.and_then(|it| it.at.as_ref()));
        let up = it.and_then(|it| it.up.as_ref());
        let angle = it.and_then(|it| it.angle.as_ref());
        let lens = it.and_then(|it| it.lens_radius.as_ref());
        let focus = it.and_then(|it| it.focus.as_ref());
        self.scene.camera_line = camera.map_or(1, |camera| self.lines.line_number(camera.span.start));
        let projection = match (it.and_then(|it| it.height.as_ref()), angle) {
            (Some(height), None) if lens.is_some() => {
                let fault =
                    Diagnostic::new(height.span.clone(), "a camera has either a lens or parallel rays");
                return self.reader.diagnostics.push(fault.with_help("a lens goes with an `angle`"));
            }
            (Some(height), None) => ProjectionDescription::Orthographic(height.value.0),
            (None, angle) => {
                ProjectionDescription::Perspective(angle.map_or(DEFAULT_VIEW_ANGLE, |angle| angle.value.0))
            }
            (Some(height), Some(angle)) => {
                let fault =
                    Diagnostic::new(height.span.clone(), "a camera has either an `angle` or a `height`");
                let fault = fault.with_related(angle.span.clone(), "the other");
                return self
                    .reader
                    .diagnostics
                    .push(fault.with_help("with a `height` all rays are parallel"));
            }
        };
        let mut view = CameraDescription {
            from: from.map_or([0.0, 0.0, 1.0], |from| from.value.0),
            at: at.map_or([0.0; 3], |at| at.value.0),
            up: up.map_or(DEFAULT_UP, |up| up.value.0),
            projection,
        };
        if let (Some(focus), None) = (focus, lens) {
            let fault = Diagnostic::new(focus.span.clone(), "a camera without `lens_radius` has no `focus`");
            return self.reader.diagnostics.push(fault.with_help("without a lens everything is sharp"));
        }
        // What is wrong may have left out what should be seen.
        if (from.is_none() || at.is_none()) && self.reader.diagnostics.total == 0 {
            self.frame_scene(&mut view, from.is_none(), at.is_none());
        }
        if let (Some(radius), ProjectionDescription::Perspective(angle)) = (lens, view.projection) {
            let way = vec3_of(view.at) - vec3_of(view.from);
            let distance = try_normalize(way).map_or(1.0, |toward| way.dot(toward));
            let focus = focus.map_or(distance, |focus| focus.value.0);
            view.projection = ProjectionDescription::Lens { angle, radius: radius.value.0, focus };
        }
        self.scene.camera = view;

        let size = Resolution::new(4, 3).unwrap_or(self.size);
        if let Err(fault) = Camera::new(&view.to_core(), size)
            && let Some(camera) = camera
        {
            let is_up = fault == CameraError::UpParallelToView;
            let at = at.map(|at| &at.span);
            let place = if is_up { up.map(|up| &up.span).or(at) } else { at };
            let place = place.or(from.map(|from| &from.span)).unwrap_or(&camera.span);
            let fault = Diagnostic::new(place.clone(), fault.to_string());
            self.reader.diagnostics.push(match (is_up, up) {
                (false, _) => {
                    fault.with_help("`from` and `at` must differ once they are rounded to single precision")
                }
                (true, None) => fault.with_help("`up` is [0, 1, 0] by default"),
                (true, Some(_)) => {
                    fault.with_help("without `up` it is [0, 1, 0]; any direction aslant of the view will do")
                }
            });
        }
        let is_lit = file.ambient_light.0.is_some()
            || !file.point_light.0.is_empty()
            || !file.directional_light.0.is_empty()
            || !file.spot_light.0.is_empty()
            || !file.sphere_light.0.is_empty()
            || !file.rectangle_light.0.is_empty();
        if !is_lit {
            self.scene.lights.push(default_light(&view));
        }
    }

    /// Moves the parts of the view that are free so that everything with an end is in the picture.
    fn frame_scene(&self, view: &mut CameraDescription, move_eye: bool, move_aim: bool) {
        let Some(mut boxes) = bounding_boxes(&self.scene) else { return };
        boxes.retain(|b| b.min.cmple(b.max).all());
        let whole = boxes.iter().fold(Aabb::EMPTY, |whole, b| whole.union(*b));
        // Of nothing, or of a point, the surroundings are shown.
        let is_something = whole.min.cmple(whole.max).all() && whole.min != whole.max;
        let middle = if whole.is_empty() { Vec3::ZERO } else { 0.5 * whole.min + 0.5 * whole.max };
        if !is_something {
            boxes = vec![Aabb { min: middle - Vec3::ONE, max: middle + Vec3::ONE }];
        }
        if move_aim {
            view.at = middle.to_array();
        }
        if move_eye {
            let angle = match view.projection {
                ProjectionDescription::Perspective(angle) | ProjectionDescription::Lens { angle, .. } => {
                    angle
                }
                // The height says how much is seen; the eye only must be outside.
                ProjectionDescription::Orthographic(_) => DEFAULT_VIEW_ANGLE,
            };
            let size = self.scene.settings.size.unwrap_or(self.size);
            let gaze = CameraFrame::new(TO_EYE, view.up.map(f64::from), f64::from(angle), FILL, size);
            let aim = view.at.map(f64::from);
            let corners = boxes.iter().flat_map(corners_of);
            let demands = gaze.edge_distances(aim, corners);
            // Never inside of things, however narrow they are seen.
            let reach = 0.1 * f64::from((whole.max - whole.min).max_element());
            let distance = larger(demands.max_distance(), demands.nearest + reach);
            let [.., back] = gaze.axes();
            let from = [0, 1, 2].map(|i| (aim[i] + distance * back[i]) as f32);
            view.from = from.map(|x| if x.is_finite() { x } else { 0.0 });
        }
    }
}

/// White light from behind the eye, from above and from the left.
fn default_light(view: &CameraDescription) -> Located<LightDescription> {
    let back = try_normalize(vec3_of(view.from) - vec3_of(view.at)).unwrap_or(Vec3::Z);
    let up = try_normalize(vec3_of(view.up)).unwrap_or(Vec3::Y);
    let left = try_normalize(back.cross(up)).unwrap_or(-Vec3::X);
    let toward = back + up * 0.8 + left * 0.6;
    let source = LightSourceDescription::Directional { to_light: toward.to_array() };
    let it = LightDescription { source, color: Rgb::WHITE, shadows: true };
    Located { value: it, line: 0, name: Some("default".into()) }
}

/// The corners of a box.
fn corners_of(it: &Aabb) -> impl Iterator<Item = Vec3d> + use<> {
    let ends = [it.min.to_array(), it.max.to_array()].map(|end| end.map(f64::from));
    (0..8).map(move |corner: usize| [0, 1, 2].map(|axis| ends[corner >> axis & 1][axis]))
}
