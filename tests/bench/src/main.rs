//! Benchmark of strahl's accelerators and of other crates; see `README.md` for its arguments.

mod comparison;
mod crates;
mod mesh;
mod strahl;

use comparison::{Contender, QueryKind, rates, timed};
use mesh::{BenchMesh, camera_rays, random_rays};

fn main() {
    if let Some(name) = std::env::args().nth(1).filter(|word| word.parse::<usize>().is_err()) {
        let size = std::env::args().nth(2).and_then(|size| size.parse().ok()).unwrap_or(100_000);
        return profile(&name, size);
    }
    let sizes: Vec<usize> = std::env::args().skip(1).map(|size| size.parse().expect("a number")).collect();
    let sizes = if sizes.is_empty() { vec![10_000, 100_000, 1_000_000] } else { sizes };
    println!(
        "| triangles | contender | build µs/triangle | bytes/triangle | camera closest | any | random closest | any |"
    );
    println!("|---:|---|---:|---:|---:|---:|---:|---:|");
    for size in sizes {
        meshes(size);
    }
}

/// Measures all contenders on one mesh. Rates are in millions of rays per second.
fn meshes(size: usize) {
    let mesh = BenchMesh::bumpy_sphere(size);
    let count = mesh.triangles.len();
    let tables = strahl::MeshTables::of(&mesh);
    let mut buffers = strahl::BvhBuffers::of(count);
    let (_, strahl_build) = timed(|| {
        let tables = strahl::MeshTables::of(&mesh);
        let mut buffers = strahl::BvhBuffers::of(count);
        strahl::contenders(&tables, &mut buffers).len()
    });
    let [stack, heap] = strahl::contenders(&tables, &mut buffers);
    let (obvhs, obvhs_build) = timed(|| crates::ObvhsContender::build(&mesh));
    let (bvh, bvh_build) = timed(|| crates::BvhCrateContender::build(&mesh));
    let nearest = crates::BvhCrateNearest(crates::BvhCrateContender::build(&mesh));
    let mut all: Vec<(&str, Box<dyn Contender + '_>)> = vec![
        stack,
        heap,
        ("obvhs, Bvh2 medium", Box::new(obvhs)),
        ("bvh", Box::new(bvh)),
        ("bvh, nearest first", Box::new(nearest)),
    ];
    let builds = [strahl_build, strahl_build, obvhs_build, bvh_build, bvh_build];
    let rays = [camera_rays(512), random_rays(200_000)];
    let columns: Vec<_> = rays
        .iter()
        .flat_map(|rays| [QueryKind::Nearest, QueryKind::AnyHit].map(|query| (rays, query)))
        .map(|(rays, query)| rates(&mut all, rays, query, 5))
        .collect();
    for (index, (name, contender)) in all.iter().enumerate() {
        let build = builds[index].as_secs_f64() * 1e6 / count as f64;
        let bytes = contender.bytes() as f64 / count as f64;
        print!("| {count} | {name} | {build:.2} | {bytes:.0} |");
        for column in &columns {
            let (rate, hits) = column[index];
            print!(" {:.2} ({hits}) |", rate / 1e6);
        }
        println!();
    }
}

/// Runs one contender on a few random rays, for profiling.
fn profile(name: &str, size: usize) {
    let mesh = BenchMesh::bumpy_sphere(size);
    let tables = strahl::MeshTables::of(&mesh);
    let mut buffers = strahl::BvhBuffers::of(mesh.triangles.len());
    let mut contender: Box<dyn Contender> = match name {
        "stack" => strahl::contenders(&tables, &mut buffers).map(|(_, it)| it).into_iter().next().unwrap(),
        "bvh" => Box::new(crates::BvhCrateContender::build(&mesh)),
        _ => Box::new(crates::ObvhsContender::build(&mesh)),
    };
    let rays = random_rays(20_000);
    if name == "count" {
        println!("{:?}", strahl::counted(&tables, &mut strahl::BvhBuffers::of(mesh.triangles.len()), &rays));
        return;
    }
    if std::env::args().nth(3).is_some() {
        println!("{}", rays.iter().filter(|ray| contender.occluded(ray, comparison::ANY_HIT_T_MAX)).count());
        return;
    }
    println!("{}", rays.iter().filter(|ray| contender.intersect_nearest(ray).is_some()).count());
}
