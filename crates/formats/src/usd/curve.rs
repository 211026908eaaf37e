//! The values of an attribute over time: time samples, between which numbers go straight, or one
//! value for all times.

use glam::DQuat;
use vides_document::error::{EngineError, vec_with_room};
use vides_engine::math::quaternion::slerp_shortest;
use vides_engine::scene::{Channel, Interpolation, Track};

use super::lexer::{Lexer, Token, unescaped};
use super::motion_out::JUST_BEFORE;
use super::stage::{Attribute, Prim, Stage};
use crate::error::{Cause, Result, Wanted};

/// Values of `width` numbers at times; without times one value for all.
#[derive(Debug, Clone, Default)]
pub(super) struct Curve {
    pub(super) times: Vec<f64>,
    pub(super) values: Vec<f64>,
    pub(super) width: usize,
}

impl Curve {
    pub(super) fn constant(values: &[f64]) -> Self {
        Self {
            times: Vec::new(),
            values: values.to_vec(),
            width: values.len(),
        }
    }

    /// Whether it is one value for all times.
    pub(super) fn rests(&self) -> bool {
        self.times.is_empty()
    }

    /// The first value.
    pub(super) fn first(&self) -> &[f64] {
        &self.values[..self.width]
    }

    /// The section that holds a time, and the share of it that is gone.
    fn locate(&self, time: f64) -> (&[f64], &[f64], f64) {
        let last = self.values.len() / self.width - 1;
        let behind = self.times.partition_point(|&at| at <= time);
        let from = behind.saturating_sub(1).min(last);
        // Before the first sample and after the last one these hold.
        let to = if behind == 0 { 0 } else { behind.min(last) };
        let value = |at: usize| &self.values[at * self.width..][..self.width];
        let share = if from == to {
            0.0
        } else {
            (time - self.times[from]) / (self.times[to] - self.times[from])
        };
        (value(from), value(to), share)
    }

    /// The value at a time; of a width that is not the curve's what lies beyond is 0.
    pub(super) fn at<const N: usize>(&self, time: f64) -> [f64; N] {
        let (from, to, share) = self.locate(time);
        let mut out = [0.0; N];
        for (out, (from, to)) in out.iter_mut().zip(from.iter().zip(to)) {
            *out = from + (to - from) * share;
        }
        out
    }

    /// The rotation at a time, of values w x y z of length 1.
    pub(super) fn rotation(&self, time: f64) -> DQuat {
        let (from, to, share) = self.locate(time);
        slerp_shortest(quaternion(from), quaternion(to), share)
    }

    /// Changes each value.
    pub(super) fn map(&mut self, change: impl Fn(&mut [f64])) {
        self.values.chunks_exact_mut(self.width).for_each(change);
    }

    /// Leaves only the keys of a step, if it is one as we write it: each value is repeated just
    /// before the next.
    fn as_step(&mut self) -> bool {
        let value = |at: usize| &self.values[at * self.width..][..self.width];
        let jumps = |at: usize| {
            let gap = self.times.get(at + 1).map(|next| next - self.times[at]);
            gap.is_some_and(|gap| gap <= 2.0 * JUST_BEFORE)
        };
        let all = 0..self.times.len();
        let steps = (1..self.times.len()).all(|at| jumps(at - 1) || value(at) == value(at - 1));
        let keys: Vec<usize> = all.filter(|&at| !jumps(at)).collect();
        if !steps || keys.len() == self.times.len() {
            return false;
        }
        for (kept, &at) in keys.iter().enumerate() {
            self.times[kept] = self.times[at];
            let value = at * self.width..(at + 1) * self.width;
            self.values.copy_within(value, kept * self.width);
        }
        self.times.truncate(keys.len());
        self.values.truncate(keys.len() * self.width);
        true
    }

    /// The same as a track.
    pub(super) fn into_track(
        mut self,
        channel: Channel,
        clock: Clock,
    ) -> Result<Track, EngineError> {
        let by = if channel == Channel::Visible || self.as_step() {
            Interpolation::Step
        } else {
            Interpolation::Linear
        };
        for time in &mut self.times {
            *time = clock.frame(*time);
        }
        Track::new(channel, by, self.times, self.values, Vec::new())
    }
}

/// Turns time codes into frames; those before the start are before frame 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Clock {
    /// Frames per time code.
    pub(super) rate: f64,
    /// The number of frame 1 in the file.
    pub(super) start: f64,
}

impl Clock {
    pub(super) fn frame(self, code: f64) -> f64 {
        code * self.rate - self.start + 1.0
    }
}

/// A quaternion of w x y z.
pub(super) fn quaternion(wxyz: &[f64]) -> DQuat {
    DQuat::from_xyzw(wxyz[1], wxyz[2], wxyz[3], wxyz[0])
}

/// All times of curves, in order, each once.
pub(super) fn all_times<'c>(curves: impl Iterator<Item = &'c Curve> + Clone) -> Result<Vec<f64>> {
    let mut times = vec_with_room(curves.clone().map(|curve| curve.times.len()).sum())?;
    times.extend(curves.flat_map(|curve| &curve.times));
    times.sort_unstable_by(f64::total_cmp);
    times.dedup();
    Ok(times)
}

impl<'a> Stage<'a> {
    /// An attribute of a prim: its samples, else its value.
    pub(super) fn attribute<'s>(
        &'s self,
        prim: &'s Prim<'a>,
        name: &str,
    ) -> Option<&'s Attribute<'a>> {
        let mut all = prim.attributes.iter().filter(|found| found.name == name);
        let first = all.next()?;
        Some(if first.samples {
            first
        } else {
            all.find(|found| found.samples).unwrap_or(first)
        })
    }

    fn lexer_at(&self, attribute: &Attribute<'_>) -> Lexer<'a> {
        self.lexer.from(attribute.at)
    }

    /// Calls `take` at the value of each sample with its time, or of the one value with none.
    fn each_value(
        &self,
        attribute: &Attribute<'a>,
        take: &mut dyn FnMut(&mut Lexer<'a>, Option<f64>) -> Result<()>,
    ) -> Result<()> {
        let mut lexer = self.lexer_at(attribute);
        if !attribute.samples {
            return take(&mut lexer, None);
        }
        lexer.need("{")?;
        while !lexer.sign(b'}') {
            let time = lexer.number()?;
            lexer.need(":")?;
            take(&mut lexer, Some(time))?;
            if !lexer.sign(b',') {
                lexer.need("}")?;
                break;
            }
        }
        Ok(())
    }

    /// A curve of `width` numbers a value; none without an attribute, or one that says `None`.
    ///
    /// # Errors
    /// [`Wanted::Numbers`], [`Cause::Order`], those of [`Lexer::numbers`].
    pub(super) fn curve(&self, prim: &Prim<'a>, name: &str, width: usize) -> Result<Option<Curve>> {
        let Some(attribute) = self.attribute(prim, name) else {
            return Ok(None);
        };
        let mut curve = Curve {
            width,
            ..Curve::default()
        };
        let mut blocked = false;
        self.each_value(attribute, &mut |lexer, time| {
            let (before, length) = (*lexer, curve.values.len());
            if !lexer.numbers(&mut curve.values)? {
                blocked = true;
                return Ok(());
            }
            if curve.values.len() - length != width {
                return Err(before.expected(Wanted::Numbers(width)));
            }
            if let Some(time) = time {
                let last = curve.times.last().copied();
                if last.is_some_and(|last| !(last < time)) {
                    return Err(before.wrong(Cause::Order));
                }
                curve.times.try_reserve(2)?;
                // What is blocked keeps the value before.
                if let Some(last) = last.filter(|_| blocked) {
                    curve.values.try_reserve(width)?;
                    curve.values.extend_from_within(length - width..length);
                    curve.values[length..].rotate_right(width);
                    curve
                        .times
                        .push((time - JUST_BEFORE).max((last + time) / 2.0));
                }
                blocked = false;
                curve.times.push(time);
            }
            Ok(())
        })?;
        Ok((!curve.values.is_empty()).then_some(curve))
    }

    /// The one value of an attribute, of samples the first, and its place.
    ///
    /// # Errors
    /// Those of [`Lexer::numbers`].
    pub(super) fn list(
        &self,
        prim: &Prim<'a>,
        name: &str,
    ) -> Result<Option<(Lexer<'a>, Vec<f64>)>> {
        let Some(attribute) = self.attribute(prim, name) else {
            return Ok(None);
        };
        let mut found = None;
        self.each_value(attribute, &mut |lexer, _| {
            if found.is_some() {
                return lexer.skip_value();
            }
            let (before, mut numbers) = (*lexer, Vec::new());
            if lexer.numbers(&mut numbers)? {
                found = Some((before, numbers));
            }
            Ok(())
        })?;
        Ok(found)
    }

    /// The value of a token; none without.
    ///
    /// # Errors
    /// [`Wanted::Text`].
    pub(super) fn token(&self, prim: &Prim<'a>, name: &str) -> Result<Option<&'a str>> {
        let mut found = None;
        if let Some(attribute) = self.attribute(prim, name) {
            self.each_value(attribute, &mut |lexer, _| {
                let text = lexer.text()?;
                found.get_or_insert(text);
                Ok(())
            })?;
        }
        Ok(found)
    }

    /// A token over time: 1 where it is not `off`. It holds from one sample to the next.
    ///
    /// # Errors
    /// [`Wanted::Text`], [`Cause::Order`].
    pub(super) fn switch(&self, prim: &Prim<'a>, name: &str, off: &str) -> Result<Option<Curve>> {
        let Some(attribute) = self.attribute(prim, name) else {
            return Ok(None);
        };
        let mut curve = Curve {
            width: 1,
            ..Curve::default()
        };
        self.each_value(attribute, &mut |lexer, time| {
            let before = *lexer;
            if lexer.skip_word("None") {
                return Ok(());
            }
            let on = lexer.text()? != off;
            if curve
                .times
                .last()
                .is_some_and(|last| time.is_none_or(|time| !(*last < time)))
            {
                return Err(before.wrong(Cause::Order));
            }
            curve.values.try_reserve(1)?;
            curve.values.push(f64::from(u8::from(on)));
            curve.times.try_reserve(1)?;
            curve.times.extend(time);
            Ok(())
        })?;
        Ok((!curve.values.is_empty()).then_some(curve))
    }

    /// The texts of an array, at most `most`.
    ///
    /// # Errors
    /// [`Wanted::List`], [`Wanted::Text`], [`Cause::Long`].
    pub(super) fn texts(
        &self,
        prim: &Prim<'a>,
        name: &str,
        most: usize,
    ) -> Result<(Lexer<'a>, Vec<String>)> {
        let mut texts = Vec::new();
        let Some(attribute) = self.attribute(prim, name).filter(|found| !found.samples) else {
            return Ok((self.lexer, texts));
        };
        let mut lexer = self.lexer_at(attribute);
        let start = lexer;
        if lexer.skip_word("None") {
            return Ok((start, texts));
        }
        if !lexer.sign(b'[') {
            return Err(lexer.expected(Wanted::List));
        }
        while !lexer.sign(b']') {
            if texts.len() >= most {
                return Err(lexer.wrong(Cause::Long));
            }
            texts.push(unescaped(lexer.text()?));
            if !lexer.sign(b',') {
                lexer.need("]")?;
                break;
            }
        }
        Ok((start, texts))
    }
}

impl Lexer<'_> {
    /// Whether the next is this word, which is taken then.
    fn skip_word(&mut self, word: &str) -> bool {
        let mut ahead = *self;
        let found = matches!(ahead.next(), Ok(Token::Word(found)) if found == word);
        if found {
            *self = ahead;
        }
        found
    }
}

pub(super) fn clamped(mut curve: Curve, most: f64) -> Curve {
    let numbers = curve.values.iter_mut();
    numbers.for_each(|number| *number = number.clamp(0.0, most));
    curve
}
