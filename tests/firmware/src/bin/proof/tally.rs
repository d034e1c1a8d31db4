//! What happens while a picture is traced, and who hears of it.

use strahl_core::*;

use crate::any::{any, used};

pub fn doors() {
    RayKind::ALL.into_iter().for_each(used);
    ().count(any(Event::MediaFull));
    ().tell(any(Step::ThrownBack));
    used((any(Fate::Sent), any(Lit::Dark)));
}

/// Hears of everything and remembers nothing.
pub struct Told;

impl Tally for Told {
    fn count(&mut self, event: Event) {
        used(event);
    }

    fn tell(&mut self, step: Step) {
        used(step);
    }
}
