//! By the zoom: the greatest smooth one that shows all of the object, then few keys below it.

use super::below::Course;
use super::film::Film;
use super::{Framed, SPARE, Work};
use crate::error::{Error, Invalid, Result, vec_with_room};
use crate::limits::{MAX_RATE, MAX_ZOOM, MIN_ZOOM};
use crate::math::monotone_cubic::{cubic, value};
use crate::path::insertion::on_curve;
use crate::path::{CameraPath, Change, Timeline, ZoomMode};
use crate::tools::check::FindingKind;

/// How far the zoom of the keys may first be above the one that is wanted, and how far below.
const OFF_BY: [f64; 2] = [0.02, 0.06];

/// Frames between two keys at least.
const APART: f64 = 3.0;

/// In this time the zoom turns from a level to its greatest speed, in seconds.
const SWING: f64 = 0.2;

/// The zoom's speed where no limit says one, in shares of the greatest a second.
const FREE_RATE: f64 = 1.0;

/// Rounds in which the zoom is asked to be slower, as keys make it faster than what they stand for.
const ROUNDS: usize = 8;

/// Steps by which the two ends of a section must differ that has frames since the zoom changes.
const STEP: f64 = 1e-7;

#[derive(Debug, Clone, Copy)]
struct Knot {
    spot: usize,
    zoom: f64,
    /// For a unit of curve time.
    slope: f64,
}

impl Work<'_> {
    pub(super) fn by_zoom(&mut self, path: &CameraPath, film: &Film) -> Result<Framed> {
        let mut bound: Vec<f64> = vec_with_room(film.spots.len())?;
        for spot in &film.spots {
            let most = self.zoom_for(&spot.camera);
            let most = most.ok_or(Invalid::PictureBehind { frame: spot.frame })?;
            if most < MIN_ZOOM {
                return Err(Invalid::PictureZoom {
                    frame: spot.frame,
                    zoom: most,
                }
                .into());
            }
            bound.push(((1.0 - SPARE) * most).clamp(MIN_ZOOM, MAX_ZOOM));
        }
        let limit = self.request.limits.get(FindingKind::Zoom);
        let mut asked = limit;
        let mut last = None;
        for round in 0..ROUNDS {
            self.watch.at(round, ROUNDS)?;
            if round + 1 == ROUNDS {
                asked = 0.0;
            }
            let found = self.zoomed(path, film, &bound, asked)?;
            let fast = found.1;
            last = Some(found.0);
            if fast <= limit * (1.0 + 1e-9) {
                break;
            }
            asked *= 0.98 * limit / fast;
        }
        last.ok_or(Error::Memory)
    }

    /// A path with a zoom that is wanted to change no faster than `rate`, and how fast it does.
    fn zoomed(
        &mut self,
        path: &CameraPath,
        film: &Film,
        bound: &[f64],
        rate: f64,
    ) -> Result<(Framed, f64)> {
        let wanted = wanted(film, bound, rate)?;
        let knots = knots(film, &wanted, path.zoom_mode)?;
        let (mut made, added) = divided(path, film, &knots)?;
        set_zooms(&mut made, film, &knots, 1.0)?;
        let now = Film::new(&made, self.request.fps)?;
        let (tightest, _) = self.shares(&now);
        // Zoom is linear in that of the keys and in their slopes.
        let most = made.points.iter().flat_map(|point| &point.orientations);
        let most = most.map(|one| one.zoom).fold(0.0, f64::max);
        let scale = ((1.0 - SPARE) / tightest).min(MAX_ZOOM / most);
        let mut now = now;
        let mut shares = self.shares(&now);
        if (scale - 1.0).abs() > 0.1 * SPARE {
            set_zooms(&mut made, film, &knots, scale)?;
            now = Film::new(&made, self.request.fps)?;
            shares = self.shares(&now);
        }
        if shares.0 > 1.0 {
            let (_, frame) = self.worst(&now);
            return Err(Invalid::PictureKeys { frame }.into());
        }
        made.check()?;
        let framed = Framed {
            path: made,
            added,
            tightest: shares.0,
            loosest: shares.1,
        };
        Ok((framed, fastest(&now)))
    }
}

/// The greatest zoom below the bound that is smooth.
fn wanted(film: &Film, bound: &[f64], rate: f64) -> Result<Vec<f64>> {
    let least = bound.iter().copied().fold(f64::INFINITY, f64::min);
    let last = film.spots[film.spots.len() - 1];
    if rate == 0.0 || last.tau <= 0.0 {
        let mut level = vec_with_room(bound.len())?;
        level.resize(bound.len(), least);
        return Ok(level);
    }
    let mut at = vec_with_room(bound.len())?;
    at.extend(film.spots.iter().map(|spot| spot.tau));
    let mut time = vec_with_room(bound.len())?;
    time.extend(film.spots.iter().map(|spot| spot.time));
    let most = bound.iter().copied().fold(0.0, f64::max);
    let turned = rate.min(FREE_RATE * most) / SWING;
    let pace = last.time / last.tau;
    let course = Course {
        at: &at,
        time: &time,
        closed: film.closed,
    };
    course.below(bound, rate, turned * pace * pace)
}

/// How fast the zoom changes at most, in mm a second.
fn fastest(film: &Film) -> f64 {
    let steps = film.spots.windows(2);
    let speeds = steps.filter(|pair| pair[1].time > pair[0].time);
    speeds
        .map(|pair| (pair[1].zoom - pair[0].zoom).abs() / (pair[1].time - pair[0].time))
        .fold(0.0, f64::max)
}

/// Few keys whose zoom is nowhere above the wanted one by more than rounding, and nowhere far below.
fn knots(film: &Film, wanted: &[f64], mode: ZoomMode) -> Result<Vec<Knot>> {
    let mut knots: Vec<Knot> = vec_with_room(film.pieces.len() + 1)?;
    let ends = film.pieces.iter().map(|piece| piece.from);
    for spot in ends.chain([film.spots.len() - 1]) {
        knots.push(knot(film, wanted, spot));
    }
    join_ends(film, &mut knots);
    loop {
        let mut more: Vec<Knot> = Vec::new();
        for pair in knots.windows(2) {
            let piece = film.piece_of(pair[0].spot);
            if !film.pieces[piece].divides {
                continue;
            }
            let Some(spot) = worst(film, wanted, pair, mode) else {
                continue;
            };
            more.try_reserve(1)?;
            more.push(knot(film, wanted, spot));
        }
        if more.is_empty() {
            break;
        }
        knots.try_reserve(more.len())?;
        knots.extend(more);
        knots.sort_by_key(|knot| knot.spot);
    }
    // What is still above goes down with both its ends.
    for _ in 0..2 * ROUNDS {
        let mut least: Vec<f64> = vec_with_room(knots.len())?;
        least.resize(knots.len(), 1.0);
        for (k, pair) in knots.windows(2).enumerate() {
            let over = excess(film, wanted, pair, mode);
            if over > 1.0 {
                least[k] = least[k].min(1.0 / over);
                least[k + 1] = least[k + 1].min(1.0 / over);
            }
        }
        for (knot, least) in knots.iter_mut().zip(&least) {
            knot.zoom = (knot.zoom * least).max(MIN_ZOOM);
            knot.slope *= least;
        }
        join_ends(film, &mut knots);
        if least.iter().all(|least| *least > 1.0 - SPARE) {
            break;
        }
    }
    // Where the zoom alone changes, it must.
    for k in 1..knots.len() {
        let piece = film.piece_of(knots[k - 1].spot);
        let step = STEP * knots[k].zoom;
        if film.pieces[piece].change == Change::Zoom
            && (knots[k].zoom - knots[k - 1].zoom).abs() < step
        {
            let down = knots[k].zoom - 2.0 * step;
            knots[k].zoom = if down >= MIN_ZOOM {
                down
            } else {
                knots[k].zoom + 2.0 * step
            };
        }
    }
    Ok(knots)
}

/// A closed path ends in its first key.
fn join_ends(film: &Film, knots: &mut [Knot]) {
    if let (true, [first, .., last]) = (film.closed, knots) {
        first.zoom = first.zoom.min(last.zoom);
        last.zoom = first.zoom;
        first.slope = 0.5 * (first.slope + last.slope);
        last.slope = first.slope;
    }
}

/// A key at a sample, with the slope that the wanted zoom has around it.
fn knot(film: &Film, wanted: &[f64], spot: usize) -> Knot {
    let spots = &film.spots;
    let here = spots[spot].tau;
    let near = 1e-3
        * film
            .pieces
            .get(film.piece_of(spot))
            .map_or(1.0, |piece| piece.duration);
    let slope = |other: usize| (wanted[other] - wanted[spot]) / (spots[other].tau - here);
    let after = (spot + 1..spots.len()).find(|k| spots[*k].tau - here >= near);
    let before = (0..spot).rev().find(|k| here - spots[*k].tau >= near);
    let slope = match (before, after) {
        (Some(before), Some(after)) => 0.5 * (slope(before) + slope(after)),
        (Some(one), None) | (None, Some(one)) => slope(one),
        (None, None) => 0.0,
    };
    Knot {
        spot,
        zoom: wanted[spot],
        slope: slope.clamp(-MAX_RATE, MAX_RATE),
    }
}

/// The zoom between two keys at a sample.
fn between<'a>(film: &'a Film, pair: &'a [Knot], mode: ZoomMode) -> impl Fn(usize) -> f64 + 'a {
    let [a, b] = [pair[0], pair[1]];
    let from = film.spots[a.spot].tau;
    let step = film.spots[b.spot].tau - from;
    let rise = b.zoom - a.zoom;
    let curve = match mode {
        ZoomMode::Linear => [a.zoom, rise, 0.0, 0.0],
        ZoomMode::Smooth => cubic(a.zoom, rise, step, a.slope, b.slope),
    };
    move |spot| {
        if step > 0.0 {
            value(&curve, (film.spots[spot].tau - from) / step)
        } else {
            a.zoom
        }
    }
}

/// The greatest quotient of the zoom between two keys and the wanted one.
fn excess(film: &Film, wanted: &[f64], pair: &[Knot], mode: ZoomMode) -> f64 {
    let zoom = between(film, pair, mode);
    (pair[0].spot..=pair[1].spot)
        .map(|spot| zoom(spot) / wanted[spot])
        .fold(0.0, f64::max)
}

/// The sample at a whole frame next to where the zoom between two keys is furthest off.
fn worst(film: &Film, wanted: &[f64], pair: &[Knot], mode: ZoomMode) -> Option<usize> {
    let zoom = between(film, pair, mode);
    let mut worst = (1.0, None);
    for spot in pair[0].spot..=pair[1].spot {
        let off = zoom(spot) / wanted[spot] - 1.0;
        let off = (off / OFF_BY[0]).max(-off / OFF_BY[1]);
        if off > worst.0 {
            worst = (off, Some(spot));
        }
    }
    let at = film.spots[worst.1?].frame;
    let ends = [
        film.spots[pair[0].spot].frame,
        film.spots[pair[1].spot].frame,
    ];
    let inside = |spot: &usize| {
        let frame = film.spots[*spot].frame;
        frame.fract() == 0.0 && frame - ends[0] >= APART && ends[1] - frame >= APART
    };
    let far = |spot: usize| (film.spots[spot].frame - at).abs();
    (pair[0].spot..pair[1].spot)
        .filter(inside)
        .min_by(|a, b| far(*a).total_cmp(&far(*b)))
}

/// The path with points where keys are, and how many were put in.
fn divided(path: &CameraPath, film: &Film, knots: &[Knot]) -> Result<(CameraPath, usize)> {
    let mut made = path.try_clone()?;
    for piece in film
        .pieces
        .iter()
        .filter(|piece| piece.change == Change::Zoom)
    {
        let one = &mut made.points[piece.point].orientations[piece.orientation];
        one.own = one.own.with(|own| {
            own.frames = piece.frames as u32;
            own.curve_time = Some(piece.duration);
        })?;
    }
    let mut added = 0;
    let key = |knot: &&Knot| film.pieces.iter().any(|piece| piece.from == knot.spot);
    let last = film.spots.len() - 1;
    for knot in knots.iter().filter(|knot| knot.spot < last && !key(knot)) {
        match on_curve(&made, film.spots[knot.spot].frame) {
            Ok(divided) => {
                made = divided.path;
                added += 1;
            }
            // Too near to a point: that key is left out.
            Err(Error::Range(_)) => {}
            Err(error) => return Err(error),
        }
    }
    Ok((made, added))
}

/// Gives all keys their zoom, times `scale`.
fn set_zooms(path: &mut CameraPath, film: &Film, knots: &[Knot], scale: f64) -> Result<()> {
    let timeline = Timeline::new(path)?;
    let mut sampled = Vec::new();
    let frame = |knot: &Knot| film.spots[knot.spot].frame;
    // Keys in order: their frames are those of the samples.
    let mut begin = 1.0;
    for section in 0..timeline.section_count() {
        let known = timeline.section(section);
        let hold = path.points[known.point].orientations[known.orientation].hold;
        let moves = known.change != Change::Nothing;
        if moves {
            begin += f64::from(hold);
        }
        sampled.try_reserve(1)?;
        sampled.push((known.point, known.orientation, moves.then_some(begin)));
        begin += known.frames as f64;
    }
    let mut next = knots[knots.len() - 1];
    if !path.closed {
        let point = path.points.len() - 1;
        let orientation = path.points[point].orientations.len() - 1;
        set_zoom(path, (point, orientation), next, scale)?;
    } else {
        next = knots[0];
    }
    for (point, orientation, begin) in sampled.into_iter().rev() {
        if let Some(begin) = begin {
            let at = knots.partition_point(|knot| frame(knot) < begin - 0.5);
            next = knots[at.min(knots.len() - 1)];
        }
        set_zoom(path, (point, orientation), next, scale)?;
    }
    Ok(())
}

fn set_zoom(
    path: &mut CameraPath,
    (point, orientation): (usize, usize),
    knot: Knot,
    scale: f64,
) -> Result<()> {
    let smooth = path.zoom_mode == ZoomMode::Smooth;
    let one = &mut path.points[point].orientations[orientation];
    one.zoom = (knot.zoom * scale).clamp(MIN_ZOOM, MAX_ZOOM);
    one.own = one
        .own
        .with(|own| own.zoom_slope = smooth.then_some(knot.slope * scale))?;
    Ok(())
}
