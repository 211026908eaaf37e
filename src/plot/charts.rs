//! Charts of what changes over the frames.

use crate::tools::check::FindingKind;
use crate::tools::profile::{self, Quantity};

use super::svg::{Anchor, Spot, Svg};
use super::{Film, MARGIN, POSES, WIDTH};

/// Room for the numbers on the left, the name above and the frames below.
const SCALE: f64 = 48.0;
const NAME: f64 = 26.0;
const FRAMES: f64 = 44.0;
const HEIGHT: f64 = 84.0;

/// A longer film is sampled at this many frames.
const FRAMES_LOOKED_AT: usize = 500_000;

/// A chart; `kinds` are the kinds of findings marked in it.
pub(super) struct Chart {
    name: &'static str,
    of_way: bool,
    values: Vec<Spot>,
    kinds: &'static [FindingKind],
}

pub(super) fn height(charts: usize) -> f64 {
    charts as f64 * (HEIGHT + NAME) + FRAMES
}

pub(super) fn of(film: &Film<'_>) -> crate::Result<Vec<Chart>> {
    let (info, space) = (film.document.info(), film.document.path().space);
    // Fine enough that events within a frame show up in a long film.
    let poses = profile::samples(film.document.sampler()?, FRAMES_LOOKED_AT)?;
    let object = film.clearance.as_ref();
    let plotted = profile::Film {
        samples: &poses,
        fps: info.fps,
        up: space.up,
        object,
    };
    let mut charts = Vec::new();
    for quantity in Quantity::ALL {
        let (name, of_way) = match quantity {
            // It only rises, at the rate the speed shows.
            Quantity::Distance => continue,
            Quantity::Speed => ("Speed, length per second", true),
            Quantity::Acceleration => ("Acceleration, length per second squared", true),
            Quantity::Turning => ("Turning, degrees per second", false),
            Quantity::Roll => ("Roll, degrees", false),
            Quantity::Zoom => ("Zoom, mm", false),
            Quantity::Clearance if object.is_none() => continue,
            Quantity::Clearance => ("Clearance, length", true),
        };
        charts.push(Chart {
            name,
            of_way,
            values: profile::with_peaks(quantity.of(&plotted)?, POSES),
            kinds: quantity.findings(),
        });
    }
    Ok(charts)
}

pub(super) fn draw(svg: &mut Svg, film: &Film<'_>, charts: &[Chart], top: f64) {
    let (left, width) = (MARGIN + SCALE, WIDTH - 2.0 * MARGIN - SCALE);
    let gaps = film.frames.saturating_sub(1).max(1) as f64;
    let x = |frame: f64| left + width * (frame - 1.0) / gaps;
    for (k, chart) in charts.iter().enumerate() {
        let y = top + k as f64 * (HEIGHT + NAME) + NAME;
        svg.group(&format!("chart-{k}"), "", |svg| {
            one(svg, film, chart, &x, (left, y, width));
        });
    }
    let bottom = top + charts.len() as f64 * (HEIGHT + NAME);
    let quiet = format!("fill=\"{}\"", film.style.quiet);
    let first = film.document.number_of_frame(1.0);
    let step = scale(gaps / 3.0).0.max(1.0);
    let mut number = (first / step).ceil() * step;
    while number <= first + gaps {
        let place = x(number - first + 1.0);
        let text = format!("{number:.0}");
        svg.text((place, bottom + 18.0), Anchor::Middle, &text, &quiet);
        number += step;
    }
    svg.text(
        (left + width / 2.0, bottom + 35.0),
        Anchor::Middle,
        "Frame",
        &quiet,
    );
}

fn one(
    svg: &mut Svg,
    film: &Film<'_>,
    chart: &Chart,
    x: &dyn Fn(f64) -> f64,
    (left, top, width): (f64, f64, f64),
) {
    let style = film.style;
    let colour = if chart.of_way { style.way } else { style.view };
    let name = format!("fill=\"{colour}\" font-weight=\"bold\"");
    svg.text((left, top - 7.0), Anchor::Start, chart.name, &name);
    // A band behind every other section.
    let sections = film.document.timeline(|timeline| {
        let all = (0..timeline.section_count()).map(|k| (k, timeline.section(k)));
        all.filter(|(_, section)| section.frames > 0)
            .collect::<Vec<_>>()
    });
    if let (Ok(sections), Ok(sampler)) = (sections, film.document.sampler()) {
        for (number, section) in sections.iter().step_by(2) {
            let first = sampler.first_frame(*number) as f64 - 1.0;
            let (from, to) = (x(first), x(first + section.frames as f64));
            svg.rectangle(
                (from, top),
                to - from,
                HEIGHT,
                &format!("fill=\"{}\"", style.band),
            );
        }
    }
    for finding in film
        .found
        .iter()
        .filter(|finding| chart.kinds.contains(&finding.kind))
    {
        let (from, to) = (x(finding.first_frame), x(finding.last_frame));
        let wide = (to - from).max(2.0);
        let fill = format!("fill=\"{}\" opacity=\"0.25\"", style.wrong);
        svg.rectangle((0.5 * (from + to - wide), top), wide, HEIGHT, &fill);
    }
    let values = chart.values.iter().map(|(_, value)| *value);
    let (low, high) = values.fold((0.0_f64, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
    let (step, decimals) = scale((high - low).max(1e-9 * high.abs()));
    let (low, mut high) = (
        (low / step).floor() * step,
        (high / step - 1e-9).ceil() * step,
    );
    if high <= low {
        high = low + step;
    }
    let y = |value: f64| top + HEIGHT - HEIGHT * (value - low) / (high - low);
    let count = ((high - low) / step).round() as i32;
    for k in 0..=count {
        let value = low + step * f64::from(k);
        let hair = format!("stroke=\"{}\"", style.hair);
        svg.line((left, y(value)), (left + width, y(value)), &hair);
        let text = format!("{value:.decimals$}");
        let quiet = format!("fill=\"{}\"", style.quiet);
        svg.text((left - 8.0, y(value) + 4.0), Anchor::End, &text, &quiet);
    }
    let spots: Vec<Spot> = chart.values.iter().map(|&(f, v)| (x(f), y(v))).collect();
    if spots.len() > 1 {
        svg.polyline(&spots, &format!("stroke=\"{colour}\" stroke-width=\"1.8\""));
    }
}

/// A round step, two to four of which span a range, and its decimals.
fn scale(range: f64) -> (f64, usize) {
    if !(range > 1e-9 && range.is_finite()) {
        return (1.0, 0);
    }
    let power = 10_f64.powf((range / 4.0).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power);
    let step = steps
        .into_iter()
        .find(|step| range / step <= 4.0)
        .unwrap_or(10.0 * power);
    let decimals = (-(step.log10() + 1e-9).floor()).clamp(0.0, 12.0) as usize;
    (step, decimals)
}
