//! Writes the pictures of [`accuracy`](crate::accuracy) to a file of the host, and prints their cost.

use core::ffi::CStr;

use semihosting::{fs::File, io::Write, print, println};

use crate::accuracy::{ProvidedBuffers, all};
use crate::scene::SIZE;
use crate::{count, stack};

/// Writes all pictures to one file, one after the other.
pub fn write_all(path: &CStr, buffers: &mut ProvidedBuffers) -> Result<(), &'static str> {
    let mut file = File::create(path).map_err(|_| "the pictures cannot be created")?;
    let mut number = 0;
    all(
        buffers,
        count::now,
        |row| file.write_all(row.as_flattened().as_flattened()).is_ok(),
        |run, cost| {
            if number == 0 {
                // Before printing, which uses stack as well.
                let stack = stack::used();
                println!("pixels {}", SIZE.width() * SIZE.height());
                println!("stack {stack}");
                println!("worker {}", cost.worker);
                println!("instructions {}", cost.instructions);
            }
            let (limits, sampling) = (run.limits, run.sampling);
            print!("run {number} {} {} {sampling} {} ", limits.levels, limits.cutoff, cost.instructions);
            number += 1;
        },
        |rays| println!("{rays}"),
    )
}
