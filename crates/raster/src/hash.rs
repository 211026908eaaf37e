//! Hashes of what is painted, to recognise it in the next frame. They are compared only within one
//! process and need not resist an adversary; two pictures collide with a probability of about 2⁻⁶⁴.

use egui::Color32;

/// Adds a word to `state`; the order of words matters.
#[inline(always)]
pub(super) fn mix(state: u64, word: u64) -> u64 {
    // Folding both halves of the product spreads every bit of the word over the result. The
    // constants are digits of π.
    let product = u128::from(state.rotate_left(29) ^ word ^ 0x2438_6A88_85A3_08D3)
        * u128::from(0x1319_8A2E_0370_7345_u64);
    (product as u64) ^ ((product >> 64) as u64)
}

/// Adds two words at once, for long inputs.
#[inline(always)]
pub(super) fn mix_two(state: u64, a: u64, b: u64) -> u64 {
    let product = u128::from(state.rotate_left(29) ^ a ^ 0x2438_6A88_85A3_08D3)
        * u128::from(b ^ 0x1319_8A2E_0370_7345_u64);
    (product as u64) ^ ((product >> 64) as u64)
}

#[inline(always)]
pub(super) fn pair(a: f32, b: f32) -> u64 {
    u64::from(a.to_bits()) << 32 | u64::from(b.to_bits())
}

#[inline(always)]
pub(super) fn bits(color: Color32) -> u32 {
    u32::from_ne_bytes(color.to_array())
}
