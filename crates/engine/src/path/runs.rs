//! Frames in any order, section by section.

use super::section_sampler::SectionSampler;
use crate::error::{Result, vec_with_room};

/// Some of ascending frames: one at which the camera rests in the key before the section of this
/// index, or those between the keys of a section.
pub(super) enum Run<'a, T> {
    Held(usize, &'a mut T),
    Moved(usize, &'a [f64], &'a mut [T]),
}

/// Goes through ascending frames of a path section by section; `ends` are those of the sections,
/// `last` is its last frame. A section begins after its first key and ends before its last one;
/// `with_keys`: it begins with its first key, and the last one of all ends with its last.
#[allow(clippy::cast_precision_loss)]
pub(super) fn each_run<T>(
    sections: &[SectionSampler],
    ends: &[usize],
    last: f64,
    frames: &[f64],
    mut results: &mut [T],
    with_keys: bool,
    mut fill: impl FnMut(Run<'_, T>) -> Result<()>,
) -> Result<()> {
    let done = |end: usize, frame: f64| {
        let end = end as f64;
        end <= frame && !(with_keys && end == last)
    };
    let (mut index, mut at) = (0, 0);
    while let Some(&frame) = frames.get(at) {
        let past = |index: usize| ends.get(index).is_some_and(|&end| done(end, frame));
        // Mostly it is the next section.
        if past(index) {
            index += 1;
        }
        if past(index) {
            index += ends[index..].partition_point(|&end| done(end, frame));
        }
        let inside = |start: f64| start < frame || (with_keys && start == frame);
        let section = sections.get(index);
        let Some(section) = section.filter(|s| inside(s.start as f64)) else {
            let (held, rest) = results.split_at_mut(1);
            fill(Run::Held(index, &mut held[0]))?;
            (results, at) = (rest, at + 1);
            continue;
        };
        section.fetch();
        let rest = &frames[at..];
        let count = rest.iter().position(|&frame| done(ends[index], frame));
        let count = count.unwrap_or(rest.len());
        if count < rest.len() {
            SectionSampler::fetch_next(&sections[index + 1..]);
        }
        let (moved, rest) = results.split_at_mut(count);
        fill(Run::Moved(index, &frames[at..at + count], moved))?;
        (results, at) = (rest, at + count);
    }
    Ok(())
}

/// Frames that are put in order at once: enough for several of each section of a long path.
const SORTED: usize = 1 << 16;

/// Has `fill` give the results of ascending frames, in whatever order they are asked for: each
/// section is then read once, and its frames are computed side by side.
pub(super) fn in_order<T: Copy + Default>(
    frames: &[f64],
    results: &mut [T],
    mut fill: impl FnMut(&[f64], &mut [T]) -> Result<()>,
) -> Result<()> {
    if frames.is_sorted() {
        return fill(frames, results);
    }
    let most = frames.len().min(SORTED);
    let mut order: Vec<(f64, u32)> = vec_with_room(most)?;
    let mut ascending: Vec<f64> = vec_with_room(most)?;
    let mut found: Vec<T> = vec_with_room(most)?;
    found.resize(most, T::default());
    for (frames, results) in frames.chunks(SORTED).zip(results.chunks_mut(SORTED)) {
        order.clear();
        order.extend(frames.iter().copied().zip(0..));
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        ascending.clear();
        ascending.extend(order.iter().map(|(frame, _)| frame));
        let found = &mut found[..frames.len()];
        fill(&ascending, found)?;
        for (result, (_, at)) in found.iter().zip(&order) {
            results[*at as usize] = *result;
        }
    }
    Ok(())
}
