//! Sets, which are made by the same macro for enums of several rooms.

use strahl_core::*;

use crate::any::{any, slice, used};
use crate::text::debugged;

pub fn doors() {
    macro_rules! set {
        ($Set:ident of $Kind:ident) => {{
            let set = $Set::of(slice(&$Kind::ALL)).with(any($Kind::ALL[0])).union(any($Set::NONE));
            used((set.len(), set.is_empty(), set.has(any($Kind::ALL[0])), set.contains(any($Set::ALL))));
            set.iter().for_each(used);
            debugged(&set);
            set
        }};
    }
    let mut set = any(EffectSet::NONE);
    set.shapes = set!(ShapeSet of ShapeKind);
    set.lights = set!(LightSet of LightKind);
    set.textures = set!(TextureSet of TextureKind);
    used(set.contains(&any(EffectSet::ALL)));
}
