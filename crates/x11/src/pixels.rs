//! Pixel conversion to the screen's format: any arrangement of red, green and blue in 8 to 32 bits,
//! in either byte order.
//!
//! Channels below eight bits use ordered dithering with a 4×4 pattern against banding. It is
//! anchored to the window, so parts painted at different times match; black and white stay pure.

use super::visual::Visual;

/// Dithering thresholds, in sixteenths (Bayer 1973).
const PATTERN: [u32; 16] = [0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5];

#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// Bytes per pixel: 1 to 4.
    bytes: usize,
    /// Rows are padded to a multiple of this many bytes.
    pad: usize,
    big_endian: bool,
    /// Bits that are always set: alpha.
    always: u32,
    /// The bits for each value of each channel, one table per threshold of the pattern, or one for
    /// all. Empty if pixels need no conversion.
    tables: Vec<[[u32; 256]; 3]>,
}

impl Layout {
    pub(super) fn new(visual: &Visual, big_endian: bool) -> Self {
        let masks = [visual.red, visual.green, visual.blue];
        let meant = u32::MAX
            .checked_shr(32 - u32::from(visual.depth))
            .unwrap_or(0);
        let always = meant & !(masks[0] | masks[1] | masks[2]);
        let ours = visual.bits == 32
            && masks == [0xff_0000, 0xff00, 0xff]
            && always == 0
            && big_endian == cfg!(target_endian = "big");
        let coarse = masks.iter().any(|mask| mask.count_ones() < 8);
        let tables = match (ours, coarse) {
            (true, _) => Vec::new(),
            (false, true) => {
                let table = |step: &u32| masks.map(|mask| table(mask, (2 * step + 1) * 255 / 32));
                PATTERN.iter().map(table).collect()
            }
            (false, false) => vec![masks.map(|mask| table(mask, 127))],
        };
        Self {
            bytes: usize::from(visual.bits / 8),
            pad: usize::from(visual.pad / 8),
            big_endian,
            always,
            tables,
        }
    }

    pub(super) fn is_ours(&self) -> bool {
        self.tables.is_empty()
    }

    pub(super) fn row(&self, width: usize) -> usize {
        (width * self.bytes).next_multiple_of(self.pad)
    }

    pub(super) fn offset(&self, x: usize) -> usize {
        x * self.bytes
    }

    /// Converts pixels starting at (`x`, `y`) of the window into `out`, without padding. Pixels for
    /// which `out` has no room are omitted.
    pub(super) fn convert(&self, pixels: &[u32], x: usize, y: usize, out: &mut [u8]) {
        let last = self.tables.len().saturating_sub(1);
        let line = (y & 3) * 4;
        match self.bytes {
            _ if self.is_ours() => {
                for (pixel, out) in pixels.iter().zip(out.chunks_exact_mut(4)) {
                    out.copy_from_slice(&pixel.to_ne_bytes());
                }
            }
            1 => self.run::<1>(pixels, x, last & line, last & 3, out),
            2 => self.run::<2>(pixels, x, last & line, last & 3, out),
            3 => self.run::<3>(pixels, x, last & line, last & 3, out),
            _ => self.run::<4>(pixels, x, last & line, last & 3, out),
        }
    }

    fn run<const N: usize>(
        &self,
        pixels: &[u32],
        x: usize,
        line: usize,
        across: usize,
        out: &mut [u8],
    ) {
        for (i, (pixel, out)) in pixels.iter().zip(out.chunks_exact_mut(N)).enumerate() {
            let [red, green, blue] = &self.tables[line + ((x + i) & across)];
            let [_, r, g, b] = pixel.to_be_bytes();
            let value =
                red[usize::from(r)] | green[usize::from(g)] | blue[usize::from(b)] | self.always;
            if self.big_endian {
                out.copy_from_slice(&value.to_be_bytes()[4 - N..]);
            } else {
                out.copy_from_slice(&value.to_le_bytes()[..N]);
            }
        }
    }
}

/// The bits under `mask` for each of 256 values; `threshold`, of 255, sets the rounding.
fn table(mask: u32, threshold: u32) -> [u32; 256] {
    let shift = mask.trailing_zeros();
    let most = mask.checked_shr(shift).unwrap_or(0);
    std::array::from_fn(|value| ((value as u32 * most + threshold) / 255) << shift)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn visual(depth: u8, bits: u8, pad: u8, masks: [u32; 3]) -> Visual {
        Visual {
            id: 1,
            depth,
            bits,
            pad,
            red: masks[0],
            green: masks[1],
            blue: masks[2],
            foreign: false,
        }
    }

    const RGB: [u32; 3] = [0xff_0000, 0xff00, 0xff];
    const BGR: [u32; 3] = [0xff, 0xff00, 0xff_0000];
    const DEEP: [u32; 3] = [0x3ff0_0000, 0xf_fc00, 0x3ff];
    const HIGH: [u32; 3] = [0xf800, 0x7e0, 0x1f];
    const FIFTEEN: [u32; 3] = [0x7c00, 0x3e0, 0x1f];
    const EIGHT: [u32; 3] = [0x7, 0x38, 0xc0];

    /// One pixel, as a number in the server's byte order.
    fn one(layout: &Layout, pixel: u32, x: usize, y: usize) -> u32 {
        let mut out = vec![0xa5; layout.offset(1)];
        layout.convert(&[pixel], x, y, &mut out);
        let mut number = [0; 4];
        if layout.big_endian {
            number[4 - out.len()..].copy_from_slice(&out);
            u32::from_be_bytes(number)
        } else {
            number[..out.len()].copy_from_slice(&out);
            u32::from_le_bytes(number)
        }
    }

    #[test]
    fn the_painters_own_pixels_are_left_alone() {
        let ours = Layout::new(&visual(24, 32, 32, RGB), cfg!(target_endian = "big"));
        assert!(ours.is_ours());
        assert_eq!(one(&ours, 0x0012_3456, 3, 1), 0x0012_3456);
        for other in [
            Layout::new(&visual(24, 32, 32, BGR), cfg!(target_endian = "big")),
            Layout::new(&visual(24, 32, 32, RGB), cfg!(target_endian = "little")),
            Layout::new(&visual(24, 24, 32, RGB), cfg!(target_endian = "big")),
            Layout::new(&visual(32, 32, 32, RGB), cfg!(target_endian = "big")),
        ] {
            assert!(!other.is_ours());
        }
    }

    #[test]
    fn eight_bits_are_moved_unchanged() {
        for big_endian in [false, true] {
            for (depth, bits, masks, expected) in [
                (24, 32, RGB, 0x12_3456),
                (24, 32, BGR, 0x56_3412),
                (24, 24, RGB, 0x12_3456),
                (24, 24, BGR, 0x56_3412),
                (32, 32, RGB, 0xff12_3456),
                (32, 32, [0xff00, 0xff_0000, 0xff00_0000], 0x5634_12ff),
            ] {
                let layout = Layout::new(&visual(depth, bits, 32, masks), big_endian);
                for x in 0..4 {
                    let got = one(&layout, 0x0012_3456, x, 1);
                    assert_eq!(got, expected, "{depth} {bits} {masks:x?}");
                }
            }
        }
    }

    #[test]
    fn ten_bits_are_the_nearest() {
        let layout = Layout::new(&visual(30, 32, 32, DEEP), false);
        for value in 0..=255_u32 {
            let got = one(&layout, value << 16 | (255 - value), 1, 2);
            let nearest = |value: u32| (f64::from(value) / 255.0 * 1023.0).round() as u32;
            assert_eq!(got >> 20, nearest(value));
            assert_eq!(got & 0x3ff, nearest(255 - value));
            assert_eq!(got >> 10 & 0x3ff, 0);
        }
    }

    #[test]
    fn few_bits_are_dithered_about_the_true_value() {
        for (depth, bits, masks) in [(16, 16, HIGH), (15, 16, FIFTEEN), (8, 8, EIGHT)] {
            for big_endian in [false, true] {
                let layout = Layout::new(&visual(depth, bits, 32, masks), big_endian);
                for value in 0..=255_u32 {
                    let mut sums = [0.0; 3];
                    for place in 0..16 {
                        let got = one(&layout, value * 0x01_0101, place % 4, place / 4);
                        assert_eq!(got >> depth, 0);
                        for (sum, mask) in sums.iter_mut().zip(masks) {
                            let most = f64::from(mask >> mask.trailing_zeros());
                            let level = f64::from((got & mask) >> mask.trailing_zeros());
                            let true_level = f64::from(value) / 255.0 * most;
                            assert!((level - true_level).abs() < 1.0);
                            *sum += level / 16.0 / most * 255.0;
                        }
                    }
                    for (sum, mask) in sums.iter().zip(masks) {
                        // A sixteenth of a level is the finest that a 4×4 pattern shows.
                        let level = 255.0 / f64::from(mask >> mask.trailing_zeros());
                        let off = (sum - f64::from(value)).abs();
                        assert!(off <= level / 16.0, "{depth}: {value} is {sum}");
                    }
                }
                let (black, white) = (one(&layout, 0, 3, 2), one(&layout, 0xff_ffff, 2, 3));
                assert_eq!((black, white), (0, masks[0] | masks[1] | masks[2]));
            }
        }
    }

    #[test]
    fn parts_fit_together() {
        let layout = Layout::new(&visual(16, 16, 32, HIGH), false);
        let pixels: Vec<u32> = (0..37).map(|i| i * 0x03_0507).collect();
        let mut whole = vec![0; 74];
        layout.convert(&pixels, 0, 5, &mut whole);
        let mut part = vec![0; 40];
        layout.convert(&pixels[7..27], 7, 5, &mut part);
        assert_eq!(whole[14..54], part);
    }

    #[test]
    fn rows_are_filled_up() {
        let row = |bits, pad| Layout::new(&visual(15, bits, pad, FIFTEEN), false).row(5);
        assert_eq!(
            (row(16, 32), row(16, 16), row(24, 32), row(32, 32)),
            (12, 10, 16, 20)
        );
    }
}
