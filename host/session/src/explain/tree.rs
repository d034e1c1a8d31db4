//! The explanation of one pixel. Its fields are those of `explain --json`, in this order.
//!
//! Colors, shares and weights are linear RGB; lengths are in scene units. Numbers have the shortest form that reads back
//! exactly, so that every sum can be recomputed.

use serde::{Serialize, Serializer};
use strahl_core::{Rgb, Vec3};
use strahl_scene::description::Float3;
use strahl_settings::{Group, SETTINGS, Setting, Settings};

/// Groups of the settings that determine the color of a pixel.
pub const SETTING_GROUPS: &[Group] = &[Group::Frame, Group::Sampling, Group::Effects];

/// The version of this format; it increases when a field is removed or changes its meaning.
pub const VERSION: u32 = 1;

/// The color of one pixel, and all rays that contribute to it.
#[derive(Debug, Serialize)]
pub struct PixelExplanation {
    /// [`VERSION`].
    pub version: u32,
    /// The scene file.
    pub scene: String,
    /// Width of the picture.
    pub width: u32,
    /// Height of the picture.
    pub height: u32,
    /// Column of the pixel, from 0 at the left.
    pub x: u32,
    /// Row of the pixel, from 0 at the top.
    pub y: u32,
    /// The settings that determine it: [`explained_settings`].
    #[serde(serialize_with = "serialize_settings")]
    pub settings: Settings,
    /// The color of the pixel.
    pub color: Float3,
    /// The color in 8-bit sRGB.
    pub srgb: [u8; 3],
    /// How the samples are combined.
    pub sum: SampleSum,
    /// The samples, in the order in which they are traced.
    pub samples: Vec<SampleRecord>,
}

/// The settings that are part of an explanation: those of [`SETTING_GROUPS`] that have an option.
pub fn explained_settings() -> impl Iterator<Item = &'static Setting> {
    SETTINGS
        .iter()
        .filter(|setting| SETTING_GROUPS.contains(&setting.group) && setting.option_name().is_some())
}

fn serialize_settings<S: Serializer>(settings: &Settings, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(explained_settings().map(|setting| (setting.name, setting.to_json(settings))))
}

/// How the samples of a pixel are combined.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SampleSum {
    /// The sum of the samples, in order, times `share`.
    Mean {
        /// One divided by the number of samples.
        share: f32,
    },
    /// The sum over subpixels, in order, of the mean of four samples times the area:
    /// `(((a + b) + (c + d)) * 0.25) * (side * side)`.
    Parts(Vec<SubpixelRecord>),
}

/// A square part of a pixel, with one sample at each corner.
#[derive(Debug, Serialize)]
pub struct SubpixelRecord {
    /// Left edge, in pixels from the left edge of the picture.
    pub x: f32,
    /// Upper edge, in pixels from the upper edge of the picture.
    pub y: f32,
    /// Side length, in pixels.
    pub side: f32,
    /// Numbers of the samples at the corners: upper left, upper right, lower left, lower right.
    pub samples: [usize; 4],
}

/// A camera ray and all rays that follow from it.
#[derive(Debug, Serialize)]
pub struct SampleRecord {
    /// Counted from 1.
    pub number: usize,
    /// Film position, in pixels from the left edge of the picture.
    pub x: f32,
    /// Film position, in pixels from the upper edge.
    pub y: f32,
    /// The sum of the contributions of its rays, in order.
    pub color: Float3,
    /// All rays, in the order in which they are traced: a ray precedes its secondary rays.
    pub rays: Vec<RayRecord>,
}

/// A ray.
#[derive(Debug, Default, Serialize)]
pub struct RayRecord {
    /// Counted from 1.
    pub number: usize,
    /// Number of the ray that it starts from; `None` for the camera ray.
    pub parent: Option<usize>,
    /// `camera`, `reflected` or `transmitted`.
    pub kind: &'static str,
    /// The camera ray has level 1.
    pub level: u8,
    /// Origin.
    pub origin: Float3,
    /// Direction, of unit length.
    pub direction: Float3,
    /// Weight in the sample at the origin.
    pub weight: Float3,
    /// The hit; `None` for the background.
    pub hit: Option<HitRecord>,
    /// Weight in the sample at the hit: `weight`, attenuated by the medium.
    pub weight_there: Float3,
    /// Ambient light reflected by the surface.
    pub ambient: Option<Float3>,
    /// The lights, in the order of the file.
    pub lights: Vec<LightRecord>,
    /// The background, or ambient plus the contributions of the lights, in this order.
    pub light: Float3,
    /// Contribution to the sample: `weight_there * light`.
    pub adds: Float3,
    /// Whether the surface reflects totally where it would transmit.
    pub total_reflection: bool,
    /// Secondary rays from the hit, traced or not.
    pub sends: Vec<SecondaryRayRecord>,
}

/// A surface that a ray hits.
#[derive(Debug, Serialize)]
pub struct HitRecord {
    /// The item.
    #[serde(flatten)]
    pub item: ItemRecord,
    /// Distance from the origin of the ray.
    pub distance: f32,
    /// Position.
    pub point: Float3,
    /// Whether the ray comes from the side that the normal points to.
    pub outside: bool,
    /// Material of the medium between origin and hit, if there is one.
    pub within: Option<NameAndLine>,
    /// Transmittance of that medium.
    pub left: Float3,
    /// Whether the surface is inside a body of higher priority; the ray then continues unchanged.
    pub hidden: bool,
}

/// An item of the scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ItemRecord {
    /// Index in the order of the file, from 0; every triangle of a mesh counts as one.
    pub object: u32,
    /// Shape.
    pub shape: &'static str,
    /// Index of a triangle in its mesh, from 0.
    pub triangle: Option<u32>,
    /// Line in the scene file, from 1; 0 if the format has no lines.
    pub line: u32,
    /// Material.
    pub material: NameAndLine,
}

/// The name and line of an element of the scene file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NameAndLine {
    /// Name, if the file gives one.
    pub name: Option<String>,
    /// Line in the scene file, from 1; 0 if it has none.
    pub line: u32,
}

/// The contribution of a light at a hit.
#[derive(Debug, Serialize)]
pub struct LightRecord {
    /// Index in the scene, from 0.
    pub number: u16,
    /// Name and line.
    #[serde(flatten)]
    pub named: NameAndLine,
    /// `seen`, or why it contributes nothing: `blocked`; `behind`: the surface faces away; `dark`: the light does not
    /// illuminate this point; `unseen`: its highlight is in another direction.
    pub outcome: &'static str,
    /// Unit vector towards the light, if it is visible.
    pub toward: Option<Float3>,
    /// Distance of the light, if it is visible and has a position.
    pub distance: Option<f32>,
    /// Light that arrives at a surface perpendicular to it.
    pub arrives: Option<Float3>,
    /// Light that the surface reflects towards the ray origin.
    pub adds: Option<Float3>,
    /// Surfaces that transmit the light, nearest first.
    pub through: Vec<TransmissionRecord>,
    /// The occluder.
    #[serde(rename = "blocker")]
    pub occluder: Option<OccluderRecord>,
}

/// A surface that transmits light along a shadow ray.
#[derive(Debug, Serialize)]
pub struct TransmissionRecord {
    /// The item.
    #[serde(flatten)]
    pub item: ItemRecord,
    /// Distance from the origin of the shadow ray.
    pub distance: f32,
    /// Transmittance of all surfaces up to this one.
    pub share: Float3,
}

/// The nearest occluder along a shadow ray.
#[derive(Debug, Serialize)]
pub struct OccluderRecord {
    /// The item.
    #[serde(flatten)]
    pub item: ItemRecord,
    /// Distance from the origin of the shadow ray.
    pub distance: f32,
}

/// A secondary ray from a hit, traced or not.
#[derive(Debug, Serialize)]
pub struct SecondaryRayRecord {
    /// `reflected` or `transmitted`.
    pub kind: &'static str,
    /// Factor of the light that arrives along it.
    pub share: Float3,
    /// Weight in the sample: `weight_there * share`.
    pub weight: Float3,
    /// Number of the ray, if it is traced.
    pub ray: Option<usize>,
    /// Why it is not traced: `cutoff` or `levels`.
    pub cut: Option<&'static str>,
}

impl RayRecord {
    /// Whether the ray has no secondary rays.
    pub fn is_leaf(&self) -> bool {
        self.sends.is_empty()
    }
}

/// The channels of a color.
pub fn rgb_array(color: Rgb) -> Float3 {
    [color.r, color.g, color.b]
}

/// The coordinates of a vector.
pub fn xyz_array(v: Vec3) -> Float3 {
    v.to_array()
}
