//! An opened scene equals the baked one.

use crate::*;

#[test]
fn a_baked_scene_is_opened_unchanged() {
    let scene = mixed_scene();
    for bytes in baked_with_every_accelerator(&scene) {
        let aligned = AlignedBytes::of(&bytes);
        let pack = BakedScene::open(aligned.bytes()).unwrap();
        let (baked, opened) = (scene.as_scene(), pack.scene());
        assert_eq!(format!("{:?}", baked.descriptor()), format!("{:?}", opened.descriptor()));
        assert_eq!(baked.required_effects(), opened.required_effects());
        assert_eq!(
            (*pack.camera_descriptor(), pack.resolution(), pack.levels(), pack.cutoff()),
            (VIEW, SIZE, 4, 0.01)
        );
        // In place: the tables point into the bytes.
        let within = aligned.bytes().as_ptr_range();
        assert!(within.contains(&opened.descriptor().geometry.shapes.as_ptr().cast()));
    }
}

#[test]
fn a_baked_scene_has_the_same_picture_bit_for_bit() {
    let scene = mixed_scene();
    let camera = Camera::new(&VIEW, SIZE).unwrap();
    let expected = picture(scene.as_scene(), List::without_bounds(scene.item_count()), camera);
    for bytes in baked_with_every_accelerator(&scene) {
        let aligned = AlignedBytes::of(&bytes);
        let pack = BakedScene::open(aligned.bytes()).unwrap();
        assert!(picture_of(&pack).unwrap() == expected);
    }
}

#[test]
fn an_empty_scene_is_baked_and_opened() {
    for bytes in baked_with_every_accelerator(&TestScene::new()) {
        let aligned = AlignedBytes::of(&bytes);
        let pack = BakedScene::open(aligned.bytes()).unwrap();
        assert!(picture_of(&pack).unwrap().iter().all(|pixel| *pixel == [0; 3]));
    }
}

#[test]
fn a_baked_scene_has_exactly_one_accelerator() {
    let [list, grid, octree, bvh] =
        <[Vec<u8>; 4]>::try_from(baked_with_every_accelerator(&mixed_scene())).unwrap();
    let wrong = BakedSceneError::Section(BakedSection::Accelerator);
    let open = |bytes: &[u8]| {
        let aligned = AlignedBytes::of(bytes);
        let pack = BakedScene::open(aligned.bytes()).unwrap();
        (
            pack.grid::<0>().err(),
            pack.octree::<0>().err(),
            pack.bvh::<()>().err(),
            pack.list_without_bounds().0,
        )
    };
    let count = mixed_scene().item_count();
    assert_eq!(open(&list), (Some(wrong), Some(wrong), Some(wrong), count));
    assert_eq!(open(&grid), (None, Some(wrong), Some(wrong), count));
    assert_eq!(open(&octree), (Some(wrong), None, Some(wrong), count));
    assert_eq!(open(&bvh), (Some(wrong), Some(wrong), None, count));
}
