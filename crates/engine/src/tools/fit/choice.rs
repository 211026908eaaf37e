//! Which of several paths it is: that of fewest points that meets all poses, but where there is
//! noise one near to what is left of them without it.

use super::report::{Measured, Report};
use super::{Data, Follow, Piece, Progress, Tolerance, WITHIN};
use crate::error::{Error, Invalid, Result};
use crate::path::CameraPath;

/// What is tried in turn, with such a share of the tolerance: a smaller one may need fewer points.
const TRIES: [(Follow, f64); 7] = [
    (Follow::Smoothly, 1.0),
    (Follow::Smoothly, 0.5),
    (Follow::Smoothly, 0.2),
    (Follow::Smoothly, 0.1),
    (Follow::Smoothly, 0.05),
    (Follow::Exactly, 1.0),
    (Follow::ByPoints, 1.0),
];

/// A path with more than a third as many points as poses has too many.
const MANY: usize = 3;

/// Of more than one pose of this many they are noise, no outliers.
const MOST_OUTLIERS: usize = 20;

/// No noise is farther from the flight than this many standard deviations of a coordinate.
const BEYOND_NOISE: f64 = 5.0;

/// More deviations than bounded noise can have.
const BOUNDED: f64 = 3.5;

/// Multiples of that which are tried for a better tolerance.
const BETTER: [f64; 3] = [1.0, 1.5, 2.0];

/// The share of the tolerance by which pieces may then miss the splines, which know better than a pose.
const NEAR: f64 = 0.1;

/// At its worst a smooth path may be farther off by this factor.
const AS_NEAR: f64 = 1.5;

/// With more poses than this for a frame, most noise between frames cannot be met.
const BETWEEN: f64 = 1.2;

/// The least noise that counts, in tolerances; in an even motion less counts.
const LITTLE_NOISE: f64 = 0.085;
const LEAST_NOISE: f64 = 0.02;

/// Tried one after the other as distances from the splines, in tolerances,
const CLOSER: [f64; 3] = [0.3, 0.15, 0.08];

/// until the root of their mean square is this, with at most this many points more, and
/// at most this many in all.
const ENOUGH: f64 = 0.07;
const SOME_MORE: usize = 3;
const AT_MOST: usize = 32;

/// A path that was tried.
pub(super) struct Made {
    pub path: CameraPath,
    pub measured: Measured,
    /// By how much it misses the splines, as root of the mean square in tolerances,
    missed: [f64; 2],
    /// and whether these are even.
    even: [bool; 2],
}

impl Made {
    fn points(&self) -> usize {
        self.path.points.len()
    }

    /// What is better is less: to meet the poses, then few points.
    fn key(&self) -> (f64, usize) {
        (self.measured.worst.max(WITHIN), self.points())
    }
}

impl Data {
    /// What a robust fit leaves out, and its points, if it needs at most half of those of a fit that
    /// was not robust.
    pub(super) fn robust(
        mut self,
        report: &Report,
        progress: Progress<'_>,
    ) -> Result<Option<(usize, usize)>> {
        match self.leave_out() {
            Err(Error::Argument(Invalid::Outliers { .. })) => return Ok(None),
            done => done?,
        }
        let outliers = self.outliers().count();
        if outliers == 0 || MOST_OUTLIERS * outliers > report.poses {
            return Ok(None);
        }
        (self.cuts, self.gaps) = self.jumps()?;
        let points = match self.best(progress) {
            Ok(made) => made.points(),
            Err(Error::Limit(_)) => return Ok(None),
            Err(error) => return Err(error),
        };
        Ok((3 * points <= 2 * report.points).then_some((outliers, points)))
    }

    /// Where there are many points, a tolerance beyond the noise if it needs at most half of them.
    pub(super) fn better(
        &mut self,
        report: &Report,
        progress: Progress<'_>,
    ) -> Result<Option<(Tolerance, usize)>> {
        if MANY * report.points <= report.poses {
            return Ok(None);
        }
        for tolerance in self.beyond_noise([report.noise, report.turning_noise.to_radians()]) {
            let Some(made) = self.with(tolerance, progress)? else {
                continue;
            };
            if 2 * made.points() <= report.points {
                return Ok(Some((tolerance, made.points())));
            }
        }
        Ok(None)
    }

    /// Tolerances beyond the noise of positions and of views (radians), the smallest first.
    fn beyond_noise(&self, noises: [f64; 2]) -> impl Iterator<Item = Tolerance> + use<> {
        let given = [self.tolerance, self.angle.to_degrees()];
        let noises = [noises[0], noises[1].to_degrees()];
        BETTER.into_iter().filter_map(move |times| {
            let beyond = noises.map(|noise| round_up(times * BEYOND_NOISE * noise));
            let larger = beyond[0] > given[0] || beyond[1] > given[1];
            larger.then(|| Tolerance {
                position: beyond[0].max(given[0]),
                angle: beyond[1].max(given[1]).min(180.0),
            })
        })
    }

    /// The nearest path with another tolerance; none if it needs too many points.
    fn with(&mut self, tolerance: Tolerance, progress: Progress<'_>) -> Result<Option<Made>> {
        let given = [self.tolerance, self.angle];
        [self.tolerance, self.angle] = [tolerance.position, tolerance.angle.to_radians()];
        let made = self.nearest(progress);
        [self.tolerance, self.angle] = given;
        match made {
            Err(Error::Limit(_)) => Ok(None),
            made => made.map(Some),
        }
    }

    /// The nearest path; but where none can meet poses between its frames, as they are noise, a
    /// smooth one of fewer points that is about as near at its worst.
    pub(super) fn best(&mut self, progress: Progress<'_>) -> Result<Made> {
        let mut best = self.nearest(progress)?;
        let frames = self.times[self.times.len() - 1];
        if best.measured.worst <= WITHIN || self.poses() as f64 <= BETWEEN * frames {
            return Ok(best);
        }
        for tolerance in self.beyond_noise(self.noises()?) {
            self.near = [self.tolerance, self.angle].map(|given| NEAR * given);
            let made = self.with(tolerance, progress);
            self.near = [f64::INFINITY; 2];
            let Some(made) = made? else {
                continue;
            };
            let measured = &made.measured;
            let turned = measured.view.greatest.max(measured.lens.greatest);
            let worst =
                (measured.position.greatest / self.tolerance).max(turned.to_radians() / self.angle);
            if worst <= AS_NEAR * best.measured.worst && made.points() < best.points() {
                best = made;
                break;
            }
        }
        Ok(best)
    }

    /// The path of fewest points that meets all poses, else the one that misses them least.
    fn nearest(&mut self, progress: Progress<'_>) -> Result<Made> {
        self.calm_down(false)?;
        if self.stands() {
            let path = self.standing(self.times[self.times.len() - 1])?;
            let measured = self.measured(&path)?;
            return Ok(Made {
                path,
                measured,
                missed: [0.0; 2],
                even: [false; 2],
            });
        }
        let noises = self.noises()?;
        let mut best: Option<(Made, (Follow, f64))> = None;
        for (follow, share) in TRIES {
            let given = [self.tolerance, self.angle];
            let met = best.as_ref().filter(|best| best.0.measured.worst <= WITHIN);
            // Less than the noise no spline follows by few points.
            let within_noise = (0..2).any(|k| share * given[k] < BOUNDED * noises[k]);
            if best.is_some() && share < 1.0 && within_noise {
                continue;
            }
            if met.is_some() && follow != Follow::Smoothly {
                break;
            }
            // Where a path meets all poses, only one of fewer points is better.
            let most = met.map_or(usize::MAX, |met| met.0.points() - 1);
            let made = match self.fitted(follow, share, most, progress) {
                Err(Error::Limit(_)) if best.is_some() => continue,
                made => made?,
            };
            let Some(made) = made else { continue };
            if made.points() > self.poses() && follow != Follow::ByPoints {
                continue;
            }
            if best.as_ref().is_none_or(|best| made.key() < best.0.key()) {
                best = Some((made, (follow, share)));
            }
        }
        let Some((best, (follow, share))) = best else {
            return Err(Invalid::TooFewPoses.into());
        };
        if follow != Follow::Smoothly || self.near[0].is_finite() {
            return Ok(best);
        }
        self.closer(best, share, noises, progress)
    }

    /// Where poses are noise the splines know better, and the tolerance is not there to be used up: a
    /// path closer to them, if it is not of many more points.
    fn closer(
        &mut self,
        mut best: Made,
        share: f64,
        noises: [f64; 2],
        progress: Progress<'_>,
    ) -> Result<Made> {
        let given = [self.tolerance, self.angle];
        let known = |k: usize| {
            let least = if best.even[k] {
                LEAST_NOISE
            } else {
                LITTLE_NOISE
            };
            noises[k] > least * given[k]
        };
        let known = [0, 1].map(known);
        let few = best.points();
        let more = SOME_MORE.min(AT_MOST.saturating_sub(few)).min(few - 1);
        let most = few + more;
        for near in CLOSER {
            let far = [0, 1].map(|k| known[k] && best.missed[k] > ENOUGH);
            if far == [false; 2] {
                break;
            }
            for k in (0..2).filter(|k| far[*k]) {
                self.near[k] = near * given[k];
            }
            match self.fitted(Follow::Smoothly, share, most, progress) {
                Ok(Some(made)) if made.measured.worst <= best.key().0 => best = made,
                Ok(Some(_)) => {}
                Ok(None) | Err(Error::Limit(_)) => break,
                Err(error) => {
                    self.near = [f64::INFINITY; 2];
                    return Err(error);
                }
            }
        }
        self.near = [f64::INFINITY; 2];
        Ok(best)
    }

    /// None if it needs more than `most` points.
    fn fitted(
        &mut self,
        follow: Follow,
        share: f64,
        most: usize,
        progress: Progress<'_>,
    ) -> Result<Option<Made>> {
        let given = [self.tolerance, self.angle];
        [self.tolerance, self.angle] = given.map(|given| share * given);
        let pieces = self.pieces(follow, most, progress);
        [self.tolerance, self.angle] = given;
        let Some(mut pieces) = pieces? else {
            return Ok(None);
        };
        self.even_out(&mut pieces.all)?;
        let path = self.path(&pieces.all, pieces.end)?;
        let measured = self.measured(&path)?;
        let frames: f64 = pieces.all.iter().map(|piece| f64::from(piece.frames)).sum();
        let missed = [0, 1].map(|k| {
            let squares = |piece: &Piece| f64::from(piece.frames) * piece.missed[k];
            (pieces.all.iter().map(squares).sum::<f64>() / frames).sqrt() / given[k]
        });
        Ok(Some(Made {
            path,
            measured,
            missed,
            even: pieces.even,
        }))
    }
}

/// To two digits.
fn round_up(number: f64) -> f64 {
    if !(number > 0.0 && number.is_finite()) {
        return 0.0;
    }
    let digit = 10f64.powf(number.log10().floor() - 1.0);
    let rounded = (number / digit).ceil() * digit;
    // As a decimal it is the number that is shown.
    format!("{rounded:.1e}").parse().unwrap_or(number)
}
