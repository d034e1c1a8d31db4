//! Counts of executed instructions, read from timer TIM2 of QEMU's STM32F405.
//!
//! QEMU runs that timer at 1 GHz of virtual time, and with `-icount shift=0` one instruction lasts one
//! virtual nanosecond: the counter increases by one per instruction. Without `-icount` it follows the host's
//! clock, and the numbers are noise.

const TIM2_CNT: *const u32 = 0x4000_0024 as *const u32;

/// Value of the counter.
#[inline(always)]
pub fn now() -> u32 {
    // SAFETY: a 32-bit peripheral register of this machine; reading has no effect.
    unsafe { TIM2_CNT.read_volatile() }
}

/// The result of `work` and its number of instructions, up to 2^32 - 1. Longer work must be measured in parts
/// and summed in a `u64`.
///
/// Not inlined, so that every measurement has the same overhead: that of `of(|| ())`.
#[inline(never)]
pub fn of<T>(work: impl FnOnce() -> T) -> (T, u32) {
    let start = now();
    let result = work();
    let end = now();
    (result, end.wrapping_sub(start))
}
