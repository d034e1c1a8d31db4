//! Name resolution: which modules the code of a module uses.

use std::collections::{BTreeSet, HashSet};

use crate::scope::{ImportVisibility, Scope};
use crate::source::Crate;

/// Name resolution in a crate.
pub struct Names<'c> {
    of: &'c Crate,
    scopes: Vec<Scope>,
}

/// Target of a name or a path.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Target {
    Module(usize),
    /// An item that is defined in this module.
    ItemIn(usize),
}

impl<'c> Names<'c> {
    pub fn of(of: &'c Crate) -> Names<'c> {
        Names { of, scopes: of.modules.iter().map(|module| Scope::of(&module.items)).collect() }
    }

    /// Modules whose items this module uses, without submodules that it only re-exports.
    pub fn used_by(&self, module: usize) -> BTreeSet<usize> {
        let scope = &self.scopes[module];
        let mut targets = Vec::new();
        for path in &scope.mentioned {
            let found = self.resolved(module, path, &mut HashSet::new());
            // A single word is a variable rather than a module.
            targets.extend(found.into_iter().filter(|it| path.len() > 1 || matches!(it, Target::ItemIn(_))));
        }
        for import in &scope.imports {
            let found = self.resolved(module, &import.path, &mut HashSet::new());
            targets.extend(
                found.into_iter().filter(|it| {
                    import.visibility == ImportVisibility::Private || !self.is_inside(*it, module)
                }),
            );
        }
        targets.into_iter().map(Target::module).filter(|used| *used != module).collect()
    }

    /// Items that other crates can name, each by the module that defines it and its name there.
    pub fn exported(&self) -> BTreeSet<(usize, String)> {
        let (mut exported, mut open, mut visited) = (BTreeSet::new(), vec![0], HashSet::new());
        while let Some(module) = open.pop() {
            if !visited.insert(module) {
                continue;
            }
            let scope = &self.scopes[module];
            exported.extend(scope.public.iter().map(|name| (module, name.clone())));
            let children = (0..self.of.modules.len()).filter(|child| {
                let child = &self.of.modules[*child];
                child.is_public
                    && child.path.split_last().is_some_and(|(_, above)| above == self.of.modules[module].path)
            });
            open.extend(children);
            for import in scope.imports.iter().filter(|import| import.visibility == ImportVisibility::Public)
            {
                for target in self.resolved(module, &import.path, &mut HashSet::new()) {
                    match target {
                        // A private module may have the name of one of its items.
                        Target::Module(of) if self.of.modules[of].is_public => open.push(of),
                        Target::Module(_) => {}
                        Target::ItemIn(of) => _ = exported.insert((of, import.path.last().unwrap().clone())),
                    }
                }
            }
            for glob in scope.globs.iter().filter(|glob| glob.visibility == ImportVisibility::Public) {
                let targets = self.resolved(module, &glob.path, &mut HashSet::new());
                open.extend(
                    targets.into_iter().filter(|it| matches!(it, Target::Module(_))).map(Target::module),
                );
            }
        }
        exported
    }

    fn is_inside(&self, target: Target, module: usize) -> bool {
        let path = |module: usize| &self.of.modules[module].path;
        path(target.module()).starts_with(path(module))
    }

    /// Targets of a name in the code of a module.
    pub fn looked_up(&self, module: usize, name: &str) -> Vec<Target> {
        self.found(module, name, &mut HashSet::new())
    }

    /// Whether the code of this module names an item of this other crate.
    pub fn names_crate(&self, module: usize, name: &str) -> bool {
        let scope = &self.scopes[module];
        let globs = scope.globs.iter().map(|glob| &glob.path);
        let imported = scope.imports.iter().map(|import| &import.path).chain(globs);
        let is_there = |path: &Vec<String>| path.first().is_some_and(|first| first == name);
        self.found(module, name, &mut HashSet::new()).is_empty()
            && imported.chain(&scope.mentioned).any(is_there)
    }

    fn found(&self, module: usize, name: &str, visited: &mut HashSet<(usize, String)>) -> Vec<Target> {
        if !visited.insert((module, name.to_owned())) {
            return Vec::new();
        }
        let scope = &self.scopes[module];
        let mut found: Vec<Target> = self.of.child(module, name).map(Target::Module).into_iter().collect();
        if scope.defined.contains(name) {
            found.push(Target::ItemIn(module));
        }
        for import in scope.imports.iter().filter(|import| import.name == name) {
            found.extend(self.resolved(module, &import.path, visited));
        }
        if found.is_empty() {
            for glob in &scope.globs {
                for target in self.resolved(module, &glob.path, visited) {
                    if let Target::Module(other) = target {
                        found.extend(self.found(other, name, visited));
                    }
                }
            }
        }
        if found.is_empty() && scope.generated.contains(name) {
            found.push(Target::ItemIn(module));
        }
        found
    }

    /// Targets of a path in the code of a module; empty if it leads to another crate.
    fn resolved(
        &self,
        module: usize,
        path: &[String],
        visited: &mut HashSet<(usize, String)>,
    ) -> Vec<Target> {
        let mut rest = path;
        let mut at = match rest {
            [first, ..] if first == "crate" || first == "$crate" => vec![Target::Module(0)],
            [first, ..] if first == "self" => vec![Target::Module(module)],
            [first, ..] if first == "super" => vec![Target::Module(self.parent(module))],
            [first, ..] => self.found(module, first, visited),
            [] => return Vec::new(),
        };
        rest = &rest[1..];
        while let [name, others @ ..] = rest {
            rest = others;
            let next = |target: Target| match target {
                Target::Module(of) if name == "super" => vec![Target::Module(self.parent(of))],
                Target::Module(of) => self.found(of, name, visited),
                item => vec![item],
            };
            at = at.into_iter().flat_map(next).collect();
        }
        at
    }

    fn parent(&self, module: usize) -> usize {
        let path = &self.of.modules[module].path;
        let above = path.split_last().map_or(&path[..], |(_, above)| above);
        self.of.index(above).unwrap_or(0)
    }
}

impl Target {
    pub fn module(self) -> usize {
        let (Target::Module(module) | Target::ItemIn(module)) = self;
        module
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Paths of the modules that `user` uses.
    fn used_by(user: &str, source: &str) -> Vec<String> {
        let of = Crate::of(source);
        let path: Vec<String> = user.split("::").filter(|name| !name.is_empty()).map(str::to_owned).collect();
        let used = Names::of(&of).used_by(of.index(&path).unwrap());
        used.into_iter().map(|module| of.modules[module].path.join("::")).collect()
    }

    /// Modules `a` to `d` with an item each, and `user` with this code.
    fn beside(code: &str) -> Vec<String> {
        used_by(
            "user",
            &format!(
                "mod a {{ pub struct A; pub fn call() {{}} }} mod b {{ pub struct B; pub mod inner {{ pub struct I; }} }} \
                 mod c {{ pub use super::b::inner::I as J; pub struct C; }} mod d {{ pub use super::a::*; }} \
                 mod user {{ {code} }}"
            ),
        )
    }

    #[test]
    fn every_form_of_use_is_found() {
        assert_eq!(beside("use crate::a::A;"), ["a"]);
        assert_eq!(beside("use super::a::A;"), ["a"]);
        assert_eq!(beside("use crate::{a::A, b::{self, inner::I}};"), ["a", "b", "b::inner"]);
        assert_eq!(beside("use super::a::A as Other;"), ["a"]);
        assert_eq!(beside("pub use crate::a::A;"), ["a"]);
        assert_eq!(beside("pub(crate) use crate::a::{A as Other};"), ["a"]);
        assert_eq!(beside("fn f() { use crate::a::A; }"), ["a"]);
        assert_eq!(beside("use super::*; fn f(_: a::A) {}"), ["a"]);
        assert_eq!(beside("use crate::b as other; fn f(_: other::inner::I) {}"), ["b", "b::inner"]);
    }

    #[test]
    fn paths_in_code_are_found() {
        assert_eq!(beside("fn f(a: &crate::a::A) {}"), ["a"]);
        assert_eq!(beside("fn f() { super::a::call() }"), ["a"]);
        assert_eq!(beside("struct S<T: Into<super::b::inner::I>>(T);"), ["b::inner"]);
        assert_eq!(beside("impl super::c::C {}"), ["c"]);
        assert_eq!(beside("fn f() { <super::a::A>::new() }"), ["a"]);
    }

    #[test]
    fn paths_in_macros_are_found() {
        assert_eq!(beside("fn f() { assert!(crate::a::call() == 1) }"), ["a"]);
        assert_eq!(beside("macro_rules! m { () => { $crate::b::B } }"), ["b"]);
        assert_eq!(beside("make! { use crate::{a::A, b::inner::I}; }"), ["a", "b::inner"]);
        assert_eq!(beside("fn f() { vec![super::a::A; 3, super::c::C::<u8>::new()] }"), ["a", "c"]);
    }

    #[test]
    fn a_path_leads_to_the_module_that_defines_its_last_name() {
        assert_eq!(beside("use crate::c::J;"), ["b::inner"]);
        assert_eq!(beside("use crate::d::A;"), ["a"]);
        assert_eq!(beside("use crate::d::*; fn f(_: A) {}"), ["a"]);
        assert_eq!(beside("use crate::d::*;"), [""; 0]);
    }

    #[test]
    fn a_generated_item_belongs_to_the_module_of_the_macro_call() {
        let source = "mod a { make!(pub struct Made); } mod user { use super::a::Made; }";
        assert_eq!(used_by("user", source), ["a"]);
    }

    #[test]
    fn names_of_other_crates_and_of_variables_are_no_modules() {
        assert_eq!(beside("use std::mem; fn f(a: u8) -> u8 { let b = a; b.c() }"), [""; 0]);
        assert_eq!(used_by("", "mod a { pub struct A; } fn f() { let a = 1; a + 1 }"), [""; 0]);
        assert_eq!(used_by("", "mod a { pub struct A; } fn f() { a::A }"), ["a"]);
    }

    #[test]
    fn a_re_export_of_a_submodule_is_no_use() {
        assert_eq!(used_by("", "mod a { pub struct A; } pub use a::A;"), [""; 0]);
        assert_eq!(used_by("", "mod a { pub struct A; } pub use a::A; fn f(_: A) {}"), ["a"]);
        assert_eq!(used_by("", "mod a { pub struct A; } use a::A;"), ["a"]);
    }

    #[test]
    fn code_for_unit_tests_is_left_out() {
        assert_eq!(
            beside("#[cfg(test)] mod tests { use crate::a::A; } #[cfg(all(test, unix))] use crate::b::B;"),
            [""; 0]
        );
        assert_eq!(beside("#[cfg(not(test))] use crate::b::B;"), ["b"]);
    }

    #[test]
    fn exported_items_are_found() {
        let of = Crate::of(
            "pub mod a { pub struct A; struct P; pub(crate) struct C; pub mod b { pub fn f() {} } mod c { pub fn g() {} } } \
             mod d { pub struct D; pub struct Hidden; pub mod e { pub const E: u8 = 0; } make!(Made); } \
             mod h { pub fn h() {} } pub use d::{D, Made, e}; pub use h::h; pub(crate) use d::Hidden;",
        );
        let exported = Names::of(&of).exported();
        let name =
            |(module, name): &(usize, String)| format!("{}::{name}", of.modules[*module].path.join("::"));
        let names: Vec<String> = exported.iter().map(name).collect();
        assert_eq!(names, ["a::A", "a::b::f", "d::D", "d::Made", "d::e::E", "h::h"]);
    }

    #[test]
    fn names_of_other_crates_are_found() {
        let of = Crate::of(
            "mod a { use libm::sqrt; } mod b { mod libm {} fn f() { libm::g() } } mod c { fn f() { libm::g() } }",
        );
        let names = Names::of(&of);
        let found = |path: &str| names.names_crate(of.index(&[path.to_owned()]).unwrap(), "libm");
        assert_eq!(["a", "b", "c"].map(found), [true, false, true]);
    }
}
