//! Keys of other programs, and the keys that they correspond to.
//!
//! The words are those of pbrt, Mitsuba, POV-Ray, Blender, three.js and glTF. A word whose value has the same type and unit
//! may be an alias of a key instead, declared with the key.

/// Words of other programs for keys of some tables.
pub struct Hint {
    /// The tables that it applies to; the root table has an empty name.
    pub tables: &'static [&'static str],
    /// The words, separated by spaces, in the form of [`normalized`](super::suggest::normalized).
    pub words: &'static str,
    /// The suggested keys, separated by spaces; only those of the table are suggested.
    pub keys: &'static str,
    /// A remark, such as a different unit; may be empty.
    pub note: &'static str,
}

const ROOT: &[&str] = &[""];
const CAMERA: &[&str] = &["camera"];
const AIMED: &[&str] = &["camera", "spot_light", "rectangle_light"];
const RENDER: &[&str] = &["render"];
const BACKGROUND: &[&str] = &["background"];
const LIGHTS: &[&str] =
    &["ambient_light", "point_light", "directional_light", "spot_light", "sphere_light", "rectangle_light"];
const SPOT: &[&str] = &["spot_light"];
const MATERIAL: &[&str] = &["material"];
const TEXTURES: &[&str] = &["checker", "gradient", "zone_plate"];
const OBJECTS: &[&str] =
    &["sphere", "plane", "disc", "triangle", "polygon", "box", "cylinder", "cone", "torus", "mesh"];
const PLANES: &[&str] = &["plane", "disc", "torus"];
const CONES: &[&str] = &["cylinder", "cone"];
const NAMED: &[&str] =
    &["point_light", "directional_light", "spot_light", "sphere_light", "rectangle_light", "material"];

const ALL_LIGHTS: &str = "point_light directional_light spot_light sphere_light rectangle_light";
const DEGREES: &str = "It is the full angle in degrees.";
const OPPOSITE: &str = "It has the opposite value.";

const fn hint(
    tables: &'static [&'static str],
    words: &'static str,
    keys: &'static str,
    note: &'static str,
) -> Hint {
    Hint { tables, words, keys, note }
}

/// All hints; the first that applies is used.
#[rustfmt::skip]
pub const HINTS: &[Hint] = &[
    hint(ROOT, "bg backdrop environment backgroundcolor sky skycolor world", "background", ""),
    hint(ROOT, "globalambient ambient", "ambient_light", ""),
    hint(ROOT, "light lights", ALL_LIGHTS, ""),
    hint(ROOT, "sun distantlight infinitelight", "directional_light", ""),
    hint(ROOT, "point omni", "point_light", ""),
    hint(ROOT, "spot", "spot_light", ""),
    hint(ROOT, "arealight", "rectangle_light sphere_light", ""),
    hint(ROOT, "quadlight rectlight", "rectangle_light", ""),
    hint(ROOT, "cube cuboid block aabb rect3", "box", ""),
    hint(ROOT, "obj ply gltf trimesh shape model", "mesh", ""),
    hint(ROOT, "disk circle", "disc", ""),
    hint(ROOT, "donut", "torus", ""),
    hint(ROOT, "floor ground infiniteplane", "plane", ""),
    hint(ROOT, "prism quad rectangle", "polygon box", ""),
    hint(ROOT, "settings", "render", ""),
    hint(ROOT, "view viewpoint", "camera", ""),
    hint(CAMERA, "origin location cameraposition lookfrom", "from", ""),
    hint(AIMED, "target center focuspoint pointat", "at", ""),
    hint(CAMERA, "vfov fovy fieldofview viewangle angleofview", "angle", "It is the full vertical angle in degrees."),
    hint(CAMERA, "yfov", "angle", "It is in degrees, not in radians as in glTF."),
    hint(CAMERA, "sky vup upvector", "up", ""),
    hint(CAMERA, "ortho orthographic ymag orthoscale", "height", ""),
    hint(CAMERA, "aperture apertureradius", "lens_radius", ""),
    hint(CAMERA, "fstop", "lens_radius", "It is a length, not an f-number."),
    hint(CAMERA, "focallength", "focus", "It is the focus distance, not the focal length."),
    hint(CAMERA, "exposure shutteropen shutterclose shuttertime", "shutter", ""),
    hint(RENDER, "resolution width height imagesize xresolution yresolution", "size", ""),
    hint(RENDER, "depth maxtracelevel maxlevel recursion", "levels", ""),
    hint(RENDER, "bounces maxbounces", "levels", "The camera ray is level 1, so it is the number of bounces + 1."),
    hint(RENDER, "adcbailout minweight threshold mincontribution", "cutoff", ""),
    hint(RENDER, "samples spp samplesperpixel pixelsamples antialiasing aa", "sampler", "Write \"stochastic:N\" for N samples."),
    hint(RENDER, "accelerator acceleration bvh", "accel", ""),
    hint(RENDER, "traversal", "walk", ""),
    hint(RENDER, "transparentshadows shadowcolor", "colored_shadows", ""),
    hint(BACKGROUND, "bottom horizon groundcolor", "below", ""),
    hint(BACKGROUND, "top zenith skycolor", "above", ""),
    hint(LIGHTS, "pos location from center origin", "position", ""),
    hint(LIGHTS, "energy power strength brightness scale multiplier", "intensity", ""),
    hint(LIGHTS, "emission emissive emit radiance rgb", "color", ""),
    hint(LIGHTS, "attenuation decay fade fadepower fadedistance", "falloff", ""),
    hint(SPOT, "coneangle spotsize outerangle outerconeangle falloffangle cutoffangle", "angle", DEGREES),
    hint(SPOT, "innerangle innerconeangle penumbra conedeltaangle spotblend hotspot", "bright_angle", DEGREES),
    hint(LIGHTS, "castshadows shadow castsshadow", "shadows", ""),
    hint(LIGHTS, "shadowless noshadow", "shadows", OPPOSITE),
    hint(MATERIAL, "emission emissive emittance glow", "", "Objects do not emit light: add a light."),
    hint(MATERIAL, "albedo basecolor diffusecolor pigment kd reflectance rgb", "color", ""),
    hint(MATERIAL, "lambert", "diffuse", ""),
    hint(MATERIAL, "ka", "ambient", ""),
    hint(MATERIAL, "specular gloss ks phong specularcolor", "highlight", ""),
    hint(MATERIAL, "exponent glossiness phongsize specularexponent ns hardness phongexponent", "shininess", ""),
    hint(MATERIAL, "reflective kr metallic metalness", "mirror", ""),
    hint(MATERIAL, "opacity alpha", "transmission", "It is 1 - opacity."),
    hint(MATERIAL, "refraction transparency transmittance kt transmissionfactor", "transmission", ""),
    hint(MATERIAL, "refractiveindex eta indexofrefraction refractionindex", "index", ""),
    hint(MATERIAL, "absorption interior sigmaa extinction", "clarity", "It is a length: 1 / absorption coefficient."),
    hint(MATERIAL, "attenuationlength fadedistance", "clarity", ""),
    hint(MATERIAL, "doublesided twosided", "one_sided", OPPOSITE),
    hint(MATERIAL, "texture pattern map", "checker gradient zone_plate", ""),
    hint(MATERIAL, "checkerboard checkered", "checker", ""),
    hint(TEXTURES, "color1 colora a", "even from", ""),
    hint(TEXTURES, "color2 colorb b", "odd to", ""),
    hint(OBJECTS, "position location pos translate origin", "center base point translate", ""),
    hint(OBJECTS, "diameter", "radius", "It is half of the diameter."),
    hint(&["torus"], "major majorradius", "radius", ""),
    hint(&["torus"], "minor minorradius tuberadius", "tube", ""),
    hint(OBJECTS, "r rad", "radius", ""),
    hint(PLANES, "up direction n", "normal axis", ""),
    hint(&["plane"], "distance offset d", "point", ""),
    hint(&["box"], "dimensions extent scale width", "size", ""),
    hint(CONES, "top apex tip p1 height", "end", ""),
    hint(CONES, "bottom p0 start", "base", ""),
    hint(&["cone"], "topradius capradius radiustop radius2", "end_radius", ""),
    hint(&["cone"], "baseradius radiusbottom radius1", "radius", ""),
    hint(CONES, "capped closed caps solid", "open", OPPOSITE),
    hint(OBJECTS, "vertices points verts positions p", "corners", ""),
    hint(OBJECTS, "vertexnormals n", "normals", ""),
    hint(OBJECTS, "filename path src url model", "file", ""),
    hint(OBJECTS, "rotation euler angles orientation", "rotate", ""),
    hint(OBJECTS, "offset move", "translate", ""),
    hint(OBJECTS, "scaling size", "scale", ""),
    hint(OBJECTS, "speed motion motionvector displacement", "velocity", ""),
    hint(NAMED, "id label title", "name", ""),
];
