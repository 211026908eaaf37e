//! The window icon: three points, a curve through them and a camera's view, drawn here so that no
//! file is needed.

/// The sizes window managers commonly use.
const SIZES: [u32; 4] = [16, 32, 48, 64];

/// Colours as red, green, blue.
const GROUND: [f32; 3] = [30.0, 37.0, 51.0];
const CURVE: [f32; 3] = [96.0, 190.0, 255.0];
const VIEW: [f32; 3] = [255.0, 184.0, 76.0];
const POINT: [f32; 3] = [255.0, 255.0, 255.0];

/// A cubic Bézier curve in the unit square, y down.
const PATH: [[f32; 2]; 4] = [[0.14, 0.76], [0.30, 0.05], [0.62, 1.02], [0.84, 0.24]];

/// The data of `_NET_WM_ICON`: width, height and ARGB rows for each size.
pub(super) fn icon() -> Vec<u32> {
    let mut data = Vec::new();
    let parts = Parts::new();
    for size in SIZES {
        data.extend([size, size]);
        for y in 0..size {
            for x in 0..size {
                let place = [x, y].map(|i| (i as f32 + 0.5) / size as f32);
                data.push(parts.pixel(place, size as f32));
            }
        }
    }
    data
}

const CURVE_RADIUS: f32 = 0.035;

struct Parts {
    /// The curve as line segments, from left to right.
    curve: [[f32; 2]; PIECES + 1],
    /// The triangle that a camera at the second point sees: outward normals and distances from the
    /// origin.
    view: [([f32; 2], f32); 3],
    points: [[f32; 2]; 3],
}

const PIECES: usize = 24;

impl Parts {
    fn new() -> Self {
        let points = [0.0, 0.5, 1.0].map(on_path);
        let view = [points[1], [0.74, 0.93], [0.95, 0.66]];
        Self {
            curve: std::array::from_fn(|i| on_path(i as f32 / PIECES as f32)),
            view: std::array::from_fn(|i| side(view[i], view[(i + 1) % 3])),
            points,
        }
    }

    fn pixel(&self, place: [f32; 2], size: f32) -> u32 {
        let cover = |distance: f32| (0.5 - distance * size).clamp(0.0, 1.0);
        let mut colour = GROUND;
        let mut paint = |paint: [f32; 3], share: f32| {
            for (colour, paint) in colour.iter_mut().zip(paint) {
                *colour += (paint - *colour) * share;
            }
        };
        // A square with rounded corners.
        let corner = place.map(|c| ((c - 0.5).abs() - 0.28).max(0.0));
        let ground = cover(length(corner) - 0.22);
        let outside = self.view.map(|(way, at)| dot(way, place) - at);
        paint(
            VIEW,
            cover(outside.into_iter().fold(f32::MIN, f32::max)) * 0.85,
        );
        // Drawing the icon delays every opening, so only nearby segments are measured.
        let near = CURVE_RADIUS + 1.0 / size;
        let first = self.curve[1..].partition_point(|end| end[0] + near < place[0]);
        let pieces = self.curve[first..].windows(2);
        let far = pieces
            .take_while(|ends| ends[0][0] - near <= place[0])
            .map(|ends| square_distance(place, ends[0], ends[1]))
            .fold(f32::MAX, f32::min);
        paint(CURVE, cover(far.sqrt() - CURVE_RADIUS));
        for at in self.points {
            let way = [place[0] - at[0], place[1] - at[1]];
            paint(POINT, cover(length(way) - 0.075));
        }
        let [red, green, blue] = colour.map(|value| (value + 0.5) as u32);
        ((ground * 255.0 + 0.5) as u32) << 24 | red << 16 | green << 8 | blue
    }
}

fn on_path(t: f32) -> [f32; 2] {
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    std::array::from_fn(|axis| (0..4).map(|i| weights[i] * PATH[i][axis]).sum())
}

fn length(way: [f32; 2]) -> f32 {
    dot(way, way).sqrt()
}

fn square_distance(p: [f32; 2], a: [f32; 2], b: [f32; 2]) -> f32 {
    let (along, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let t = (dot(along, from) / dot(along, along)).clamp(0.0, 1.0);
    let way = [from[0] - t * along[0], from[1] - t * along[1]];
    dot(way, way)
}

fn dot(a: [f32; 2], b: [f32; 2]) -> f32 {
    a[0] * b[0] + a[1] * b[1]
}

/// The outward normal of the line through `a` and `b`, and the line's distance along it.
fn side(a: [f32; 2], b: [f32; 2]) -> ([f32; 2], f32) {
    let along = [b[0] - a[0], b[1] - a[1]];
    let way = [-along[1], along[0]].map(|part| part / length(along));
    (way, dot(way, a))
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
