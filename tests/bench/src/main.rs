//! Measures strahl's accelerators; the package's `README.md` tells how to call it.

mod contest;
mod mesh;
mod ours;
mod peers;

use contest::{Contender, Question, rates, timed};
use mesh::{Mesh, camera_rays, random_rays};

fn main() {
    if let Some(name) = std::env::args().nth(1).filter(|word| word.parse::<usize>().is_err()) {
        let size = std::env::args().nth(2).and_then(|size| size.parse().ok()).unwrap_or(100_000);
        return alone(&name, size);
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

/// Everybody on one mesh. Rates are in millions of rays per second.
fn meshes(size: usize) {
    let mesh = Mesh::stone(size);
    let count = mesh.triangles.len();
    let tables = ours::Tables::of(&mesh);
    let mut room = ours::Room::of(count);
    let (_, ours_build) = timed(|| {
        let tables = ours::Tables::of(&mesh);
        let mut room = ours::Room::of(count);
        ours::hierarchy(&tables, &mut room).len()
    });
    let [stack, heap] = ours::hierarchy(&tables, &mut room);
    let (obvhs, obvhs_build) = timed(|| peers::Obvhs::build(&mesh));
    let (bvh, bvh_build) = timed(|| peers::Svenstaro::build(&mesh));
    let nearest = peers::SvenstaroNearest(peers::Svenstaro::build(&mesh));
    let mut all: Vec<(&str, Box<dyn Contender + '_>)> = vec![
        stack,
        heap,
        ("obvhs, Bvh2 medium", Box::new(obvhs)),
        ("bvh", Box::new(bvh)),
        ("bvh, nearest first", Box::new(nearest)),
    ];
    let builds = [ours_build, ours_build, obvhs_build, bvh_build, bvh_build];
    let rays = [camera_rays(512), random_rays(200_000)];
    let columns: Vec<_> = rays
        .iter()
        .flat_map(|rays| [Question::Closest, Question::Any].map(|question| (rays, question)))
        .map(|(rays, question)| rates(&mut all, rays, question, 5))
        .collect();
    for (place, (name, contender)) in all.iter().enumerate() {
        let build = builds[place].as_secs_f64() * 1e6 / count as f64;
        let bytes = contender.bytes() as f64 / count as f64;
        print!("| {count} | {name} | {build:.2} | {bytes:.0} |");
        for column in &columns {
            let (rate, hits) = column[place];
            print!(" {:.2} ({hits}) |", rate / 1e6);
        }
        println!();
    }
}

/// One contender on a few random rays, to be looked at with a profiler.
fn alone(name: &str, size: usize) {
    let mesh = Mesh::stone(size);
    let tables = ours::Tables::of(&mesh);
    let mut room = ours::Room::of(mesh.triangles.len());
    let mut contender: Box<dyn Contender> = match name {
        "stack" => ours::hierarchy(&tables, &mut room).map(|(_, it)| it).into_iter().next().unwrap(),
        "bvh" => Box::new(peers::Svenstaro::build(&mesh)),
        _ => Box::new(peers::Obvhs::build(&mesh)),
    };
    let rays = random_rays(20_000);
    if name == "count" {
        println!("{:?}", ours::counted(&tables, &mut ours::Room::of(mesh.triangles.len()), &rays));
        return;
    }
    if std::env::args().nth(3).is_some() {
        println!("{}", rays.iter().filter(|ray| contender.any(ray, contest::WAY)).count());
        return;
    }
    println!("{}", rays.iter().filter(|ray| contender.closest(ray).is_some()).count());
}
