//! Circles of modules: a module that uses itself through others.

use std::collections::{BTreeMap, BTreeSet};

use crate::names::Names;
use crate::source::Crate;

/// Sibling modules that use each other, and one use for each step.
pub struct Circle {
    /// Such as `accel: bvh, self`, where `self` is the code of the parent module.
    pub name: String,
    pub uses: Vec<String>,
}

/// All circles of sibling modules, with their descendants, and the code of their parent module.
pub fn circles(of: &Crate) -> Vec<Circle> {
    let names = Names::of(of);
    let uses: Vec<BTreeSet<usize>> = (0..of.modules.len()).map(|module| names.used_by(module)).collect();
    let mut circles = Vec::new();
    for around in &of.modules {
        // For each pair of siblings a pair of descendants of which one uses the other.
        let mut steps: BTreeMap<(&str, &str), (usize, usize)> = BTreeMap::new();
        for (user, used) in
            uses.iter().enumerate().flat_map(|(user, used)| used.iter().map(move |it| (user, *it)))
        {
            let sibling = |module: usize| {
                let inside = of.modules[module].path.strip_prefix(&around.path[..])?;
                Some(inside.first().map_or("self", String::as_str))
            };
            if let (Some(a), Some(b)) = (sibling(user), sibling(used))
                && a != b
            {
                steps.entry((a, b)).or_insert((user, used));
            }
        }
        for members in in_circles(&steps.keys().copied().collect()) {
            let inside = steps.iter().filter(|((a, b), _)| members.contains(a) && members.contains(b));
            let path = |module: usize| format!("crate::{}", of.modules[module].path.join("::"));
            circles.push(Circle {
                name: format!(
                    "{}: {}",
                    around.path.join("::"),
                    members.iter().copied().collect::<Vec<_>>().join(", ")
                ),
                uses: inside
                    .map(|(_, (user, used))| format!("{} uses {}", path(*user), path(*used)))
                    .collect(),
            });
        }
    }
    circles
}

/// Strongly connected components with more than one element.
fn in_circles<'n>(steps: &BTreeSet<(&'n str, &'n str)>) -> Vec<BTreeSet<&'n str>> {
    let reached = |from: &'n str| {
        let mut reached = BTreeSet::new();
        let mut open = vec![from];
        while let Some(at) = open.pop() {
            open.extend(steps.iter().filter(|(a, b)| *a == at && reached.insert(*b)).map(|(_, b)| *b));
        }
        reached
    };
    let all: BTreeSet<&str> = steps.iter().flat_map(|(a, b)| [*a, *b]).collect();
    let reached: BTreeMap<&str, BTreeSet<&str>> = all.iter().map(|it| (*it, reached(it))).collect();
    let circle = |it: &&'n str| -> BTreeSet<&'n str> {
        reached[it].iter().copied().filter(|other| reached[other].contains(it)).collect()
    };
    let circles: BTreeSet<BTreeSet<&str>> =
        all.iter().map(circle).filter(|circle| circle.len() > 1).collect();
    circles.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(source: &str) -> Vec<String> {
        circles(&Crate::of(source)).into_iter().map(|circle| circle.name).collect()
    }

    #[test]
    fn modules_that_use_each_other_are_a_circle() {
        assert_eq!(
            named("mod a { use super::b::B; pub struct A; } mod b { use super::a::A; pub struct B; }"),
            [": a, b"]
        );
        assert_eq!(named("mod a { use super::b::B; } mod b { pub struct B; }"), [""; 0]);
    }

    #[test]
    fn a_circle_may_be_long_and_more_than_one() {
        let source = "mod a { use super::b::B; pub struct A; } mod b { use super::c::C; pub struct B; } \
                      mod c { use super::a::A; pub struct C; } mod d { use super::{a::A, e::E}; pub struct D; } \
                      mod e { fn f() { super::d::D } pub struct E; }";
        assert_eq!(named(source), [": a, b, c", ": d, e"]);
    }

    #[test]
    fn modules_in_folders_are_a_circle_of_the_folders() {
        let source = "mod a { mod x { use crate::b::y::Y; } pub mod z { pub struct Z; } } \
                      mod b { pub mod y { pub struct Y; } mod w { use crate::a::z::Z; } }";
        assert_eq!(named(source), [": a, b"]);
    }

    #[test]
    fn a_circle_inside_a_folder_is_found() {
        let source =
            "mod a { mod x { use super::y::Y; pub struct X; } mod y { use super::x::X; pub struct Y; } }";
        assert_eq!(named(source), ["a: x, y"]);
    }

    #[test]
    fn a_module_and_one_in_it_may_be_a_circle() {
        let source = "mod a { mod x { use super::A; pub struct X; } use x::X; pub struct A; }";
        assert_eq!(named(source), ["a: self, x"]);
        let source = "mod a { mod x { use super::A; pub struct X; } pub use x::X; pub struct A; }";
        assert_eq!(named(source), [""; 0], "what is only re-exported is not used");
    }
}
