//! The tree of rays of one pixel, as it is told: field by field what `--json` prints.
//!
//! Colours, shares and weights are linear, red, green and blue; lengths are those of the scene.
//! Numbers have the shortest form that is read back exactly, so that every sum can be done again.

use serde::{Serialize, Serializer};
use strahl_core::{Rgb, Vec3};
use strahl_settings::{Group, SETTINGS, Setting, Settings};

/// Groups of the settings that determine the color of a pixel.
pub const SETTING_GROUPS: &[Group] = &[Group::Frame, Group::Sampling, Group::Effects];

/// The version of the form of all this; it grows when a field changes its meaning or goes.
pub const VERSION: u32 = 1;

/// A colour, a share or a weight.
pub type Triple = [f32; 3];

/// How one pixel comes about.
#[derive(Debug, Serialize)]
pub struct PixelExplanation {
    /// Of this form.
    pub version: u32,
    /// The scene file.
    pub scene: String,
    /// Width of the picture.
    pub width: u32,
    /// Its height.
    pub height: u32,
    /// Column of the pixel, from 0 at the left.
    pub x: u32,
    /// Row, from 0 at the top.
    pub y: u32,
    /// The settings that make it.
    #[serde(serialize_with = "serialize_settings")]
    pub settings: Settings,
    /// Its colour.
    pub color: Triple,
    /// The same in eight bits of sRGB.
    pub srgb: [u8; 3],
    /// How its colour comes of the samples.
    pub sum: SampleSum,
    /// The rays through the picture, in their order.
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

/// How the colour of a pixel comes of its samples.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SampleSum {
    /// Their sum, in their order, times this share.
    Mean {
        /// One over their number.
        share: f32,
    },
    /// The sum over these parts, in their order, of the mean of four samples times the square of
    /// the side: `(((a + b) + (c + d)) * 0.25) * (side * side)`.
    Parts(Vec<SubpixelRecord>),
}

/// A square part of a pixel.
#[derive(Debug, Serialize)]
pub struct SubpixelRecord {
    /// Its left edge, in the picture.
    pub x: f32,
    /// Its upper edge.
    pub y: f32,
    /// Its side; the pixel's is 1.
    pub side: f32,
    /// The samples at its corners, by their numbers: upper left, upper right, lower left, lower
    /// right.
    pub samples: [usize; 4],
}

/// A ray through the picture, and all that comes of it.
#[derive(Debug, Serialize)]
pub struct SampleRecord {
    /// Counted from 1.
    pub number: usize,
    /// Where it goes through the picture, in pixels from its left edge.
    pub x: f32,
    /// From its upper edge.
    pub y: f32,
    /// The sum of what its rays add, in their order.
    pub color: Triple,
    /// The camera ray, and all that are sent from where it arrives, in the order in which they are
    /// followed: each stands before those that it sends.
    pub rays: Vec<RayRecord>,
}

/// A ray.
#[derive(Debug, Default, Serialize)]
pub struct RayRecord {
    /// Counted from 1.
    pub number: usize,
    /// The one that has sent it; none has sent the camera ray.
    pub parent: Option<usize>,
    /// `camera`, `reflected` or `transmitted`.
    pub kind: &'static str,
    /// The camera ray has level 1.
    pub level: u8,
    /// Where it starts.
    pub origin: Triple,
    /// Where it goes, of length one.
    pub direction: Triple,
    /// How much of what it finds counts in the sample, when it starts.
    pub weight: Triple,
    /// What it meets, if not the background.
    pub hit: Option<HitRecord>,
    /// How much of what it finds there counts in the sample: what the way leaves of its weight.
    pub weight_there: Triple,
    /// The surface's share of the light from everywhere.
    pub ambient: Option<Triple>,
    /// What comes of each light that was looked at, in the order of the file.
    pub lights: Vec<LightRecord>,
    /// What it brings by itself: the background, or ambient plus what the lights add, in this order.
    pub light: Triple,
    /// What it adds to the sample: `weight_there * light`.
    pub adds: Triple,
    /// Whether light that would go through the surface is thrown back as a whole.
    pub total_reflection: bool,
    /// The rays that go on from there, sent or cut.
    pub sends: Vec<SecondaryRayRecord>,
}

/// A surface that a ray meets.
#[derive(Debug, Serialize)]
pub struct HitRecord {
    /// What.
    #[serde(flatten)]
    pub thing: ItemRecord,
    /// How far away.
    pub distance: f32,
    /// Where.
    pub point: Triple,
    /// Whether on the outer side, to which the normal points.
    pub outside: bool,
    /// What fills space on the way there, where something does.
    pub within: Option<NameAndLine>,
    /// What the way there leaves of light.
    pub left: Triple,
    /// Whether the surface lies hidden inside a body of higher priority.
    pub hidden: bool,
}

/// An item of the scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ItemRecord {
    /// Its number, in the order of the file, from 0; every triangle of a mesh counts as one.
    pub object: u32,
    /// Its shape.
    pub shape: &'static str,
    /// The number of a triangle in its mesh, from 0.
    pub triangle: Option<u32>,
    /// Its line in the scene file; of a model without lines, 0.
    pub line: u32,
    /// What it is made of.
    pub material: NameAndLine,
}

/// Something with a line, and a name where the file gives it one.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NameAndLine {
    /// Its name.
    pub name: Option<String>,
    /// Its line in the scene file; 0 where it has none.
    pub line: u32,
}

/// What comes of a light at a surface.
#[derive(Debug, Serialize)]
pub struct LightRecord {
    /// Its place in the scene, from 0.
    pub number: u16,
    /// Its name and line.
    #[serde(flatten)]
    pub named: NameAndLine,
    /// `seen`, or why not: `blocked`; `behind`, where the surface faces away; `dark`, where the
    /// light does not shine; `unseen`, where a mirror would show it in another direction.
    pub outcome: &'static str,
    /// Towards it, of length one, where it is seen.
    pub toward: Option<Triple>,
    /// How far away it is, where it is seen and has a place.
    pub distance: Option<f32>,
    /// What arrives on a surface that faces it.
    pub arrives: Option<Triple>,
    /// What the surface sends of it along the ray.
    pub adds: Option<Triple>,
    /// Through what its light comes.
    pub through: Vec<TransmissionRecord>,
    /// What stands in its way.
    pub blocker: Option<OccluderRecord>,
}

/// A surface that light passes on its way from a light.
#[derive(Debug, Serialize)]
pub struct TransmissionRecord {
    /// Which.
    #[serde(flatten)]
    pub thing: ItemRecord,
    /// How far away from where the light is looked for.
    pub distance: f32,
    /// What has come through everything up to here.
    pub share: Triple,
}

/// What stands in the way of a light.
#[derive(Debug, Serialize)]
pub struct OccluderRecord {
    /// The nearest.
    #[serde(flatten)]
    pub thing: ItemRecord,
    /// How far away from where the light is looked for.
    pub distance: f32,
}

/// A ray that goes on from a surface.
#[derive(Debug, Serialize)]
pub struct SecondaryRayRecord {
    /// `reflected` or `transmitted`.
    pub kind: &'static str,
    /// Its share of the light that arrives along it.
    pub share: Triple,
    /// How much of what it finds would count: `weight_there * share`.
    pub weight: Triple,
    /// Its number, if it is sent.
    pub ray: Option<usize>,
    /// Why it is not sent: `cutoff` or `levels`.
    pub cut: Option<&'static str>,
}

impl RayRecord {
    /// Whether the surface is made of what lets light through or mirrors it, or the ray ends here.
    pub fn is_leaf(&self) -> bool {
        self.sends.is_empty()
    }
}

/// The channels of a colour.
pub fn rgb_array(color: Rgb) -> Triple {
    [color.r, color.g, color.b]
}

/// The coordinates of a vector.
pub fn xyz_array(v: Vec3) -> Triple {
    v.to_array()
}
