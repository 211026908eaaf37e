//! Lists of rectangles: few large ones are shown faster than many small ones.

use vides_raster::Area;

/// A longer list is merged into one rectangle.
const MOST: usize = 32;

/// Extra pixels worth showing to save a rectangle.
const SLACK: u64 = 64 * 64;

/// Adds `area`, clipped to a buffer of `size` and merged with nearby rectangles.
pub(super) fn add(list: &mut Vec<Area>, area: Area, size: (u32, u32)) {
    let Some(mut area) = cut(area, size) else {
        return;
    };
    // A merged rectangle may now reach others.
    while let Some(near) = list.iter().position(|other| worth_joining(*other, area)) {
        area = joined(list.swap_remove(near), area);
    }
    list.push(area);
    if list.len() > MOST {
        let all = list.drain(..).reduce(joined);
        list.extend(all);
    }
}

fn cut(area: Area, (width, height): (u32, u32)) -> Option<Area> {
    let inside = area.x < width && area.y < height && area.width > 0 && area.height > 0;
    inside.then(|| Area {
        width: area.width.min(width - area.x),
        height: area.height.min(height - area.y),
        ..area
    })
}

fn worth_joining(a: Area, b: Area) -> bool {
    pixels(joined(a, b)) <= pixels(a) + pixels(b) + SLACK
}

fn pixels(area: Area) -> u64 {
    u64::from(area.width) * u64::from(area.height)
}

fn joined(a: Area, b: Area) -> Area {
    let (x, y) = (a.x.min(b.x), a.y.min(b.y));
    Area {
        x,
        y,
        width: (a.x + a.width).max(b.x + b.width) - x,
        height: (a.y + a.height).max(b.y + b.height) - y,
    }
}

/// Cuts `area` into pieces of at most `most` bytes, but at least one pixel each. `row` returns the
/// number of bytes in a row of this many pixels.
pub(super) fn pieces(
    area: Area,
    most: usize,
    row: impl Fn(usize) -> usize,
) -> impl Iterator<Item = Area> {
    let mut width = area.width.max(1);
    while width > 1 && row(width as usize) > most {
        width = width.div_ceil(2);
    }
    let rows = (most / row(width as usize).max(1)).max(1);
    let height = u32::try_from(rows)
        .unwrap_or(u32::MAX)
        .min(area.height.max(1));
    let across = (0..area.width).step_by(width as usize);
    across.flat_map(move |x| {
        (0..area.height)
            .step_by(height as usize)
            .map(move |y| Area {
                x: area.x + x,
                y: area.y + y,
                width: width.min(area.width - x),
                height: height.min(area.height - y),
            })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(x: u32, y: u32, width: u32, height: u32) -> Area {
        Area {
            x,
            y,
            width,
            height,
        }
    }

    #[test]
    fn what_lies_outside_is_cut_off() {
        let mut list = Vec::new();
        for outside in [
            area(100, 0, 5, 5),
            area(0, 80, 5, 5),
            area(3, 3, 0, 9),
            area(u32::MAX, u32::MAX, u32::MAX, u32::MAX),
        ] {
            add(&mut list, outside, (100, 80));
        }
        assert_eq!(list, []);
        add(&mut list, area(90, 70, u32::MAX, u32::MAX), (100, 80));
        assert_eq!(list, [area(90, 70, 10, 10)]);
    }

    #[test]
    fn tiles_side_by_side_become_one() {
        let mut list = Vec::new();
        for tile in 0..16 {
            add(
                &mut list,
                area(tile % 4 * 64, tile / 4 * 64, 64, 64),
                (1000, 1000),
            );
        }
        assert_eq!(list, [area(0, 0, 256, 256)]);
        add(&mut list, area(900, 900, 10, 10), (1000, 1000));
        assert_eq!(list.len(), 2);
    }

    #[test]
    fn there_are_never_many() {
        let mut list = Vec::new();
        for i in 0..1000_u32 {
            add(
                &mut list,
                area(i * 37 % 40 * 200, i * 91 % 40 * 200, 3, 3),
                (9000, 9000),
            );
            assert!(list.len() <= MOST);
        }
    }

    #[test]
    fn pieces_cover_all_once_and_keep_the_limit() {
        for (width, height, most) in [
            (1200, 800, 262_144),
            (10, 10, 64),
            (8000, 3, 7000),
            (5, 5, 1),
        ] {
            let whole = area(3, 7, width, height);
            let mut covered = vec![0_u8; (width * height) as usize];
            for piece in pieces(whole, most, |width| width * 4) {
                let bytes = piece.width as usize * piece.height as usize * 4;
                assert!(bytes <= most || (piece.width, piece.height) == (1, 1));
                for y in piece.y..piece.y + piece.height {
                    for x in piece.x..piece.x + piece.width {
                        covered[((y - 7) * width + x - 3) as usize] += 1;
                    }
                }
            }
            assert!(covered.iter().all(|&count| count == 1));
        }
        assert_eq!(pieces(area(0, 0, 0, 5), 10, |width| width).count(), 0);
    }
}
