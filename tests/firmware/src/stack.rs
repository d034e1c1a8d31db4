//! High-water mark of the stack: the free RAM is painted before main, and the lowest overwritten word is the
//! mark.
//!
//! The stack grows down from `_stack_start` (the end of RAM) to `_stack_end` (the end of the
//! statics). cortex-m-rt's feature `paint-stack` paints it.

use cortex_m_rt::STACK_PAINT_VALUE;

unsafe extern "C" {
    static _stack_start: u32;
    static _stack_end: u32;
}

/// Maximum stack usage since the start, in bytes.
pub fn used() -> usize {
    used_below(&raw const _stack_start as usize)
}

/// Maximum stack usage since the start below an address on the stack, in bytes.
pub fn used_below(address: usize) -> usize {
    let (top, bottom) = (&raw const _stack_start as usize, &raw const _stack_end as usize);
    let mut mark = bottom;
    // SAFETY: aligned words of the RAM between the two linker symbols.
    while mark < top && unsafe { (mark as *const u32).read_volatile() } == STACK_PAINT_VALUE {
        mark += 4;
    }
    address.saturating_sub(mark)
}
