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
                Background, Cone, Cuboid, Disc, Falloff, Geometry, ItemId, Light, Material,
                MaterialId, Moving, PI, Parts, Plane, Polygon, Projection, Real, Rgb, Scene, SceneError, Shape,
                Source, Sphere, Texture, Torus, TurnedCuboid, Vec3, View, unit, vec3,
            };

            use crate::description::{self, Description, Form, Object, Triple};

            /// The tables of a scene.
            #[derive(Clone, Debug, Default)]
            pub struct Stock {
                shapes: Vec<Shape>,
                points: Vec<Vec3>,
                normals: Vec<Vec3>,
                planes: Vec<Plane>,
                discs: Vec<Disc>,
                polygons: Vec<Polygon>,
                cuboids: Vec<Cuboid>,
                turned_cuboids: Vec<TurnedCuboid>,
                cones: Vec<Cone>,
                tori: Vec<Torus>,
                moving: Vec<Moving>,
                made_of: Vec<MaterialId>,
                materials: Vec<Material>,
                textures: Vec<Texture>,
                lights: Vec<Light>,
                ambient: Rgb,
                background: Option<Background>,
                colored_shadows: bool,
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
                        materials: description.materials.iter().map(|m| material(&m.it)).collect(),
                        textures: description.textures.iter().map(texture).collect(),
                        lights: description.lights.iter().map(|l| light(&l.it)).collect(),
                        ambient: color(description.ambient),
                        background: Some(background(&description.background)),
                        colored_shadows: description.colored_shadows.is_some(),
                        ..Stock::default()
                    };
                    let mut moving = description.moving.iter().peekable();
                    for (object, place) in description.objects.iter().zip(0..) {
                        let first = stock.shapes.len();
                        stock.add(object, &description.triangles);
                        if let Some(motion) = moving.next_if(|motion| motion.object == place) {
                            stock.set_moving(first, motion.velocity, description.shutter);
                        }
                    }
                    stock
                }

                fn add(&mut self, object: &Object, triangles: &[[u32; 3]]) {
                    if let Form::Mesh { first, count, smooth } = object.form {
                        let end = first as usize + count as usize;
                        let triangles = triangles.get(first as usize..end).unwrap_or_default();
                        let shape = if smooth { Shape::SmoothTriangle } else { Shape::Triangle };
                        self.shapes.extend(triangles.iter().map(|corners| shape(*corners)));
                    } else {
                        let shape = self.shape(object.form).unwrap_or_else(|| self.nothing());
                        self.shapes.push(shape);
                    }
                    self.made_of.resize(self.shapes.len(), MaterialId(object.material));
                }

                /// Makes everything from the shape `first` on move.
                fn set_moving(&mut self, first: usize, velocity: Triple, shutter: [f32; 2]) {
                    let [opening, closing] = shutter.map(|time| vector(velocity) * Real::from(time));
                    for shape in self.shapes.iter_mut().skip(first) {
                        let moving = Moving { shape: *shape, opening, closing };
                        *shape = Shape::Moving(push(&mut self.moving, moving));
                    }
                }

                /// The shape of an object that is one; none when nothing is left of it.
                fn shape(&mut self, form: Form) -> Option<Shape> {
                    Some(match form {
                        Form::Sphere { center, radius } => {
                            Shape::Sphere(Sphere { center: vector(center), radius: Real::from(radius) })
                        }
                        Form::Plane { point, normal } => {
                            let item = ItemId(self.shapes.len() as u32);
                            let plane = Plane { point: vector(point), normal: unit(vector(normal))?, item };
                            Shape::Plane(push(&mut self.planes, plane))
                        }
                        Form::Disc { center, normal, radius } => {
                            let (center, radius) = (vector(center), Real::from(radius));
                            let disc = Disc { center, normal: unit(vector(normal))?, radius };
                            Shape::Disc(push(&mut self.discs, disc))
                        }
                        Form::Cuboid { min, max } => {
                            let cuboid = Cuboid { min: vector(min), max: vector(max) };
                            Shape::Cuboid(push(&mut self.cuboids, cuboid))
                        }
                        Form::TurnedCuboid { center, half, first, third } => {
                            let (center, half) = (vector(center), vector(half));
                            let cuboid = TurnedCuboid::new(center, half, vector(first), vector(third))?;
                            Shape::TurnedCuboid(push(&mut self.turned_cuboids, cuboid))
                        }
                        Form::Cone { base, base_radius, end, end_radius, capped } => {
                            let (r0, r1) = (Real::from(base_radius), Real::from(end_radius));
                            let cone = Cone::new(vector(base), r0, vector(end), r1, capped)?;
                            Shape::Cone(push(&mut self.cones, cone))
                        }
                        Form::Torus { center, axis, major, minor } => {
                            let (major, minor) = (Real::from(major), Real::from(minor));
                            let torus = Torus { center: vector(center), axis: unit(vector(axis))?, major, minor };
                            Shape::Torus(push(&mut self.tori, torus))
                        }
                        Form::Triangle { corners, smooth: false } => Shape::Triangle(corners),
                        Form::Triangle { corners, smooth: true } => Shape::SmoothTriangle(corners),
                        Form::Polygon { first, count, smooth } => {
                            let end = first as usize + count as usize;
                            let corners = self.points.get(first as usize..end)?;
                            let polygon = Polygon::new(first, corners, smooth)?;
                            Shape::Polygon(push(&mut self.polygons, polygon))
                        }
                        Form::Mesh { .. } | Form::Nothing => return None,
                    })
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
                            planes: &self.planes,
                            discs: &self.discs,
                            polygons: &self.polygons,
                            cuboids: &self.cuboids,
                            turned_cuboids: &self.turned_cuboids,
                            cones: &self.cones,
                            tori: &self.tori,
                            moving: &self.moving,
                        },
                        made_of: &self.made_of,
                        materials: &self.materials,
                        textures: &self.textures,
                        lights: &self.lights,
                        ambient: self.ambient,
                        background: self.background.unwrap_or(Parts::EMPTY.background),
                        colored_shadows: self.colored_shadows,
                    })
                }
            }

            /// The view that is described.
            pub fn view(view: &description::View) -> View {
                View {
                    from: vector(view.from),
                    at: vector(view.at),
                    up: vector(view.up),
                    projection: match view.projection {
                        description::Projection::Perspective(angle) => {
                            Projection::Perspective { angle: Real::from(angle) * (PI / 180.0) }
                        }
                        description::Projection::Lens { angle, radius, focus } => Projection::Lens {
                            angle: Real::from(angle) * (PI / 180.0),
                            radius: Real::from(radius),
                            focus: Real::from(focus),
                        },
                        description::Projection::Orthographic(height) => {
                            Projection::Orthographic { height: Real::from(height) }
                        }
                    },
                }
            }

            fn push<T>(table: &mut Vec<T>, entry: T) -> u32 {
                table.push(entry);
                table.len() as u32 - 1
            }

            fn vector([x, y, z]: Triple) -> Vec3 {
                vec3(Real::from(x), Real::from(y), Real::from(z))
            }

            /// The direction of `v`; up for none.
            fn direction(v: Triple) -> Vec3 {
                unit(vector(v)).unwrap_or(Vec3::Z)
            }

            fn color(c: strahl_core::Rgb) -> Rgb {
                Rgb::new(Real::from(c.r), Real::from(c.g), Real::from(c.b))
            }

            fn background(background: &description::Background) -> Background {
                match *background {
                    description::Background::Color(c) => Background::Color(color(c)),
                    description::Background::Gradient { up, below, above } => Background::Gradient {
                        up: direction(up),
                        below: color(below),
                        above: color(above),
                    },
                }
            }

            fn texture(texture: &description::Texture) -> Texture {
                match *texture {
                    description::Texture::Checker { even, odd, origin, size } => {
                        let frequency =
                            |size: f32| if size > 0.0 { 1.0 / Real::from(size) } else { 0.0 };
                        Texture::Checker {
                            even: color(even),
                            odd: color(odd),
                            origin: vector(origin),
                            frequency: vec3(frequency(size[0]), frequency(size[1]), frequency(size[2])),
                        }
                    }
                    description::Texture::Gradient { from, to, start, end } => Texture::Gradient {
                        from: color(from),
                        to: color(to),
                        origin: vector(start),
                        along: vector(end) - vector(start),
                    },
                    description::Texture::ZonePlate { from, to, origin, frequency } => Texture::ZonePlate {
                        from: color(from),
                        to: color(to),
                        origin: vector(origin),
                        frequency: Real::from(frequency),
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
                    roughness: Real::from(material.roughness),
                    index: Real::from(material.index),
                    interface: material.interface,
                    clarity: color(material.clarity),
                    priority: material.priority,
                    two_sided: material.two_sided,
                }
            }

            fn light(light: &description::Light) -> Light {
                let falloff = |[constant, linear, quadratic]: Triple| Falloff {
                    constant: Real::from(constant),
                    linear: Real::from(linear),
                    quadratic: Real::from(quadratic),
                };
                // libm's, which is the same everywhere.
                let cos = |degrees: f32| libm::cos(f64::from(degrees).to_radians()) as Real;
                let source = match light.source {
                    description::Source::Point { position, falloff: f } => {
                        Source::Point { position: vector(position), falloff: falloff(f) }
                    }
                    description::Source::Directional { toward } => {
                        Source::Directional { toward: direction(toward) }
                    }
                    description::Source::Spot { position, direction: d, bright, dark, falloff: f } => {
                        Source::Spot {
                            position: vector(position),
                            direction: direction(d),
                            cos_bright: cos(bright),
                            cos_dark: cos(dark),
                            falloff: falloff(f),
                        }
                    }
                    description::Source::Sphere { position, radius, falloff: f } => Source::Sphere {
                        position: vector(position),
                        radius: Real::from(radius),
                        falloff: falloff(f),
                    },
                    description::Source::Rectangle { position, half, soft, falloff: f } => {
                        let (position, half) = (vector(position), half.map(vector));
                        Source::Rectangle { position, half, soft, falloff: falloff(f) }
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
