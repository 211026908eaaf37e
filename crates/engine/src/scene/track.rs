//! Tracks: the keys of one channel, and the ways between them (`docs/reference/scene.md`, tracks).

use glam::DQuat;

use super::channel::Channel;
use super::host::{self, Question};
pub use super::interpolation::Interpolation;
use super::key_list::KeyList;
use super::motion::check_frame;
use super::rotation::{Between, GreatArc, Turns, quaternion, unit, wxyz};
use super::state::Warnings;
use super::tangents::{self, NumberKeys};
use super::time::{Extrapolation, local_frame};
use crate::error::{Error, Invalid, OutOfRange, Place, Quantity, Result, TooMany};
use crate::limits::{MAX_COORDINATE, MAX_KEYS, MAX_TANGENT};
use crate::math::euler::EulerAngles;
use crate::path::Tcb;
use crate::path::camera_path::check_zoom;

/// The keys of one channel.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    channel: Channel,
    interpolation: Interpolation,
    pub(super) list: KeyList,
    before: Extrapolation,
    after: Extrapolation,
    pub(super) width: usize,
    pub(super) prepared: Prepared,
}

#[derive(Debug, Clone, PartialEq, Default)]
pub(super) enum Prepared {
    #[default]
    Nothing,
    /// As the tangents of `hermite`.
    Slopes(Vec<f64>),
    Turns(Turns),
}

impl Track {
    /// A track of at least one key, holding before and after.
    ///
    /// `values` are the keys' numbers, key by key; `shape` is for `hermite` the tangents before and
    /// after each key, per frame; for `tcb` tension, continuity and bias of each key; else empty.
    ///
    /// # Errors
    /// [`Error::Argument`], [`Error::Range`], [`Error::Limit`] with their place; [`Error::Memory`].
    pub fn new(
        channel: Channel,
        interpolation: Interpolation,
        frames: Vec<f64>,
        values: Vec<f64>,
        shape: Vec<f64>,
    ) -> Result<Self> {
        let mut track = Self {
            channel,
            interpolation,
            width: values.len() / frames.len().max(1),
            list: KeyList {
                frames,
                values,
                shape,
            },
            before: Extrapolation::Hold,
            after: Extrapolation::Hold,
            prepared: Prepared::Nothing,
        };
        track
            .check()
            .and_then(|()| track.prepare())
            .map_err(|error| track.at_channel(error))?;
        Ok(track)
    }

    /// The same track with what is shown before its first and after its last key.
    ///
    /// # Errors
    /// [`Error::Argument`] for [`Channel::Visible`] with [`Extrapolation::Offset`];
    /// [`Error::Memory`].
    pub fn with_extrapolation(
        mut self,
        before: Extrapolation,
        after: Extrapolation,
    ) -> Result<Self> {
        if self.channel == Channel::Visible && [before, after].contains(&Extrapolation::Offset) {
            let error = Error::Argument(Invalid::SwitchWithOffset);
            return Err(self.at_channel(error));
        }
        (self.before, self.after) = (before, after);
        if self.interpolation == Interpolation::Cubic {
            self.prepare().map_err(|error| self.at_channel(error))?;
        }
        Ok(self)
    }

    pub(super) fn at_channel(&self, error: Error) -> Error {
        error.at(Place::Channel((&self.channel).into()))
    }

    /// What it moves.
    #[must_use]
    pub const fn channel(&self) -> &Channel {
        &self.channel
    }

    /// How it goes from key to key.
    #[must_use]
    pub const fn interpolation(&self) -> &Interpolation {
        &self.interpolation
    }

    /// The frames of the keys.
    #[must_use]
    pub fn frames(&self) -> &[f64] {
        &self.list.frames
    }

    /// The numbers of the keys, as they were given.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.list.values
    }

    /// Tangents, or tension, continuity and bias, as they were given.
    #[must_use]
    pub fn shape(&self) -> &[f64] {
        &self.list.shape
    }

    /// What is shown before the first and after the last key.
    #[must_use]
    pub const fn extrapolation(&self) -> (Extrapolation, Extrapolation) {
        (self.before, self.after)
    }

    /// The frames of the first and of the last key.
    #[must_use]
    pub fn ends(&self) -> (f64, f64) {
        (
            self.list.frames[0],
            self.list.frames[self.list.frames.len() - 1],
        )
    }

    /// Numbers of a key: 3 for the Euler interpolations of a rotation.
    #[must_use]
    pub const fn width(&self) -> usize {
        self.width
    }

    /// Numbers of the channel: 4 for a rotation, also by Euler angles.
    pub(super) const fn channel_width(&self) -> usize {
        if self.interpolation.euler() {
            4
        } else {
            self.width
        }
    }

    pub(super) fn numbers_kept(&self) -> usize {
        self.list.frames.len() + self.list.values.len() + self.list.shape.len()
    }

    /// About how many bytes it takes; what is prepared of rotations is at most four times as much.
    pub(super) fn heap_size(&self) -> usize {
        let prepared = match &self.prepared {
            Prepared::Nothing => 0,
            Prepared::Slopes(slopes) => slopes.len(),
            Prepared::Turns(_) => 4 * self.numbers_kept(),
        };
        size_of::<Self>() + 8 * (self.numbers_kept() + prepared)
    }

    pub(super) fn renumber_deformation(&mut self, number: impl Fn(usize) -> usize) {
        if let Channel::Deformation { at, .. } = &mut self.channel {
            *at = number(*at);
        }
    }

    pub(super) fn check_count(&self) -> Result<()> {
        match self.list.len() {
            0 => Err(Invalid::NoKey.into()),
            1..=MAX_KEYS => Ok(()),
            _ => Err(TooMany::Keys.into()),
        }
    }

    pub(super) fn check(&self) -> Result<()> {
        let count = self.list.len();
        self.check_count()?;
        if self.width == 0 || self.list.values.len() != count * self.width {
            return Err(OutOfRange::KeyNumbers {
                keys: count,
                numbers: self.list.values.len(),
            }
            .into());
        }
        self.check_combination()?;
        let wanted = match self.interpolation {
            Interpolation::Hermite => 2 * self.width * count,
            Interpolation::Tcb => 3 * count,
            _ => 0,
        };
        if self.list.shape.len() != wanted {
            return Err(OutOfRange::KeyShapeNumbers {
                interpolation: (&self.interpolation).into(),
                wanted,
                keys: count,
                given: self.list.shape.len(),
            }
            .into());
        }
        for key in 0..count {
            self.check_key(key)
                .map_err(|error| error.at(Place::Key(key)))?;
        }
        Ok(())
    }

    /// The same track with other keys, of which nothing is checked or prepared.
    pub(super) fn with_list(&self, list: KeyList) -> Self {
        Self {
            channel: self.channel.clone(),
            interpolation: self.interpolation.clone(),
            list,
            prepared: Prepared::Nothing,
            ..*self
        }
    }

    pub(super) fn set_manner(
        &mut self,
        interpolation: Interpolation,
        (before, after): (Extrapolation, Extrapolation),
    ) {
        (self.interpolation, self.before, self.after) = (interpolation, before, after);
    }

    /// Refuses the combinations that the table of `docs/reference/scene.md` does not have.
    fn check_combination(&self) -> Result<()> {
        if !self.interpolation.fits(&self.channel) {
            return Err(Invalid::NotInterpolated {
                channel: self.channel.clone(),
                by: (&self.interpolation).into(),
            }
            .into());
        }
        let width = if self.interpolation.euler() {
            3
        } else {
            self.channel.own_width().unwrap_or(self.width)
        };
        if width != self.width {
            return Err(OutOfRange::KeyWidth {
                wanted: width,
                given: self.width,
            }
            .into());
        }
        Ok(())
    }

    pub(super) fn check_key(&self, key: usize) -> Result<()> {
        let frame = self.list.frames[key];
        check_frame(frame)?;
        if key > 0 && !(self.list.frames[key - 1] < frame) {
            return Err(Invalid::KeyOrder.into());
        }
        let value = &self.list.values[key * self.width..][..self.width];
        for &number in value {
            if !number.is_finite() {
                return Err(Invalid::NotFinite(Quantity::Value).into());
            }
            if number.abs() > MAX_COORDINATE {
                return Err(OutOfRange::Exceeds(Quantity::Value, MAX_COORDINATE).into());
            }
        }
        let (low, high) = self.channel.range();
        let inside = value.iter().all(|v| (low..=high).contains(v));
        let fits = match self.channel {
            Channel::Rotation if !self.interpolation.euler() => {
                unit(quaternion(value))?;
                true
            }
            Channel::Zoom => {
                check_zoom(value[0])?;
                true
            }
            Channel::Visible => value[0] == 0.0 || value[0] == 1.0,
            Channel::Cone => inside && value[0] <= value[1],
            Channel::Deformation { .. } => {
                value
                    .iter()
                    .try_for_each(|&v| crate::deform::check_number(v))?;
                true
            }
            _ => inside,
        };
        if !fits {
            return Err(OutOfRange::ChannelValue.into());
        }
        match self.interpolation {
            Interpolation::Tcb => self.tcb(key).check(),
            Interpolation::Hermite => {
                let tangents = &self.list.shape[2 * self.width * key..][..2 * self.width];
                if tangents.iter().all(|slope| slope.abs() <= MAX_TANGENT) {
                    return Ok(());
                }
                Err(OutOfRange::Tangent.into())
            }
            _ => Ok(()),
        }
    }

    fn tcb(&self, key: usize) -> Tcb {
        match self.list.shape.get(3 * key..3 * key + 3) {
            Some(&[tension, continuity, bias]) => Tcb::new(tension, continuity, bias),
            _ => Tcb::default(),
        }
    }

    pub(super) fn prepare(&mut self) -> Result<()> {
        let keys = NumberKeys {
            frames: &self.list.frames,
            values: &self.list.values,
            width: self.width,
        };
        let tcb = |key| self.tcb(key);
        let plain = |_| Tcb::default();
        let turns = |between| Turns::new(&self.list.frames, &self.list.values, between, tcb);
        let rotation = self.channel == Channel::Rotation;
        self.prepared = match self.interpolation {
            Interpolation::Step | Interpolation::Hermite | Interpolation::Host(_) if rotation => {
                Prepared::Turns(turns(Between::Keys)?)
            }
            Interpolation::Linear
            | Interpolation::Ramp
            | Interpolation::Sine
            | Interpolation::Parabolic
                if rotation =>
            {
                Prepared::Turns(turns(Between::Arcs)?)
            }
            Interpolation::Tcb if rotation => Prepared::Turns(turns(Between::Smooth)?),
            Interpolation::CatmullRom if rotation => {
                let turns =
                    Turns::new(&self.list.frames, &self.list.values, Between::Smooth, plain)?;
                Prepared::Turns(turns)
            }
            Interpolation::CatmullRom | Interpolation::EulerCatmullRom => {
                Prepared::Slopes(tangents::tcb(keys, plain)?)
            }
            Interpolation::Tcb => Prepared::Slopes(tangents::tcb(keys, tcb)?),
            Interpolation::Cubic => {
                let ends = self.list.values.len() - self.width;
                let repeats = [self.before, self.after].contains(&Extrapolation::Repeat);
                let periodic =
                    repeats && self.list.values[..self.width] == self.list.values[ends..];
                Prepared::Slopes(tangents::cubic(keys, periodic)?)
            }
            _ => Prepared::Nothing,
        };
        Ok(())
    }

    /// The section that holds a frame, and the share of it that is gone, exactly 0 at a key.
    fn locate(&self, frame: f64) -> (usize, f64) {
        let behind = self.list.frames.partition_point(|&key| key <= frame);
        let section = behind.max(1) - 1;
        let Some(&next) = self.list.frames.get(section + 1) else {
            return (section, 0.0);
        };
        let from = self.list.frames[section];
        (section, (frame - from) / (next - from))
    }

    /// The section that holds a frame and the share of the way that is gone, where the way is
    /// straight or a great arc. The section found last (`hint`, of whatever track) is tried first:
    /// tracks that were recorded together have their keys at the same frames.
    #[inline]
    pub(super) fn straight(&self, frame: f64, hint: &mut usize) -> Option<(usize, f64)> {
        use Interpolation::{Linear, Parabolic, Ramp, Sine, Step};
        if !matches!(self.interpolation, Step | Linear | Ramp | Sine | Parabolic) {
            return None;
        }
        if let Some(&[from, next]) = self.list.frames.get(*hint..*hint + 2)
            && from <= frame
            && frame < next
        {
            return Some((*hint, self.share((frame - from) / (next - from))));
        }
        let (first, last) = self.ends();
        let (local, rounds) = local_frame(frame, first, last, self.before, self.after);
        if rounds != 0.0 {
            return None;
        }
        let (section, u) = self.locate(local);
        *hint = section;
        Some((section, self.share(u)))
    }

    /// The great arc of a section of a rotation, if it is one; the last key stays.
    #[inline]
    pub(super) fn arc(&self, section: usize) -> Option<GreatArc> {
        match &self.prepared {
            Prepared::Turns(turns) => turns.arc(section),
            _ => None,
        }
    }

    pub(super) const fn asks_host(&self) -> bool {
        matches!(self.interpolation, Interpolation::Host(_))
    }

    /// The numbers at any finite frame, as many as a key has.
    #[inline]
    pub(super) fn value<const WIDTH: usize>(
        &self,
        frame: f64,
        warnings: &mut Warnings,
    ) -> [f64; WIDTH] {
        let mut numbers = [0.0; WIDTH];
        self.numbers(frame, &mut numbers, warnings);
        numbers
    }

    /// The numbers at any finite frame; `out` has the width of a key.
    // Inlined, so that loops over three numbers are unrolled.
    #[inline]
    pub fn numbers(&self, frame: f64, out: &mut [f64], warnings: &mut Warnings) {
        let (first, last) = self.ends();
        let (local, rounds) = local_frame(frame, first, last, self.before, self.after);
        let (section, u) = self.locate(local);
        self.between(local, section, u, out, warnings);
        if rounds != 0.0 {
            let ends = self.list.values.len() - self.width;
            for (at, number) in out.iter_mut().enumerate() {
                *number += rounds * (self.list.values[ends + at] - self.list.values[at]);
            }
        }
    }

    #[inline]
    fn between(
        &self,
        frame: f64,
        section: usize,
        u: f64,
        out: &mut [f64],
        warnings: &mut Warnings,
    ) {
        let width = out.len();
        let from = &self.list.values[section * width..][..width];
        if let Interpolation::Host(name) = &self.interpolation {
            if !self.ask(name, frame, out, warnings) {
                out.copy_from_slice(from);
            }
            return;
        }
        out.copy_from_slice(from);
        if u == 0.0 {
            return;
        }
        let to = &self.list.values[(section + 1) * width..][..width];
        let slopes = match (&self.prepared, &self.interpolation) {
            (Prepared::Slopes(slopes), _) => slopes,
            (_, Interpolation::Hermite) => &self.list.shape,
            _ => {
                let u = self.share(u);
                for (out, to) in out.iter_mut().zip(to) {
                    *out = *out * (1.0 - u) + to * u;
                }
                return;
            }
        };
        let step = self.list.frames[section + 1] - self.list.frames[section];
        let leave = &slopes[(2 * section + 1) * width..][..width];
        let reach = &slopes[(2 * section + 2) * width..][..width];
        for (at, out) in out.iter_mut().enumerate() {
            let rise = to[at] - *out;
            let (r, s) = (step * leave[at], step * reach[at]);
            let (b, a) = (3.0 * rise - 2.0 * r - s, r + s - 2.0 * rise);
            *out += ((a * u + b) * u + r) * u;
        }
    }

    /// The share of the way that is gone when the share `u` of the time is.
    fn share(&self, u: f64) -> f64 {
        match self.interpolation {
            Interpolation::Step => 0.0,
            Interpolation::Ramp => (3.0 - 2.0 * u) * u * u,
            Interpolation::Sine => {
                let sin = (std::f64::consts::FRAC_PI_2 * u).sin();
                sin * sin
            }
            Interpolation::Parabolic if u <= 0.5 => 2.0 * u * u,
            Interpolation::Parabolic => 1.0 - 2.0 * (1.0 - u) * (1.0 - u),
            _ => u,
        }
    }

    fn ask(&self, name: &str, frame: f64, out: &mut [f64], warnings: &mut Warnings) -> bool {
        let Some(function) = host::function(name) else {
            warnings.add(|| Invalid::NotRegistered {
                channel: (&self.channel).into(),
                name: name.into(),
            });
            return false;
        };
        let question = Question {
            frames: &self.list.frames,
            values: &self.list.values,
            width: self.width,
            frame,
        };
        let answered = function(question, out);
        let usable = |number: &f64| number.abs() <= MAX_COORDINATE;
        if answered && out.iter().all(usable) {
            return true;
        }
        warnings.add(|| {
            let (channel, name) = ((&self.channel).into(), name.into());
            match answered {
                true => Invalid::InterpolationGave { channel, name },
                false => Invalid::InterpolationFailed { channel, name },
            }
        });
        false
    }

    /// The orientation of a rotation track at any finite frame, of length 1.
    #[must_use]
    pub fn rotation(&self, frame: f64, warnings: &mut Warnings) -> DQuat {
        let Prepared::Turns(turns) = &self.prepared else {
            let [yaw, pitch, roll] = self.value(frame, warnings).map(f64::to_radians);
            return EulerAngles { yaw, pitch, roll }.quaternion().normalize();
        };
        let (first, last) = self.ends();
        let (local, rounds) = local_frame(frame, first, last, self.before, self.after);
        let (section, u) = self.locate(local);
        let host = matches!(self.interpolation, Interpolation::Host(_));
        let q = if host || (u != 0.0 && self.interpolation == Interpolation::Hermite) {
            let mut numbers = wxyz(turns.key(section));
            self.between(local, section, u, &mut numbers, warnings);
            // Through zero there is no direction: the key before holds.
            unit(quaternion(&numbers)).unwrap_or_else(|_| {
                if host {
                    warnings.add(|| Invalid::RotationZero);
                }
                turns.key(section)
            })
        } else if u == 0.0 {
            turns.key(section)
        } else {
            turns.between(section, self.share(u))
        };
        if rounds == 0.0 {
            q
        } else {
            turns.offset(q, rounds)
        }
    }
}

#[cfg(test)]
#[path = "track_tests.rs"]
mod tests;
