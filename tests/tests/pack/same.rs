//! What was written is what is opened.

use crate::*;

#[test]
fn a_baked_scene_is_opened_as_it_was() {
    let scene = fair();
    for bytes in every_pack(&scene) {
        let aligned = Aligned::of(&bytes);
        let pack = Pack::open(aligned.bytes()).unwrap();
        let (was, is) = (scene.as_scene(), pack.scene());
        assert_eq!(format!("{:?}", was.descriptor()), format!("{:?}", is.descriptor()));
        assert_eq!(was.required_effects(), is.required_effects());
        assert_eq!((*pack.view(), pack.size(), pack.levels(), pack.cutoff()), (VIEW, SIZE, 4, 0.01));
        // In place: the tables are the bytes themselves.
        let within = aligned.bytes().as_ptr_range();
        assert!(within.contains(&is.descriptor().geometry.shapes.as_ptr().cast()));
    }
}

#[test]
fn a_baked_scene_has_the_same_picture_bit_for_bit() {
    let scene = fair();
    let camera = Camera::new(&VIEW, SIZE).unwrap();
    let truth = picture(scene.as_scene(), List::without_bounds(scene.item_count()), camera);
    for bytes in every_pack(&scene) {
        let aligned = Aligned::of(&bytes);
        let pack = Pack::open(aligned.bytes()).unwrap();
        assert!(picture_of(&pack).unwrap() == truth);
    }
}

#[test]
fn an_empty_scene_is_baked_and_opened() {
    for bytes in every_pack(&TestScene::new()) {
        let aligned = Aligned::of(&bytes);
        let pack = Pack::open(aligned.bytes()).unwrap();
        assert!(picture_of(&pack).unwrap().iter().all(|pixel| *pixel == [0; 3]));
    }
}

#[test]
fn a_pack_says_which_accelerator_it_has() {
    let [bare, grid, octree, bvh] = <[Vec<u8>; 4]>::try_from(every_pack(&fair())).unwrap();
    let wrong = PackError::Part(PackPart::Finder);
    let open = |bytes: &[u8]| {
        let aligned = Aligned::of(bytes);
        let pack = Pack::open(aligned.bytes()).unwrap();
        (pack.grid::<0>().err(), pack.octree::<0>().err(), pack.bvh::<()>().err(), pack.bare().0)
    };
    let count = fair().item_count();
    assert_eq!(open(&bare), (Some(wrong), Some(wrong), Some(wrong), count));
    assert_eq!(open(&grid), (None, Some(wrong), Some(wrong), count));
    assert_eq!(open(&octree), (Some(wrong), None, Some(wrong), count));
    assert_eq!(open(&bvh), (Some(wrong), Some(wrong), None, count));
}
