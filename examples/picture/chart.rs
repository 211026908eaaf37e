//! Speed and turning over the frames of the film.

use crate::film::{Pace, Piece};
use crate::style::{HAIR, INK, QUIET, VIEW, WAY};
use crate::svg::{Anchor, Spot, Svg};

/// Room for the numbers at the left of the charts.
const SCALE_WIDTH: f64 = 44.0;

/// Height of the strip with the sections' numbers.
const STRIP: f64 = 22.0;

/// Height of the line with a chart's name above it.
const NAME: f64 = 24.0;

/// Room for the frames' numbers below.
const FRAMES_HEIGHT: f64 = 38.0;

/// What the charts show.
pub(crate) struct Film<'a> {
    pub(crate) pieces: &'a [Piece],
    pub(crate) paces: &'a [Pace],
    /// All frames.
    pub(crate) frames: usize,
    /// Number of the first frame in the user's film.
    pub(crate) first_frame: i64,
}

/// Where frames lie from left to right.
struct Columns {
    left: f64,
    width: f64,
    frames: usize,
}

impl Columns {
    /// Frame 1 at the left end, the last one at the right.
    fn x(&self, frame: f64) -> f64 {
        let gaps = self.frames.saturating_sub(1).max(1) as f64;
        self.left + self.width * (frame - 1.0) / gaps
    }

    /// A piece fills the gaps that lead to its frames.
    fn piece(&self, piece: &Piece) -> (f64, f64) {
        let before = piece.first as f64 - 1.0;
        (self.x(before), self.x(before + piece.frames as f64))
    }
}

/// Draws both charts below each other into a rectangle.
pub(crate) fn draw(svg: &mut Svg, film: &Film<'_>, (x, y): Spot, width: f64, height: f64) {
    let columns = Columns {
        left: x + SCALE_WIDTH,
        width: width - SCALE_WIDTH,
        frames: film.frames,
    };
    let each = (height - STRIP - FRAMES_HEIGHT) / 2.0 - NAME;
    let speed_top = y + STRIP + NAME;
    let turning_top = speed_top + each + NAME;
    let bottom = turning_top + each;

    sections(
        svg,
        film,
        &columns,
        y,
        [(speed_top, each), (turning_top, each)],
    );
    let speeds: Vec<Spot> = film.paces.iter().map(|p| (p.frame, p.speed)).collect();
    let turnings: Vec<Spot> = film.paces.iter().map(|p| (p.frame, p.turning)).collect();
    svg.group("speed", "", |svg| {
        let name = "Speed, length per second";
        chart(svg, &columns, name, &speeds, WAY, (speed_top, each));
    });
    svg.group("turning", "", |svg| {
        let name = "Turning, degrees per frame";
        chart(svg, &columns, name, &turnings, VIEW, (turning_top, each));
    });
    frames(svg, film, &columns, bottom);
}

/// Bands behind the charts and numbers above them.
fn sections(svg: &mut Svg, film: &Film<'_>, columns: &Columns, y: f64, charts: [(f64, f64); 2]) {
    svg.group("sections", "", |svg| {
        for piece in film.pieces {
            let (from, to) = columns.piece(piece);
            let colour = match (piece.number, piece.moves) {
                (None, _) => "#e6e8eb",
                (Some(_), true) => "#eef4fb",
                (Some(_), false) => "#fcf0e8",
            };
            let fill = format!("fill=\"{colour}\"");
            svg.rectangle((from, y), to - from, STRIP, &fill);
            for (top, height) in charts {
                svg.rectangle((from, top), to - from, height, &fill);
            }
            let label = piece
                .number
                .map_or(String::new(), |number| number.to_string());
            if to - from >= 8.0 * label.len() as f64 + 4.0 {
                let place = ((from + to) / 2.0, y + 15.5);
                let bold = format!("fill=\"{INK}\" font-weight=\"bold\"");
                svg.text(place, Anchor::Middle, &label, &bold);
            }
        }
        // Where one piece ends and the next begins.
        for piece in film.pieces.iter().skip(1) {
            let (from, _) = columns.piece(piece);
            let stroke = "stroke=\"#ffffff\" stroke-width=\"1.5\" stroke-linecap=\"butt\"";
            svg.line((from, y), (from, y + STRIP), stroke);
            for (top, height) in charts {
                svg.line((from, top), (from, top + height), stroke);
            }
        }
    });
}

fn chart(
    svg: &mut Svg,
    columns: &Columns,
    name: &str,
    values: &[Spot],
    colour: &str,
    (top, height): (f64, f64),
) {
    let largest = values.iter().map(|(_, value)| *value).fold(0.0, f64::max);
    let (step, steps, decimals) = scale(largest);
    let highest = step * f64::from(steps);
    let y = |value: f64| top + height - height * value / highest;
    let style = format!("fill=\"{colour}\" font-weight=\"bold\"");
    svg.text((columns.left, top - 7.0), Anchor::Start, name, &style);
    for index in 0..=steps {
        let value = step * f64::from(index);
        let place = y(value);
        let line = format!("stroke=\"{HAIR}\" stroke-width=\"1\"");
        svg.line(
            (columns.left, place),
            (columns.left + columns.width, place),
            &line,
        );
        svg.text(
            (columns.left - 8.0, place + 4.0),
            Anchor::End,
            &format!("{value:.decimals$}"),
            &format!("fill=\"{QUIET}\""),
        );
    }
    let spots: Vec<Spot> = values
        .iter()
        .map(|&(frame, value)| (columns.x(frame), y(value)))
        .collect();
    if !spots.is_empty() {
        svg.polyline(&spots, &format!("stroke=\"{colour}\" stroke-width=\"2\""));
    }
}

/// Numbers of frames below the charts.
fn frames(svg: &mut Svg, film: &Film<'_>, columns: &Columns, bottom: f64) {
    svg.group("frames", &format!("fill=\"{QUIET}\""), |svg| {
        let step = (film.frames as f64 / 12.0).max(1.0);
        let (step, _, _) = scale(2.0 * step);
        let step = step.max(1.0) as i64;
        let last = film.first_frame + film.frames as i64 - 1;
        let mut number = film.first_frame.div_euclid(step) * step;
        if number < film.first_frame {
            number += step;
        }
        while number <= last {
            let x = columns.x((number - film.first_frame + 1) as f64);
            let tick = format!("stroke=\"{QUIET}\" stroke-width=\"1\"");
            svg.line((x, bottom), (x, bottom + 4.0), &tick);
            svg.text((x, bottom + 18.0), Anchor::Middle, &number.to_string(), "");
            number += step;
        }
        let middle = columns.left + columns.width / 2.0;
        svg.text((middle, bottom + 36.0), Anchor::Middle, "Frame", "");
    });
}

/// Round steps for an axis that reaches `largest`: their size, their number
/// (2 to 5), and the decimals that they need.
fn scale(largest: f64) -> (f64, u32, usize) {
    if !(largest > 1e-9 && largest.is_finite()) {
        return (0.5, 2, 1);
    }
    let power = 10_f64.powf((largest / 4.0).log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .map(|factor| factor * power)
        .into_iter()
        .find(|step| largest / step <= 4.0)
        .unwrap_or(10.0 * power);
    let steps = ((largest / step).ceil() as u32).max(2);
    let decimals = (-(step.log10() + 1e-9).floor()).clamp(0.0, 12.0) as usize;
    (step, steps, decimals)
}
