//! The window's icon: three points, the curve through them and a camera's view,
//! drawn here, so that there is no file to be found.

/// The sizes that window managers ask for.
const SIZES: [u32; 4] = [16, 32, 48, 64];

/// Colours as red, green, blue.
const GROUND: [f32; 3] = [30.0, 37.0, 51.0];
const CURVE: [f32; 3] = [96.0, 190.0, 255.0];
const VIEW: [f32; 3] = [255.0, 184.0, 76.0];
const POINT: [f32; 3] = [255.0, 255.0, 255.0];

/// The curve in the unit square, y down: a cubic Bézier curve.
const PATH: [[f32; 2]; 4] = [[0.14, 0.76], [0.30, 0.05], [0.62, 1.02], [0.84, 0.24]];

/// As the property `_NET_WM_ICON` wants it: width, height and rows of ARGB for
/// each size.
pub(super) fn icon() -> Vec<u32> {
    let mut data = Vec::new();
    let curve: Vec<[f32; 2]> = (0..=24).map(|i| on_path(i as f32 / 24.0)).collect();
    for size in SIZES {
        data.extend([size, size]);
        for y in 0..size {
            for x in 0..size {
                let place = [x, y].map(|i| (i as f32 + 0.5) / size as f32);
                data.push(pixel(place, 1.0 / size as f32, &curve));
            }
        }
    }
    data
}

/// One pixel; `unit` is its width.
fn pixel(place: [f32; 2], unit: f32, curve: &[[f32; 2]]) -> u32 {
    let cover = |distance: f32| (0.5 - distance / unit).clamp(0.0, 1.0);
    let mut colour = GROUND;
    let mut paint = |paint: [f32; 3], share: f32| {
        for (colour, paint) in colour.iter_mut().zip(paint) {
            *colour += (paint - *colour) * share;
        }
    };
    // A square with round corners.
    let corner = place.map(|c| ((c - 0.5).abs() - 0.28).max(0.0));
    let ground = cover(corner[0].hypot(corner[1]) - 0.22);
    // What a camera at the second point sees.
    let view = [on_path(0.5), [0.74, 0.93], [0.95, 0.66]];
    let outside = (0..3).map(|i| beside(place, view[i], view[(i + 1) % 3]));
    paint(VIEW, cover(outside.fold(f32::MIN, f32::max)) * 0.85);
    let far = (curve.iter().zip(curve.iter().skip(1)))
        .map(|(&a, &b)| distance(place, a, b))
        .fold(f32::MAX, f32::min);
    paint(CURVE, cover(far - 0.035));
    for at in [0.0, 0.5, 1.0] {
        let point = on_path(at);
        paint(POINT, cover(distance(place, point, point) - 0.075));
    }
    let [red, green, blue] = colour.map(|value| value.round() as u32);
    ((ground * 255.0).round() as u32) << 24 | red << 16 | green << 8 | blue
}

fn on_path(t: f32) -> [f32; 2] {
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    std::array::from_fn(|axis| (0..4).map(|i| weights[i] * PATH[i][axis]).sum())
}

/// How far `p` is from the line from `a` to `b`.
fn distance(p: [f32; 2], a: [f32; 2], b: [f32; 2]) -> f32 {
    let (along, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let length = along[0] * along[0] + along[1] * along[1];
    let dot = along[0] * from[0] + along[1] * from[1];
    let t = if length > 0.0 {
        (dot / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (from[0] - t * along[0]).hypot(from[1] - t * along[1])
}

/// How far `p` lies to the outer side of the straight line through `a` and `b`.
fn beside(p: [f32; 2], a: [f32; 2], b: [f32; 2]) -> f32 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let cross = along[0] * (p[1] - a[1]) - along[1] * (p[0] - a[0]);
    cross / along[0].hypot(along[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_icon_is_as_window_managers_read_it() {
        let icon = icon();
        let mut rest = icon.as_slice();
        for size in SIZES {
            assert_eq!(rest[..2], [size, size]);
            let (picture, next) = rest[2..].split_at((size * size) as usize);
            assert_eq!(picture[0] >> 24, 0, "its corners are transparent");
            let white = picture
                .iter()
                .filter(|&&pixel| pixel == 0xffff_ffff)
                .count();
            assert!(white as u32 > size * size / 70, "three points");
            let orange = picture
                .iter()
                .filter(|&&p| p >> 16 & 0xff > 200 && p & 0xff < 120);
            assert!(
                orange.count() as u32 > size * size / 60,
                "the camera's view"
            );
            rest = next;
        }
        assert!(rest.is_empty());
    }
}
