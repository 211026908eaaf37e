//! By turning the views, or by moving the camera along them: key by key, until it holds between keys.

use glam::{DQuat, DVec3};

use super::below::Course;
use super::film::{Film, Spot};
use super::outline::Camera;
use super::{Framed, SPARE, TIGHT, What, Work};
use crate::error::{Error, Invalid, Result, vec_with_room};
use crate::math::orientation::unit;
use crate::path::insertion::on_curve;
use crate::path::{CameraPath, Change, Orientation, Tangents, Target, UpVector};
use crate::tools::check::FindingKind;

/// The share of the room that keys first take.
const AIM: f64 = 0.997;

/// Rounds in which points are added, and keys take less of the room.
const ROUNDS: usize = 60;

/// An excess between keys up to which these take less of the room instead of a point being added.
const NEAR: f64 = 1.04;

/// If both keys take less of the room than this and the object is still too large, a point is added.
const GIVEN: f64 = 0.97;

/// Frames between two keys at least.
const APART: f64 = 3.0;

/// The least share of the room that a key may come to take.
const LEAST_AIM: f64 = 0.3;

/// Turns of a view at one key, each by what is missing; halvings of one that goes too far.
const TURNS: usize = 100;
const HALVINGS: usize = 30;

/// The share of what a key may take that it takes where it was turned.
const TURNED: f64 = 0.999;

/// The share of the way to a target that the camera may go.
const TO_TARGET: f64 = 0.95;

/// The least distance between two points, in units of `half_size`.
const STEP: f64 = 1e-6;

/// Angle between the ways before and behind a point from which it is a corner, in radians.
const CORNER: f64 = 0.2;

impl Work<'_> {
    /// Changes keys until all of the object is in the room everywhere.
    pub(super) fn by_keys(&mut self, path: &CameraPath, film: &Film) -> Result<Framed> {
        let mut together = None;
        if self.request.what == What::View {
            together = self.by_targets(path, film)?;
            if together
                .as_ref()
                .is_some_and(|framed| framed.tightest >= TIGHT)
            {
                return together.ok_or(Error::Memory);
            }
        }
        // Targets that jump past the room do hold, where nothing nearer does.
        match (self.key_by_key(path, film), together) {
            (Err(Error::Argument(_)), Some(framed)) => Ok(framed),
            (found, _) => found,
        }
    }

    fn key_by_key(&mut self, path: &CameraPath, film: &Film) -> Result<Framed> {
        let mut base = pinned(path, film)?;
        let mut aims: Vec<f64> = vec_with_room(base.points.len())?;
        aims.resize(base.points.len(), AIM);
        for round in 0..ROUNDS {
            self.watch.at(round, ROUNDS)?;
            let before = Film::new(&base, self.request.fps)?;
            let made = match self.request.what {
                What::View => self.turned(&base, &before, &aims)?,
                _ => self.moved(&base, &before, &aims)?,
            };
            let now = Film::new(&made, self.request.fps)?;
            if now.pieces.len() != before.pieces.len() {
                // Where nothing changes any more there are no frames.
                break;
            }
            let over = self.overs(&now)?;
            if over.iter().all(|(share, _)| *share <= 1.0 - SPARE) {
                made.check()?;
                let (tightest, loosest) = self.shares(&now);
                return Ok(Framed {
                    added: made.points.len() - path.points.len(),
                    path: made,
                    tightest,
                    loosest,
                });
            }
            self.give_way(&mut base, &mut aims, &now, &over)?;
        }
        let (_, frame) = self.worst(film);
        Err(Invalid::PictureKeys { frame }.into())
    }

    /// The greatest share of the room in each section, and its frame; at the end of the last key.
    fn overs(&mut self, film: &Film) -> Result<Vec<(f64, f64)>> {
        let mut overs = vec_with_room(film.pieces.len() + 1)?;
        overs.resize(film.pieces.len().max(1), (0.0, 1.0));
        for (k, spot) in film.spots.iter().enumerate() {
            let share = self.share(spot);
            let over = &mut overs[film.piece_of(k)];
            if share > over.0 {
                *over = (share, spot.frame);
            }
        }
        Ok(overs)
    }

    /// Adds points where the object is far out, else lets the keys beside take less of the room.
    fn give_way(
        &self,
        base: &mut CameraPath,
        aims: &mut Vec<f64>,
        film: &Film,
        over: &[(f64, f64)],
    ) -> Result<()> {
        let mut inserted = 0;
        for (k, &(share, frame)) in over.iter().enumerate() {
            if share <= 1.0 - SPARE {
                continue;
            }
            let Some(piece) = film.pieces.get(k) else {
                return Err(Invalid::PictureKeys { frame }.into());
            };
            let begin = film.spots[piece.from].frame;
            let room = piece.frames as f64 >= 2.0 * APART;
            // Points that were put in before this section have moved its number.
            let first = piece.point + inserted;
            let same = piece.orientation + 1 < base.points[first].orientations.len();
            let ends = [first, (first + usize::from(!same)) % base.points.len()];
            let given = ends.iter().all(|end| aims[*end] < GIVEN);
            if (share > NEAR || given) && piece.divides && room {
                let inside = [begin + APART, begin + piece.frames as f64 - APART];
                let frame = frame.round().clamp(inside[0].ceil(), inside[1].floor());
                match on_curve(base, frame) {
                    Ok(divided) => {
                        *base = divided.path;
                        let aim = aims[divided.at - 1];
                        aims.try_reserve(1)?;
                        aims.insert(divided.at, if given { AIM } else { aim });
                        inserted += 1;
                        continue;
                    }
                    Err(Error::Range(_)) => {}
                    Err(error) => return Err(error),
                }
            }
            let less = (1.0 - 10.0 * SPARE) / share.min(1.25);
            for end in ends {
                aims[end] *= less;
                if aims[end] < LEAST_AIM {
                    return Err(Invalid::PictureKeys { frame }.into());
                }
            }
        }
        Ok(())
    }

    /// Where all views look at places: these brought towards the object, as little as it takes.
    fn by_targets(&mut self, path: &CameraPath, film: &Film) -> Result<Option<Framed>> {
        let all = || path.points.iter().flat_map(|point| &point.orientations);
        let fixed = |one: &Orientation| {
            matches!(one.target, Target::Absolute(_)) && one.own.ahead.is_none()
        };
        if !all().all(fixed) {
            return Ok(None);
        }
        let middle = self.outline.middle();
        let mut ends = [0.0, 1.0];
        let mut best = None;
        for round in 0..20 {
            let share = if round == 0 {
                1.0
            } else {
                0.5 * (ends[0] + ends[1])
            };
            let mut made = path.try_clone()?;
            for one in made
                .points
                .iter_mut()
                .flat_map(|point| &mut point.orientations)
            {
                if let Target::Absolute(target) = one.target {
                    one.target = Target::Absolute(target.lerp(middle, share));
                }
                one.own = one.own.with(|own| {
                    own.velocities = None;
                    own.turning = None;
                })?;
            }
            if made.check().is_err() {
                return Ok(None);
            }
            let made = pinned(&made, film)?;
            let now = Film::new(&made, self.request.fps)?;
            let (tightest, loosest) = self.shares(&now);
            // Where nothing changes any more there are no frames.
            let same = now.pieces.len() == film.pieces.len();
            let fits = same && tightest <= 1.0 - SPARE;
            if round == 0 && !fits {
                return Ok(None);
            }
            ends[usize::from(fits)] = share;
            if fits {
                best = Some(Framed {
                    path: made,
                    added: 0,
                    tightest,
                    loosest,
                });
                if tightest > AIM {
                    break;
                }
            }
        }
        Ok(best)
    }

    /// All views turned as little as brings the object into the room.
    fn turned(&mut self, base: &CameraPath, film: &Film, aims: &[f64]) -> Result<CameraPath> {
        let mut made = base.try_clone()?;
        for (point, orientation, spot) in keys(base, film)? {
            let spot = &film.spots[spot];
            let one = &mut made.points[point].orientations[orientation];
            let position = base.points[point].position;
            self.turn(one, position, spot, base, aims[point])?;
        }
        Ok(made)
    }

    /// Turns one view by what is missing, until nothing is.
    fn turn(
        &mut self,
        one: &mut Orientation,
        position: DVec3,
        spot: &Spot,
        path: &CameraPath,
        aim: f64,
    ) -> Result<()> {
        let large = || Error::from(Invalid::PictureLarge { frame: spot.frame });
        let mut camera = spot.camera;
        let upright = path.space.up;
        let axis = one.own.up.level(upright).unwrap_or(upright);
        let roll = if one.own.up.is_level() {
            one.roll.to_radians()
        } else {
            axis.roll_from_up(camera.view, camera.up)
        };
        let halves = [0, 2].map(|k| (self.room[k] * aim / one.zoom).atan());
        let mut turned = false;
        for turn in 0.. {
            let missing = self
                .outline
                .reach(&camera)
                .map(|reach| missing(reach, halves));
            match missing {
                Some(Some([0.0, 0.0])) => break,
                Some(Some([aside, above])) => {
                    let right = camera.view.cross(camera.up);
                    let turn = DQuat::from_axis_angle(camera.up, -aside)
                        * DQuat::from_axis_angle(right, above);
                    camera.view = unit(turn * camera.view);
                }
                // Not all before the camera, or seen aslant wider than from its middle.
                _ if !turned => {
                    camera.view = unit(self.outline.middle() - camera.eye);
                }
                // With all of the room it fits as it is.
                Some(None) if self.share(&Spot { camera, ..*spot }) <= 1.0 - SPARE => break,
                _ => return Err(large()),
            }
            turned = true;
            camera.up = axis.up_from_roll(camera.view, roll);
            if turn == TURNS {
                return Err(large());
            }
        }
        if !turned {
            return Ok(());
        }
        // Turned both ways at once, or to the middle, it may have gone too far.
        let old = spot.camera.view;
        let whole = DQuat::from_rotation_arc(old, camera.view);
        let part_of = |part: f64| {
            let view = unit(DQuat::IDENTITY.slerp(whole, part) * old);
            let up = axis.up_from_roll(view, roll);
            Camera { view, up, ..camera }
        };
        let mut ends = [0.0, 1.0];
        if self.share(&Spot { camera, ..*spot }) < TURNED * aim {
            for _ in 0..HALVINGS {
                let part = 0.5 * (ends[0] + ends[1]);
                let camera = part_of(part);
                let fits = self.share(&Spot { camera, ..*spot }) <= aim;
                ends[usize::from(fits)] = part;
            }
            camera = part_of(ends[1]);
        }
        let far = one.target.offset_from(position).length();
        let offset = camera.view * far;
        one.target = match (one.target, one.own.ahead) {
            (Target::Absolute(_), None) => Target::Absolute(position + offset),
            _ => Target::Relative(offset),
        };
        if !one.own.up.is_level() {
            one.roll = roll.to_degrees();
        }
        one.own = one.own.with(|own| {
            own.ahead = None;
            own.velocities = None;
            own.turning = None;
            own.roll_slope = None;
            if !own.up.is_level() {
                own.up = UpVector::Axis;
            }
        })?;
        Ok(())
    }

    /// All points moved along the view, as near to the object as the room allows.
    fn moved(&mut self, base: &CameraPath, film: &Film, aims: &[f64]) -> Result<CameraPath> {
        let ways = ways(base, film)?;
        let mut bound = vec_with_room(film.spots.len())?;
        for (k, spot) in film.spots.iter().enumerate() {
            self.watch.check()?;
            bound.push(self.nearer(base, film, aims, (k, spot), ways[k])?);
        }
        // A point is one place, whatever is turned there.
        let mut at_points = vec_with_room(base.points.len())?;
        at_points.resize(base.points.len(), f64::INFINITY);
        for (k, far) in bound.iter().enumerate() {
            if let Some(point) = stands(base, film, k) {
                at_points[point] = at_points[point].min(*far);
            }
        }
        for (k, far) in bound.iter_mut().enumerate() {
            if let Some(point) = stands(base, film, k) {
                *far = at_points[point];
            }
        }
        let half = base.space.half_size;
        let limits = &self.request.limits;
        let last = film.spots[film.spots.len() - 1];
        if last.tau > 0.0 {
            let mut axes: [Vec<f64>; 2] =
                [vec_with_room(bound.len())?, vec_with_room(bound.len())?];
            axes[0].extend(film.spots.iter().map(|spot| spot.tau));
            axes[1].extend(film.spots.iter().map(|spot| spot.time));
            let course = Course {
                at: &axes[0],
                time: &axes[1],
                closed: film.closed,
            };
            let pace = last.time / last.tau;
            let bend = 0.5 * half * limits.get(FindingKind::Acceleration) * pace * pace;
            bound = course.below(&bound, half * limits.get(FindingKind::Speed), bend)?;
        }
        place(base, film, &ways, &bound)
    }

    /// How far forwards a camera may go at a sample.
    fn nearer(
        &mut self,
        path: &CameraPath,
        film: &Film,
        aims: &[f64],
        (k, spot): (usize, &Spot),
        way: DVec3,
    ) -> Result<f64> {
        let camera = spot.camera;
        let piece = film.pieces.get(film.piece_of(k));
        let (from, to) = match piece {
            Some(piece) => (piece.point, (piece.point + 1) % path.points.len()),
            None => (0, 0),
        };
        let aim = aims[from].min(aims[to]);
        let mut sides = camera.sides();
        for (side, room) in sides.iter_mut().zip(self.room) {
            *side = *side * (spot.zoom / (room * aim)) - camera.view;
        }
        let reach = self.outline.furthest(camera.eye, sides);
        let mut most = f64::INFINITY;
        for (side, reach) in sides.iter().zip(reach) {
            let along = side.dot(way);
            if along < 0.0 {
                most = most.min(reach / along);
            } else if reach > 0.0 {
                return Err(Invalid::PictureLarge { frame: spot.frame }.into());
            }
        }
        if let Some(piece) = piece {
            let one = &path.points[piece.point].orientations[piece.orientation];
            if let (Target::Absolute(target), None) = (one.target, one.own.ahead) {
                most = most.min(TO_TARGET * (target - camera.eye).dot(way).abs());
            }
        }
        let farthest = path.space.farthest();
        if !(most.abs() < farthest) {
            return Err(Invalid::PictureLarge { frame: spot.frame }.into());
        }
        Ok(most)
    }
}

/// The angles by which a view must turn to the right and up to bring what has this `reach` within the
/// half angles of the picture; none where it is too large.
fn missing(reach: [f64; 4], halves: [f64; 2]) -> Option<[f64; 2]> {
    let angles = reach.map(f64::atan);
    let mut turns = [0.0; 2];
    for (side, (turn, half)) in turns.iter_mut().zip(halves).enumerate() {
        let [there, back] = [angles[2 * side], angles[2 * side + 1]];
        if there + back > 2.0 * half * (1.0 + 0.01 * SPARE) {
            return None;
        }
        // A little more than it takes, so that it comes to an end.
        let more = |angle: f64| (angle - half) * 1.001 + 0.01 * SPARE * half;
        if there > half {
            *turn = more(there).min(half - back).max(there - half);
        } else if back > half {
            *turn = -more(back).min(half - there).max(back - half);
        }
    }
    Some(turns)
}

/// The path with all its frames and curve times as they are.
fn pinned(path: &CameraPath, film: &Film) -> Result<CameraPath> {
    let mut made = path.try_clone()?;
    for piece in &film.pieces {
        let one = &mut made.points[piece.point].orientations[piece.orientation];
        one.own = one.own.with(|own| {
            own.frames = piece.frames as u32;
            own.curve_time = Some(piece.duration);
        })?;
    }
    Ok(made)
}

/// All orientations, with the sample of their key; those without frames have that of the next one.
fn keys(path: &CameraPath, film: &Film) -> Result<Vec<(usize, usize, usize)>> {
    let mut keys = vec_with_room(path.points.len())?;
    let mut next = 0;
    for (point, support) in path.points.iter().enumerate() {
        for orientation in 0..support.orientations.len() {
            let here = |piece: &super::film::Piece| (piece.point, piece.orientation);
            while film
                .pieces
                .get(next)
                .is_some_and(|piece| here(piece) < (point, orientation))
            {
                next += 1;
            }
            let around = if film.closed { Some(0) } else { None };
            let spot = match film.pieces.get(next) {
                Some(piece) => piece.from,
                None => around.unwrap_or(film.spots.len() - 1),
            };
            keys.try_reserve(1)?;
            keys.push((point, orientation, spot));
        }
    }
    Ok(keys)
}

/// The point at which the camera stands at a sample.
fn stands(path: &CameraPath, film: &Film, spot: usize) -> Option<usize> {
    let Some(piece) = film.pieces.get(film.piece_of(spot)) else {
        return Some(0);
    };
    let last = path.points[piece.point].orientations.len() - 1;
    let end = film.spots[piece.from].frame + piece.frames as f64;
    if spot == piece.from
        || piece.orientation < last
        || film.spots[spot].frame <= film.spots[piece.from].frame
    {
        return Some(piece.point);
    }
    (film.spots[spot].frame >= end).then_some((piece.point + 1) % path.points.len())
}

/// The way in which each sample may be moved: along the view; at a point with several along their
/// mean.
fn ways(path: &CameraPath, film: &Film) -> Result<Vec<DVec3>> {
    let mut means = vec_with_room(path.points.len())?;
    means.resize(path.points.len(), DVec3::ZERO);
    for (point, _, spot) in keys(path, film)? {
        means[point] += film.spots[spot].camera.view;
    }
    let mut ways = vec_with_room(film.spots.len())?;
    for (k, spot) in film.spots.iter().enumerate() {
        let mean = stands(path, film, k).and_then(|point| means[point].try_normalize());
        ways.push(mean.unwrap_or(spot.camera.view));
    }
    Ok(ways)
}

/// The path with its points moved so far, and the tangents of the moved way.
fn place(base: &CameraPath, film: &Film, ways: &[DVec3], far: &[f64]) -> Result<CameraPath> {
    let mut made = base.try_clone()?;
    let moved = |k: usize| film.spots[k].camera.eye + far[k] * ways[k];
    let count = base.points.len();
    let mut tangents: Vec<[Option<(DVec3, f64)>; 2]> = vec_with_room(count)?;
    tangents.resize(count, [None; 2]);
    for (point, _, spot) in keys(base, film)? {
        made.points[point].position = base.points[point].position + far[spot] * ways[spot];
    }
    let step = STEP * base.space.half_size;
    for (k, piece) in film.pieces.iter().enumerate() {
        if piece.orientation + 1 < base.points[piece.point].orientations.len() {
            continue;
        }
        // A section without any way would have no frames.
        let next = (piece.point + 1) % count;
        let [from, to] = [piece.point, next].map(|point| made.points[point].position);
        if piece.change == Change::Position && from.distance(to) < step {
            made.points[next].position -= 2.0 * step * ways[piece.from];
        }
        let range = film.range(k);
        // Behind the last section stands the last key.
        let end = if k + 1 == film.pieces.len() {
            range.end - 1
        } else {
            range.end
        };
        let start = slope(film, &moved, piece.from + 1, end - 1);
        let finish = slope(film, &moved, end - 1, piece.from + 1);
        tangents[piece.point][1] = Some((start, piece.duration));
        tangents[next][0] = Some((finish, piece.duration));
    }
    for (point, tangents) in made.points.iter_mut().zip(tangents) {
        let (before, after) = match tangents {
            [Some((before, a)), Some((after, b))] => {
                let mean = 0.5 * (before + after);
                if before.angle_between(after) < CORNER {
                    (mean * a, mean * b)
                } else {
                    (before * a, after * b)
                }
            }
            [Some((one, step)), None] | [None, Some((one, step))] => (one * step, one * step),
            [None, None] => continue,
        };
        if before.is_finite() && after.is_finite() {
            point.tangents = Some(Tangents { before, after });
        }
    }
    for one in made
        .points
        .iter_mut()
        .flat_map(|point| &mut point.orientations)
    {
        // A key's own velocity belongs to where it was.
        if matches!(one.target, Target::Absolute(_)) {
            one.own = one.own.with(|own| own.roll_slope = None)?;
        }
    }
    Ok(made)
}

/// The derivative by curve time at one end of a section, of a parabola through three samples.
fn slope(film: &Film, moved: &dyn Fn(usize) -> DVec3, at: usize, other: usize) -> DVec3 {
    let whole = (film.spots[other].tau - film.spots[at].tau).abs();
    let step = |share: f64| {
        let near = |k: &usize| (film.spots[*k].tau - film.spots[at].tau).abs() >= share * whole;
        if at < other {
            (at..=other).find(near)
        } else {
            (other..=at).rev().find(near)
        }
    };
    let (Some(a), Some(b)) = (step(0.01), step(0.03)) else {
        return DVec3::ZERO;
    };
    let [h, g] = [a, b].map(|k| film.spots[k].tau - film.spots[at].tau);
    let [p, q, r] = [at, a, b].map(moved);
    if h == g || h == 0.0 {
        return DVec3::ZERO;
    }
    ((q - p) / h * g - (r - p) / g * h) / (g - h)
}
