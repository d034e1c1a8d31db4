//! Hard shadows: their edges, and what casts none.

use strahl_test_scene::{SplitMix64, TestRay, TestShape, TestShapeKind, TestedCore};
use strahl_tests::oracle;

use crate::*;

fn white(source: LightSource) -> Light {
    Light { source, color: Rgb::WHITE, casts_shadows: true }
}

fn point_light(x: Real, y: Real, z: Real) -> Light {
    white(LightSource::Point { position: vec3(x, y, z), falloff: Falloff::NONE })
}

/// A matte floor under one light; `add` adds occluders.
fn floor(light: Light, add: impl FnOnce(&mut TestScene)) -> TestScene {
    let mut scene = TestScene::new();
    scene.material(Material { ambient: Rgb::BLACK, ..Material::MATTE });
    scene.plane(Vec3::ZERO, Vec3::Y);
    add(&mut scene);
    scene.lights.push(light);
    scene
}

/// Whether the floor is lit at (x, 0, 0), seen from a low angle.
fn is_lit(scene: &TestScene, x: f64) -> bool {
    let (color, counters) = scene.trace_counted(vec3(x as Real, 0.25, 6.0), vec3(x as Real, 0.0, 0.0), ALL);
    assert_eq!(counters.rays[RayKind::Shadow], 1);
    !color.is_black()
}

#[test]
fn a_shadow_has_the_size_of_similar_triangles() {
    // The light is three times as high as the disc: the shadow is 1.5 times as large.
    let scene = floor(point_light(0.0, 3.0, 0.0), |scene| {
        scene.disc(Vec3::Y, Vec3::Y, 0.5);
    });
    for (x, lit) in
        [(0.0, false), (0.5, false), (0.7499, false), (0.7501, true), (-0.7499, false), (-2.0, true)]
    {
        assert_eq!(is_lit(&scene, x), lit, "{x}");
    }
    // In directional light it is as large as the disc, and displaced by the angle.
    let toward = vec3(0.6, 0.8, 0.0);
    let scene = floor(white(LightSource::Directional { to_light: toward }), |scene| {
        scene.disc(Vec3::Y, Vec3::Y, 0.5);
    });
    for (x, lit) in [(-0.75, false), (-0.2501, false), (-0.2499, true), (-1.2499, false), (-1.2501, true)] {
        assert_eq!(is_lit(&scene, x), lit, "{x}");
    }
}

#[test]
fn every_shape_casts_a_shadow() {
    let add: [fn(&mut TestScene); 9] = [
        |scene| {
            scene.sphere(Vec3::Y, 0.25);
        },
        |scene| {
            scene.plane(Vec3::Y, vec3(0.5, 1.0, 0.0));
        },
        |scene| {
            scene.triangle([vec3(-1.0, 1.0, -1.0), vec3(1.0, 1.0, -1.0), vec3(0.0, 1.0, 1.0)]);
        },
        |scene| {
            let corners = [vec3(-1.0, 1.0, -1.0), vec3(1.0, 1.0, -1.0), vec3(0.0, 1.0, 1.0)];
            scene.polygon(&corners, &[Vec3::Y; 3]);
        },
        |scene| {
            scene.cuboid(vec3(-0.5, 0.75, -0.5), vec3(0.5, 0.75, 0.5));
        },
        |scene| {
            scene.oriented_cuboid(Vec3::Y, Vec3::splat(0.25), Vec3::ONE, Vec3::Z);
        },
        |scene| {
            scene.cone(Cone::new(vec3(-0.5, 1.0, 0.0), 0.25, vec3(0.5, 1.0, 0.0), 0.5, false).unwrap());
        },
        |scene| {
            scene.torus(vec3(1.0, 1.0, 0.0), Vec3::Y, 1.0, 0.25);
        },
        |scene| {
            scene.disc(Vec3::Y, vec3(0.0, 1.0, 1.0), 0.25);
        },
    ];
    for add in add {
        assert!(!is_lit(&floor(point_light(0.0, 3.0, 0.0), add), 0.0));
        // A light without shadows traces no shadow ray.
        let mut scene = floor(point_light(0.0, 3.0, 0.0), add);
        scene.lights[0].casts_shadows = false;
        let (color, counters) = scene.trace_counted(vec3(0.0, 0.25, 6.0), Vec3::ZERO, ALL);
        assert_eq!((color.is_black(), counters.rays[RayKind::Shadow]), (false, 0));
    }
}

#[test]
fn an_item_behind_the_light_casts_no_shadow() {
    for behind in [3.001, 3.5, 100.0] {
        let scene = floor(point_light(0.0, 3.0, 0.0), |scene| {
            scene.disc(vec3(0.0, behind, 0.0), Vec3::Y, 50.0);
        });
        assert!(is_lit(&scene, 0.0), "{behind}");
    }
    // An item just in front of it does.
    let scene = floor(point_light(0.0, 3.0, 0.0), |scene| {
        scene.disc(vec3(0.0, 2.999, 0.0), Vec3::Y, 50.0);
    });
    assert!(!is_lit(&scene, 0.0));
}

#[test]
fn a_light_inside_a_closed_body_is_occluded() {
    let scene = floor(point_light(0.0, 3.0, 0.0), |scene| {
        scene.sphere(vec3(0.0, 3.0, 0.0), 0.5);
    });
    assert!(!is_lit(&scene, 0.0) && !is_lit(&scene, 4.0));
}

#[test]
fn a_light_in_a_surface_lights_its_side() {
    let add: [fn(&mut TestScene); 5] = [
        |scene| {
            scene.disc(vec3(0.0, 3.0, 0.0), Vec3::Y, 1.0);
        },
        |scene| {
            scene.plane(vec3(7.0, 3.0, 5.0), Vec3::Y);
        },
        |scene| {
            scene.sphere(vec3(0.0, 3.75, 0.0), 0.75);
        },
        |scene| {
            scene.cuboid(vec3(-1.0, 3.0, -1.0), vec3(1.0, 4.0, 1.0));
        },
        |scene| {
            scene.triangle([vec3(-1.0, 3.0, -1.0), vec3(1.0, 3.0, -1.0), vec3(0.0, 3.0, 1.0)]);
        },
    ];
    for add in add {
        let scene = floor(point_light(0.0, 3.0, 0.0), add);
        for x in [0.0, 0.1, 1.0, 4.0] {
            assert!(is_lit(&scene, x), "{x}");
        }
    }
}

#[test]
fn a_light_on_a_surface_is_not_occluded_by_it() {
    // A light at a rounded point of a random shape, seen from a point in front of the surface at no grazing
    // angle. It is in front of or behind the surface by a few roundings of its coordinates; shadow rays end
    // before it by that distance.
    let mut rng = SplitMix64::new(0x5eed_0005);
    let mut shadow_rays = 0;
    for round in 0..4_000 {
        let kind = TestShapeKind::ALL[round % TestShapeKind::ALL.len()];
        let shape = TestShape::random(kind, strahl_test_scene::DVec3::ZERO, 1.0, &mut rng);
        let viewpoint = rng.in_ball(strahl_test_scene::DVec3::ZERO, 6.0);
        let target = rng.in_ball(strahl_test_scene::DVec3::ZERO, 0.7);
        let ray = TestRay { origin: viewpoint, direction: target - viewpoint };
        let oracle::OracleAnswer::Hit(contact) = oracle::intersect(&shape, &ray) else { continue };
        if contact.slope < 0.5 || contact.distance < 2.0 {
            continue;
        }
        let position = vec3(contact.point.x as Real, contact.point.y as Real, contact.point.z as Real);
        let from = vec3(viewpoint.x as Real, viewpoint.y as Real, viewpoint.z as Real);
        // A small disc that faces the light, at the origin of the ray.
        let mut scene = TestScene::with_shapes(&[shape]);
        scene.material(Material { ambient: Rgb::BLACK, ..Material::MATTE });
        scene.disc(from, position - from, 1e-3);
        scene.lights.push(point_light(position.x, position.y, position.z));
        let viewpoint = from + try_normalize(position - from).unwrap() * 0.5;
        let (color, counters) = scene.trace_counted(viewpoint, from, ALL);
        if counters.rays[RayKind::Shadow] == 1 {
            assert!(!color.is_black(), "{round}: {kind:?} {contact:?}");
            shadow_rays += 1;
        }
    }
    assert!(shadow_rays > 1_000, "{shadow_rays}");
}

#[test]
fn glass_casts_a_full_shadow() {
    let glass = Material {
        transmission: Rgb::WHITE,
        refractive_index: 1.5,
        diffuse: Rgb::BLACK,
        ambient: Rgb::WHITE,
        ..Material::MATTE
    };
    for material in [glass, Material { refractive_index: 1.0, ..glass }] {
        let scene = floor(point_light(0.0, 3.0, 0.0), |scene| {
            scene.material(material);
            scene.sphere(Vec3::Y, 0.5);
        });
        assert!(!is_lit(&scene, 0.0) && is_lit(&scene, 2.0));
    }
}

#[test]
fn a_light_behind_the_surface_costs_no_shadow_ray() {
    let scene = floor(point_light(0.0, -3.0, 0.0), |_| ());
    let (color, counters) = scene.trace_counted(vec3(0.0, 0.25, 6.0), Vec3::ZERO, ALL);
    assert_eq!((color, counters.rays[RayKind::Shadow]), (Rgb::BLACK, 0));
}

#[test]
fn two_plates_with_a_narrow_gap_cast_shadows_at_every_scale() {
    // The gap is 1/1000 of the size; the light is above the upper plate.
    for k in -20..=20 {
        let scale = (0..20 + k).fold(1.0 / 1_048_576.0, |scale: Real, _| 2.0 * scale);
        let gap = 1e-3 * scale;
        let mut scene = TestScene::new();
        scene.material(Material { ambient: Rgb::BLACK, ..Material::MATTE });
        scene.disc(Vec3::ZERO, Vec3::Y, scale);
        scene.disc(vec3(0.0, gap, 0.0), Vec3::Y, 0.5 * scale);
        scene.lights.push(point_light(0.0, scale, 0.0));
        // From the side into the gap, at half of its height: under the upper plate, and beside it.
        let is_lit = |x: Real| {
            let viewpoint = vec3(-scale, 0.5 * gap + 1e-4 * scale, 0.0);
            let color = scene.trace(viewpoint, vec3(x * scale, 0.0, 0.0), ALL);
            !color.is_black()
        };
        assert!(!is_lit(-0.499) && !is_lit(-0.25), "2^{k}");
        assert!(is_lit(-0.5012), "2^{k}");
    }
}
