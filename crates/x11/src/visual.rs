//! The choice of the window's visual.

use x11rb::protocol::xproto::{Screen, Setup, VisualClass, Visualtype};

/// A TrueColor visual and its image format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Visual {
    pub(super) id: u32,
    /// The number of significant bits.
    pub(super) depth: u8,
    /// Bits per pixel in an image: 8, 16, 24 or 32.
    pub(super) bits: u8,
    /// Image rows are padded to a multiple of this many bits.
    pub(super) pad: u8,
    pub(super) red: u32,
    pub(super) green: u32,
    pub(super) blue: u32,
    /// Not the root's visual, so it needs its own colormap.
    pub(super) foreign: bool,
}

/// Best first.
const DEPTHS: [u8; 5] = [24, 30, 32, 16, 15];

/// The root's visual if usable, otherwise the best usable one; `None` if there is no TrueColor
/// visual.
pub(super) fn choose(setup: &Setup, screen: &Screen) -> Option<Visual> {
    let all = || {
        screen.allowed_depths.iter().flat_map(|depth| {
            (depth.visuals.iter())
                .filter_map(|visual| usable(setup, depth.depth, visual, screen.root_visual))
        })
    };
    let own = all().find(|visual| !visual.foreign);
    own.or_else(|| {
        all().min_by_key(|visual| {
            let place = DEPTHS.iter().position(|&depth| depth == visual.depth);
            place.unwrap_or(DEPTHS.len())
        })
    })
}

fn usable(setup: &Setup, depth: u8, visual: &Visualtype, own: u32) -> Option<Visual> {
    let format = (setup.pixmap_formats.iter()).find(|format| format.depth == depth)?;
    let masks = [visual.red_mask, visual.green_mask, visual.blue_mask];
    let apart = masks[0] & masks[1] | masks[1] & masks[2] | masks[2] & masks[0] == 0;
    let fit = visual.class == VisualClass::TRUE_COLOR
        && depth >= 8
        && matches!(format.bits_per_pixel, 8 | 16 | 24 | 32)
        && matches!(format.scanline_pad, 8 | 16 | 32)
        && depth <= format.bits_per_pixel
        && masks.iter().all(|&mask| contiguous(mask))
        && apart;
    fit.then_some(Visual {
        id: visual.visual_id,
        depth,
        bits: format.bits_per_pixel,
        pad: format.scanline_pad,
        red: visual.red_mask,
        green: visual.green_mask,
        blue: visual.blue_mask,
        foreign: visual.visual_id != own,
    })
}

/// Whether the mask is one run of at most 16 set bits.
fn contiguous(mask: u32) -> bool {
    let run = mask.checked_shr(mask.trailing_zeros()).unwrap_or(0);
    run != 0 && run <= 0xffff && run & (run + 1) == 0
}

#[cfg(test)]
mod tests {
    use super::*;
    use x11rb::protocol::xproto::{Depth, Format};

    fn kind(visual_id: u32, class: VisualClass, masks: [u32; 3]) -> Visualtype {
        Visualtype {
            visual_id,
            class,
            red_mask: masks[0],
            green_mask: masks[1],
            blue_mask: masks[2],
            ..Visualtype::default()
        }
    }

    fn of(root_visual: u32, kinds: &[(u8, Visualtype)]) -> Option<Visual> {
        let format = |depth, bits_per_pixel| Format {
            depth,
            bits_per_pixel,
            scanline_pad: 32,
        };
        let setup = Setup {
            pixmap_formats: vec![
                format(8, 8),
                format(15, 16),
                format(16, 16),
                format(24, 32),
                format(30, 32),
                format(32, 32),
            ],
            ..Setup::default()
        };
        let depth = |&(depth, kind): &(u8, Visualtype)| Depth {
            depth,
            visuals: vec![kind],
        };
        let screen = Screen {
            root_visual,
            allowed_depths: kinds.iter().map(depth).collect(),
            ..Screen::default()
        };
        choose(&setup, &screen)
    }

    const RGB: [u32; 3] = [0xff_0000, 0xff00, 0xff];
    const DEEP: [u32; 3] = [0x3ff0_0000, 0xf_fc00, 0x3ff];
    const HIGH: [u32; 3] = [0xf800, 0x7e0, 0x1f];

    #[test]
    fn the_screens_own_visual_is_taken_where_it_will_do() {
        let kinds = [
            (24, kind(1, VisualClass::TRUE_COLOR, RGB)),
            (16, kind(2, VisualClass::TRUE_COLOR, HIGH)),
            (30, kind(3, VisualClass::TRUE_COLOR, DEEP)),
        ];
        for (id, depth) in [(1, 24), (2, 16), (3, 30)] {
            let visual = of(id, &kinds).expect("one of them");
            assert_eq!(
                (visual.id, visual.depth, visual.foreign),
                (id, depth, false)
            );
        }
    }

    #[test]
    fn on_a_palette_screen_the_best_other_is_taken() {
        let kinds = [
            (8, kind(1, VisualClass::PSEUDO_COLOR, [0; 3])),
            (16, kind(2, VisualClass::TRUE_COLOR, HIGH)),
            (24, kind(3, VisualClass::DIRECT_COLOR, RGB)),
            (32, kind(4, VisualClass::TRUE_COLOR, RGB)),
        ];
        let visual = of(1, &kinds).expect("one of them");
        assert_eq!((visual.id, visual.foreign), (4, true));
        assert_eq!(of(1, &kinds[..1]), None);
    }

    #[test]
    fn masks_that_are_none_are_refused() {
        for masks in [
            [0xff, 0xff, 0xff],
            [0, 0xff00, 0xff],
            [0x00f0_f000, 0xf00, 0xff],
        ] {
            let kinds = [(24, kind(1, VisualClass::TRUE_COLOR, masks))];
            assert_eq!(of(1, &kinds), None, "{masks:x?}");
        }
        assert!(contiguous(0xf800) && contiguous(1) && contiguous(0xff00_0000));
        assert!(!contiguous(0) && !contiguous(5) && !contiguous(0x1_ffff));
    }
}
