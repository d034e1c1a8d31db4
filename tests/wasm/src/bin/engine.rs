//! Runs the module of the first argument and writes its pictures to the folder of the second, like the
//! firmware.

use std::error::Error;
use std::path::PathBuf;

use strahl_firmware::packs::SCENES;
use wasmi::{Engine, Linker, Module, Store};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let (Some(module), Some(folder)) = (arguments.next(), arguments.next()) else {
        return Err("usage: engine MODULE FOLDER".into());
    };
    let engine = Engine::default();
    let module = Module::new(&engine, std::fs::read(module)?)?;
    let mut store = Store::new(&engine, ());
    let instance = Linker::new(&engine).instantiate_and_start(&mut store, &module)?;
    let draw = instance.get_typed_func::<u32, u32>(&store, "draw")?;
    let floats = instance.get_typed_func::<(), u32>(&store, "floats")?;
    let memory = instance.get_memory(&store, "memory").ok_or("the module has no memory")?;
    for (baked, number) in SCENES.iter().zip(0..) {
        let length = draw.call(&mut store, number)? as usize;
        let start = floats.call(&mut store, ())? as usize;
        let bytes = memory.data(&store).get(start..start + length).ok_or("the picture lies outside")?;
        if bytes.is_empty() {
            return Err(format!("{:?} is not drawn", baked.name).into());
        }
        std::fs::write(folder.join(baked.name.to_str()?), bytes)?;
    }
    Ok(())
}
