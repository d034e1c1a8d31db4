//! The owned tables that a scene borrows from, made of a [`Description`] for either precision.
//!
//! Both cores compile the same sources, so one macro makes the stock of both: every number of
//! the description, which is single precision, is widened first, and everything derived (units,
//! planes of polygons, axes of cones) is computed in the core's own precision.
//!
//! [`Description`]: strahl_scene::description::Description

macro_rules! stock {
    ($(#[$doc:meta])* $precision:ident, $core:ident) => {
        $(#[$doc])*
        pub mod $precision {
            use $core::geometry::{Cone, Cuboid, Disc, ItemId, OrientedCuboid, Torus};
            use $core::math::{PI, try_normalize};
            use $core::scene::{Shading, Texture};
            use $core::{Background, Falloff, Light, Material, MaterialId, Projection, Real, Rgb, SceneTables, Source, Sphere, Vec3, View, vec3};

            use strahl_scene::description::{self, Description, Form, Object, Triple};

            /// The tables of the scene that is described.
            pub fn scene_tables(description: &Description) -> SceneTables {
                let mut tables = SceneTables::new();
                let vertices: Vec<Vec3> = description.points.iter().map(|p| vector(*p)).collect();
                let normals = description.normals.iter().map(|n| try_normalize(vector(*n)).unwrap_or(Vec3::Z));
                tables.add_vertices(&vertices, &normals.collect::<Vec<_>>());
                for it in &description.materials {
                    tables.add_material(material(&it.it));
                }
                for it in &description.textures {
                    tables.add_texture(texture(it));
                }
                tables.lights.extend(description.lights.iter().map(|l| light(&l.it)));
                tables.ambient = color(description.ambient);
                tables.background = background(&description.background);
                tables.colored_shadows = description.colored_shadows.is_some();
                let mut moving = description.moving.iter().peekable();
                for (object, place) in description.objects.iter().zip(0..) {
                    let first = tables.len() as u32;
                    add(&mut tables, object, &description.triangles);
                    if let Some(motion) = moving.next_if(|motion| motion.object == place) {
                        let [opening, closing] =
                            description.shutter.map(|time| vector(motion.velocity) * Real::from(time));
                        for item in first..tables.len() as u32 {
                            tables.set_motion(ItemId(item), opening, closing);
                        }
                    }
                }
                tables
            }

            /// Adds the items of an object; where nothing is left of a shape, an empty triangle in its place.
            fn add(tables: &mut SceneTables, object: &Object, triangles: &[[u32; 3]]) {
                let material = MaterialId(object.material);
                if let Form::Mesh { first, count, smooth } = object.form {
                    let end = first as usize + count as usize;
                    let triangles = triangles.get(first as usize..end).unwrap_or_default();
                    tables.add_triangles(triangles, shading(smooth), material);
                } else if add_shape(tables, object.form, material).is_none() {
                    if tables.parts().geometry.vertices.is_empty() {
                        tables.add_vertices(&[Vec3::ZERO], &[]);
                    }
                    tables.add_triangles(&[[0; 3]], Shading::Flat, material);
                }
            }

            /// Adds an object that is one shape; none when nothing is left of it.
            fn add_shape(tables: &mut SceneTables, form: Form, material: MaterialId) -> Option<ItemId> {
                Some(match form {
                    Form::Sphere { center, radius } => {
                        let sphere = Sphere { center: vector(center), radius: Real::from(radius) };
                        tables.add_sphere(sphere, material)
                    }
                    Form::Plane { point, normal } => {
                        tables.add_plane(vector(point), try_normalize(vector(normal))?, material)
                    }
                    Form::Disc { center, normal, radius } => {
                        let (center, radius) = (vector(center), Real::from(radius));
                        tables.add_disc(Disc { center, normal: try_normalize(vector(normal))?, radius }, material)
                    }
                    Form::Cuboid { min, max } => {
                        tables.add_cuboid(Cuboid { min: vector(min), max: vector(max) }, material)
                    }
                    Form::OrientedCuboid { center, half, first, third } => {
                        let (center, half) = (vector(center), vector(half));
                        let cuboid = OrientedCuboid::new(center, half, vector(first), vector(third))?;
                        tables.add_turned_cuboid(cuboid, material)
                    }
                    Form::Cone { base, base_radius, end, end_radius, capped } => {
                        let (r0, r1) = (Real::from(base_radius), Real::from(end_radius));
                        tables.add_cone(Cone::new(vector(base), r0, vector(end), r1, capped)?, material)
                    }
                    Form::Torus { center, axis, major, minor } => {
                        let (major_radius, minor_radius) = (Real::from(major), Real::from(minor));
                        let (center, axis) = (vector(center), try_normalize(vector(axis))?);
                        tables.add_torus(Torus { center, axis, major_radius, minor_radius }, material)
                    }
                    Form::Triangle { corners, smooth } => {
                        tables.add_triangles(&[corners], shading(smooth), material).start
                    }
                    Form::Polygon { first, count, smooth } => {
                        tables.add_polygon(first..first.checked_add(count)?, shading(smooth), material).ok()?
                    }
                    Form::Mesh { .. } | Form::Nothing => return None,
                })
            }

            fn shading(is_smooth: bool) -> Shading {
                if is_smooth { Shading::Smooth } else { Shading::Flat }
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

            fn vector([x, y, z]: Triple) -> Vec3 {
                vec3(Real::from(x), Real::from(y), Real::from(z))
            }

            /// The direction of `v`; up for none.
            fn direction(v: Triple) -> Vec3 {
                try_normalize(vector(v)).unwrap_or(Vec3::Z)
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
