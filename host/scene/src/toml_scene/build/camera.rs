//! The camera, with defaults that show the whole scene.

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

/// The default direction from the scene to the camera: in front, slightly right and above.
const TO_CAMERA: Vec3d = [0.35, 0.3, 1.0];
/// The share of the half picture that the scene may fill, so that nothing touches its edge.
const FILL: f64 = 0.91;

impl SceneBuilder<'_> {
    /// Adds the camera, and a default light if the file has no light.
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
                let diagnostic =
                    Diagnostic::new(height.span.clone(), "an orthographic camera cannot have a lens");
                return self.reader.diagnostics.push(diagnostic.with_help("use `angle` with a lens"));
            }
            (Some(height), None) => ProjectionDescription::Orthographic(height.value.0),
            (None, angle) => {
                ProjectionDescription::Perspective(angle.map_or(DEFAULT_VIEW_ANGLE, |angle| angle.value.0))
            }
            (Some(height), Some(angle)) => {
                let diagnostic =
                    Diagnostic::new(height.span.clone(), "a camera has either `angle` or `height`");
                let diagnostic = diagnostic.with_related(angle.span.clone(), "the other one");
                return self
                    .reader
                    .diagnostics
                    .push(diagnostic.with_help("`height` makes the camera orthographic"));
            }
        };
        let mut view = CameraDescription {
            from: from.map_or([0.0, 0.0, 1.0], |from| from.value.0),
            at: at.map_or([0.0; 3], |at| at.value.0),
            up: up.map_or(DEFAULT_UP, |up| up.value.0),
            projection,
        };
        if let (Some(focus), None) = (focus, lens) {
            let diagnostic = Diagnostic::new(focus.span.clone(), "`focus` requires `lens_radius`");
            return self
                .reader
                .diagnostics
                .push(diagnostic.with_help("without a lens everything is in focus"));
        }
        // After an error, objects may be missing.
        if (from.is_none() || at.is_none()) && self.reader.diagnostics.total == 0 {
            self.frame_scene(&mut view, from.is_none(), at.is_none());
        }
        if let (Some(radius), ProjectionDescription::Perspective(angle)) = (lens, view.projection) {
            let direction = vec3_of(view.at) - vec3_of(view.from);
            let distance = try_normalize(direction).map_or(1.0, |toward| direction.dot(toward));
            let focus = focus.map_or(distance, |focus| focus.value.0);
            view.projection = ProjectionDescription::Lens { angle, radius: radius.value.0, focus };
        }
        self.scene.camera = view;

        let size = Resolution::new(4, 3).unwrap_or(self.size);
        if let Err(diagnostic) = Camera::new(&view.to_core(), size)
            && let Some(camera) = camera
        {
            let is_up = diagnostic == CameraError::UpParallelToView;
            let at = at.map(|at| &at.span);
            let place = if is_up { up.map(|up| &up.span).or(at) } else { at };
            let place = place.or(from.map(|from| &from.span)).unwrap_or(&camera.span);
            let diagnostic = Diagnostic::new(place.clone(), diagnostic.to_string());
            self.reader.diagnostics.push(match (is_up, up) {
                (false, _) => diagnostic
                    .with_help("`from` and `at` must differ once they are rounded to single precision"),
                (true, None) => diagnostic.with_help("`up` is [0, 1, 0] by default"),
                (true, Some(_)) => diagnostic.with_help(
                    "`up` must not be parallel to the viewing direction; the default is [0, 1, 0]",
                ),
            });
        }
        // The lights of the file have been added before the camera.
        if file.ambient_light.0.is_none() && self.scene.lights.is_empty() {
            self.scene.lights.push(default_light(&view));
        }
    }

    /// Sets the position and the target of the camera, if not given, so that all bounded objects are in the picture.
    fn frame_scene(&self, view: &mut CameraDescription, move_position: bool, move_target: bool) {
        let Some(mut boxes) = bounding_boxes(&self.scene) else { return };
        boxes.retain(|b| b.min.cmple(b.max).all());
        let whole = boxes.iter().fold(Aabb::EMPTY, |whole, b| whole.union(*b));
        // Without bounded objects, or for a single point, show a box of side 2.
        let is_something = whole.min.cmple(whole.max).all() && whole.min != whole.max;
        let center = if whole.is_empty() { Vec3::ZERO } else { 0.5 * whole.min + 0.5 * whole.max };
        if !is_something {
            boxes = vec![Aabb { min: center - Vec3::ONE, max: center + Vec3::ONE }];
        }
        if move_target {
            view.at = center.to_array();
        }
        if move_position {
            let angle = match view.projection {
                ProjectionDescription::Perspective(angle) | ProjectionDescription::Lens { angle, .. } => {
                    angle
                }
                // The height determines the visible part; the camera only has to be outside.
                ProjectionDescription::Orthographic(_) => DEFAULT_VIEW_ANGLE,
            };
            let size = self.scene.settings.size.unwrap_or(self.size);
            let frame = CameraFrame::new(TO_CAMERA, view.up.map(f64::from), f64::from(angle), FILL, size);
            let target = view.at.map(f64::from);
            let corners = boxes.iter().flat_map(corners_of);
            let distances = frame.edge_distances(target, corners);
            // Never inside objects, even if they are viewed edge-on.
            let margin = 0.1 * f64::from((whole.max - whole.min).max_element());
            let distance = larger(distances.max_distance(), distances.nearest + margin);
            let [.., back] = frame.axes();
            let from = [0, 1, 2].map(|i| (target[i] + distance * back[i]) as f32);
            view.from = from.map(|x| if x.is_finite() { x } else { 0.0 });
        }
    }
}

/// A white directional light from behind the camera, above and left of it.
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
