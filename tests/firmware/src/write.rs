//! Files of pictures on the host, and reports of the cost of each picture.

use core::ffi::CStr;
use core::fmt::Display;

use semihosting::{fs::File, io::Write, print, println};
use strahl_device::accuracy::{ProvidedBuffers, all};
use strahl_device::draw::PixelBytes;
use strahl_device::scene::SIZE;

use crate::{count, stack};

/// A file of pictures, one after the other.
pub struct PictureFile(File);

impl PictureFile {
    /// An empty file.
    pub fn create(path: &CStr) -> Result<PictureFile, &'static str> {
        File::create(path).map(PictureFile).map_err(|_| "the pictures cannot be created")
    }

    /// Appends a row. Returns whether it succeeded.
    pub fn write(&mut self, row: &[PixelBytes]) -> bool {
        self.0.write_all(row.as_flattened().as_flattened()).is_ok()
    }
}

/// Prints the cost of each picture of [`strahl_device::accuracy`], which the caller completes with its number
/// of rays.
#[derive(Default)]
pub struct CostReport {
    /// Number of pictures that have been reported.
    count: u32,
}

impl CostReport {
    /// Prints the cost of a picture, in instructions and bytes of its worker.
    pub fn print(&mut self, run: impl Display, instructions: u64, worker: usize) {
        if self.count == 0 {
            // Before printing, which uses stack as well.
            let stack = stack::used();
            println!("pixels {}", SIZE.width() * SIZE.height());
            println!("stack {stack}");
            println!("worker {worker}");
            println!("instructions {instructions}");
        }
        print!("run {} {run} {instructions} ", self.count);
        self.count += 1;
    }
}

/// Writes all pictures to one file, and prints their cost.
pub fn write_all(buffers: &mut ProvidedBuffers) -> Result<(), &'static str> {
    let (mut file, mut report) = (PictureFile::create(c"golden.f32")?, CostReport::default());
    all(
        buffers,
        count::now,
        |row| file.write(row),
        |run, cost| report.print(run, cost.instructions, cost.worker),
        |rays| println!("{rays}"),
    )
}
