//! Writes the pictures of [`accuracy`](crate::accuracy) into a file of the host, and tells what they
//! took.

use core::ffi::CStr;

use semihosting::{fs::File, io::Write, print, println};

use crate::accuracy::{Lent, all};
use crate::scene::SIZE;
use crate::{count, stack};

/// Draws all pictures into one file, one after the other.
pub fn write_all(path: &CStr, lent: &mut Lent) -> Result<(), &'static str> {
    let mut file = File::create(path).map_err(|_| "the pictures cannot be created")?;
    let mut number = 0;
    all(
        lent,
        count::now,
        |row| file.write_all(row.as_flattened().as_flattened()).is_ok(),
        |run, took| {
            if number == 0 {
                // Before anything is printed, which takes stack as well.
                let stack = stack::used();
                println!("pixels {}", SIZE.width() * SIZE.height());
                println!("stack {stack}");
                println!("worker {}", took.worker);
                println!("instructions {}", took.instructions);
            }
            let (limits, sampling) = (run.limits, run.sampling);
            print!("run {number} {} {} {sampling} {} ", limits.levels, limits.cutoff, took.instructions);
            number += 1;
        },
        |rays| println!("{rays}"),
    )
}
