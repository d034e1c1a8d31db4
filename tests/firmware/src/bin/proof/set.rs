//! Sets of enum variants, which one macro defines.

use strahl_core::geometry::{ShapeKind, ShapeKindSet};
use strahl_core::scene::{EffectSet, LightKind, LightKindSet, TextureKind, TextureKindSet};

use crate::any::{any, slice, used};
use crate::text::{debugged, displayed};

pub fn entry_points() {
    macro_rules! set {
        ($Set:ident of $Kind:ident) => {{
            let set = $Set::with($Set::of(slice(&$Kind::ALL)), any($Kind::ALL[0]));
            let set = $Set::union(set, any($Set::NONE));
            used(($Set::len(set), $Set::is_empty(set)));
            used(($Set::contains(set, any($Kind::ALL[0])), $Set::is_superset(set, any($Set::ALL))));
            used($Set::difference(set, any($Set::ALL)));
            $Set::iter(set).for_each(|kind| used((kind, $Kind::name(kind))));
            debugged(&set);
            set
        }};
    }
    let mut set = any(EffectSet::NONE);
    set.shapes = set!(ShapeKindSet of ShapeKind);
    set.lights = set!(LightKindSet of LightKind);
    set.textures = set!(TextureKindSet of TextureKind);
    used(EffectSet::is_superset(&set, &any(EffectSet::ALL)));
    displayed(EffectSet::difference(&set, &any(EffectSet::ALL)));
}
