//! Frames per second of a file that does not say: by the times of its keys.

use vides_document::error::vec_with_room;
use vides_document::mesh::gltf::Container;
use vides_engine::limits::MAX_KEYS;

use crate::content::{DEFAULT_FPS, Recording};
use crate::error::Result;
use crate::tree::At;

/// Rates that are tried where keys are farther apart than frames.
const USUAL: [f64; 4] = [DEFAULT_FPS, 24.0, 30.0, 60.0];

/// How far a key may be from a frame: 32 bits leave less over an hour.
const NEAR: f64 = 0.05;

/// The rate at which the keys of the sampler with most of them are at whole frames.
pub(super) fn guessed(container: &Container<'_>, clips: &[At<'_>]) -> Result<Option<f64>> {
    let mut times = None;
    for clip in clips {
        let Some(samplers) = clip.get("samplers") else {
            continue;
        };
        for sampler in samplers.list()? {
            // What cannot be read is reported with its track.
            let input = sampler.get("input");
            let input = input.and_then(|at| container.accessor(at.value, MAX_KEYS).ok());
            let most = times.as_ref();
            let more = |count| most.is_none_or(|(_, most)| count > *most);
            if let Some(input) = input.filter(|input| input.width() == 1)
                && more(input.count())
            {
                let count = input.count();
                times = Some((input, count));
            }
        }
    }
    let Some((input, count)) = times else {
        return Ok(None);
    };
    let mut seconds: Vec<f64> = vec_with_room(count)?;
    seconds.extend((0..count).map(|key| input.number(key, 0)));
    let mut recording = Recording {
        seconds: Some(seconds),
        ..Recording::default()
    };
    let by_steps = recording.rate();
    let seconds = recording.seconds.take().unwrap_or_default();
    let whole = |rate: &f64| {
        let steps = seconds.windows(2).map(|pair| (pair[1] - pair[0]) * rate);
        steps
            .into_iter()
            .all(|step| (step - step.round()).abs() < NEAR)
    };
    Ok(by_steps.into_iter().chain(USUAL).find(whole))
}
