//! Three views of the way, the view directions on a sphere, and the findings.

use crate::glam::DVec3;
use crate::path::Pose;
use crate::tools::check::Finding;

use super::svg::{Anchor, Spot, Svg, cut};
use super::{Film, MARGIN};

/// Title, and the axes (in upright coordinates) to the right and up.
const VIEWS: [(&str, DVec3, DVec3); 3] = [
    ("From the front", DVec3::X, DVec3::Y),
    ("From the right", DVec3::NEG_Z, DVec3::Y),
    ("From above", DVec3::X, DVec3::NEG_Z),
];

/// Limit on the objects' lines.
const EDGES: usize = 6_000;

const TICKS: usize = 40;

fn name(svg: &mut Svg, film: &Film<'_>, (x, y): Spot, text: &str) {
    let bold = format!("fill=\"{}\" font-weight=\"bold\"", film.style.ink);
    svg.text((x, y - 8.0), Anchor::Start, text, &bold);
}

fn is_wrong(film: &Film<'_>, frame: f64) -> bool {
    let at = |finding: &Finding| finding.first_frame <= frame && frame <= finding.last_frame;
    film.found.iter().any(at)
}

/// Draws the way as runs of spots, in another colour where something was found.
fn way(svg: &mut Svg, film: &Film<'_>, colour: &str, width: f64, spot: &dyn Fn(&Pose) -> Spot) {
    let mut run: Vec<Spot> = Vec::new();
    let mut wrong = false;
    let mut draw = |run: &[Spot], wrong: bool| {
        if run.len() > 1 {
            let colour = if wrong { film.style.wrong } else { colour };
            svg.polyline(
                run,
                &format!("stroke=\"{colour}\" stroke-width=\"{width}\""),
            );
        }
    };
    for (frame, pose) in &film.samples {
        let here = is_wrong(film, *frame);
        let place = spot(pose);
        if here != wrong {
            draw(&run, wrong);
            run.drain(..run.len().saturating_sub(1));
            wrong = here;
        }
        run.push(place);
    }
    draw(&run, wrong);
}

/// Lines of the obstacles, thinned to [`EDGES`].
fn edges(film: &Film<'_>) -> Vec<[DVec3; 2]> {
    let Some(mesh) = &film.obstacles else {
        return Vec::new();
    };
    let place = |ends: [u32; 2]| ends.map(|at| mesh.points[at as usize]);
    let corners = mesh.triangles.iter();
    let sides = corners.flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let lines = mesh.lines.iter().copied();
    let every = (mesh.lines.len() + 3 * mesh.triangles.len()).div_ceil(EDGES);
    let some = lines.chain(sides).step_by(every.max(1));
    some.map(place).collect()
}

pub(super) fn draw(svg: &mut Svg, film: &Film<'_>, top: f64, side: f64) {
    let path = film.document.path();
    let space = path.space;
    let relative = |place: DVec3| space.up.upright(place - space.centre) / space.half_size;
    let places = film
        .samples
        .iter()
        .map(|(_, pose)| relative(pose.vrp.into()));
    let far = places.map(|p| p.abs().max_element()).fold(1.05, f64::max);
    let scale = 0.5 * side / far;
    for (k, (title, right, up)) in VIEWS.into_iter().enumerate() {
        let left = MARGIN + k as f64 * (side + MARGIN);
        let centre = (left + side / 2.0, top + side / 2.0 + 12.0);
        let spot = |place: DVec3| {
            let p = relative(place);
            (
                centre.0 + scale * p.dot(right),
                centre.1 - scale * p.dot(up),
            )
        };
        name(svg, film, (left, top), title);
        svg.group(&format!("view-{k}"), "", |svg| {
            let hair = format!("stroke=\"{}\"", film.style.hair);
            let corner = (centre.0 - scale, centre.1 - scale);
            svg.rectangle(corner, 2.0 * scale, 2.0 * scale, &hair);
            let line = format!("stroke=\"{}\"", film.style.object);
            for [from, to] in edges(film) {
                svg.line(spot(from), spot(to), &line);
            }
            // View directions of some poses.
            let look = format!(
                "stroke=\"{}\" stroke-width=\"1\" opacity=\"0.7\"",
                film.style.view
            );
            let step = film.samples.len().div_ceil(24);
            for (_, pose) in film.samples.iter().step_by(step) {
                let eye = DVec3::from_array(pose.vrp);
                let there = eye + 0.16 * space.half_size * DVec3::from_array(pose.vpn);
                svg.line(spot(eye), spot(there), &look);
            }
            way(svg, film, film.style.way, 2.0, &|pose| {
                spot(pose.vrp.into())
            });
            let fill = format!("fill=\"{}\"", film.style.way);
            for point in &path.points {
                svg.circle(spot(point.position), 2.8, &fill);
            }
        });
    }
}

/// The view directions as a curve on the unit sphere, seen from slightly above; the back is faint.
pub(super) fn sphere(svg: &mut Svg, film: &Film<'_>, (x, y): Spot, side: f64) {
    let up = film.document.path().space.up;
    name(svg, film, (x, y), "Views on the sphere, ticks: up");
    let centre = (x + side / 2.0, y + side / 2.0 + 12.0);
    let radius = 0.46 * side;
    let (right, out) = (
        DVec3::new(0.8, 0.0, -0.6),
        DVec3::new(0.6, 0.5, 0.8).normalize(),
    );
    let above = out.cross(right);
    let right = above.cross(out);
    let project = |v: DVec3| {
        let spot = (
            centre.0 + radius * v.dot(right),
            centre.1 - radius * v.dot(above),
        );
        (spot, v.dot(out) >= 0.0)
    };
    let vector = |v: [f64; 3]| up.upright(v.into());
    svg.group("sphere", "", |svg| {
        let hair = format!("stroke=\"{}\"", film.style.hair);
        svg.circle(centre, radius, &hair);
        // The horizon and two meridians.
        for (a, b) in [
            (DVec3::X, DVec3::Z),
            (DVec3::X, DVec3::Y),
            (DVec3::Z, DVec3::Y),
        ] {
            let ring = |k: i32| {
                let (sin, cos) = (f64::from(k).to_radians() * 5.0).sin_cos();
                project(cos * a + sin * b)
            };
            for k in 0..72 {
                let ((from, front), (to, _)) = (ring(k), ring(k + 1));
                let faint = if front { 1.0 } else { 0.35 };
                svg.line(from, to, &format!("{hair} opacity=\"{faint}\""));
            }
        }
        for (axis, label) in [(DVec3::X, "x"), (DVec3::Y, "up"), (DVec3::Z, "z")] {
            let (spot, _) = project(1.1 * axis);
            let quiet = format!("fill=\"{}\"", film.style.quiet);
            svg.text((spot.0, spot.1 + 4.0), Anchor::Middle, label, &quiet);
        }
        for front in [false, true] {
            let opacity = if front { "" } else { " opacity=\"0.35\"" };
            for pair in film.samples.windows(2) {
                let [a, b] = [&pair[0], &pair[1]].map(|(_, pose)| project(vector(pose.vpn)));
                if a.1 != front {
                    continue;
                }
                let wrong = is_wrong(film, pair[0].0);
                let colour = if wrong {
                    film.style.wrong
                } else {
                    film.style.view
                };
                let stroke = format!("stroke=\"{colour}\" stroke-width=\"2\"{opacity}");
                svg.line(a.0, b.0, &stroke);
            }
        }
        let step = film.samples.len().div_ceil(TICKS);
        let tick = format!("stroke=\"{}\" stroke-width=\"1.2\"", film.style.way);
        for (_, pose) in film.samples.iter().step_by(step) {
            let (view, up) = (vector(pose.vpn), vector(pose.vup));
            let (from, front) = project(view);
            let (to, _) = project(view + 0.13 * up);
            let opacity = if front { 1.0 } else { 0.35 };
            svg.line(from, to, &format!("{tick} opacity=\"{opacity}\""));
        }
        if let Some((_, first)) = film.samples.first() {
            let (spot, _) = project(vector(first.vpn));
            svg.circle(spot, 3.5, &format!("fill=\"{}\"", film.style.view));
        }
    });
}

/// A list of the findings, as far as there is room.
pub(super) fn findings(svg: &mut Svg, film: &Film<'_>, (x, y): Spot, width: f64) {
    name(svg, film, (x, y), "Findings");
    const LINE: f64 = 19.0;
    const LINES: usize = 13;
    let quiet = format!("fill=\"{}\"", film.style.quiet);
    svg.group("findings", "", |svg| {
        let mut at = y + 14.0;
        let mut line = |text: &str, colour: &str| {
            svg.text((x, at), Anchor::Start, &cut(text, width), colour);
            at += LINE;
        };
        if film.found.is_empty() {
            line("none", &quiet);
        }
        let wrong = format!("fill=\"{}\"", film.style.wrong);
        for finding in film.found.iter().take(LINES) {
            let (first, last) = (finding.first_frame, finding.last_frame);
            line(&format!("{first:.0}–{last:.0}  {finding}"), &wrong);
        }
        if film.found.len() > LINES {
            line(&format!("… and {} more", film.found.len() - LINES), &quiet);
        }
        for note in &film.notes {
            line(&note.to_string(), &quiet);
        }
    });
}
