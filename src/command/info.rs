//! `vides info`: the contents of a path, in tables.

use std::fmt::{Display, Write};
use std::path::Path;

use vides::document::Info;
use vides::path::{CameraPath, Change, CurveParameters, Section, Space, Timeline};

use super::failure::{Failure, one_line, print};
use super::info_parts::{changed, heading, last_of, modes};
use super::table::{Align, Table, decimals};
use super::{info_json, input, scene};

pub(super) fn run(file: &Path, json: bool) -> Result<(), Failure> {
    let document = input::load_scene(file)?;
    let text = match document.path_alone() {
        _ if json => info_json::object(file, &document)
            .map_err(|error| Failure::from(error.at(input::name(file))))?,
        Some(path) => tables(file, path, &document.info)
            .map_err(|error| Failure::from(error.at(input::name(file))))?,
        None => scene::tables(file, &document),
    };
    print(text.trim_end_matches('\n')).and_then(|()| print("\n"))
}

fn tables(file: &Path, path: &CameraPath, info: &Info) -> vides::Result<String> {
    let timeline = Timeline::new(path)?;
    let frames = timeline.frame_count()?;
    Ok(format!(
        "{}\nPoints\n{}\nSections\n{}",
        summary(file, path, info, &timeline, frames),
        points(path),
        sections(path, info, &timeline)
    ))
}

fn summary(
    file: &Path,
    path: &CameraPath,
    info: &Info,
    timeline: &Timeline,
    frames: usize,
) -> String {
    let mut text = heading(info);
    let mut entry = |name: &str, value: &dyn Display| {
        let _ = writeln!(text, "{name:<13}{value}");
    };
    let [mode, zoom] = modes(path);
    let shape = if path.closed { "closed" } else { "open" };
    let length = timeline.length();
    let places = decimals([length].into_iter());
    let first = i64::from(info.first_frame);
    let speeds = path.base_frames;

    entry("File", &one_line(&input::name(file)));
    entry(
        "Path",
        &format_args!("{shape}, {} points", path.points.len()),
    );
    entry("Length", &format_args!("{length:.places$}"));
    entry(
        "Frames",
        &format_args!("{frames}, numbered {first} to {}", last_of(first, frames)),
    );
    entry(
        "Time",
        &format_args!(
            "{:.2} s at {} frames per second",
            frames as f64 / info.fps,
            info.fps
        ),
    );
    entry(
        "Base speeds",
        &format_args!(
            "move {}, turn {}, zoom {}, roll {} frames",
            speeds.movement, speeds.turning, speeds.zoom, speeds.rolling
        ),
    );
    entry("Orientation", &mode);
    entry("Zoom", &zoom);
    if path.space != Space::default() || !info.unit.is_empty() {
        let space = path.space;
        let [x, y, z] = space.centre.to_array();
        let gap = if info.unit.is_empty() { "" } else { " " };
        entry(
            "Space",
            &format_args!(
                "({x:?}, {y:?}, {z:?}) ± {:?}{gap}{}, {} up",
                space.half_size,
                one_line(&info.unit),
                space.up.name()
            ),
        );
    }
    if !info.object.is_empty() {
        let lines = info.object.iter().filter(|point| point.draw).count();
        entry(
            "Object",
            &format_args!("{} points, {lines} lines", info.object.len()),
        );
    }
    text
}

fn points(path: &CameraPath) -> Table {
    let named = path.points.iter().any(|point| point.name.is_some());
    let mut columns = vec![("No.", Align::Right)];
    if named {
        columns.push(("Name", Align::Left));
    }
    columns.extend([
        ("x", Align::Right),
        ("y", Align::Right),
        ("z", Align::Right),
        ("Orientations", Align::Right),
        ("Curve", Align::Left),
    ]);
    let mut table = Table::new(&columns);
    let all = path
        .points
        .iter()
        .flat_map(|point| point.position.to_array());
    let places = decimals(all);
    for (index, point) in path.points.iter().enumerate() {
        let mut cells = vec![(index + 1).to_string()];
        if named {
            cells.push(one_line(point.name.as_deref().unwrap_or("")));
        }
        cells.extend(point.position.to_array().map(|x| format!("{x:.places$}")));
        cells.push(point.orientations.len().to_string());
        cells.push(curve(path, index));
        table.row(cells);
    }
    table
}

/// The source of a point's curve parameters, and those that are not 0.
fn curve(path: &CameraPath, point: usize) -> String {
    let mut text = match path.points[point].curve {
        CurveParameters::Preset(preset) => format!("preset {preset}"),
        CurveParameters::Own(_) => "own".to_owned(),
    };
    let tcb = path.tcb(point);
    let values = [("t", tcb.tension), ("c", tcb.continuity), ("b", tcb.bias)];
    let mut separator = ": ";
    for (name, value) in values.into_iter().filter(|(_, value)| *value != 0.0) {
        let _ = write!(text, "{separator}{name} {value}");
        separator = ", ";
    }
    text
}

fn sections(path: &CameraPath, info: &Info, timeline: &Timeline) -> Table {
    let mut table = Table::new(&[
        ("No.", Align::Right),
        ("From", Align::Left),
        ("To", Align::Left),
        ("Changes", Align::Left),
        ("By", Align::Right),
        ("", Align::Left),
        ("Frames", Align::Right),
        ("First", Align::Right),
        ("Last", Align::Right),
        ("Seconds", Align::Right),
    ]);
    let count = timeline.section_count();
    let all = || (0..count).map(|index| timeline.section(index));
    let lengths = all().filter(|section| section.change == Change::Position);
    let half_size = path.space.half_size;
    let places = decimals(lengths.map(|section| half_size * section.amount));
    // The very first pose belongs to no section.
    let mut next = i64::from(info.first_frame) + 1;
    let mut row = |number: String, from: String, to: String, change: [String; 3], frames: usize| {
        let mut cells = vec![number, from, to];
        cells.extend(change);
        cells.push(frames.to_string());
        if frames > 0 {
            cells.push(next.to_string());
            cells.push(last_of(next, frames).to_string());
            cells.push(format!("{:.2}", frames as f64 / info.fps));
            next += frames as i64;
        } else {
            cells.resize(cells.len() + 3, "-".to_owned());
        }
        table.row(cells);
    };
    let rest = || ["rest".to_owned(), String::new(), String::new()];
    for (index, section) in all().enumerate() {
        let (point, orientation) = (section.point, section.orientation);
        let from = place(path, point, orientation);
        let hold = path.points[point].orientations[orientation].hold as usize;
        if hold > 0 && section.change != Change::Nothing {
            row(String::new(), from.clone(), String::new(), rest(), hold);
        }
        let to = if orientation + 1 < path.points[point].orientations.len() {
            place(path, point, orientation + 1)
        } else {
            place(path, (point + 1) % path.points.len(), 0)
        };
        let change = change(&section, half_size, places);
        row((index + 1).to_string(), from, to, change, section.frames);
    }
    // The hold of a closed path's first key is already listed.
    if let (false, Some(point)) = (path.closed, path.points.last()) {
        let orientation = point.orientations.len() - 1;
        let hold = point.orientations[orientation].hold as usize;
        if hold > 0 {
            let from = place(path, path.points.len() - 1, orientation);
            row(String::new(), from, String::new(), rest(), hold);
        }
    }
    table
}

/// A point's number, with its orientation's if it has several.
fn place(path: &CameraPath, point: usize, orientation: usize) -> String {
    if path.points[point].orientations.len() > 1 {
        format!("{}.{}", point + 1, orientation + 1)
    } else {
        (point + 1).to_string()
    }
}

fn change(section: &Section, half_size: f64, places: usize) -> [String; 3] {
    let (name, by, unit) = changed(section, half_size);
    let by = match section.change {
        Change::Position => format!("{by:.places$}"),
        Change::Nothing => String::new(),
        _ => format!("{by:.2}"),
    };
    [name.to_owned(), by, unit.to_owned()]
}
