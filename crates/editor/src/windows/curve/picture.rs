//! The picture in the curve window: what the parameters do to the curve around the current point.
//!
//! The points are projected onto the plane in which they spread most: there the curve is flattest.

use egui::{Pos2, Rect, Stroke, Vec2, pos2, vec2};
use glam::DVec3;
use vides_document::Document;
use vides_engine::path::{CameraPath, CurveParameters, SupportPoint, Tcb, curve};

use super::pending::{CurveSource, Pending};
use crate::theme::{self, Palette};

/// Segments on either side that a point's position shapes.
const SIDE: usize = 2;

/// Straight pieces of each segment.
const PIECES: usize = 24;

/// The neighbourhood of the current point as a separate path.
struct Around {
    path: CameraPath,
    current: usize,
    /// Each point's number in the whole path.
    numbers: Vec<usize>,
}

impl Around {
    fn of(document: &Document) -> Self {
        let path = document.path();
        let count = path.points.len();
        let current = document.selection().point;
        // One more point on each side, since it shapes the outermost segment.
        let reach = SIDE + 1;
        let whole = count <= 2 * reach + 1;
        let numbers: Vec<usize> = if whole {
            (0..count).collect()
        } else if path.closed {
            (0..=2 * reach)
                .map(|k| (current + count + k - reach) % count)
                .collect()
        } else {
            (current.saturating_sub(reach)..(current + reach + 1).min(count)).collect()
        };
        let points = numbers.iter().map(|&number| {
            let point = &path.points[number];
            // A spline depends on points further away.
            let outermost = number == numbers[0] || Some(&number) == numbers.last();
            let cut = path.curve.is_spline() && !whole && outermost;
            SupportPoint {
                curve: point.curve,
                tangents: match cut {
                    true => Some(curve::tangents(path, number)),
                    false => point.tangents,
                },
                ..SupportPoint::new(point.position)
            }
        });
        Self {
            current: numbers.iter().position(|&n| n == current).unwrap_or(0),
            path: CameraPath {
                points: points.collect(),
                presets: path.presets,
                curve: path.curve,
                closed: path.closed && whole,
                ..CameraPath::default()
            },
            numbers,
        }
    }

    /// With what is pending; parameters out of range, refused later, are drawn at the limit.
    fn with(&self, document: &Document, pending: &Pending) -> CameraPath {
        let limited = |tcb: Tcb| {
            let part = |value: f64| value.clamp(-1.0, 1.0);
            Tcb::new(part(tcb.tension), part(tcb.continuity), part(tcb.bias))
        };
        let mut path = self.path.clone();
        for (number, preset) in path.presets.iter_mut().enumerate() {
            *preset = limited(pending.preset(document, number));
        }
        let point = &mut path.points[self.current];
        point.position = pending.position(document).into();
        if pending.shapes() {
            point.tangents = None;
        }
        point.curve = match pending.choice(document) {
            CurveSource::Preset(preset) => CurveParameters::Preset(preset.min(9) as u8),
            CurveSource::Own => CurveParameters::Own(limited(pending.tcb(document))),
        };
        path
    }

    fn segments(&self) -> impl Iterator<Item = usize> + use<> {
        let (count, closed) = (self.path.segment_count(), self.path.closed);
        let current = self.current;
        (0..2 * SIDE)
            .filter_map(move |k| {
                if closed {
                    Some((current + 2 * count + k - SIDE) % count)
                } else {
                    (current + k).checked_sub(SIDE).filter(|&s| s < count)
                }
            })
            .take(count)
    }

    fn curve(&self, path: &CameraPath) -> Vec<Vec<DVec3>> {
        let along = |segment| {
            let cubic = curve::segment(path, segment);
            let at = |k: usize| cubic.point(k as f64 / PIECES as f64);
            (0..=PIECES).map(at).collect()
        };
        self.segments().map(along).collect()
    }
}

/// The curve around the current point as it will be, segment by segment.
pub(super) fn preview(document: &Document, pending: &Pending) -> Vec<Vec<DVec3>> {
    let around = Around::of(document);
    around.curve(&around.with(document, pending))
}

/// A projection into the picture.
#[derive(Debug)]
struct Flat {
    centre: DVec3,
    across: DVec3,
    up: DVec3,
    middle: Pos2,
    scale: f64,
}

impl Flat {
    fn new(points: &[DVec3], curves: [&[Vec<DVec3>]; 2], rect: Rect) -> Self {
        let count = points.len().max(1) as f64;
        let centre = points.iter().sum::<DVec3>() / count;
        let (across, up) = axes(points, centre);
        let mut flat = Self {
            centre,
            across,
            up,
            middle: rect.center(),
            scale: 1.0,
        };
        // Fits in all that is drawn, centred.
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let drawn = curves.into_iter().flatten().flatten();
        for [x, y] in drawn.chain(points).map(|&point| flat.plane(point)) {
            low = [low[0].min(x), low[1].min(y)];
            high = [high[0].max(x), high[1].max(y)];
        }
        let [wide, tall] = [high[0] - low[0], high[1] - low[1]];
        let [x, y] = [
            f64::midpoint(low[0], high[0]),
            f64::midpoint(low[1], high[1]),
        ];
        flat.centre += across * x + up * y;
        let fits = |room: f32, size: f64| f64::from(room) / size.max(1e-12);
        flat.scale = fits(rect.width(), wide).min(fits(rect.height(), tall));
        if !flat.scale.is_finite() {
            flat.scale = 0.0;
        }
        flat
    }

    fn plane(&self, point: DVec3) -> [f64; 2] {
        let way = point - self.centre;
        [way.dot(self.across), way.dot(self.up)]
    }

    fn at(&self, point: DVec3) -> Pos2 {
        let [x, y] = self.plane(point).map(|part| (part * self.scale) as f32);
        self.middle + vec2(x, -y)
    }
}

/// The directions of the widest spread: the first runs as the points do, the second up if it can.
fn axes(points: &[DVec3], centre: DVec3) -> (DVec3, DVec3) {
    let spread = |direction: DVec3| -> DVec3 {
        let share = points
            .iter()
            .map(|&p| (p - centre) * (p - centre).dot(direction));
        share.sum()
    };
    let run = match points {
        [first, .., last] => *last - *first,
        _ => DVec3::X,
    };
    // Power iteration: the longest axis grows fastest. Begun askew, against symmetry.
    let start = [run, DVec3::new(1.0, 0.61, 0.37)];
    let mut across = start
        .into_iter()
        .find_map(DVec3::try_normalize)
        .unwrap_or(DVec3::X);
    across = (across + DVec3::new(1e-3, 0.61e-3, 0.37e-3)).normalize();
    for _ in 0..60 {
        across = spread(across).try_normalize().unwrap_or(across);
    }
    if across.dot(run) < 0.0 {
        across = -across;
    }
    let flat = |v: DVec3| v - across * v.dot(across);
    let upright = [DVec3::Y, DVec3::Z, DVec3::X]
        .into_iter()
        .map(flat)
        .find(|v| v.length() > 0.3)
        .unwrap_or(DVec3::Y);
    let upright = upright.normalize();
    // Beside it, so that what lies flat is seen from above.
    let beside = upright.cross(across);
    let [mut high, mut both, mut wide] = [0.0; 3];
    for way in points.iter().map(|&point| point - centre) {
        let (x, y) = (way.dot(beside), way.dot(upright));
        high += y * y;
        both += x * y;
        wide += x * x;
    }
    // All on one line: any side will do.
    if high + wide <= 1e-18 * spread(across).length() {
        return (across, upright);
    }
    let (sin, cos) = ((2.0 * both).atan2(high - wide) / 2.0).sin_cos();
    let mut up = upright * cos + beside * sin;
    if cos < 0.2 && sin < 0.0 {
        up = -up;
    }
    (across, up)
}

pub(crate) fn paint(
    painter: &egui::Painter,
    rect: Rect,
    palette: &Palette,
    document: &Document,
    pending: &Pending,
) {
    let around = Around::of(document);
    let after = around.with(document, pending);
    let old = around.curve(&around.path);
    let new = around.curve(&after);
    let points: Vec<DVec3> = around.path.points.iter().map(|p| p.position).collect();
    let drawn: Vec<usize> = {
        let count = points.len();
        let mut seen: Vec<usize> = around
            .segments()
            .flat_map(|s| [s, (s + 1) % count])
            .collect();
        seen.sort_unstable();
        seen.dedup();
        seen
    };
    let shown: Vec<DVec3> = drawn.iter().map(|&k| points[k]).collect();
    let flat = Flat::new(&shown, [&old, &new], rect.shrink2(vec2(24.0, 20.0)));
    let mut lines = Vec::new();
    let mut line = |curve: &[Vec<DVec3>], stroke: Stroke| {
        for segment in curve {
            let line: Vec<Pos2> = segment.iter().map(|&point| flat.at(point)).collect();
            lines.extend_from_slice(&line);
            painter.line(line, stroke);
        }
    };
    line(&old, Stroke::new(1.5, palette.weak));
    if !pending.is_empty() {
        line(&new, Stroke::new(2.0, palette.accent));
    }
    for &k in &drawn {
        let at = flat.at(after.points[k].position);
        let current = k == around.current;
        let colour = if current {
            palette.accent
        } else {
            palette.text
        };
        let arm = if current { 5.0 } else { 3.5 };
        let stroke = Stroke::new(1.5, colour);
        painter.line_segment([at - vec2(arm, 0.0), at + vec2(arm, 0.0)], stroke);
        painter.line_segment([at - vec2(0.0, arm), at + vec2(0.0, arm)], stroke);
        let colour = if current {
            palette.accent
        } else {
            palette.weak
        };
        let number = (around.numbers[k] + 1).to_string();
        let galley = painter.layout_no_wrap(number, theme::small(), colour);
        let place = beside(at, galley.size(), &lines);
        painter.galley(place.min, galley, colour);
    }
}

/// A place of this size beside a point, at the upper right unless lines cross it less elsewhere.
fn beside(at: Pos2, size: Vec2, lines: &[Pos2]) -> Rect {
    let (right, left) = (at.x + 5.0, at.x - 5.0 - size.x);
    let (above, below) = (at.y - 3.0 - size.y, at.y + 3.0);
    let places = [(right, above), (left, above), (right, below), (left, below)]
        .map(|(x, y)| Rect::from_min_size(pos2(x, y), size));
    let crossed = |place: &Rect| lines.iter().filter(|&&on| place.contains(on)).count();
    places.into_iter().min_by_key(crossed).unwrap_or(places[0])
}

#[cfg(test)]
mod tests {
    use vides_engine::path::CurveKind;

    use super::*;
    use vides_document::{At, Edit, Info};
    use vides_engine::path::Tangents;

    fn document(count: usize, closed: bool) -> Document {
        let at = |k: usize| {
            let k = k as f64;
            SupportPoint::new(DVec3::new(k.cos(), 0.1 * k, (1.3 * k).sin()))
        };
        let path = CameraPath {
            points: (0..count).map(at).collect(),
            closed,
            ..CameraPath::default()
        };
        Document::from_parts(path, Info::default()).unwrap()
    }

    /// The neighbourhood gives the very segments of the whole path, of a spline to rounding,
    /// also where a point owns its tangents.
    #[test]
    fn the_neighbourhood_is_that_of_the_whole() {
        let paths = [
            (2, false),
            (3, true),
            (5, false),
            (7, true),
            (20, false),
            (20, true),
        ];
        let kinds = CurveKind::ALL;
        for ((count, closed), kind) in paths
            .into_iter()
            .zip([kinds; 6])
            .flat_map(|(path, kinds)| kinds.map(|kind| (path, kind)))
        {
            let mut document = document(count, closed);
            document.apply(Edit::set(At::Path, "curve", kind)).unwrap();
            let tangents = Some(Tangents {
                before: DVec3::X,
                after: DVec3::Y,
            });
            document
                .apply(Edit::set(At::Point(1), "tangents", tangents))
                .unwrap();
            for current in 0..count {
                document.select(current, 0).unwrap();
                let around = Around::of(&document);
                assert_eq!(around.numbers[around.current], current);
                let segments: Vec<usize> = around.segments().collect();
                assert!(!segments.is_empty());
                for segment in segments {
                    let whole = curve::segment(document.path(), around.numbers[segment]);
                    let found = curve::segment(&around.path, segment);
                    if kind == CurveKind::Cubic {
                        let away = |t: f64| found.point(t).distance(whole.point(t));
                        assert!([0.2, 0.5, 0.8].map(away).into_iter().all(|far| far < 1e-12));
                    } else {
                        assert_eq!(found, whole);
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_pending_gives_the_curve_that_applying_gives() {
        let mut document = document(9, false);
        document.select(4, 0).unwrap();
        let mut pending = Pending::default();
        pending.choose(&document, CurveSource::Preset(3));
        pending.set_tcb(&document, Tcb::new(0.5, -0.25, 1.0));
        pending.position[1] = Some(0.75);
        let around = Around::of(&document);
        let shown = around.curve(&around.with(&document, &pending));
        for edit in pending.edits(&document) {
            document.apply(edit).unwrap();
        }
        let around = Around::of(&document);
        assert_eq!(around.curve(&around.path), shown);
        document
            .apply(Edit::set(At::Point(4), "preset", 0))
            .unwrap();
        let around = Around::of(&document);
        assert_ne!(around.curve(&around.path), shown);
    }

    #[test]
    fn points_in_a_plane_are_seen_at_their_distances() {
        let (a, b) = (DVec3::new(2.0, 0.0, 1.0).normalize(), DVec3::Y);
        let points: Vec<DVec3> = [(0.0, 0.0), (3.0, 0.5), (5.0, -1.0), (9.0, 0.2)]
            .map(|(x, y)| a * x + b * y)
            .into();
        let rect = Rect::from_min_size(Pos2::ZERO, vec2(200.0, 100.0));
        let flat = Flat::new(&points, [&[], &[]], rect);
        for p in &points {
            assert!(rect.expand(0.01).contains(flat.at(*p)));
            for q in &points {
                let seen = f64::from((flat.at(*p) - flat.at(*q)).length());
                assert!((seen - flat.scale * (*p - *q).length()).abs() < 1e-3);
            }
        }
        // In order from left to right, up is up.
        assert!(flat.at(points[0]).x < flat.at(points[3]).x);
        assert!(flat.at(points[1]).y < flat.at(points[2]).y);
    }

    /// At one height, as many flights are, they are seen from above.
    #[test]
    fn a_level_curve_is_seen_from_above() {
        let around = [
            (-0.6, 0.8),
            (0.0, 0.85),
            (0.75, 0.6),
            (0.7, -0.55),
            (0.0, -0.8),
        ];
        for tilt in [0.0, 1e-3, -1e-3] {
            let points = around.map(|(x, z)| DVec3::new(x, 0.2 + tilt * x, z));
            let rect = Rect::from_min_size(Pos2::ZERO, vec2(200.0, 100.0));
            let flat = Flat::new(&points, [&[], &[]], rect);
            assert!(flat.across.cross(flat.up).y > 0.9, "{flat:?}");
            for p in &points {
                for q in &points {
                    let seen = f64::from((flat.at(*p) - flat.at(*q)).length());
                    assert!((seen - flat.scale * (*p - *q).length()).abs() < 0.01);
                }
            }
        }
    }

    #[test]
    fn a_number_stands_where_the_curve_does_not_run() {
        let (at, size) = (pos2(50.0, 50.0), vec2(7.0, 11.0));
        let rising = |k: i16| pos2(50.0 + f32::from(k), 50.0 - f32::from(k));
        let falling = |k: i16| pos2(50.0 + f32::from(k), 50.0 + f32::from(k));
        let free = |lines: &[Pos2]| {
            let place = beside(at, size, lines);
            assert!(!place.contains(at) && place.distance_to_pos(at) < 8.0);
            assert!(!lines.iter().any(|&on| place.contains(on)));
            (place.center() - at).angle().to_degrees()
        };
        let upper_right = free(&[]);
        assert!((-90.0..0.0).contains(&upper_right));
        assert_eq!(free(&(0..30).map(falling).collect::<Vec<_>>()), upper_right);
        let upper_left = free(&(0..30).map(rising).collect::<Vec<_>>());
        assert!((-180.0..-90.0).contains(&upper_left));
        let below = free(
            &(-30..0)
                .map(falling)
                .chain((0..30).map(rising))
                .collect::<Vec<_>>(),
        );
        assert!((0.0..90.0).contains(&below));
    }

    #[test]
    fn points_in_one_place_or_line_do_no_harm() {
        let rect = Rect::from_min_size(Pos2::ZERO, vec2(200.0, 100.0));
        for points in [
            vec![DVec3::ONE; 3],
            vec![DVec3::ZERO, DVec3::Y],
            vec![DVec3::X * 1e9, DVec3::ZERO],
        ] {
            let flat = Flat::new(&points, [&[], &[]], rect);
            for point in points {
                let at = flat.at(point);
                assert!(at.x.is_finite() && at.y.is_finite());
            }
        }
    }
}
