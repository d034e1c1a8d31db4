//! Other readers agree on files that both support.

use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{DefaultElement, Property};

use crate::files::mesh;
use crate::random::Random;

/// Triangles as positions of vertices, with their normals.
type Soup = Vec<[([f32; 3], Option<[f32; 3]>); 3]>;

fn ours(extension: &str, file: &[u8]) -> Soup {
    let it = mesh(extension, file);
    let corner = |i: u32| (it.vertices[i as usize], it.normals.get(i as usize).copied());
    it.triangles.iter().map(|triangle| triangle.map(corner)).collect()
}

#[test]
fn tobj_reads_the_same_triangles() {
    let mut random = Random(1990);
    for normals in [false, true] {
        for _ in 0..100 {
            let mut text = String::new();
            for _ in 0..20 {
                let [x, y, z] = [0; 3].map(|_| random.coordinate());
                text.push_str(&format!("v {x} {y} {z}\nvn {z} {x} {}\nvt 0 1\n", y.abs() + 1.0));
            }
            for _ in 0..30 {
                text.push('f');
                for _ in 0..3 {
                    let (v, n) = (1 + random.below(20), random.below(20) as i32 - 20);
                    text.push_str(&if normals { format!(" {v}/1/{n}") } else { format!(" {v}") });
                }
                text.push('\n');
            }
            let options = tobj::LoadOptions { single_index: true, ..Default::default() };
            let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| unreachable!()).unwrap();
            let mut theirs = Soup::new();
            for model in models {
                let triple = |numbers: &[f32], i: u32| numbers.get(3 * i as usize..)?.first_chunk().copied();
                let corner =
                    |i: u32| (triple(&model.mesh.positions, i).unwrap(), triple(&model.mesh.normals, i));
                let (triangles, []) = model.mesh.indices.as_chunks::<3>() else { panic!() };
                theirs.extend(triangles.iter().map(|triangle| triangle.map(corner)));
            }
            assert_eq!(ours("obj", text.as_bytes()), theirs, "{text}");
        }
    }
}

#[test]
fn ply_rs_reads_the_same_triangles() {
    let mut random = Random(1994);
    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        for _ in 0..60 {
            let mut file = format!(
                "ply\nformat {encoding} 1.0\nelement vertex 20\nproperty float x\nproperty double y\nproperty short z\n\
                 element face 30\nproperty uchar a\nproperty list ushort int vertex_indices\nend_header\n"
            )
            .into_bytes();
            macro_rules! write {
                ($x:expr) => {
                    match encoding {
                        "ascii" => file.extend(format!("{} ", $x).bytes()),
                        "binary_big_endian" => file.extend($x.to_be_bytes()),
                        _ => file.extend($x.to_le_bytes()),
                    }
                };
            }
            let end = |file: &mut Vec<u8>| file.extend((encoding == "ascii").then_some(b'\n'));
            for _ in 0..20 {
                write!(random.coordinate());
                write!(f64::from(random.coordinate()));
                write!(random.below(100) as i16);
                end(&mut file);
            }
            for _ in 0..30 {
                write!(7_u8);
                write!(3_u16);
                (0..3).for_each(|_| write!(random.below(20) as i32));
                end(&mut file);
            }
            let theirs = Parser::<DefaultElement>::new().read_ply(&mut file.as_slice()).unwrap().payload;
            let points: Vec<_> = theirs["vertex"]
                .iter()
                .map(|vertex| ["x", "y", "z"].map(|name| vertex[name].to_f32_lossy().unwrap()))
                .collect();
            let triangles = theirs["face"].iter().map(|face| match &face["vertex_indices"] {
                Property::ListInt(corners) => [0, 1, 2].map(|i| (points[corners[i] as usize], None)),
                other => panic!("{other:?}"),
            });
            assert_eq!(ours("ply", &file), triangles.collect::<Soup>());
        }
    }
}
