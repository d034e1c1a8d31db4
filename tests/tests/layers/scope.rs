//! The names of one module: those that it defines, imports and mentions, by every kind of `use`, by paths,
//! and in macros.

use std::collections::HashSet;

use proc_macro2::{TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::visit::{self, Visit};
use syn::{Ident, Item, ItemUse, Macro, Path, UseTree, Visibility};

/// Names that a module defines, imports and mentions.
#[derive(Default)]
pub struct Scope {
    pub defined: HashSet<String>,
    /// The public ones of `defined`.
    pub public: HashSet<String>,
    /// Words in macro calls at item level: possibly names of generated items.
    pub generated: HashSet<String>,
    pub imports: Vec<Import>,
    pub globs: Vec<Glob>,
    pub mentioned: Vec<Vec<String>>,
}

pub struct Import {
    pub name: String,
    pub path: Vec<String>,
    pub visibility: ImportVisibility,
}

pub struct Glob {
    pub path: Vec<String>,
    pub visibility: ImportVisibility,
}

/// Where an import is visible.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum ImportVisibility {
    Private,
    Crate,
    Public,
}

impl Scope {
    /// The names in the items of a module.
    pub fn of(items: &[Item]) -> Scope {
        let mut scope = Scope::default();
        for item in items {
            scope.define(item);
            scope.visit_item(item);
        }
        scope
    }

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
                None => return words(it.mac.tokens.clone(), &mut self.generated),
            },
            _ => return,
        };
        self.defined.insert(text(name));
        if matches!(visibility, Visibility::Public(_)) {
            self.public.insert(text(name));
        }
    }

    /// Adds the imports of a `use`.
    fn import(&mut self, tree: &UseTree, mut before: Vec<String>, visibility: ImportVisibility) {
        match tree {
            UseTree::Path(it) => {
                before.push(text(&it.ident));
                self.import(&it.tree, before, visibility);
            }
            UseTree::Group(it) => {
                it.items.iter().for_each(|tree| self.import(tree, before.clone(), visibility));
            }
            UseTree::Name(it) => self.import_as(&it.ident, &it.ident, before, visibility),
            UseTree::Rename(it) => self.import_as(&it.ident, &it.rename, before, visibility),
            UseTree::Glob(_) => self.globs.push(Glob { path: before, visibility }),
        }
    }

    fn import_as(
        &mut self,
        name: &Ident,
        rename: &Ident,
        mut path: Vec<String>,
        visibility: ImportVisibility,
    ) {
        if name != "self" || path.is_empty() {
            path.push(text(name));
        }
        let own = if rename == "self" { path.last().cloned() } else { Some(text(rename)) };
        self.imports.push(Import { name: own.unwrap_or_default(), path, visibility });
    }

    /// Adds the paths in the tokens of a macro: words separated by `::`, after the prefix `before`.
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
            let visibility = match it.vis {
                Visibility::Inherited => ImportVisibility::Private,
                Visibility::Restricted(_) => ImportVisibility::Crate,
                Visibility::Public(_) => ImportVisibility::Public,
            };
            self.import(&it.tree, Vec::new(), visibility);
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

    // `pub(in path)` and attributes are not uses.
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
