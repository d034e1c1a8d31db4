//! The panic proof (`tests/firmware/src/bin/proof`) calls every public function of the core, except those that are listed
//! here as host-only.
//!
//! Functions are identified by their type: the proof must call `Type::function` by this path, because a method call does
//! not name the type. Implementations of traits are called by the functions that take them.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::visit::{self, Visit};
use syn::{Expr, ExprCall, ImplItem, Item, ItemImpl, ItemMacro, Macro, Path, Type, Visibility};

use crate::expansion::{Rule, has_public_functions};
use crate::names::Names;
use crate::source::{Crate, attributes, features};
use crate::{core, workspace};

/// Public types and functions that no firmware needs, and that are not proven.
const FOR_HOSTS_ONLY: [&str; 2] = ["BakedSceneWriter", "Shading"];

/// A feature with which the core needs a heap: its items are host-only.
const HEAP: &str = "alloc";

/// The public functions of a crate, `function` or `Type::function`, each with its module.
fn public_functions(of: &Crate) -> BTreeMap<String, String> {
    let names = Names::of(of);
    let exported = names.exported();
    let mut functions = BTreeMap::new();
    for (index, module) in of.modules.iter().enumerate() {
        let mut add = |function: String| _ = functions.insert(function, module.path.join("::"));
        let without_heap = |item: &&Item| !features(attributes(item)).contains(&HEAP.to_owned());
        let is_for_hosts = module.features.contains(&HEAP.to_owned());
        for item in module.items.iter().filter(|_| !is_for_hosts).filter(without_heap) {
            match item {
                Item::Fn(it) if exported.contains(&(index, it.sig.ident.to_string())) => {
                    add(it.sig.ident.to_string())
                }
                Item::Impl(it) => {
                    let Some(subject) = subject(it) else { continue };
                    let is_exported =
                        |target: crate::names::Target| exported.contains(&(target.module(), subject.clone()));
                    if names.looked_up(index, &subject).into_iter().any(is_exported) {
                        public_in(it).for_each(|function| add(format!("{subject}::{function}")));
                    }
                }
                // Macro calls have been expanded; definitions are no functions.
                Item::Macro(it) if it.ident.is_none() => {
                    let path = module.path.join("::");
                    assert!(
                        !calls_a_macro_with_functions(of, it),
                        "a macro call in {path} cannot be expanded"
                    );
                }
                _ => {}
            }
        }
    }
    functions
}

/// Whether a call is of a macro of the crate that defines public functions.
fn calls_a_macro_with_functions(of: &Crate, call: &ItemMacro) -> bool {
    let name = call.mac.path.segments.last().map(|name| &name.ident);
    of.modules.iter().flat_map(|module| &module.items).any(|item| match item {
        Item::Macro(it) => it.ident.as_ref() == name && has_public_functions(it.mac.tokens.clone()),
        _ => false,
    })
}

/// The type of an inherent `impl`.
fn subject(it: &ItemImpl) -> Option<String> {
    match (&it.trait_, &*it.self_ty) {
        (None, Type::Path(path)) => Some(path.path.segments.last()?.ident.to_string()),
        _ => None,
    }
}

fn public_in(it: &ItemImpl) -> impl Iterator<Item = String> {
    it.items.iter().filter_map(|item| match item {
        ImplItem::Fn(it)
            if matches!(it.vis, Visibility::Public(_)) && !features(&it.attrs).contains(&HEAP.to_owned()) =>
        {
            Some(it.sig.ident.to_string())
        }
        _ => None,
    })
}

/// Functions that a crate calls by their path, `function` or `Type::function`, and all words of its code.
#[derive(Default)]
struct Called {
    functions: BTreeSet<String>,
    words: BTreeSet<String>,
    /// Simple macros that are defined so far.
    rules: HashMap<String, Rule>,
}

impl Called {
    fn by(of: &Crate) -> Called {
        let mut called = Called::default();
        of.modules.iter().flat_map(|module| &module.items).for_each(|item| called.visit_item(item));
        called
    }

    fn tokens(&mut self, tokens: TokenStream) {
        // The last four tokens.
        let mut before = [const { String::new() }; 4];
        for token in tokens {
            match &token {
                TokenTree::Group(group) => {
                    if group.delimiter() == Delimiter::Parenthesis && is_name(&before[3]) && before[2] != ":"
                    {
                        self.functions.insert(before[3].clone());
                    }
                    self.tokens(group.stream());
                }
                TokenTree::Ident(it) => _ = self.words.insert(it.to_string()),
                _ => {}
            }
            before.rotate_left(1);
            before[3] = token.to_string();
            let [subject, one, other, function] = &before;
            if one == ":" && other == ":" && is_name(subject) && is_name(function) {
                self.functions.insert(format!("{subject}::{function}"));
            }
        }
    }
}

impl<'ast> Visit<'ast> for Called {
    fn visit_expr_call(&mut self, it: &'ast ExprCall) {
        if let Expr::Path(path) = &*it.func {
            let name = &path.path.segments.last().unwrap().ident;
            // A function of a type is identified by its path only.
            if path.qself.is_none()
                && path.path.segments.iter().rev().nth(1).is_none_or(|it| is_module(&it.ident))
            {
                self.functions.insert(name.unraw().to_string());
            }
        }
        visit::visit_expr_call(self, it);
    }

    fn visit_path(&mut self, it: &'ast Path) {
        let names: Vec<String> =
            it.segments.iter().map(|segment| segment.ident.unraw().to_string()).collect();
        if let [.., subject, function] = &names[..] {
            self.functions.insert(format!("{subject}::{function}"));
        }
        self.words.extend(names);
        visit::visit_path(self, it);
    }

    fn visit_item_macro(&mut self, it: &'ast ItemMacro) {
        if let (Some(name), Some(rule)) = (&it.ident, Rule::of(it.mac.tokens.clone())) {
            self.rules.insert(name.to_string(), rule);
        }
    }

    fn visit_macro(&mut self, it: &'ast Macro) {
        let rule = it.path.get_ident().and_then(|name| self.rules.get(&name.to_string()));
        let expanded = rule.and_then(|rule| rule.expanded(it.tokens.clone()));
        self.tokens(expanded.unwrap_or_else(|| it.tokens.clone()));
    }
}

fn is_module(name: &syn::Ident) -> bool {
    name.to_string().starts_with(|c: char| c.is_lowercase())
}

fn is_name(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

fn proof() -> Crate {
    Crate::read(&workspace().join("tests/firmware/src/bin/proof/main.rs"))
}

#[test]
fn the_proof_calls_every_public_function_that_is_not_for_hosts_only() {
    let Called { functions: called, .. } = Called::by(&proof());
    let functions = public_functions(&core());
    assert!(functions.len() > 100, "only {} found", functions.len());
    let is_for_hosts = |function: &str| {
        let subject = function.split("::").next().unwrap();
        FOR_HOSTS_ONLY.contains(&function) || FOR_HOSTS_ONLY.contains(&subject)
    };
    let is_proven = |function: &str| called.contains(function) != is_for_hosts(function);
    let unproven: Vec<String> = functions
        .iter()
        .filter(|(function, _)| !is_proven(function))
        .map(|(function, module)| format!("{function} in {module}"))
        .collect();
    assert!(
        unproven.is_empty(),
        "not called by its path in the proof, or for hosts and called:\n{}",
        unproven.join("\n")
    );
}

#[test]
fn the_proof_names_everything_that_is_public() {
    let Called { words, .. } = Called::by(&proof());
    let core = core();
    let exported = Names::of(&core).exported();
    let is_for_hosts = |module: usize| core.modules[module].features.contains(&HEAP.to_owned());
    let unnamed: Vec<&str> = exported
        .iter()
        .filter(|(module, name)| {
            !is_for_hosts(*module) && !words.contains(name) && !FOR_HOSTS_ONLY.contains(&name.as_str())
        })
        .map(|(_, name)| name.as_str())
        .collect();
    assert!(unnamed.is_empty(), "not named in the proof: {unnamed:?}");
}

#[test]
fn no_function_of_the_proof_has_the_name_of_a_public_one() {
    let functions = public_functions(&core());
    let proof = proof();
    for item in proof.modules.iter().flat_map(|module| &module.items) {
        if let Item::Fn(it) = item {
            assert!(
                !functions.contains_key(&it.sig.ident.to_string()),
                "{} is a function of the core",
                it.sig.ident
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn functions(source: &str) -> Vec<String> {
        public_functions(&Crate::of(source)).into_keys().collect()
    }

    #[test]
    fn functions_of_public_types_are_public() {
        let source = "pub mod a { pub struct A<T>(T); impl<T> A<T> { pub const fn f() {} fn p() {} pub(crate) fn c() {} } pub fn g() {} } \
                      mod b { pub struct B; impl B { pub fn h(&self) {} } struct P; impl P { pub fn i() {} } pub fn j() {} } pub use b::B;";
        assert_eq!(functions(source), ["A::f", "B::h", "g"]);
    }

    #[test]
    fn a_function_belongs_to_its_type_wherever_it_is_implemented() {
        let source = "mod a { pub struct A; } mod b { use super::a::A; impl A { pub fn f() {} } impl Clone for A { fn clone() {} } } pub use a::A;";
        assert_eq!(functions(source), ["A::f"]);
    }

    #[test]
    fn functions_that_a_macro_defines_belong_to_the_types_of_the_call() {
        let source = "macro_rules! set { ($Set:ident of $Kind:ident) => { pub struct $Set; impl $Set { pub const fn of(kind: $Kind) {} \
                      /// doc\n #[inline] pub fn has() {} fn p() {} } impl core::fmt::Debug for $Set { fn fmt() {} } } } \
                      /// doc\n set! { A of B } set!(C of D);";
        assert_eq!(functions(source), ["A::has", "A::of", "C::has", "C::of"]);
    }

    #[test]
    fn items_that_need_a_heap_are_host_only() {
        let source = "#[cfg(feature = \"alloc\")] pub mod a { pub fn f() {} } pub struct B; \
                      #[cfg(feature = \"alloc\")] impl B { pub fn g() {} } impl B { #[cfg(feature = \"alloc\")] pub fn h() {} pub fn i() {} }";
        assert_eq!(functions(source), ["B::i"]);
    }

    #[test]
    fn calls_by_path_are_found_and_declarations_are_not() {
        let source = "fn a(b: &mut (C, D)) { e((f::<8>(), g.h(3))); I::<2>::j(&(k, l)); m.map(N::o); p::q() } \
                      fn r() { macro_rules! s { ($T:ident) => { $T::t(u(1)) } } s!(V); s!(W); w!(X::x) }";
        let Called { functions, .. } = Called::by(&Crate::of(source));
        assert_eq!(
            functions,
            BTreeSet::from(
                ["I::j", "N::o", "V::t", "W::t", "X::x", "e", "f", "p::q", "q", "u"].map(str::to_owned)
            )
        );
    }
}
