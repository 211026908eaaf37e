//! Fingerprints of what is painted, to know it again in the next frame.
//!
//! They are compared within one process only and met by no adversary: two
//! different pictures share one with a chance of about 2⁻⁶⁴.

use egui::Color32;

/// `state` continued by one word. The order of the words counts.
#[inline(always)]
pub(super) fn mix(state: u64, word: u64) -> u64 {
    // Both halves of the product: every bit of the word reaches every bit of
    // the result. The constants are digits of π.
    let product = u128::from(state.rotate_left(29) ^ word ^ 0x2438_6A88_85A3_08D3)
        * u128::from(0x1319_8A2E_0370_7345_u64);
    (product as u64) ^ ((product >> 64) as u64)
}

/// `state` continued by two words at once, for long rows of them.
#[inline(always)]
pub(super) fn mix_two(state: u64, a: u64, b: u64) -> u64 {
    let product = u128::from(state.rotate_left(29) ^ a ^ 0x2438_6A88_85A3_08D3)
        * u128::from(b ^ 0x1319_8A2E_0370_7345_u64);
    (product as u64) ^ ((product >> 64) as u64)
}

/// Two numbers as one word, by their bits.
#[inline(always)]
pub(super) fn pair(a: f32, b: f32) -> u64 {
    u64::from(a.to_bits()) << 32 | u64::from(b.to_bits())
}

#[inline(always)]
pub(super) fn bits(color: Color32) -> u32 {
    u32::from_ne_bytes(color.to_array())
}
