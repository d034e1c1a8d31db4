//! Why a ray was sent.

/// Why a ray was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayKind {
    /// From the eye, through the picture.
    Camera,
    /// From a mirror, or thrown back inside glass.
    Reflected,
    /// Through glass.
    Transmitted,
    /// Towards a light.
    Shadow,
}

impl RayKind {
    /// Every kind.
    pub const ALL: [RayKind; 4] =
        [RayKind::Camera, RayKind::Reflected, RayKind::Transmitted, RayKind::Shadow];

    /// Its name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            RayKind::Camera => "camera",
            RayKind::Reflected => "reflected",
            RayKind::Transmitted => "transmitted",
            RayKind::Shadow => "shadow",
        }
    }
}

/// Whether a ray is sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayOutcome {
    /// It is.
    Sent,
    /// Too little of what it finds would count.
    BelowCutoff,
    /// The levels end here.
    LevelLimit,
}
