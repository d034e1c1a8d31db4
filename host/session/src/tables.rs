//! Scene tables of the core, made from a [`LoadedScene`] in either precision.
//!
//! Both cores compile the same sources, so one macro makes the functions for both. Every number of the description, which is
//! single precision, is widened first; everything derived (unit vectors, planes of polygons, axes of cones) is computed in
//! the core's own precision.
//!
//! [`LoadedScene`]: strahl_scene::description::LoadedScene

macro_rules! tables {
    ($(#[$doc:meta])* $precision:ident, $core:ident) => {
        $(#[$doc])*
        pub mod $precision {
            use $core::geometry::{Cone, Cuboid, Disc, ItemId, OrientedCuboid, Torus};
            use $core::math::{PI, try_normalize};
            use $core::scene::{Shading, Texture};
            use $core::{Background, Falloff, Light, Material, MaterialId, Projection, Real, Rgb, SceneTables, LightSource, Sphere, Vec3, CameraDescriptor, vec3};

            use strahl_scene::description::{self, Float3, LoadedScene, ObjectDescription, ShapeDescription};

            /// The tables of a scene.
            pub fn scene_tables(description: &LoadedScene) -> SceneTables {
                let mut tables = SceneTables::new();
                let vertices: Vec<Vec3> = description.vertices.iter().map(|p| vector(*p)).collect();
                let normals = description.normals.iter().map(|n| try_normalize(vector(*n)).unwrap_or(Vec3::Z));
                tables.add_vertices(&vertices, &normals.collect::<Vec<_>>());
                for it in &description.materials {
                    tables.add_material(material(&it.value));
                }
                for it in &description.textures {
                    tables.add_texture(texture(it));
                }
                tables.lights.extend(description.lights.iter().map(|l| light(&l.value)));
                tables.ambient = color(description.ambient);
                tables.background = background(&description.background);
                tables.colored_shadows = description.colored_shadows_line.is_some();
                let mut moving = description.motions.iter().peekable();
                for (object, place) in description.objects.iter().zip(0..) {
                    let first = tables.item_count() as u32;
                    add(&mut tables, object, &description.triangles);
                    if let Some(motion) = moving.next_if(|motion| motion.object == place) {
                        let [opening, closing] =
                            description.shutter.map(|time| vector(motion.velocity) * Real::from(time));
                        for item in first..tables.item_count() as u32 {
                            tables.set_motion(ItemId(item), opening, closing);
                        }
                    }
                }
                tables
            }

            /// Adds the items of an object; an empty triangle if its shape is degenerate.
            fn add(tables: &mut SceneTables, object: &ObjectDescription, triangles: &[[u32; 3]]) {
                let material = MaterialId(object.material);
                if let ShapeDescription::Mesh { first, count, smooth } = object.shape {
                    let end = first as usize + count as usize;
                    let triangles = triangles.get(first as usize..end).unwrap_or_default();
                    tables.add_triangles(triangles, shading(smooth), material);
                } else if add_shape(tables, object.shape, material).is_none() {
                    if tables.descriptor().geometry.vertices.is_empty() {
                        tables.add_vertices(&[Vec3::ZERO], &[]);
                    }
                    tables.add_triangles(&[[0; 3]], Shading::Flat, material);
                }
            }

            /// Adds an object of one shape; `None` if it is degenerate.
            fn add_shape(tables: &mut SceneTables, shape: ShapeDescription, material: MaterialId) -> Option<ItemId> {
                Some(match shape {
                    ShapeDescription::Sphere { center, radius } => {
                        let sphere = Sphere { center: vector(center), radius: Real::from(radius) };
                        tables.add_sphere(sphere, material)
                    }
                    ShapeDescription::Plane { point, normal } => {
                        tables.add_plane(vector(point), try_normalize(vector(normal))?, material)
                    }
                    ShapeDescription::Disc { center, normal, radius } => {
                        let (center, radius) = (vector(center), Real::from(radius));
                        tables.add_disc(Disc { center, normal: try_normalize(vector(normal))?, radius }, material)
                    }
                    ShapeDescription::Cuboid { min, max } => {
                        tables.add_cuboid(Cuboid { min: vector(min), max: vector(max) }, material)
                    }
                    ShapeDescription::OrientedCuboid { center, half_size, first, third } => {
                        let (center, half) = (vector(center), vector(half_size));
                        let cuboid = OrientedCuboid::new(center, half, vector(first), vector(third))?;
                        tables.add_oriented_cuboid(cuboid, material)
                    }
                    ShapeDescription::Cone { base, base_radius, end, end_radius, capped } => {
                        let (r0, r1) = (Real::from(base_radius), Real::from(end_radius));
                        tables.add_cone(Cone::new(vector(base), r0, vector(end), r1, capped)?, material)
                    }
                    ShapeDescription::Torus { center, axis, major_radius, minor_radius } => {
                        let (major_radius, minor_radius) = (Real::from(major_radius), Real::from(minor_radius));
                        let (center, axis) = (vector(center), try_normalize(vector(axis))?);
                        tables.add_torus(Torus { center, axis, major_radius, minor_radius }, material)
                    }
                    ShapeDescription::Triangle { vertices, smooth } => {
                        tables.add_triangles(&[vertices], shading(smooth), material).start
                    }
                    ShapeDescription::Polygon { first, count, smooth } => {
                        tables.add_polygon(first..first.checked_add(count)?, shading(smooth), material).ok()?
                    }
                    ShapeDescription::Mesh { .. } | ShapeDescription::Degenerate => return None,
                })
            }

            fn shading(is_smooth: bool) -> Shading {
                if is_smooth { Shading::Smooth } else { Shading::Flat }
            }

            /// The camera of a scene.
            pub fn camera_descriptor(camera: &description::CameraDescription) -> CameraDescriptor {
                CameraDescriptor {
                    position: vector(camera.from),
                    target: vector(camera.at),
                    up: vector(camera.up),
                    projection: match camera.projection {
                        description::ProjectionDescription::Perspective(angle) => {
                            Projection::Perspective { field_of_view: Real::from(angle) * (PI / 180.0) }
                        }
                        description::ProjectionDescription::Lens { angle, radius, focus } => Projection::ThinLens {
                            field_of_view: Real::from(angle) * (PI / 180.0),
                            lens_radius: Real::from(radius),
                            focus_distance: Real::from(focus),
                        },
                        description::ProjectionDescription::Orthographic(height) => {
                            Projection::Orthographic { height: Real::from(height) }
                        }
                    },
                }
            }

            fn vector([x, y, z]: Float3) -> Vec3 {
                vec3(Real::from(x), Real::from(y), Real::from(z))
            }

            /// The direction of `v`; up if it has none.
            fn direction(v: Float3) -> Vec3 {
                try_normalize(vector(v)).unwrap_or(Vec3::Z)
            }

            fn color(c: strahl_core::Rgb) -> Rgb {
                Rgb::new(Real::from(c.r), Real::from(c.g), Real::from(c.b))
            }

            fn background(background: &description::BackgroundDescription) -> Background {
                match *background {
                    description::BackgroundDescription::Color(c) => Background::Color(color(c)),
                    description::BackgroundDescription::Gradient { up, below, above } => Background::Gradient {
                        up: direction(up),
                        below: color(below),
                        above: color(above),
                    },
                }
            }

            fn texture(texture: &description::TextureDescription) -> Texture {
                match *texture {
                    description::TextureDescription::Checker { even, odd, origin, size } => {
                        let frequency =
                            |size: f32| if size > 0.0 { 1.0 / Real::from(size) } else { 0.0 };
                        Texture::Checker {
                            even: color(even),
                            odd: color(odd),
                            origin: vector(origin),
                            frequency: vec3(frequency(size[0]), frequency(size[1]), frequency(size[2])),
                        }
                    }
                    description::TextureDescription::Gradient { from, to, start, end } => Texture::Gradient {
                        start_color: color(from),
                        end_color: color(to),
                        origin: vector(start),
                        axis: vector(end) - vector(start),
                    },
                    description::TextureDescription::ZonePlate { from, to, origin, frequency } => Texture::ZonePlate {
                        start_color: color(from),
                        end_color: color(to),
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
                    highlight_exponent: Real::from(material.highlight_exponent),
                    reflection: color(material.reflection),
                    transmission: color(material.transmission),
                    roughness: Real::from(material.roughness),
                    refractive_index: Real::from(material.refractive_index),
                    fresnel: material.fresnel,
                    attenuation_length: color(material.attenuation_length),
                    priority: material.priority,
                    two_sided: material.two_sided,
                }
            }

            fn light(light: &description::LightDescription) -> Light {
                let falloff = |[constant, linear, quadratic]: Float3| Falloff {
                    constant: Real::from(constant),
                    linear: Real::from(linear),
                    quadratic: Real::from(quadratic),
                };
                // libm: identical on all platforms.
                let cos = |degrees: f32| libm::cos(f64::from(degrees).to_radians()) as Real;
                let source = match light.source {
                    description::LightSourceDescription::Point { position, falloff: f } => {
                        LightSource::Point { position: vector(position), falloff: falloff(f) }
                    }
                    description::LightSourceDescription::Directional { to_light } => {
                        LightSource::Directional { to_light: direction(to_light) }
                    }
                    description::LightSourceDescription::Spot { position, direction: d, inner_angle, outer_angle, falloff: f } => {
                        LightSource::Spot {
                            position: vector(position),
                            direction: direction(d),
                            cos_inner: cos(inner_angle),
                            cos_outer: cos(outer_angle),
                            falloff: falloff(f),
                        }
                    }
                    description::LightSourceDescription::Sphere { position, radius, falloff: f } => LightSource::Sphere {
                        position: vector(position),
                        radius: Real::from(radius),
                        falloff: falloff(f),
                    },
                    description::LightSourceDescription::Rectangle { position, half_edges, soft_shadows, falloff: f } => {
                        let (position, half) = (vector(position), half_edges.map(vector));
                        LightSource::Rectangle { position, half_edges: half, soft_shadows, falloff: falloff(f) }
                    }
                };
                Light { source, color: color(light.color), casts_shadows: light.shadows }
            }
        }
    };
}

tables! {
    /// Single precision: tables of `strahl-core`.
    single, strahl_core
}
tables! {
    /// Double precision: tables of `strahl-core-double`.
    double, strahl_core_double
}
