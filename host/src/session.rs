//! A scene opened once in the precision that is asked for: pictures of it, and what rays hit.

use std::time::{Duration, Instant};

use crate::description::Description;
use crate::finding::Finding;
use crate::precision::Precision;
use crate::progress::Progress;
use crate::ray_query::RayCaster;
use crate::render_output::{AccelStats, RenderError, RenderOutput, Rendered, SceneStats};
use crate::render_request::RenderRequest;
use crate::scheduler::Scheduler;
use crate::{double, engine, stock};
use strahl_picture::Picture;

/// A scene with its accelerator, whatever precision it computes with.
pub trait Engine: Sync {
    /// What is in the scene.
    fn scene(&self) -> &SceneStats;

    /// The accelerator.
    fn accelerator(&self) -> &AccelStats;

    /// Renders a picture.
    fn render(&self, request: &RenderRequest, progress: &dyn Progress) -> Result<Rendered, RenderError>;

    /// Renders a picture that becomes better pass by pass, as `scheduler` says; the last that was completed.
    fn refine(
        &self,
        request: &RenderRequest,
        progress: &dyn Progress,
        scheduler: &mut dyn Scheduler,
    ) -> Result<Rendered, RenderError>;

    /// Finds the nearest hits of rays, for one thread.
    fn ray_caster(&self) -> RayCaster<'_>;
}

/// The tables of a scene, and memory for its accelerator. The caller keeps it as long as the session.
#[derive(Debug)]
pub struct SceneStorage {
    tables: Tables,
    build: Duration,
}

#[derive(Debug)]
enum Tables {
    Single(Box<strahl_core::SceneTables>, engine::accelerators::AccelMemory),
    Double(Box<strahl_core_double::SceneTables>, double::engine::accelerators::AccelMemory),
}

impl SceneStorage {
    /// The tables of a scene in this precision.
    pub fn new(description: &Description, precision: Precision) -> Self {
        let clock = Instant::now();
        let tables = match precision {
            Precision::Single => {
                Tables::Single(Box::new(stock::single::scene_tables(description)), Default::default())
            }
            Precision::Double => {
                Tables::Double(Box::new(stock::double::scene_tables(description)), Default::default())
            }
        };
        SceneStorage { tables, build: clock.elapsed() }
    }
}

/// A scene with its accelerator, of which pictures are rendered one after another.
pub struct Session<'s> {
    engine: Box<dyn Engine + 's>,
    precision: Precision,
    build: Duration,
}

impl<'s> Session<'s> {
    /// Builds the accelerator that is asked for.
    pub fn new(
        description: &Description,
        storage: &'s mut SceneStorage,
        finding: &Finding,
    ) -> Result<Self, RenderError> {
        let clock = Instant::now();
        let SceneStorage { tables, build } = storage;
        let (engine, precision): (Box<dyn Engine + 's>, _) = match tables {
            Tables::Single(tables, memory) => {
                let session = engine::session::Session::new(description, tables, finding, memory)?;
                (Box::new(session), Precision::Single)
            }
            Tables::Double(tables, memory) => {
                let session = double::engine::session::Session::new(description, tables, finding, memory)?;
                (Box::new(session), Precision::Double)
            }
        };
        Ok(Session { engine, precision, build: *build + clock.elapsed() })
    }

    /// What is in the scene.
    pub fn scene(&self) -> &SceneStats {
        self.engine.scene()
    }

    /// The accelerator.
    pub fn accelerator(&self) -> &AccelStats {
        self.engine.accelerator()
    }

    /// Renders a picture.
    ///
    /// Precision and accelerator are those of the session, whatever else the settings ask for.
    pub fn render(
        &self,
        request: &RenderRequest,
        progress: &dyn Progress,
    ) -> Result<RenderOutput, RenderError> {
        Ok(self.output(request, self.engine.render(request, progress)?))
    }

    /// Renders a picture that becomes better pass by pass, as `scheduler` says; the last that was completed.
    pub fn refine(
        &self,
        request: &RenderRequest,
        progress: &dyn Progress,
        scheduler: &mut dyn Scheduler,
    ) -> Result<RenderOutput, RenderError> {
        Ok(self.output(request, self.engine.refine(request, progress, scheduler)?))
    }

    /// Finds the nearest hits of rays, for one thread.
    pub fn ray_caster(&self) -> RayCaster<'_> {
        self.engine.ray_caster()
    }

    fn output(&self, request: &RenderRequest, rendered: Rendered) -> RenderOutput {
        let Rendered { colors, counters, trace, trace_cpu } = rendered;
        RenderOutput {
            picture: Picture { size: request.settings.picture_size(), colors },
            counters,
            precision: self.precision,
            scene: *self.scene(),
            accelerator: *self.accelerator(),
            build: self.build,
            trace,
            trace_cpu,
        }
    }
}

/// Opens a scene and renders one picture of it.
pub fn render(
    description: &Description,
    request: &RenderRequest,
    progress: &dyn Progress,
) -> Result<RenderOutput, RenderError> {
    let mut storage = SceneStorage::new(description, request.settings.precision);
    Session::new(description, &mut storage, &request.settings.acceleration())?.render(request, progress)
}
