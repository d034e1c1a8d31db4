//! The owned tables that a scene borrows from, made of a [`Description`] for either precision.
//!
//! Both cores compile the same sources, so one macro makes the stock of both: every number of
//! the description, which is single precision, is widened first, and everything derived (units,
//! planes of polygons, axes of cones) is computed in the core's own precision.
//!
//! [`Description`]: crate::description::Description

macro_rules! stock {
    ($(#[$doc:meta])* $precision:ident, $core:ident) => {
        $(#[$doc])*
        pub mod $precision {
            use $core::{
                Background, Cone, Falloff, Geometry, Interface, Light, Material, MaterialId, PI, Parts,
                Polygon, Projection, Real, Rgb, Scene, SceneError, Shape, Source, Sphere, Texture, Vec3,
                View, unit, vec3,
            };

            use crate::description::{self, Description, Form, Object, Triple};

            /// The tables of a scene.
            #[derive(Clone, Debug, Default)]
            pub struct Stock {
                shapes: Vec<Shape>,
                points: Vec<Vec3>,
                normals: Vec<Vec3>,
                polygons: Vec<Polygon>,
                cones: Vec<Cone>,
                made_of: Vec<MaterialId>,
                materials: Vec<Material>,
                textures: Vec<Texture>,
                lights: Vec<Light>,
                ambient: Rgb,
                background: Option<Background>,
            }

            impl Stock {
                /// The tables of the scene that is described.
                pub fn new(description: &Description) -> Self {
                    let mut stock = Stock {
                        points: description.points.iter().map(|p| vector(*p)).collect(),
                        normals: description
                            .normals
                            .iter()
                            .map(|n| unit(vector(*n)).unwrap_or(Vec3::Z))
                            .collect(),
                        made_of: description.objects.iter().map(|o| MaterialId(o.material)).collect(),
                        materials: description.materials.iter().map(|m| material(&m.it)).collect(),
                        lights: description.lights.iter().map(|l| light(&l.it)).collect(),
                        ambient: color(description.ambient),
                        background: Some(background(&description.background)),
                        ..Stock::default()
                    };
                    for object in &description.objects {
                        let shape = stock.shape(object);
                        stock.shapes.push(shape);
                    }
                    stock
                }

                fn shape(&mut self, object: &Object) -> Shape {
                    match object.form {
                        Form::Sphere { center, radius } => {
                            Shape::Sphere(Sphere { center: vector(center), radius: Real::from(radius) })
                        }
                        Form::Cone { base, base_radius, end, end_radius, capped } => {
                            let (r0, r1) = (Real::from(base_radius), Real::from(end_radius));
                            match Cone::new(vector(base), r0, vector(end), r1, capped) {
                                Some(cone) => Shape::Cone(push(&mut self.cones, cone)),
                                None => self.nothing(),
                            }
                        }
                        Form::Triangle { corners, smooth: false } => Shape::Triangle(corners),
                        Form::Triangle { corners, smooth: true } => Shape::SmoothTriangle(corners),
                        Form::Polygon { first, count, smooth } => {
                            let end = first as usize + count as usize;
                            let corners = self.points.get(first as usize..end).unwrap_or_default();
                            match Polygon::new(first, corners, smooth) {
                                Some(polygon) => Shape::Polygon(push(&mut self.polygons, polygon)),
                                None => self.nothing(),
                            }
                        }
                        Form::Nothing => self.nothing(),
                    }
                }

                /// A triangle whose corners are all the same.
                fn nothing(&mut self) -> Shape {
                    if self.points.is_empty() {
                        self.points.push(Vec3::ZERO);
                    }
                    Shape::Triangle([0; 3])
                }

                /// The scene of these tables.
                pub fn scene(&self) -> Result<Scene<'_>, SceneError> {
                    Scene::new(Parts {
                        geometry: Geometry {
                            shapes: &self.shapes,
                            points: &self.points,
                            normals: &self.normals,
                            polygons: &self.polygons,
                            cones: &self.cones,
                            ..Geometry::EMPTY
                        },
                        made_of: &self.made_of,
                        materials: &self.materials,
                        textures: &self.textures,
                        lights: &self.lights,
                        ambient: self.ambient,
                        background: self.background.unwrap_or(Parts::EMPTY.background),
                    })
                }
            }

            /// The view that is described.
            pub fn view(view: &description::View) -> View {
                View {
                    from: vector(view.from),
                    at: vector(view.at),
                    up: vector(view.up),
                    projection: Projection::Perspective { angle: Real::from(view.angle) * (PI / 180.0) },
                }
            }

            fn push<T>(table: &mut Vec<T>, entry: T) -> u32 {
                table.push(entry);
                table.len() as u32 - 1
            }

            fn vector([x, y, z]: Triple) -> Vec3 {
                vec3(Real::from(x), Real::from(y), Real::from(z))
            }

            // The types below are those of the single core; for it these are copies.

            fn vector_of(v: strahl_core::Vec3) -> Vec3 {
                vector([v.x, v.y, v.z])
            }

            fn color(c: strahl_core::Rgb) -> Rgb {
                Rgb::new(Real::from(c.r), Real::from(c.g), Real::from(c.b))
            }

            fn background(background: &strahl_core::Background) -> Background {
                match *background {
                    strahl_core::Background::Color(c) => Background::Color(color(c)),
                    strahl_core::Background::Gradient { up, below, above } => Background::Gradient {
                        up: vector_of(up),
                        below: color(below),
                        above: color(above),
                    },
                }
            }

            fn material(material: &strahl_core::Material) -> Material {
                Material {
                    ambient: color(material.ambient),
                    diffuse: color(material.diffuse),
                    texture: material.texture,
                    highlight: color(material.highlight),
                    exponent: Real::from(material.exponent),
                    mirror: color(material.mirror),
                    transmitted: color(material.transmitted),
                    index: Real::from(material.index),
                    interface: match material.interface {
                        strahl_core::Interface::Constant => Interface::Constant,
                        strahl_core::Interface::Fresnel => Interface::Fresnel,
                    },
                    clarity: color(material.clarity),
                    priority: material.priority,
                    two_sided: material.two_sided,
                }
            }

            fn light(light: &strahl_core::Light) -> Light {
                let falloff = |f: strahl_core::Falloff| Falloff {
                    constant: Real::from(f.constant),
                    linear: Real::from(f.linear),
                    quadratic: Real::from(f.quadratic),
                };
                let source = match light.source {
                    strahl_core::Source::Point { position, falloff: f } => {
                        Source::Point { position: vector_of(position), falloff: falloff(f) }
                    }
                    strahl_core::Source::Directional { toward } => {
                        Source::Directional { toward: vector_of(toward) }
                    }
                    strahl_core::Source::Spot { position, direction, cos_bright, cos_dark, falloff: f } => {
                        Source::Spot {
                            position: vector_of(position),
                            direction: vector_of(direction),
                            cos_bright: Real::from(cos_bright),
                            cos_dark: Real::from(cos_dark),
                            falloff: falloff(f),
                        }
                    }
                };
                Light { source, color: color(light.color), shadows: light.shadows }
            }
        }
    };
}

stock! {
    /// For `strahl-core`.
    single, strahl_core
}
stock! {
    /// For its twin.
    double, strahl_core_double
}
