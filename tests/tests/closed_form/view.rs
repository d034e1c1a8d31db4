//! Cameras, sides of surfaces, backgrounds and textures.

use strahl_tests::assert_picture;

use crate::*;

const VIEW: CameraDescriptor = CameraDescriptor {
    position: Vec3::ZERO,
    target: vec3(0.0, 0.0, -1.0),
    up: vec3(0.0, 1.0, 0.0),
    projection: Projection::Perspective { field_of_view: 1.2 },
};

fn picture(scene: &TestScene, view: &CameraDescriptor, width: u32, height: u32) -> Vec<Rgb> {
    let size = Resolution::new(width, height).unwrap();
    let world = World::new(scene.as_scene(), List::without_bounds(scene.item_count()));
    let tracer = Tracer::<_, AllEffects, 64>::new(&world, Camera::new(view, size).unwrap(), ALL).unwrap();
    let mut colors = vec![Rgb::BLACK; width as usize * height as usize];
    let mut frame = Framebuffer::new(Tile::full(size), &mut colors).unwrap();
    let Ok(()) = render(
        &mut tracer.with_worker(&mut Worker::new(())),
        &mut CenterSampler,
        Tile::full(size).pixels(),
        &mut frame,
    );
    colors
}

/// A wall at distance 5 whose red channel encodes x, and whose green channel encodes y, from top to bottom.
fn gradient_plane() -> TestScene {
    let mut scene = TestScene::new();
    let gradient =
        |to, origin, along| Texture::Gradient { start_color: Rgb::BLACK, end_color: to, origin, axis: along };
    let across = gradient(Rgb::new(1.0, 0.0, 0.0), vec3(-8.0, 0.0, 0.0), vec3(16.0, 0.0, 0.0));
    let down = gradient(Rgb::new(0.0, 1.0, 0.0), vec3(0.0, 8.0, 0.0), vec3(0.0, -16.0, 0.0));
    // A pane in front of a wall: their colors are added.
    let texture = scene.add_texture(across);
    scene.material(Material { texture, transmission: Rgb::WHITE, ..unlit(Rgb::WHITE) });
    scene.plane(vec3(0.0, 0.0, -5.0), Vec3::Z);
    let texture = scene.add_texture(down);
    scene.material(Material { texture, ..unlit(Rgb::WHITE) });
    scene.plane(vec3(0.0, 0.0, -5.0625), Vec3::Z);
    scene.ambient = Rgb::WHITE;
    scene
}

#[test]
fn a_perspective_view_spreads_its_angle_over_the_rows() {
    let (width, height) = (9, 7);
    let colors = picture(&gradient_plane(), &VIEW, width, height);
    // From the center of the first row to that of the last; pixels are square.
    let step = 2.0 * 0.6_f64.tan() / f64::from(height - 1);
    for (color, i) in colors.iter().zip(0..) {
        let (x, y) = (f64::from(i % width) - 4.0, f64::from(i / width) - 3.0);
        let (red, green) = (0.5 + 5.0 * step * x / 16.0, 0.5 + 5.0625 * step * y / 16.0);
        assert_color(*color, [red, green, 0.0], 4.0 * ROUNDINGS);
    }
}

#[test]
fn an_orthographic_view_spreads_its_height_over_the_rows() {
    let (width, height) = (9, 7);
    let view = CameraDescriptor { projection: Projection::Orthographic { height: 12.0 }, ..VIEW };
    let colors = picture(&gradient_plane(), &view, width, height);
    for (color, i) in colors.iter().zip(0..) {
        let (x, y) = (f64::from(i % width) - 4.0, f64::from(i / width) - 3.0);
        assert_color(*color, [0.5 + 2.0 * x / 16.0, 0.5 + 2.0 * y / 16.0, 0.0], ROUNDINGS);
    }
}

#[test]
fn a_centered_sphere_is_a_disc() {
    let mut scene = TestScene::new();
    scene.material(unlit(Rgb::WHITE));
    scene.sphere(vec3(0.0, 0.0, -5.0), 3.0);
    scene.ambient = Rgb::WHITE;
    let disc = "
        .........
        ...###...
        ..#####..
        ..#####..
        ..#####..
        ...###...
        .........";
    // Its silhouette is at an angle whose sine is 3/5, which is 0.75 at distance 1; a row is 0.3.
    let angle = 2.0 * 0.9_f64.atan();
    let view =
        CameraDescriptor { projection: Projection::Perspective { field_of_view: angle as Real }, ..VIEW };
    assert_picture(&picture(&scene, &view, 9, 7), 9, disc);
    // Orthographic: its radius is 3, and a row is 1.2.
    let view = CameraDescriptor { projection: Projection::Orthographic { height: 7.2 }, ..VIEW };
    assert_picture(&picture(&scene, &view, 9, 7), 9, disc);
}

#[test]
fn the_camera_keeps_up_and_right_from_every_side() {
    // A small sphere above the center and a smaller one to the right of it.
    let mut scene = TestScene::new();
    scene.material(unlit(Rgb::WHITE));
    scene.sphere(vec3(0.0, 2.0, 0.0), 0.9);
    scene.material(unlit(Rgb::gray(0.25)));
    scene.sphere(vec3(2.0, 0.0, 0.0), 0.5);
    scene.ambient = Rgb::WHITE;
    let picture_from = |from: Vec3, up: Vec3| {
        let view = CameraDescriptor {
            position: from,
            target: Vec3::ZERO,
            up,
            projection: Projection::Orthographic { height: 4.0 },
        };
        picture(&scene, &view, 5, 5)
    };
    assert_picture(
        &picture_from(vec3(0.0, 0.0, 9.0), vec3(0.0, 1.0, -3.0)),
        5,
        "..#.. ..... ....+ ..... .....",
    );
    assert_picture(&picture_from(vec3(0.0, 0.0, -9.0), Vec3::Y), 5, "..#.. ..... +.... ..... .....");
    assert_picture(&picture_from(vec3(0.0, 0.0, 9.0), Vec3::X), 5, "..+.. ..... #.... ..... .....");
}

#[test]
fn a_checkered_floor_changes_at_every_cell() {
    let mut scene = TestScene::new();
    let texture = scene.add_texture(Texture::Checker {
        even: Rgb::WHITE,
        odd: Rgb::gray(0.5),
        origin: vec3(0.0, 7.0, 0.0),
        frequency: vec3(0.5, 0.0, 1.0),
    });
    scene.material(Material { texture, ..unlit(Rgb::WHITE) });
    scene.disc(Vec3::ZERO, Vec3::Y, 3.3);
    scene.ambient = Rgb::WHITE;
    let from = vec3(0.0, 5.0, 0.0);
    let view = CameraDescriptor {
        position: from,
        target: Vec3::ZERO,
        up: -Vec3::Z,
        projection: Projection::Orthographic { height: 7.0 },
    };
    assert_picture(
        &picture(&scene, &view, 8, 8),
        8,
        "
        ........
        ..##oo..
        .#oo##o.
        .o##oo#.
        .#oo##o.
        .o##oo#.
        ..oo##..
        ........",
    );
}

#[test]
fn a_background_changes_with_the_height_of_the_direction() {
    let mut scene = TestScene::new();
    let (below, above) = (Rgb::new(1.0, 0.0, 0.25), Rgb::new(0.0, 0.5, 0.25));
    scene.background = Background::Gradient { up: Vec3::Y, below, above };
    assert_eq!(scene.trace(Vec3::ONE, vec3(1.0, 9.0, 1.0), ALL), above);
    assert_eq!(scene.trace(Vec3::ONE, vec3(1.0, -9.0, 1.0), ALL), below);
    assert_eq!(scene.trace(Vec3::ONE, vec3(9.0, 1.0, 5.0), ALL), Rgb::new(0.5, 0.25, 0.25));
    // 3, 4, 5: the height of the direction is 0.6.
    assert_color(scene.trace(Vec3::ZERO, vec3(0.0, 3.0, -4.0), ALL), [0.2, 0.4, 0.25], ROUNDINGS);
}

/// Color of a triangle in z = 0 whose front faces +z, with one light on one side.
fn triangle_color(two_sided: bool, viewpoint: Real, light: Real) -> Rgb {
    let mut scene = TestScene::new();
    scene.material(Material { ambient: Rgb::BLACK, two_sided, ..Material::MATTE });
    scene.polygon(&[vec3(-1.0, -1.0, 0.0), vec3(1.0, -1.0, 0.0), vec3(0.0, 1.0, 0.0)], &[]);
    let source = LightSource::Point { position: vec3(0.0, 0.0, light), falloff: Falloff::NONE };
    scene.lights.push(Light { source, color: Rgb::WHITE, casts_shadows: true });
    scene.trace(vec3(0.0, 0.0, viewpoint), Vec3::ZERO, ALL)
}

#[test]
fn a_two_sided_surface_is_lit_on_the_side_of_the_camera() {
    for (viewpoint, light, lit) in
        [(2.0, 3.0, true), (2.0, -3.0, false), (-2.0, -3.0, true), (-2.0, 3.0, false)]
    {
        assert_eq!(
            triangle_color(true, viewpoint, light),
            if lit { Rgb::WHITE } else { Rgb::BLACK },
            "{viewpoint} {light}"
        );
    }
}

#[test]
fn a_one_sided_surface_is_shaded_as_its_front_on_both_sides() {
    for (viewpoint, light, lit) in
        [(2.0, 3.0, true), (2.0, -3.0, false), (-2.0, -3.0, false), (-2.0, 3.0, true)]
    {
        assert_eq!(
            triangle_color(false, viewpoint, light),
            if lit { Rgb::WHITE } else { Rgb::BLACK },
            "{viewpoint} {light}"
        );
    }
}
