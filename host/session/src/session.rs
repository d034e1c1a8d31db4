//! A scene opened once in the requested precision: pictures and ray queries.

use std::time::{Duration, Instant};

use strahl_core::tally::Counters;
use strahl_engine::{
    AccelMemory, AccelStats, Engine, Progress, RayCaster, RenderError, RenderOptions, Rendered, SceneEngine,
    SceneStats, Scheduler,
};
use strahl_picture::Picture;
use strahl_scene::description::LoadedScene;
use strahl_settings::{AccelSettings, Precision, Settings};

use crate::tables::{double, single};

/// The tables of a scene, and memory for its accelerator. A [`Session`] borrows it.
#[derive(Debug)]
pub struct SceneStorage {
    tables: Tables,
    build: Duration,
}

#[derive(Debug)]
enum Tables {
    Single(Box<strahl_core::SceneTables>, strahl_core::CameraDescriptor, AccelMemory),
    Double(
        Box<strahl_core_double::SceneTables>,
        strahl_core_double::CameraDescriptor,
        strahl_engine_double::AccelMemory,
    ),
}

impl SceneStorage {
    /// Builds the tables of a scene in this precision.
    pub fn new(description: &LoadedScene, precision: Precision) -> Self {
        let clock = Instant::now();
        let camera = &description.camera;
        let tables = match precision {
            Precision::Single => {
                let tables = Box::new(single::scene_tables(description));
                Tables::Single(tables, single::camera_descriptor(camera), AccelMemory::default())
            }
            Precision::Double => {
                let tables = Box::new(double::scene_tables(description));
                Tables::Double(
                    tables,
                    double::camera_descriptor(camera),
                    strahl_engine_double::AccelMemory::default(),
                )
            }
        };
        SceneStorage { tables, build: clock.elapsed() }
    }

    /// The contents of the scene. Returns an error if the core refuses it.
    pub fn scene_stats(&self) -> Result<SceneStats, RenderError> {
        match &self.tables {
            Tables::Single(tables, camera, _) => {
                let scene = tables.scene().map_err(RenderError::invalid)?;
                Ok(strahl_engine::scene_engine::scene_stats(&scene, camera))
            }
            Tables::Double(tables, camera, _) => {
                let scene = tables.scene().map_err(RenderError::invalid)?;
                Ok(strahl_engine_double::scene_engine::scene_stats(&scene, camera))
            }
        }
    }
}

/// A scene with its accelerator: renders pictures and answers ray queries.
pub struct Session<'s> {
    engine: Box<dyn Engine + 's>,
    precision: Precision,
    build: Duration,
}

impl<'s> Session<'s> {
    /// Builds the accelerator. Returns an error if the core refuses the scene.
    pub fn new(storage: &'s mut SceneStorage, accelerator: &AccelSettings) -> Result<Self, RenderError> {
        let clock = Instant::now();
        let SceneStorage { tables, build } = storage;
        let (engine, precision): (Box<dyn Engine + 's>, _) = match tables {
            Tables::Single(tables, camera, memory) => {
                let scene = tables.scene().map_err(RenderError::invalid)?;
                (Box::new(SceneEngine::new(scene, *camera, accelerator, memory)?), Precision::Single)
            }
            Tables::Double(tables, camera, memory) => {
                let scene = tables.scene().map_err(RenderError::invalid)?;
                let engine = strahl_engine_double::SceneEngine::new(scene, *camera, accelerator, memory)?;
                (Box::new(engine), Precision::Double)
            }
        };
        Ok(Session { engine, precision, build: *build + clock.elapsed() })
    }

    /// The contents of the scene.
    pub fn scene(&self) -> &SceneStats {
        self.engine.scene()
    }

    /// The accelerator.
    pub fn accelerator(&self) -> &AccelStats {
        self.engine.accelerator()
    }

    /// Renders a picture.
    ///
    /// Precision and accelerator are those of the session; the settings do not change them.
    pub fn render(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        progress: &dyn Progress,
    ) -> Result<RenderOutput, RenderError> {
        Ok(self.output(settings, self.engine.render(settings, options, progress)?))
    }

    /// Renders progressively, pass by pass as `scheduler` chooses. Returns the picture of the last complete pass.
    pub fn refine(
        &self,
        settings: &Settings,
        options: &RenderOptions<'_>,
        progress: &dyn Progress,
        scheduler: &mut dyn Scheduler,
    ) -> Result<RenderOutput, RenderError> {
        Ok(self.output(settings, self.engine.refine(settings, options, progress, scheduler)?))
    }

    /// A function that finds the nearest hit of a ray, for use by one thread.
    pub fn ray_caster(&self) -> RayCaster<'_> {
        self.engine.ray_caster()
    }

    fn output(&self, settings: &Settings, rendered: Rendered) -> RenderOutput {
        let Rendered { colors, counters, trace, trace_cpu } = rendered;
        RenderOutput {
            picture: Picture { size: settings.picture_size(), colors },
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

/// A picture with its statistics.
#[derive(Debug)]
pub struct RenderOutput {
    /// The picture.
    pub picture: Picture,
    /// Event counters. Tests are zero unless [`RenderOptions`] requests them.
    pub counters: Counters,
    /// Floating-point precision of the computation.
    pub precision: Precision,
    /// The contents of the scene.
    pub scene: SceneStats,
    /// The accelerator.
    pub accelerator: AccelStats,
    /// Wall-clock time to build the tables and the accelerator.
    pub build: Duration,
    /// Wall-clock time of tracing.
    pub trace: Duration,
    /// Processor time of tracing, summed over all threads.
    pub trace_cpu: Duration,
}

/// Opens a scene and renders one picture.
pub fn render(
    description: &LoadedScene,
    settings: &Settings,
    options: &RenderOptions<'_>,
    progress: &dyn Progress,
) -> Result<RenderOutput, RenderError> {
    let mut storage = SceneStorage::new(description, settings.precision);
    Session::new(&mut storage, &settings.acceleration())?.render(settings, options, progress)
}
