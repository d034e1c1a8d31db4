//! strahl's accelerators.

use strahl_core::accel::{
    Accelerator, Bvh, BvhBuilder, BvhEntry, BvhNode, BvhSize, LeafLayout, TraversalHeap, TraversalStack,
    TriangleBlock,
};
use strahl_core::geometry::{Aabb, Ray, ShapeKind, ShapeKindSet};
use strahl_core::scene::{EffectSet, Effects};
use strahl_core::tally::{Counters, RayKind};
use strahl_core::{Geometry, Material, MaterialId, Scene, SceneDescriptor, Shape, World};

use crate::comparison::{ANY_HIT_T_MAX, ClosestTriangle, Contender};
use crate::mesh::BenchMesh;

/// Triangles only.
pub struct TriangleBenchEffects;

impl Effects for TriangleBenchEffects {
    const SET: EffectSet = EffectSet {
        shapes: ShapeKindSet::of(&[ShapeKind::Triangle, ShapeKind::SmoothTriangle]),
        ..EffectSet::NONE
    };
}

/// Scene tables of a mesh.
pub struct MeshTables {
    shapes: Vec<Shape>,
    points: Vec<strahl_core::Vec3>,
    material_ids: Vec<MaterialId>,
    pub boxes: Vec<Aabb>,
}

impl MeshTables {
    pub fn of(mesh: &BenchMesh) -> Self {
        let shapes: Vec<Shape> = mesh.triangles.iter().map(|corners| Shape::Triangle(*corners)).collect();
        let material_ids = vec![MaterialId(0); shapes.len()];
        let mut tables = MeshTables { shapes, points: mesh.points.clone(), material_ids, boxes: Vec::new() };
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
        .expect("a mesh is a valid scene")
    }
}

/// A world and its scratch memory.
struct StrahlContender<'s, A: Accelerator> {
    world: World<'s, A>,
    scratch: A::Scratch,
    bytes: usize,
}

impl<A: Accelerator> Contender for StrahlContender<'_, A> {
    fn bytes(&self) -> usize {
        self.bytes
    }

    fn intersect_nearest(&mut self, ray: &Ray) -> Option<ClosestTriangle> {
        let hit = self.world.nearest_hit::<TriangleBenchEffects, ()>(
            ray,
            f32::MAX,
            RayKind::Camera,
            &mut self.scratch,
            &mut (),
        );
        hit.map(|hit| ClosestTriangle { t: hit.t, item: hit.item.0 })
    }

    fn occluded(&mut self, ray: &Ray, t_max: f32) -> bool {
        self.world
            .occluder::<TriangleBenchEffects, ()>(ray, t_max, RayKind::Shadow, &mut self.scratch, &mut ())
            .is_some()
    }
}

/// Buffers of a BVH.
pub struct BvhBuffers {
    nodes: Vec<BvhNode>,
    items: Vec<BvhEntry>,
    block_buffer: Vec<TriangleBlock>,
}

impl BvhBuffers {
    pub fn of(items: usize) -> Self {
        let BvhSize { nodes, entries: items } = BvhSize::recommended(items);
        BvhBuffers {
            nodes: vec![BvhNode::EMPTY; nodes],
            items: vec![BvhEntry::EMPTY; items],
            block_buffer: Vec::new(),
        }
    }
}

/// Builds the BVH with triangle blocks.
fn tree<'s>(tables: &MeshTables, buffers: &'s mut BvhBuffers) -> Bvh<'s, (), TriangleBlock> {
    let BvhBuffers { nodes, items, block_buffer } = buffers;
    let geometry = tables.scene().descriptor().geometry;
    let builder = BvhBuilder::new(&tables.boxes, LeafLayout::TriangleBlocks(&geometry), nodes, items)
        .expect("the buffers are large enough");
    block_buffer.resize(builder.block_count(), TriangleBlock::EMPTY);
    builder.into_block_bvh(&geometry, block_buffer).expect("the buffers are large enough")
}

/// Builds the BVH, traversed with a stack and with a heap.
pub fn contenders<'s>(
    tables: &'s MeshTables,
    buffers: &'s mut BvhBuffers,
) -> [(&'static str, Box<dyn Contender + 's>); 2] {
    let tree = tree(tables, buffers);
    let bytes = tree.size_in_bytes() + tables.scene().descriptor().geometry.size_in_bytes();
    [
        ("strahl, stack", contender(tables, tree.with_queue::<TraversalStack<64>>(), bytes)),
        ("strahl, heap", contender(tables, tree.with_queue::<TraversalHeap<64>>(), bytes)),
    ]
}

fn contender<'s, A: Accelerator + 's>(
    tables: &'s MeshTables,
    accelerator: A,
    bytes: usize,
) -> Box<dyn Contender + 's> {
    Box::new(StrahlContender {
        world: World::new(tables.scene(), accelerator),
        scratch: A::Scratch::default(),
        bytes,
    })
}

/// Box tests, leaf visits and triangle tests per ray, for nearest-hit and any-hit queries.
pub fn counted(tables: &MeshTables, buffers: &mut BvhBuffers, rays: &[Ray]) -> [[f64; 3]; 2] {
    let world = World::new(tables.scene(), tree(tables, buffers).with_queue::<TraversalStack<64>>());
    let mut counters = Counters::new();
    let mut scratch = TraversalStack::default();
    for ray in rays {
        let _ = world.nearest_hit::<TriangleBenchEffects, _>(
            ray,
            f32::MAX,
            RayKind::Camera,
            &mut scratch,
            &mut counters,
        );
        let _ = world.occluder::<TriangleBenchEffects, _>(
            ray,
            ANY_HIT_T_MAX,
            RayKind::Shadow,
            &mut scratch,
            &mut counters,
        );
    }
    [RayKind::Camera, RayKind::Shadow].map(|kind| {
        [counters.box_tests[kind], counters.leaf_visits[kind], counters.shape_tests[kind]]
            .map(|count| count as f64 / rays.len() as f64)
    })
}
