//! strahl's own ways of finding.

use strahl_core::accel::{
    Accelerator, Bvh, BvhBuilder, BvhNode, BvhSize, LeafEntry, LeafLayout, TraversalHeap, TraversalStack,
    TriangleBlock,
};
use strahl_core::geometry::{Aabb, Ray, ShapeKind, ShapeSet};
use strahl_core::scene::{EffectSet, Effects};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{Geometry, Material, MaterialId, Scene, SceneDescriptor, Shape, World};

use crate::contest::{Contender, Found, WAY};
use crate::mesh::Mesh;

/// Triangles and nothing else.
pub struct Triangles;

impl Effects for Triangles {
    const SET: EffectSet = EffectSet {
        shapes: ShapeSet::of(&[ShapeKind::Triangle, ShapeKind::SmoothTriangle]),
        ..EffectSet::NONE
    };
}

/// The tables of a mesh.
pub struct Tables {
    shapes: Vec<Shape>,
    points: Vec<strahl_core::Vec3>,
    material_ids: Vec<MaterialId>,
    pub boxes: Vec<Aabb>,
}

impl Tables {
    pub fn of(mesh: &Mesh) -> Self {
        let shapes: Vec<Shape> = mesh.triangles.iter().map(|corners| Shape::Triangle(*corners)).collect();
        let material_ids = vec![MaterialId(0); shapes.len()];
        let mut tables = Tables { shapes, points: mesh.points.clone(), material_ids, boxes: Vec::new() };
        tables.boxes = tables.scene().descriptor().geometry.all_bounds().collect();
        tables
    }

    pub fn scene(&self) -> Scene<'_> {
        let geometry = Geometry { shapes: &self.shapes, vertices: &self.points, ..Geometry::EMPTY };
        Scene::new(SceneDescriptor {
            geometry,
            material_ids: &self.material_ids,
            materials: &[Material::MATTE],
            ..SceneDescriptor::EMPTY
        })
        .expect("a mesh is a scene")
    }
}

/// A world and what its walks remember.
struct Asked<'s, A: Accelerator> {
    world: World<'s, A>,
    scratch: A::Scratch,
    bytes: usize,
}

impl<A: Accelerator> Contender for Asked<'_, A> {
    fn bytes(&self) -> usize {
        self.bytes
    }

    fn closest(&mut self, ray: &Ray) -> Option<Found> {
        let hit = self.world.nearest_hit::<Triangles, ()>(
            ray,
            f32::MAX,
            RayKind::Camera,
            &mut self.scratch,
            &mut (),
        );
        hit.map(|hit| Found { t: hit.t, item: hit.item.0 })
    }

    fn any(&mut self, ray: &Ray, reach: f32) -> bool {
        self.world
            .occluder::<Triangles, ()>(ray, reach, RayKind::Shadow, &mut self.scratch, &mut ())
            .is_some()
    }
}

/// The memory of a hierarchy.
pub struct Room {
    nodes: Vec<BvhNode>,
    items: Vec<LeafEntry>,
    runs: Vec<TriangleBlock>,
}

impl Room {
    pub fn of(items: usize) -> Self {
        let BvhSize { nodes, entries: items } = BvhSize::recommended(items);
        Room { nodes: vec![BvhNode::EMPTY; nodes], items: vec![LeafEntry::EMPTY; items], runs: Vec::new() }
    }
}

/// Builds the hierarchy with its leaves in runs.
fn tree<'s>(tables: &Tables, room: &'s mut Room) -> Bvh<'s, (), TriangleBlock> {
    let Room { nodes, items, runs } = room;
    let geometry = tables.scene().descriptor().geometry;
    let grown = BvhBuilder::new(&tables.boxes, LeafLayout::TriangleBlocks(&geometry), nodes, items)
        .expect("there is room");
    runs.resize(grown.block_count(), TriangleBlock::EMPTY);
    grown.into_bvh_with_blocks(&geometry, runs).expect("there is room")
}

/// Builds, and answers by a stack and by a heap.
pub fn hierarchy<'s>(tables: &'s Tables, room: &'s mut Room) -> [(&'static str, Box<dyn Contender + 's>); 2] {
    let tree = tree(tables, room);
    let bytes = tree.size_in_bytes() + tables.scene().descriptor().geometry.size_in_bytes();
    [
        ("strahl, stack", asked(tables, tree.with_queue::<TraversalStack<64>>(), bytes)),
        ("strahl, heap", asked(tables, tree.with_queue::<TraversalHeap<64>>(), bytes)),
    ]
}

fn asked<'s, A: Accelerator + 's>(
    tables: &'s Tables,
    accelerator: A,
    bytes: usize,
) -> Box<dyn Contender + 's> {
    Box::new(Asked { world: World::new(tables.scene(), accelerator), scratch: A::Scratch::default(), bytes })
}

/// What walks count: boxes, leaves and triangles per ray, for the closest hit and for any.
pub fn counted(tables: &Tables, room: &mut Room, rays: &[Ray]) -> [[f64; 3]; 2] {
    let world = World::new(tables.scene(), tree(tables, room).with_queue::<TraversalStack<64>>());
    let mut counters = Counters::new();
    let mut scratch = TraversalStack::default();
    for ray in rays {
        let _ =
            world.nearest_hit::<Triangles, _>(ray, f32::MAX, RayKind::Camera, &mut scratch, &mut counters);
        let _ = world.occluder::<Triangles, _>(ray, WAY, RayKind::Shadow, &mut scratch, &mut counters);
    }
    [RayKind::Camera, RayKind::Shadow].map(|kind| {
        [counters.box_tests[kind], counters.leaf_visits[kind], counters.shape_tests[kind]]
            .map(|count| count as f64 / rays.len() as f64)
    })
}
