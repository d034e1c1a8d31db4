//! Source files as the compiler sees them: the modules of a crate, each with its items.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use syn::punctuated::Punctuated;
use syn::{Attribute, Expr, ExprLit, Item, ItemMacro, ItemMod, Lit, Meta, Token, Visibility};

use crate::expansion::Rule;

/// The modules of a library, a program, a test or an example. The first is its root.
pub struct Crate {
    pub modules: Vec<Module>,
    indices: HashMap<Vec<String>, usize>,
}

/// A module, with its items but without those of its submodules and of unit tests.
pub struct Module {
    /// Path from the root.
    pub path: Vec<String>,
    pub items: Vec<Item>,
    /// Source file.
    pub file: PathBuf,
    /// Whether it is declared with `pub mod`.
    pub is_public: bool,
    /// Features that enable it.
    pub features: Vec<String>,
}

impl Crate {
    /// Reads the root module and all modules that it declares, recursively.
    pub fn read(root: &Path) -> Crate {
        let mut read = Crate { modules: Vec::new(), indices: HashMap::new() };
        let file = parsed(root);
        let folder = root.parent().unwrap();
        read.add(Module::root(root), file.items, folder);
        read.expand();
        read
    }

    /// A crate whose modules are all in one text.
    pub fn of(text: &str) -> Crate {
        let mut read = Crate { modules: Vec::new(), indices: HashMap::new() };
        let file = syn::parse_file(text).unwrap_or_else(|error| panic!("{error}"));
        read.add(Module::root("lib.rs".as_ref()), file.items, ".".as_ref());
        read.expand();
        read
    }

    /// Replaces calls of simple macros of the crate by their expansion.
    fn expand(&mut self) {
        let mut rules = HashMap::new();
        for item in self.modules.iter().flat_map(|module| &module.items) {
            if let Item::Macro(ItemMacro { ident: Some(name), mac, .. }) = item
                && let Some(rule) = Rule::of(mac.tokens.clone())
            {
                rules.insert(name.to_string(), rule);
            }
        }
        let expanded = |item: Item| match &item {
            Item::Macro(ItemMacro { ident: None, mac, .. }) => {
                let rule = mac.path.segments.last().and_then(|name| rules.get(&name.ident.to_string()));
                let items = rule.and_then(|rule| rule.expanded(mac.tokens.clone()));
                items
                    .and_then(|items| syn::parse2::<syn::File>(items).ok())
                    .map_or(vec![item], |file| file.items)
            }
            _ => vec![item],
        };
        for module in &mut self.modules {
            module.items = std::mem::take(&mut module.items).into_iter().flat_map(expanded).collect();
        }
    }

    /// The index of the module with this path.
    pub fn index(&self, path: &[String]) -> Option<usize> {
        self.indices.get(path).copied()
    }

    /// The index of a submodule.
    pub fn child(&self, parent: usize, name: &str) -> Option<usize> {
        let mut path = self.modules[parent].path.clone();
        path.push(name.to_owned());
        self.index(&path)
    }

    /// Adds a module and its submodules, whose files are in this folder.
    fn add(&mut self, module: Module, items: Vec<Item>, folder: &Path) {
        let index = self.modules.len();
        self.indices.insert(module.path.clone(), index);
        self.modules.push(module);
        for item in items {
            match item {
                item if is_for_tests(attributes(&item)) => {}
                Item::Mod(declared) => self.add_declared(index, declared, folder),
                item => self.modules[index].items.push(item),
            }
        }
    }

    fn add_declared(&mut self, parent: usize, declared: ItemMod, folder: &Path) {
        let name = declared.ident.to_string();
        let parent = &self.modules[parent];
        let mut module = Module {
            path: [&parent.path[..], std::slice::from_ref(&name)].concat(),
            items: Vec::new(),
            file: parent.file.clone(),
            is_public: matches!(declared.vis, Visibility::Public(_)),
            features: [&parent.features[..], &features(&declared.attrs)].concat(),
        };
        let inner = folder.join(&name);
        if let Some((_, items)) = declared.content {
            self.add(module, items, &inner);
            return;
        }
        let beside = inner.with_extension("rs");
        module.file = if beside.exists() { beside } else { inner.join("mod.rs") };
        let items = parsed(&module.file).items;
        self.add(module, items, &inner);
    }
}

impl Module {
    fn root(file: &Path) -> Module {
        let (path, items, features) = Default::default();
        Module { path, items, file: file.to_owned(), is_public: true, features }
    }
}

/// The syntax tree of a file.
pub fn parsed(path: &Path) -> syn::File {
    let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Whether these attributes restrict an item to unit tests.
fn is_for_tests(attributes: &[Attribute]) -> bool {
    fn needs_test(meta: &Meta) -> bool {
        match meta {
            Meta::Path(path) => path.is_ident("test"),
            Meta::List(list) if list.path.is_ident("all") => list
                .parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated)
                .is_ok_and(|all| all.iter().any(needs_test)),
            _ => false,
        }
    }
    attributes
        .iter()
        .filter(|attribute| attribute.path().is_ident("cfg"))
        .any(|attribute| attribute.parse_args::<Meta>().is_ok_and(|meta| needs_test(&meta)))
}

/// Features that enable an item.
pub fn features(attributes: &[Attribute]) -> Vec<String> {
    let cfgs = attributes.iter().filter(|attribute| attribute.path().is_ident("cfg"));
    let feature = |attribute: &Attribute| match attribute.parse_args::<Meta>().ok()? {
        Meta::NameValue(it) if it.path.is_ident("feature") => text(&it.value),
        _ => None,
    };
    cfgs.filter_map(feature).collect()
}

fn text(value: &Expr) -> Option<String> {
    match value {
        Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value()),
        _ => None,
    }
}

/// Attributes of an item.
pub fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(it) => &it.attrs,
        Item::Enum(it) => &it.attrs,
        Item::ExternCrate(it) => &it.attrs,
        Item::Fn(it) => &it.attrs,
        Item::ForeignMod(it) => &it.attrs,
        Item::Impl(it) => &it.attrs,
        Item::Macro(it) => &it.attrs,
        Item::Mod(it) => &it.attrs,
        Item::Static(it) => &it.attrs,
        Item::Struct(it) => &it.attrs,
        Item::Trait(it) => &it.attrs,
        Item::TraitAlias(it) => &it.attrs,
        Item::Type(it) => &it.attrs,
        Item::Union(it) => &it.attrs,
        Item::Use(it) => &it.attrs,
        _ => &[],
    }
}
