//! The path in its space: a parallel projection with y upright, as the
//! editor's movement window shows it.

use glam::{DVec2, DVec3, dvec2, dvec3};
use vides::document::Document;
use vides::path::{Pose, Sampler, Timeline};

use crate::Problem;
use crate::style::{INK, OBJECT, VIEW, WAY};
use crate::svg::{Anchor, Spot, Svg, cut, width};

/// Turned about the y axis, and seen from above, in degrees.
const TURN: f64 = 13.0;
const TILT: f64 = 27.0;

/// Depth of a camera's picture before it, as a share of the cube's edge.
const CAMERA: f64 = 0.065;

/// Half the picture's width by half its height: 36 to 24 mm.
const ASPECT: f64 = 1.5;

/// Cameras beside those at the keys: one each so many pixels of the way.
const SPACING: f64 = 62.0;

/// From space to pixels.
struct Projection {
    right: DVec3,
    up: DVec3,
    towards_us: DVec3,
    scale: f64,
    offset: DVec2,
}

impl Projection {
    /// Such that all of `points` fill the rectangle.
    fn new(points: &[DVec3], (x, y): Spot, width: f64, height: f64) -> Self {
        let (turn, tilt) = (TURN.to_radians(), TILT.to_radians());
        let towards_us = dvec3(turn.sin() * tilt.cos(), tilt.sin(), turn.cos() * tilt.cos());
        let right = dvec3(turn.cos(), 0.0, -turn.sin());
        let mut projection = Self {
            right,
            up: towards_us.cross(right),
            towards_us,
            scale: 1.0,
            offset: DVec2::ZERO,
        };
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for &point in points {
            let spot = projection.flat(point);
            (low, high) = (low.min(spot), high.max(spot));
        }
        let extent = (high - low).max(DVec2::splat(f64::MIN_POSITIVE));
        projection.scale = (width / extent.x).min(height / extent.y);
        projection.offset =
            dvec2(x + width / 2.0, y + height / 2.0) - projection.scale * (low + high) / 2.0;
        projection
    }

    fn flat(&self, point: DVec3) -> DVec2 {
        dvec2(self.right.dot(point), -self.up.dot(point))
    }

    fn spot(&self, point: DVec3) -> Spot {
        (self.scale * self.flat(point) + self.offset).into()
    }
}

/// Draws cube, object, curve, cameras and support points into a rectangle.
pub(crate) fn draw(
    svg: &mut Svg,
    document: &Document,
    corner: Spot,
    width: f64,
    height: f64,
) -> Result<(), Problem> {
    let curves = document.timeline(bezier_points)?;
    let corners = cube();
    let mut all: Vec<DVec3> = corners.to_vec();
    all.extend(curves.iter().flatten());
    all.extend(document.info().object.iter().map(|point| point.position));
    let projection = Projection::new(&all, corner, width, height);

    cube_edges(svg, &projection, &corners);
    object(svg, &projection, document);
    shadow(svg, &projection, &curves);
    let cameras = cameras(document, &projection)?;
    svg.group(
        "curve",
        &format!("stroke=\"{WAY}\" stroke-width=\"2.2\""),
        |svg| {
            let flat: Vec<_> = curves
                .iter()
                .map(|curve| curve.map(|point| projection.spot(point)))
                .collect();
            svg.curves(&flat, "");
        },
    );
    svg.group("cameras", &format!("stroke=\"{VIEW}\""), |svg| {
        for (pose, is_key) in &cameras {
            camera(svg, &projection, pose, *is_key);
        }
    });
    points(svg, &projection, document, (corner.0, corner.0 + width));
    Ok(())
}

/// Each segment as a Bézier curve: a parallel projection keeps it one, so the
/// picture shows the curve itself and not a polygon.
fn bezier_points(timeline: &Timeline) -> Vec<[DVec3; 4]> {
    (0..timeline.segment_count())
        .map(|segment| {
            let curve = timeline.curve(segment);
            let (start, end) = (curve.point(0.0), curve.point(1.0));
            let (leaves, arrives) = (curve.derivative(0.0), curve.derivative(1.0));
            [start, start + leaves / 3.0, end - arrives / 3.0, end]
        })
        .collect()
}

/// The movement space's corners: bit 0 of the index is x, bit 1 y, bit 2 z.
fn cube() -> [DVec3; 8] {
    std::array::from_fn(|index| {
        let side = |bit: usize| if index >> bit & 1 == 1 { 1.0 } else { -1.0 };
        dvec3(side(0), side(1), side(2))
    })
}

/// The edges that meet in the farthest corner are hidden: dashed.
fn cube_edges(svg: &mut Svg, projection: &Projection, corners: &[DVec3; 8]) {
    let depth = |index: &usize| projection.towards_us.dot(corners[*index]);
    let farthest = (0..8).min_by(|a, b| depth(a).total_cmp(&depth(b)));
    svg.group("cube", "stroke=\"#a9b2bd\" stroke-width=\"1\"", |svg| {
        for from in 0..8 {
            for bit in 0..3 {
                let to = from | 1 << bit;
                if to == from {
                    continue;
                }
                let hidden = Some(from) == farthest || Some(to) == farthest;
                let dashes = if hidden {
                    "stroke-dasharray=\"4 5\""
                } else {
                    ""
                };
                svg.line(
                    projection.spot(corners[from]),
                    projection.spot(corners[to]),
                    dashes,
                );
            }
        }
    });
}

fn object(svg: &mut Svg, projection: &Projection, document: &Document) {
    svg.group(
        "object",
        &format!("stroke=\"{OBJECT}\" stroke-width=\"1.6\""),
        |svg| {
            for pair in document.info().object.windows(2) {
                if pair[1].draw {
                    svg.line(
                        projection.spot(pair[0].position),
                        projection.spot(pair[1].position),
                        "",
                    );
                }
            }
        },
    );
}

/// The curve's shadow on the floor of the cube, which tells how deep in space
/// a piece of it lies.
fn shadow(svg: &mut Svg, projection: &Projection, curves: &[[DVec3; 4]]) {
    let flat: Vec<_> = curves
        .iter()
        .map(|curve| curve.map(|point| projection.spot(dvec3(point.x, -1.0, point.z))))
        .collect();
    svg.group("shadow", "stroke=\"#dfe4ea\" stroke-width=\"3\"", |svg| {
        svg.curves(&flat, "");
    });
}

/// Cameras along the way: all keys (true), and some between (false).
fn cameras(document: &Document, projection: &Projection) -> Result<Vec<(Pose, bool)>, Problem> {
    let sampler: &Sampler = document.sampler()?;
    let count = document.timeline(Timeline::section_count)?;
    let mut found = Vec::new();
    let mut keys = Vec::new();
    for section in 0..count {
        let (first, frames) = document.timeline(|timeline| {
            (
                sampler.first_frame(section),
                timeline.section(section).frames,
            )
        })?;
        if frames == 0 {
            continue;
        }
        let (start, end) = (first - 1, first + frames - 1);
        if keys.is_empty() {
            keys.push(sampler.pose(start as f64)?);
        }
        keys.push(sampler.pose(end as f64)?);
        // Between its ends, at equal distances in the picture.
        let spots = |frame: usize| -> Result<DVec2, Problem> {
            let pose = sampler.pose(frame as f64)?;
            Ok(projection.scale * projection.flat(DVec3::from_array(pose.vrp)))
        };
        let steps = frames.min(400);
        let frame_at = |step: usize| start + frames * step / steps;
        let mut ways = vec![0.0];
        for step in 1..=steps {
            let more = (spots(frame_at(step))? - spots(frame_at(step - 1))?).length();
            ways.push(ways[step - 1] + more);
        }
        let pieces = (ways[steps] / SPACING).round() as usize;
        for piece in 1..pieces {
            let way = ways[steps] * piece as f64 / pieces as f64;
            let step = ways.partition_point(|&reached| reached < way);
            found.push((sampler.pose(frame_at(step) as f64)?, false));
        }
    }
    if keys.is_empty() {
        keys.push(sampler.pose(1.0)?);
    }
    found.extend(keys.into_iter().map(|pose| (pose, true)));
    Ok(found)
}

/// A small pyramid from the camera to its picture, with a roof that shows up.
fn camera(svg: &mut Svg, projection: &Projection, pose: &Pose, is_key: bool) {
    let at = DVec3::from_array(pose.vrp);
    let (ahead, up) = (DVec3::from_array(pose.vpn), DVec3::from_array(pose.vup));
    let right = ahead.cross(up);
    // As deep as it may be without growing out of proportion at wide angles.
    let half = (12.0 / pose.zoom).min(1.0);
    let depth = 2.0 * CAMERA;
    let (x, y) = (right * depth * half * ASPECT, up * depth * half);
    let centre = at + ahead * depth;
    let corners = [
        centre - x - y,
        centre + x - y,
        centre + x + y,
        centre - x + y,
    ];
    let spots = corners.map(|corner| projection.spot(corner));
    let (opacity, fill) = if is_key { (1.0, 0.16) } else { (0.55, 0.05) };
    let stroke = format!("stroke-width=\"1\" stroke-opacity=\"{opacity}\"");
    let start = projection.spot(at);
    for spot in spots {
        svg.line(start, spot, &stroke);
    }
    svg.polygon(
        &spots,
        &format!("{stroke} fill=\"{VIEW}\" fill-opacity=\"{fill}\""),
    );
    let roof = [
        corners[3] + 0.25 * x + 0.12 * y,
        corners[2] - 0.25 * x + 0.12 * y,
        centre + 1.55 * y,
    ];
    svg.polygon(
        &roof.map(|corner| projection.spot(corner)),
        &format!("stroke=\"none\" fill=\"{VIEW}\" fill-opacity=\"{opacity}\""),
    );
}

/// Crosses, numbers and names, outside of the curve.
fn points(svg: &mut Svg, projection: &Projection, document: &Document, sides: Spot) {
    let points = &document.path().points;
    let spots: Vec<Spot> = points
        .iter()
        .map(|point| projection.spot(point.position))
        .collect();
    let middle = spots
        .iter()
        .fold(DVec2::ZERO, |sum, &spot| sum + DVec2::from(spot))
        / spots.len() as f64;
    svg.group("points", "", |svg| {
        for (index, (point, &(x, y))) in points.iter().zip(&spots).enumerate() {
            let arm = 5.0;
            let cross = format!("stroke=\"{INK}\" stroke-width=\"1.8\"");
            svg.line((x - arm, y - arm), (x + arm, y + arm), &cross);
            svg.line((x - arm, y + arm), (x + arm, y - arm), &cross);
            // Away from the middle, where the path's inside and its views are.
            let away = (DVec2::from((x, y)) - middle).normalize_or(DVec2::Y);
            let label = match &point.name {
                Some(name) => format!("{} {name}", index + 1),
                None => (index + 1).to_string(),
            };
            let label = cut(&label, 150.0);
            // Beside the cross, on the other side where there is no room on this.
            let (left, right) = (x - sides.0, sides.1 - x);
            let room = width(&label) + 10.0;
            let anchor = match away.x {
                away if away > 0.3 && room <= right => Anchor::Start,
                away if away < -0.3 && room <= left => Anchor::End,
                away if away.abs() <= 0.3 && room / 2.0 <= left.min(right) => Anchor::Middle,
                _ if left > right => Anchor::End,
                _ => Anchor::Start,
            };
            let below = if away.y > 0.0 { 22.0 } else { -14.0 };
            let place = match anchor {
                Anchor::Start => (x + 10.0 * away.x.abs(), y + below),
                Anchor::Middle => (x + 10.0 * away.x, y + below),
                Anchor::End => (x - 10.0 * away.x.abs(), y + below),
            };
            // A white rim keeps it readable on lines.
            svg.text(
                place,
                anchor,
                &label,
                "stroke=\"#ffffff\" stroke-width=\"4\" fill=\"#ffffff\"",
            );
            svg.text(place, anchor, &label, &format!("fill=\"{INK}\""));
        }
    });
}
