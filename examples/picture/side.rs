//! What stands beside the scene: the legend, and the sections by number.

use crate::film::Piece;
use crate::style::{HAIR, INK, OBJECT, QUIET, VIEW, WAY};
use crate::svg::{Anchor, Spot, Svg, cut};

/// From one line to the next.
const LINE: f64 = 21.0;

/// Length of a line's sample in the legend.
const SAMPLE: f64 = 26.0;

/// Draws the legend, and returns how far down it reaches.
pub(crate) fn legend(svg: &mut Svg, (x, y): Spot, has_object: bool) -> f64 {
    let curve = format!("stroke=\"{WAY}\" stroke-width=\"2.2\"");
    let object = format!("stroke=\"{OBJECT}\" stroke-width=\"1.6\"");
    let mut lines = vec![
        ("the camera's way", curve.as_str()),
        (
            "its shadow on the floor",
            "stroke=\"#dfe4ea\" stroke-width=\"3\"",
        ),
    ];
    if has_object {
        lines.push(("object", object.as_str()));
    }
    lines.push(("movement space", "stroke=\"#a9b2bd\" stroke-width=\"1\""));
    let mut place = y + 4.0;
    svg.group("legend", "", |svg| {
        let ink = format!("fill=\"{INK}\"");
        let beside = |place: f64| (x + SAMPLE + 12.0, place + 4.5);
        let middle = x + SAMPLE / 2.0;
        let cross = format!("stroke=\"{INK}\" stroke-width=\"1.8\"");
        svg.line(
            (middle - 5.0, place - 5.0),
            (middle + 5.0, place + 5.0),
            &cross,
        );
        svg.line(
            (middle - 5.0, place + 5.0),
            (middle + 5.0, place - 5.0),
            &cross,
        );
        svg.text(beside(place), Anchor::Start, "support point", &ink);
        place += LINE;
        let picture = [
            (middle + 5.0, place - 6.0),
            (middle + 11.0, place - 8.0),
            (middle + 11.0, place + 5.0),
            (middle + 5.0, place + 7.0),
        ];
        let stroke = format!("stroke=\"{VIEW}\" stroke-width=\"1\"");
        for corner in picture {
            svg.line((middle - 11.0, place), corner, &stroke);
        }
        svg.polygon(
            &picture,
            &format!("{stroke} fill=\"{VIEW}\" fill-opacity=\"0.16\""),
        );
        svg.text(
            beside(place),
            Anchor::Start,
            "camera, pale between keys",
            &ink,
        );
        for (name, stroke) in lines {
            place += LINE;
            svg.line((x, place), (x + SAMPLE, place), stroke);
            svg.text(beside(place), Anchor::Start, name, &ink);
        }
    });
    place + LINE
}

/// Draws the list of sections into a rectangle; what does not fit is counted.
pub(crate) fn sections(svg: &mut Svg, pieces: &[Piece], (x, y): Spot, width: f64, height: f64) {
    let room = ((height - LINE) / LINE).max(1.0) as usize;
    let shown = if pieces.len() > room {
        room - 1
    } else {
        pieces.len()
    };
    svg.group("list", "", |svg| {
        let quiet = format!("fill=\"{QUIET}\"");
        svg.text((x, y + 4.5), Anchor::Start, "Section", &quiet);
        svg.text((x + width, y + 4.5), Anchor::End, "Frames", &quiet);
        let rule = format!("stroke=\"{HAIR}\" stroke-width=\"1\"");
        svg.line((x, y + 11.0), (x + width, y + 11.0), &rule);
        let mut place = y + LINE + 7.0;
        for piece in &pieces[..shown] {
            let colour = match (piece.number, piece.moves) {
                (None, _) => QUIET,
                (Some(_), true) => WAY,
                (Some(_), false) => VIEW,
            };
            if let Some(number) = piece.number {
                let bold = format!("fill=\"{colour}\" font-weight=\"bold\"");
                svg.text((x + 14.0, place), Anchor::End, &number.to_string(), &bold);
            }
            let ink = if piece.number.is_some() { INK } else { QUIET };
            let style = format!("fill=\"{ink}\"");
            let what = cut(&piece.what, width - 80.0);
            svg.text((x + 28.0, place), Anchor::Start, &what, &style);
            let frames = piece.frames.to_string();
            svg.text((x + width, place), Anchor::End, &frames, &style);
            place += LINE;
        }
        if shown < pieces.len() {
            let more = format!("and {} more", pieces.len() - shown);
            svg.text((x + 28.0, place), Anchor::Start, &more, &quiet);
        }
    });
}
