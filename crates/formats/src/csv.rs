//! Comma-separated values: a heading, then frame, numbers and seconds, with as many digits as give
//! the same bits back.

use std::fmt::Display;
use std::io::Write;

use super::content::Content;
use super::error::Result;
use super::flight::Flight;
use super::format::{Format, Holds};
use super::loss::Report;
use super::rows;

pub(super) static CSV: Format = Format {
    name: "csv",
    title: "CSV",
    endings: &["csv"],
    holds: Holds::Frames,
    recognises: |source| rows::is_poses(source.beginning(), true),
    read: Some(|source, _, _| rows::poses_of_text(source.text()?).map(Content::Poses)),
    write: Some(write),
    ..Format::PLAIN
};

const HEADER: &[u8] = b"frame,vrp_x,vrp_y,vrp_z,vpn_x,vpn_y,vpn_z,vup_x,vup_y,vup_z,zoom,seconds\n";

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, _: &mut Report) -> Result<()> {
    // Writing into a vector cannot fail.
    if flight.looks() {
        return flight.write_poses(HEADER.into(), out, |flight, text, index, pose| {
            let numbers = [pose.vrp, pose.vpn, pose.vup];
            push_row(text, &flight.number(index), numbers.as_flattened());
            let _ = writeln!(text, ",{:?},{:?}", pose.zoom, flight.seconds(index));
        });
    }
    let mut head = b"frame".to_vec();
    for column in 0..4 {
        for row in 0..4 {
            let _ = write!(head, ",m{row}{column}");
        }
    }
    head.extend_from_slice(b",visible,seconds\n");
    flight.write_states(head, out, |flight, text, index, state| {
        push_row(text, &flight.number(index), &flight.matrix(state));
        let _ = writeln!(text, ",{},{:?}", state.visible, flight.seconds(index));
    })
}

fn push_row(text: &mut Vec<u8>, frame: &dyn Display, numbers: &[f64]) {
    let _ = write!(text, "{frame}");
    for number in numbers {
        let _ = write!(text, ",{number:?}");
    }
}
