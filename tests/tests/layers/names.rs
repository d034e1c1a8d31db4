//! Which modules the code of a module names: by `use` in all of its forms, by paths, and in macros.

use std::collections::{BTreeSet, HashSet};

use proc_macro2::{TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::visit::{self, Visit};
use syn::{Ident, Item, ItemUse, Macro, Path, UseTree, Visibility};

use crate::source::Crate;

/// The names of a crate.
pub struct Names<'c> {
    of: &'c Crate,
    scopes: Vec<Scope>,
}

/// What a name or a path leads to.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Target {
    Module(usize),
    /// Something that is defined in this module.
    ItemIn(usize),
}

/// The names in a module, and those that it mentions.
#[derive(Default)]
struct Scope {
    defined: HashSet<String>,
    /// Those of them that are `pub`.
    public: HashSet<String>,
    /// Words in macro calls that stand for items: they may be names of what these define.
    made: HashSet<String>,
    imports: Vec<Import>,
    globs: Vec<Glob>,
    mentioned: Vec<Vec<String>>,
}

struct Import {
    name: String,
    path: Vec<String>,
    seen: Seen,
}

struct Glob {
    path: Vec<String>,
    seen: Seen,
}

/// From where an import is seen.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Seen {
    Here,
    InTheCrate,
    Everywhere,
}

impl<'c> Names<'c> {
    pub fn of(of: &'c Crate) -> Names<'c> {
        let scope = |module: &crate::source::Module| {
            let mut scope = Scope::default();
            for item in &module.items {
                scope.define(item);
                scope.visit_item(item);
            }
            scope
        };
        Names { of, scopes: of.modules.iter().map(scope).collect() }
    }

    /// The modules whose items some code of this module names, but for those that it only re-exports
    /// from the modules in it.
    pub fn used_by(&self, module: usize) -> BTreeSet<usize> {
        let scope = &self.scopes[module];
        let mut targets = Vec::new();
        for path in &scope.mentioned {
            let found = self.resolved(module, path, &mut HashSet::new());
            // A word alone is a variable rather than a module.
            targets.extend(found.into_iter().filter(|it| path.len() > 1 || matches!(it, Target::ItemIn(_))));
        }
        for import in &scope.imports {
            let found = self.resolved(module, &import.path, &mut HashSet::new());
            targets.extend(
                found.into_iter().filter(|it| import.seen == Seen::Here || !self.is_inside(*it, module)),
            );
        }
        targets.into_iter().map(Target::module).filter(|used| *used != module).collect()
    }

    /// What other crates can name: each item by the module that defines it and its name there.
    pub fn exported(&self) -> BTreeSet<(usize, String)> {
        let (mut exported, mut open, mut seen) = (BTreeSet::new(), vec![0], HashSet::new());
        while let Some(module) = open.pop() {
            if !seen.insert(module) {
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
            for import in scope.imports.iter().filter(|import| import.seen == Seen::Everywhere) {
                for target in self.resolved(module, &import.path, &mut HashSet::new()) {
                    match target {
                        // A private module may have the name of an item in it.
                        Target::Module(of) if self.of.modules[of].is_public => open.push(of),
                        Target::Module(_) => {}
                        Target::ItemIn(of) => _ = exported.insert((of, import.path.last().unwrap().clone())),
                    }
                }
            }
            for glob in scope.globs.iter().filter(|glob| glob.seen == Seen::Everywhere) {
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

    /// What a name in the code of a module stands for: one thing, or several of the same name.
    pub fn looked_up(&self, module: usize, name: &str) -> Vec<Target> {
        self.found(module, name, &mut HashSet::new())
    }

    /// Whether some code of this module names something of another crate.
    pub fn names_crate(&self, module: usize, name: &str) -> bool {
        let scope = &self.scopes[module];
        let globs = scope.globs.iter().map(|glob| &glob.path);
        let imported = scope.imports.iter().map(|import| &import.path).chain(globs);
        let is_there = |path: &Vec<String>| path.first().is_some_and(|first| first == name);
        self.found(module, name, &mut HashSet::new()).is_empty()
            && imported.chain(&scope.mentioned).any(is_there)
    }

    fn found(&self, module: usize, name: &str, seen: &mut HashSet<(usize, String)>) -> Vec<Target> {
        if !seen.insert((module, name.to_owned())) {
            return Vec::new();
        }
        let scope = &self.scopes[module];
        let mut found: Vec<Target> = self.of.child(module, name).map(Target::Module).into_iter().collect();
        if scope.defined.contains(name) {
            found.push(Target::ItemIn(module));
        }
        for import in scope.imports.iter().filter(|import| import.name == name) {
            found.extend(self.resolved(module, &import.path, seen));
        }
        if found.is_empty() {
            for glob in &scope.globs {
                for target in self.resolved(module, &glob.path, seen) {
                    if let Target::Module(other) = target {
                        found.extend(self.found(other, name, seen));
                    }
                }
            }
        }
        if found.is_empty() && scope.made.contains(name) {
            found.push(Target::ItemIn(module));
        }
        found
    }

    /// What a path in the code of a module leads to; nothing if it leads to another crate.
    fn resolved(&self, module: usize, path: &[String], seen: &mut HashSet<(usize, String)>) -> Vec<Target> {
        let mut rest = path;
        let mut at = match rest {
            [first, ..] if first == "crate" || first == "$crate" => vec![Target::Module(0)],
            [first, ..] if first == "self" => vec![Target::Module(module)],
            [first, ..] if first == "super" => vec![Target::Module(self.parent(module))],
            [first, ..] => self.found(module, first, seen),
            [] => return Vec::new(),
        };
        rest = &rest[1..];
        while let [name, others @ ..] = rest {
            rest = others;
            let next = |target: Target| match target {
                Target::Module(of) if name == "super" => vec![Target::Module(self.parent(of))],
                Target::Module(of) => self.found(of, name, seen),
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

impl Scope {
    fn define(&mut self, item: &Item) {
        let (name, visibility) = match item {
            Item::Const(it) => (&it.ident, &it.vis),
            Item::Enum(it) => (&it.ident, &it.vis),
            Item::Fn(it) => (&it.sig.ident, &it.vis),
            Item::Static(it) => (&it.ident, &it.vis),
            Item::Struct(it) => (&it.ident, &it.vis),
            Item::Trait(it) => (&it.ident, &it.vis),
            Item::TraitAlias(it) => (&it.ident, &it.vis),
            Item::Type(it) => (&it.ident, &it.vis),
            Item::Union(it) => (&it.ident, &it.vis),
            Item::Macro(it) => match &it.ident {
                Some(name) => (name, &Visibility::Inherited),
                None => return words(it.mac.tokens.clone(), &mut self.made),
            },
            _ => return,
        };
        self.defined.insert(text(name));
        if matches!(visibility, Visibility::Public(_)) {
            self.public.insert(text(name));
        }
    }

    /// Takes in the paths of a `use`.
    fn import(&mut self, tree: &UseTree, mut before: Vec<String>, seen: Seen) {
        match tree {
            UseTree::Path(it) => {
                before.push(text(&it.ident));
                self.import(&it.tree, before, seen);
            }
            UseTree::Group(it) => {
                it.items.iter().for_each(|tree| self.import(tree, before.clone(), seen));
            }
            UseTree::Name(it) => self.import_as(&it.ident, &it.ident, before, seen),
            UseTree::Rename(it) => self.import_as(&it.ident, &it.rename, before, seen),
            UseTree::Glob(_) => self.globs.push(Glob { path: before, seen }),
        }
    }

    fn import_as(&mut self, name: &Ident, rename: &Ident, mut path: Vec<String>, seen: Seen) {
        if name != "self" || path.is_empty() {
            path.push(text(name));
        }
        let own = if rename == "self" { path.last().cloned() } else { Some(text(rename)) };
        self.imports.push(Import { name: own.unwrap_or_default(), path, seen });
    }

    /// Takes in the paths in the tokens of a macro: words with `::` between them, after `before`.
    fn tokens(&mut self, tokens: TokenStream, before: &[String]) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let is_colon = |i: usize| matches!(tokens.get(i), Some(TokenTree::Punct(it)) if it.as_char() == ':');
        let mut path = before.to_vec();
        let mut i = 0;
        while let Some(token) = tokens.get(i) {
            i += 1;
            match token {
                TokenTree::Ident(it) => {
                    path.push(text(it));
                    if is_colon(i) && is_colon(i + 1) {
                        i += 2;
                        continue;
                    }
                }
                // `path::{..}`
                TokenTree::Group(group) if path.len() > before.len() => {
                    self.tokens(group.stream(), &path);
                    path = before.to_vec();
                    continue;
                }
                TokenTree::Group(group) => self.tokens(group.stream(), &[]),
                _ => {}
            }
            if path.len() > before.len() {
                self.mentioned.push(path);
            }
            path = before.to_vec();
        }
    }
}

impl<'ast> Visit<'ast> for Scope {
    fn visit_item_use(&mut self, it: &'ast ItemUse) {
        if it.leading_colon.is_none() {
            let seen = match it.vis {
                Visibility::Inherited => Seen::Here,
                Visibility::Restricted(_) => Seen::InTheCrate,
                Visibility::Public(_) => Seen::Everywhere,
            };
            self.import(&it.tree, Vec::new(), seen);
        }
    }

    fn visit_path(&mut self, it: &'ast Path) {
        if it.leading_colon.is_none() {
            self.mentioned.push(it.segments.iter().map(|segment| text(&segment.ident)).collect());
        }
        visit::visit_path(self, it);
    }

    fn visit_macro(&mut self, it: &'ast Macro) {
        self.tokens(it.tokens.clone(), &[]);
        visit::visit_macro(self, it);
    }

    // `pub(in path)` and attributes use nothing.
    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}
}

fn text(name: &Ident) -> String {
    name.unraw().to_string()
}

fn words(tokens: TokenStream, into: &mut HashSet<String>) {
    for token in tokens {
        match token {
            TokenTree::Ident(it) => _ = into.insert(text(&it)),
            TokenTree::Group(it) => words(it.stream(), into),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The modules that `user` uses, by their paths.
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
    fn every_form_of_use_is_seen() {
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
    fn paths_in_code_are_seen() {
        assert_eq!(beside("fn f(a: &crate::a::A) {}"), ["a"]);
        assert_eq!(beside("fn f() { super::a::call() }"), ["a"]);
        assert_eq!(beside("struct S<T: Into<super::b::inner::I>>(T);"), ["b::inner"]);
        assert_eq!(beside("impl super::c::C {}"), ["c"]);
        assert_eq!(beside("fn f() { <super::a::A>::new() }"), ["a"]);
    }

    #[test]
    fn paths_in_macros_are_seen() {
        assert_eq!(beside("fn f() { assert!(crate::a::call() == 1) }"), ["a"]);
        assert_eq!(beside("macro_rules! m { () => { $crate::b::B } }"), ["b"]);
        assert_eq!(beside("make! { use crate::{a::A, b::inner::I}; }"), ["a", "b::inner"]);
        assert_eq!(beside("fn f() { vec![super::a::A; 3, super::c::C::<u8>::new()] }"), ["a", "c"]);
    }

    #[test]
    fn a_path_leads_to_where_its_end_is_defined() {
        assert_eq!(beside("use crate::c::J;"), ["b::inner"]);
        assert_eq!(beside("use crate::d::A;"), ["a"]);
        assert_eq!(beside("use crate::d::*; fn f(_: A) {}"), ["a"]);
        assert_eq!(beside("use crate::d::*;"), [""; 0]);
    }

    #[test]
    fn what_is_made_by_a_macro_is_in_the_module_that_calls_it() {
        let source = "mod a { make!(pub struct Made); } mod user { use super::a::Made; }";
        assert_eq!(used_by("user", source), ["a"]);
    }

    #[test]
    fn the_names_of_other_crates_and_of_variables_are_no_modules() {
        assert_eq!(beside("use std::mem; fn f(a: u8) -> u8 { let b = a; b.c() }"), [""; 0]);
        assert_eq!(used_by("", "mod a { pub struct A; } fn f() { let a = 1; a + 1 }"), [""; 0]);
        assert_eq!(used_by("", "mod a { pub struct A; } fn f() { a::A }"), ["a"]);
    }

    #[test]
    fn a_re_export_from_inside_is_no_use() {
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
    fn what_other_crates_can_name_is_found() {
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
    fn crates_that_are_named_are_found() {
        let of = Crate::of(
            "mod a { use libm::sqrt; } mod b { mod libm {} fn f() { libm::g() } } mod c { fn f() { libm::g() } }",
        );
        let names = Names::of(&of);
        let found = |path: &str| names.names_crate(of.index(&[path.to_owned()]).unwrap(), "libm");
        assert_eq!(["a", "b", "c"].map(found), [true, false, true]);
    }
}
