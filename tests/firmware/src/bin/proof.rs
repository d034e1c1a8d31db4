//! The proof that nothing in the core can panic: it links only without a way to a panic.
//!
//! The panic handler calls a function that nobody defines. Where the optimiser could not remove
//! every path to it, the linker asks for `a_panic_is_reachable`. What is not called is not
//! proven, so every public door of the core is opened here, with numbers of which the optimiser
//! knows nothing. To be linked, never to be run.
//!
//! When it does not link: let the handler loop, link, and look in `objdump -d -C` for who calls
//! `core::panicking`.

#![no_std]
#![no_main]

use core::fmt::{self, Debug, Write};
use core::hint::black_box;
use core::ops::ControlFlow;

use cortex_m_rt::entry;
use embedded_graphics_core::Pixel as Dot;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size as Extent};
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::primitives::Rectangle;
use strahl_core::*;

unsafe extern "C" {
    fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: it is never called, for it does not exist.
    unsafe { a_panic_is_reachable() }
}

#[entry]
fn main() -> ! {
    loop {
        ground();
        sets();
        shapes();
        geometry();
        finding();
        scene();
        camera();
        light();
        counters();
        pictures();
        packs();
        errors();
        #[cfg(feature = "canary")]
        canary();
    }
}

/// Something in place of the example, of which the optimiser knows no more than the type.
fn any<T>(example: T) -> T {
    black_box(example)
}

/// Takes a result, so that what leads to it is not left out.
fn used<T>(result: T) {
    black_box(result);
}

/// A slice of any length, any place and any content.
fn slice<T>(example: &[T]) -> &[T] {
    any(example)
}

fn number() -> Real {
    any(1.0)
}

fn vector() -> Vec3 {
    any(Vec3::X)
}

fn color() -> Rgb {
    any(Rgb::WHITE)
}

fn item() -> ItemId {
    any(ItemId(0))
}

fn ray() -> Ray {
    Ray::new(vector(), vector()).at_time(number())
}

/// The panic that shows that the proof can fail.
#[cfg(feature = "canary")]
fn canary() {
    used(slice(&[1, 2, 3])[any(0)]);
}

fn ground() {
    used((vec3(number(), number(), number()), unit(vector()), sqrt(number()), gamma(any(3))));
    let roots: CubicRoots = cubic_roots([number(); 4], number(), number());
    roots.iter().for_each(used);
    used(root_between(|x| (x, number()), number(), number(), any(true)));
    used(difference_of_products(number(), number(), number(), number()));
    used((FARTHEST, PI, ROUNDOFF, Rgb::BLACK, Rgb::BRIGHTEST));

    let c = Rgb::new(number(), number(), number());
    used((c.largest(), c.is_black(), c.is_within(number()), c.at_most(number())));
    used((c.toward(Rgb::gray(number()), number()), c.map(any), c.to_srgb8(), Rgb::default()));
    used(Rgb::contrast(slice(&[Rgb::WHITE]).iter().copied()));
    let mut sum = c + color();
    sum += c * color();
    sum *= c * number();
    used(sum);
}

fn sets() {
    // Each set is made by the same macro, for an enum of its own.
    macro_rules! set {
        ($Set:ident of $Kind:ident) => {{
            let set = $Set::of(slice(&$Kind::ALL)).with(any($Kind::ALL[0])).union(any($Set::NONE));
            used((set.len(), set.is_empty(), set.has(any($Kind::ALL[0])), set.contains(any($Set::ALL))));
            set.iter().for_each(used);
            debugged(&set);
            set
        }};
    }
    let mut set = any(EffectSet::NONE);
    set.shapes = set!(ShapeSet of ShapeKind);
    set.lights = set!(LightSet of LightKind);
    set.textures = set!(TextureSet of TextureKind);
    used(set.contains(&any(EffectSet::ALL)));
    RayKind::ALL.into_iter().for_each(used);
    used(any(ShapeKind::Sphere).name());
}

fn shapes() {
    used(Cone::new(vector(), number(), vector(), number(), any(true)));
    used(TurnedCuboid::new(vector(), vector(), vector(), vector()));
    used(Polygon::new(any(0), slice(&[Vec3::X]), any(true)));
    used(any(SHAPES[0]).kind());

    let aabb = Aabb::around(slice(&[Vec3::X]).iter().copied()).union(Aabb::round(vector(), vector()));
    let span: Option<Span> = aabb.span(&ray());
    used((span, aabb.is_empty(), any(Aabb::EMPTY), Aabb::of_points(slice(&[Vec3::X]))));

    used((ray().at(number()), leave(vector(), vector(), vector())));
    used(has_area([vector(), vector(), vector()]));
    let axis = Axis::largest_of(vector());
    used(axis.to_third(vector()));
}

/// One of each.
static SHAPES: [Shape; 10] = [
    Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 }),
    Shape::Triangle([0, 1, 2]),
    Shape::SmoothTriangle([0, 1, 2]),
    Shape::Plane(0),
    Shape::Disc(0),
    Shape::Polygon(0),
    Shape::Cuboid(0),
    Shape::TurnedCuboid(0),
    Shape::Cone(0),
    Shape::Torus(0),
];

/// Shapes and tables of any length with anything in them, whether they fit together or not.
fn any_geometry() -> Geometry<'static> {
    const CONE: Cone = Cone {
        base: Vec3::ZERO,
        axis: Vec3::Y,
        height: 1.0,
        base_radius: 1.0,
        end_radius: 0.0,
        capped: true,
    };
    Geometry {
        shapes: slice(&SHAPES),
        points: slice(&[Vec3::ZERO]),
        normals: slice(&[Vec3::Y]),
        planes: slice(&[Plane { point: Vec3::ZERO, normal: Vec3::Y, item: ItemId(3) }]),
        discs: slice(&[Disc { center: Vec3::ZERO, normal: Vec3::Y, radius: 1.0 }]),
        polygons: slice(&[Polygon {
            first: 0,
            count: 3,
            point: Vec3::ZERO,
            normal: Vec3::Y,
            bounds: Aabb::EMPTY,
            smooth: true,
        }]),
        cuboids: slice(&[Cuboid { min: Vec3::ZERO, max: Vec3::ONE }]),
        turned_cuboids: slice(&[TurnedCuboid {
            center: Vec3::ZERO,
            half: Vec3::ONE,
            axes: [Vec3::X, Vec3::Y, Vec3::Z],
        }]),
        cones: slice(&[CONE]),
        tori: slice(&[Torus { center: Vec3::ZERO, axis: Vec3::Y, major: 1.0, minor: 0.5 }]),
        moving: slice(&[Moving { shape: Shape::Triangle([0, 1, 2]), opening: Vec3::ZERO, closing: Vec3::X }]),
    }
}

fn geometry() {
    /// Somebody who has shapes, but is no tracer.
    struct Bare;
    impl Shapes for Bare {
        const SHAPES: ShapeSet = ShapeSet::ALL;
        const SMOOTH: bool = false;
        const MOTION: bool = true;
    }
    fn met<S: Shapes>(geometry: &Geometry<'_>) {
        used((geometry.kind(&any(SHAPES[0])), geometry.offset(&any(SHAPES[0]), number())));
        used(geometry.distance::<S>(any(&SHAPES[0]), &ray()));
        let surface: Option<Surface> = geometry.surface::<S>(any(&SHAPES[0]), &ray(), number());
        used(surface);
    }
    let geometry = any_geometry();
    used((geometry.check(), geometry.shape(item()), geometry.bounds(item())));
    geometry.all_bounds().for_each(used);
    met::<Bare>(&geometry);
    met::<Everything>(&geometry);
}

/// Offers what it likes, as often as it likes.
struct Stranger;

impl Accelerator for Stranger {
    type Scratch = u32;

    fn walk<Q: Query>(&self, ray: &Ray, scratch: &mut u32, query: &mut Q) {
        used((ray, any(scratch)));
        while any(true) {
            query.enter();
            query.boxes(any(1));
            used(query.reach());
            if query.test(item()).is_break() {
                return;
            }
        }
    }
}

/// Looks for nobody knows what.
struct Anybody;

impl Query for Anybody {
    fn reach(&self) -> Real {
        number()
    }

    fn test(&mut self, item: ItemId) -> ControlFlow<()> {
        used(item);
        any(ControlFlow::Continue(()))
    }

    fn boxes(&mut self, count: u32) {
        used(count);
    }

    fn enter(&mut self) {}

    fn skipped(&mut self) {}
}

/// Lists of any length, in lent memory of any length.
fn lists<'s>(lent: &'s mut [Aabb], balls: [&'s mut [Ball]; 2]) -> [List<'s>; 3] {
    let bare = List::bare(any(1));
    let boxes = slice(&[Aabb::EMPTY]);
    let [items, groups] = balls.map(any);
    [bare, List::boxed(boxes, any(lent)).unwrap_or(bare), List::balled(boxes, items, groups).unwrap_or(bare)]
}

fn finding() {
    used(groups_of(any(1)));
    for list in lists(&mut [Aabb::EMPTY], [&mut [Ball::EMPTY], &mut [Ball::EMPTY]]) {
        used(list.bytes());
        list.walk(&ray(), &mut (), &mut Anybody);
    }
    tree::<LastFirst<2>>();
    tree::<NearestFirst<2>>();
    subdivisions::<0>();
    subdivisions::<8>();
}

/// A hierarchy of anything, in lent memory of any length.
fn tree<W: Waiting>() {
    used(BvhRoom::comfortable(any(1)));
    let (mut nodes, mut items) = ([Node::EMPTY; 2], [Slot::EMPTY; 2]);
    let (nodes, items) = (any(nodes.as_mut_slice()), any(items.as_mut_slice()));
    let boxes = slice(&[Aabb::EMPTY]);
    let geometry = any_geometry();
    match any(Leaves::Runs(&geometry)) {
        Leaves::Singly => {
            let Ok(tree) = Bvh::<()>::build(boxes, nodes, items) else { return };
            hierarchy(tree.walked::<W>());
        }
        leaves => {
            let Ok(grown) = Grown::build(boxes, leaves, nodes, items) else { return };
            used(grown.runs());
            let mut runs = [Run::EMPTY; 2];
            let Ok(tree) = grown.in_runs::<W>(&geometry, any(runs.as_mut_slice())) else { return };
            hierarchy(tree);
        }
    }
    if let Ok(grown) = Grown::build(boxes, any(Leaves::Singly), &mut [Node::EMPTY], &mut [Slot::EMPTY]) {
        hierarchy(grown.singly::<W>());
    }
}

fn hierarchy<W: Waiting, L: Leaf>(tree: Bvh<'_, W, L>) {
    used((tree.bytes(), tree.regions(), tree.entries(), tree.depth()));
    tree.walked::<W>().walk(&ray(), &mut W::default(), &mut Anybody);
    used(any(Run::EMPTY).items().count());
}

/// A grid and an octree of anything, in lent memory of any length.
fn subdivisions<const MAILBOX: usize>() {
    let boxes = slice(&[Aabb::EMPTY]);
    let mut mailbox = any(Mailbox::<MAILBOX>::new());
    mailbox.forget();
    used((GridRoom::comfortable(boxes), GridRoom::of_items(any(1)), OctreeRoom::comfortable(any(1))));

    let (mut cells, mut items) = ([0; 2], [0; 2]);
    let (cells, items) = (any(cells.as_mut_slice()), any(items.as_mut_slice()));
    if let Ok(grid) = Grid::<MAILBOX>::with_density(number(), boxes, cells, items) {
        used((grid.bytes(), grid.regions(), grid.entries(), grid.cells()));
        grid.walk(&ray(), &mut mailbox, &mut Anybody);
        grid.without_boxes().walk(&ray(), &mut mailbox, &mut Anybody);
    }
    let mut memory = StaticGrid::<5, 7>::new();
    if let Ok(grid) = memory.build::<MAILBOX>(boxes) {
        grid.walk(&ray(), &mut mailbox, &mut Anybody);
    }

    let (mut nodes, mut items) = ([OctreeNode::EMPTY; 2], [0; 2]);
    let (nodes, items) = (any(nodes.as_mut_slice()), any(items.as_mut_slice()));
    used(Octree::<MAILBOX>::build(boxes, nodes, items).is_ok());
    if let Ok(tree) = Octree::<MAILBOX>::with_limits(any(OctreeLimits::DEFAULT), boxes, nodes, items) {
        used((tree.bytes(), tree.regions(), tree.entries(), tree.nodes(), tree.depth()));
        tree.walk(&ray(), &mut mailbox, &mut Anybody);
        tree.without_boxes().walk(&ray(), &mut mailbox, &mut Anybody);
    }
}

static MATERIALS: [Material; 1] = [Material::MATTE];

/// Parts with anything in them, whether they fit together or not.
fn any_parts() -> Parts<'static> {
    const CHECKER: Texture =
        Texture::Checker { even: Rgb::WHITE, odd: Rgb::BLACK, origin: Vec3::ZERO, frequency: Vec3::ONE };
    const LAMP: Light = Light {
        source: Source::Point { position: Vec3::ZERO, falloff: Falloff::SQUARE },
        color: Rgb::WHITE,
        shadows: true,
    };
    Parts {
        geometry: any_geometry(),
        made_of: slice(&[MaterialId(0)]),
        materials: slice(&MATERIALS),
        textures: slice(&[CHECKER]),
        lights: slice(&[LAMP]),
        ambient: color(),
        background: any(Background::Color(Rgb::BLACK)),
        colored_shadows: any(true),
    }
}

fn scene() {
    let Ok(scene) = Scene::new(any_parts()) else { return };
    used((scene.parts(), scene.effects(), scene.material(item())));
    used((Scene::new(any(Parts::EMPTY)).is_ok(), any(Background::Color(Rgb::BLACK)).toward(vector())));

    let material = any(Material { interface: any(Interface::Fresnel), ..Material::MATTE });
    used((
        material.is_transmitting(),
        material.is_shiny(),
        material.is_absorbing(),
        material.is_lit(),
        material.is_rough(),
    ));
    if let (Some(light), Some(texture)) = (scene.parts().lights.first(), scene.parts().textures.first()) {
        used((light.kind(), light.is_soft(), texture.kind(), any(Falloff::NONE)));
    }

    let mut lent = [Aabb::EMPTY];
    let [list, ..] = lists(&mut lent, [&mut [], &mut []]);
    asked::<_, Everything>(World::new(scene, list));
    asked::<_, Few>(World::new(scene, Stranger));
}

/// Spheres and nothing else.
struct Few;

impl Effects for Few {
    const SET: EffectSet = EffectSet { shapes: ShapeSet::of(&[ShapeKind::Sphere]), ..EffectSet::NONE };
}

/// What it does not see is the sky.
struct ShortSighted;

impl Effects for ShortSighted {
    const SET: EffectSet =
        EffectSet { lights: LightSet::ALL, reflection: true, transmission: true, ..Few::SET };
    const SIGHT: Real = 10.0;
    const LAST: LastLevel = LastLevel::Background;
}

fn asked<A: Accelerator, E: Effects>(world: World<'_, A>) {
    let (kind, mut scratch) = (any(RayKind::Shadow), A::Scratch::default());
    used((world.scene(), world.accelerator()));
    used(world.nearest::<E, _>(&ray(), number(), kind, &mut scratch, &mut Told));
    used(world.blocker::<E, _>(&ray(), number(), kind, &mut scratch, &mut Told));
    used(world.blocks::<E, _>(item(), &ray(), number(), kind, &mut Told));
    used(world.surface::<E>(&ray(), any(Hit { t: 1.0, item: ItemId(0) })));
}

/// Hears of everything and remembers nothing.
struct Told;

impl Tally for Told {
    fn count(&mut self, event: Event) {
        used(event);
    }

    fn tell(&mut self, step: Step) {
        used(step);
    }
}

fn size() -> Size {
    any(Size::new(any(1), any(1))).unwrap_or(const { Size::new(1, 1).unwrap() })
}

fn any_camera() -> Option<Camera> {
    let projection = any(Projection::Perspective { angle: 1.0 });
    Camera::new(&View { from: vector(), at: vector(), up: vector(), projection }, size()).ok()
}

fn camera() {
    used((size().width(), size().height()));
    used(any_camera().map(|camera| (camera.ray(any(Place { x: 0.0, y: 0.0 })), camera.has_lens())));
}

fn light() {
    let refraction: Option<Refraction> = refracted(vector(), vector(), number());
    used((reflected(vector(), vector()), refraction, absorbed(color(), number())));

    let (materials, body) = (slice(&MATERIALS), any(MaterialId(0)));
    let mut media = Media::NONE;
    while any(true) {
        let crossing: Crossing =
            if any(true) { media.entering(body, materials) } else { media.leaving(body, materials) };
        used((media.in_force(materials), index(crossing.behind, materials), &crossing));
        media = crossing.media;
    }
    // Not only what a way through bodies leads to.
    let media = any(Media::NONE);
    used((media.in_force(materials), media.entering(body, materials), media.leaving(body, materials)));
}

fn counters() {
    let mut counters = any(Counters::new());
    counters.count(any(Event::MediaFull));
    counters.add(&any(Counters::default()));
    let (kind, shape) = (any(RayKind::Camera), any(ShapeKind::Sphere));
    used((counters.rays(kind), counters.camera_hits(), counters.boxes(kind), counters.shapes(kind)));
    used((
        counters.regions(kind),
        counters.skipped(kind),
        counters.shadow_cache_asked(),
        counters.shadow_cache_hits(),
        counters.by_shape(shape),
        counters.media_full(),
        counters.level_limit_weight(),
        counters.cutoff_weight(),
    ));
    used((counters.level_limit(), counters.cutoff(), counters.deepest()));
    let mut rays = any(RayCounters::new());
    rays.count(any(Event::MediaFull));
    used(rays.counters());
    ().count(any(Event::MediaFull));
    ().tell(any(Step::ThrownBack));
    used((any(Fate::Sent), any(Lit::Dark)));
}

fn pictures() {
    tiles();
    let Ok(scene) = Scene::new(any_parts()) else { return };
    for list in lists(&mut [Aabb::EMPTY], [&mut [Ball::EMPTY], &mut [Ball::EMPTY]]) {
        traced::<_, Everything, _, 64>(&World::new(scene, list), Counters::new());
        traced::<_, Everything, _, 5>(&World::new(scene, list), ());
    }
    traced::<_, Few, _, 1>(&World::new(scene, Stranger), Told);
    traced::<_, Few, _, 1>(&World::new(scene, Bare(any(1))), RayCounters::new());
    traced::<_, ShortSighted, _, 2>(&World::new(scene, Bare(any(1))), ());
}

fn tile() -> Tile {
    any(Tile { first: Pixel { x: 0, y: 0 }, width: 1, height: 1 })
}

fn tiles() {
    let pixel = any(Pixel { x: 0, y: 0 });
    used((Tile::whole(size()), Lattice::tile(tile()), tile().within(tile())));
    used((tile().len(), tile().is_empty(), tile().place(pixel)));
    tile().tiles(any(1)).for_each(used);
}

fn traced<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(world: &World<'_, A>, tally: T) {
    let Some(camera) = any_camera() else { return };
    let limits = any(Limits::DEFAULT);
    let Ok(tracer) = Tracer::<A, E, LEVELS>::new(world, camera, limits) else { return };
    let mut bare = Worker::<A, (), LEVELS, 0>::of_any_size(()).without_shadow_cache();
    used((tracer.look(any_sample(), &mut bare), any(Worker::<A, (), LEVELS, 0>::BYTES)));
    let mut worker = Worker::new(tally);
    used(tracer.look(any_sample(), &mut worker));

    sampled(&tracer, &mut worker, Single);
    sampled(&tracer, &mut worker, Somewhere);
    let (filter, seed) = (any(Filter::Gaussian), any(0));
    if let Some(regular) = Regular::new(any(1)) {
        sampled(&tracer, &mut worker, regular.filtered(filter).seeded(seed));
    }
    if let Some(stochastic) = Stochastic::new(any(1)) {
        sampled(&tracer, &mut worker, stochastic.filtered(filter));
    }
    let ends = any(Confidence { errors: 1.0, tolerance: 0.1 });
    if let Some(mut stochastic) = Stochastic::between(any(1), any(2), ends) {
        let mut gathered = any(Gathered::NONE);
        stochastic.look_on(any(Pixel { x: 0, y: 0 }), &mut gathered, &mut |_| any(Sight::DARK));
        used((gathered.sight(), gathered.rays(), gathered.doubt(number())));
        sampled(&tracer, &mut worker, &mut stochastic.seeded(seed));
        stochastic.begin();
    }
    corners(&tracer, &mut worker);

    used(worker.tally());
    used(worker.tally_mut());
    used(worker.into_tally());
}

fn agreement() -> Option<Agreement> {
    let colors = Agreement::of_colors(number())?;
    Some(if any(true) { colors.and_items() } else { colors })
}

/// What shares the corners of pixels or of blocks.
fn corners<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(
    tracer: &Tracer<'_, '_, A, E, LEVELS>,
    worker: &mut Worker<A, T, LEVELS>,
) {
    let Some(agreement) = agreement() else { return };
    used(Corners::corners(&mut Loose, any(Pixel { x: 0, y: 0 }), &mut |_| any(Sight::DARK)));
    used((<Rgb as Record>::of(any(Sight::DARK)), <Sight as Record>::of(any(Sight::DARK))));
    let sights = any([Sight::DARK; 4]);
    let (mut row, mut kept) = (any([Sight::DARK; 4]), any([Kept::NOTHING; 4]));
    if let Some(parting) = Parting::new(any(1), agreement) {
        let parting = parting.seeded(any(0));
        sampled(tracer, worker, Corner(parting));
        sampled(tracer, worker, Adaptive::new(parting, Loose, any(&mut kept[..])));
        let mut parted = Adaptive::new(parting, Loose, any(&mut kept[..]));
        let pixel = any(Pixel { x: 0, y: 0 });
        used(parted.look_by_parts(pixel, &mut |_| any(Sight::DARK), &mut |part: Part| used(part)));
        let row = CornerRow::new(any(&mut row[..]));
        sampled(tracer, worker, Adaptive::new(parting, row, any(&mut kept[..])));
        if let Some(lattice) = Lattice::new(tile(), any(&sights[..])) {
            sampled(tracer, worker, Adaptive::new(parting, lattice, any(&mut kept[..])));
        }
    }
    if let Some(selection) = Selection::new(any(4), agreement) {
        used((selection.step(), selection.blocks(tile()), selection.area(tile())));
        selection.sides().for_each(used);
        let every: Every<Single> = selection.raster(Single);
        sampled(tracer, worker, every);
        let mut selected = Selected::new(selection, Single, Loose, any(&mut kept[..]));
        used(render_selected(tracer, &mut selected, worker, tile().pixels(), &mut Screen));
        used(render_refined(tracer, &mut selected, worker, tile(), &mut Screen));
        used(*selected.selection());
        selected.begin();
        selected.refine(
            any(Pixel { x: 0, y: 0 }),
            any(4),
            &mut |sample| any((sample, Sight::DARK)).1,
            &mut |_, _| {},
        );
        selected.block(any(Pixel { x: 0, y: 0 }), &mut |sample| any((sample, Sight::DARK)).1, &mut |_, _| {});
    }
}

fn any_sample() -> Sample {
    used(Stream::new(any(0), any(0), any(0), any(0)).pair(Dimension::PIXEL));
    used((Dimension::LENS, Dimension::SHUTTER, Dimension::lobe(any(1)), Dimension::light(any(1), any(1))));
    any(Sample { place: Place { x: 0.0, y: 0.0 }, stream: Stream::new(0, 0, 0, 0) })
}

/// Rays that go anywhere.
struct Somewhere;

impl Sampler for Somewhere {
    fn look(&mut self, _: Pixel, shoot: &mut impl FnMut(Sample) -> Sight) -> Sight {
        let sight = shoot(any_sample());
        used(sight.met.and(any(Met::Several)));
        sight
    }
}

/// A screen whose wire may break.
struct Screen;

impl Dimensions for Screen {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(Point::zero(), Extent::zero())
    }
}

impl DrawTarget for Screen {
    type Color = Rgb565;
    type Error = u8;

    fn draw_iter<I: IntoIterator<Item = Dot<Rgb565>>>(&mut self, pixels: I) -> Result<(), u8> {
        pixels.into_iter().for_each(used);
        any(Ok(()))
    }
}

impl Sink for Screen {
    type Error = u8;

    fn put(&mut self, pixel: Pixel, color: Rgb) -> Result<(), u8> {
        used((pixel, color));
        any(Ok(()))
    }
}

fn sampled<A: Accelerator, E: Effects, T: Tally, const LEVELS: usize>(
    tracer: &Tracer<'_, '_, A, E, LEVELS>,
    worker: &mut Worker<A, T, LEVELS>,
    mut sampler: impl Sampler,
) {
    let mut colors = [Rgb::BLACK; 4];
    if let Some(mut frame) = Frame::new(tile(), any(&mut colors[..])) {
        let Ok(()) = render(tracer, &mut sampler, worker, tile().pixels(), &mut frame);
    }
    let Ok(()) =
        render(tracer, &mut sampler, worker, tile().pixels(), &mut |pixel, color| used((pixel, color)));
    used(render(tracer, &mut sampler, worker, [any(Pixel { x: 0, y: 0 })], &mut Screen));
    let mut screen = Screen;
    let mut display = Display::new(&mut screen, Point::new(any(0), any(0)), any(Dither::Ordered));
    used(render(tracer, &mut sampler, worker, [any(Pixel { x: 0, y: 0 })], &mut display));
    used(<Rgb565 as Steps>::of(any([0; 3])));
}

/// Bytes that may be a baked scene, and are used as whatever they say they are.
fn packs() {
    let Ok(pack) = Pack::open(slice(&[0_u8])) else { return };
    used((pack.size(), pack.levels(), pack.cutoff(), pack.view(), pack.camera(size()), pack.bare()));
    let finder: Result<Finder<'_>, PackError> = pack.finder();
    used((finder, any(PackPart::Finder), any(TextureId::NONE)));
    traced::<_, Everything, _, 5>(&World::new(*pack.scene(), pack.bare()), ());
    if let Ok(grid) = pack.grid::<8>() {
        traced::<_, Few, _, 2>(&World::new(*pack.scene(), grid.with_mailbox::<16>()), ());
    }
    if let Ok(octree) = pack.octree::<8>() {
        traced::<_, Few, _, 2>(&World::new(*pack.scene(), octree.with_mailbox::<16>()), ());
    }
    if let Ok(bvh) = pack.bvh::<LastFirst<8>>() {
        traced::<_, Few, _, 2>(&World::new(*pack.scene(), bvh), ());
    }
}

fn errors() {
    displayed(any(PackError::Checksum));
    displayed(any(ViewFault::NoUp));
    displayed(any(ShapeFault::Radius));
    displayed(any(MaterialFault::Color));
    displayed(any(SceneError::Shape(ItemId(0), ShapeFault::Radius)));
    displayed(any(TracerError::Cutoff));
    let (what, needed, lent) = (any(Storage::Groups), any(1), any(0));
    displayed(any(BuildError::StorageTooSmall { what, needed, lent }));
}

/// Forgets what does not fit.
struct Line {
    text: [u8; 16],
    length: usize,
}

impl Write for Line {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            *self.text.get_mut(self.length).ok_or(fmt::Error)? = byte;
            self.length += 1;
        }
        Ok(())
    }
}

fn displayed(error: impl core::error::Error) {
    let mut line = Line { text: [0; 16], length: 0 };
    used((write!(line, "{error}"), line.text));
}

fn debugged(set: &impl Debug) {
    let mut line = Line { text: [0; 16], length: 0 };
    used((write!(line, "{set:?}"), line.text));
}
