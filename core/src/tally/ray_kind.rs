//! Kinds of rays, and whether a secondary ray is sent.

/// Where a ray comes from: the camera, a reflection, a transmission, or a surface, towards a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// A primary ray, from the camera through a point of the film.
    Camera,
    /// Reflected by a surface, specular, Fresnel or total internal reflection.
    Reflected,
    /// Transmitted through a surface, refracted or straight on.
    Transmitted,
    /// From a surface to a light.
    Shadow,
}

impl RayKind {
    /// All kinds, in the order of their declaration.
    pub const ALL: [RayKind; 4] =
        [RayKind::Camera, RayKind::Reflected, RayKind::Transmitted, RayKind::Shadow];

    /// Lowercase name: `camera`, `reflected`, `transmitted` or `shadow`.
    pub const fn name(self) -> &'static str {
        match self {
            RayKind::Camera => "camera",
            RayKind::Reflected => "reflected",
            RayKind::Transmitted => "transmitted",
            RayKind::Shadow => "shadow",
        }
    }
}

/// Whether a secondary ray is sent, and if not, why.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayOutcome {
    /// The ray is sent.
    Sent,
    /// Not sent: its weight is not above [`Limits::cutoff`](crate::trace::Limits::cutoff).
    BelowCutoff,
    /// Not sent: its level would exceed [`Limits::levels`](crate::trace::Limits::levels).
    LevelLimit,
}
