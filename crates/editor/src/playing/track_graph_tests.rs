//! Tests of [`super`], by mouse and keys as in the window.

use egui::{PointerButton, Rangef, Shape};
use egui_kittest::kittest::Queryable;
use vides_document::Edit;
use vides_engine::math::euler::EulerAngles;
use vides_engine::scene::{
    Channel, Extrapolation, Interpolation, Node, Part, Scene, Track, Warnings,
};

use super::super::graph_drag::tests::apart;
use super::super::tracks::tests::*;
use super::*;
use crate::playing::track_rows::channel_name;
use crate::screenshots::screenshot;
use crate::setup::Theme;
use crate::space::tests::{motion, release};
use crate::tests::{LARGE, SMALL, functions_change};
use crate::texts::Language;

pub(in crate::playing) fn graph_in(language: Language, size: [f32; 2], theme: Theme) -> Window {
    let mut harness = window_in(language, size, theme);
    let name = language.texts().timeline.graph_switch;
    harness.get_by_label(name).click();
    steps_on(&mut harness);
    harness
}

pub(in crate::playing) fn graph() -> Window {
    graph_in(Language::English, LARGE, Theme::Dark)
}

pub(in crate::playing) fn set_track(harness: &mut Window, track: Track) {
    let channel = track.channel().clone();
    let part = Part::track(1, channel, Some(track)).unwrap();
    let edit = Edit::Part(Box::new(part));
    let editor = harness.state_mut();
    editor.document.apply(edit).unwrap();
    editor.document = editor.document.try_clone().unwrap().as_opened();
    // As undo selects it, so that rows stay where they are.
    editor.select_nodes(vec![1, 2]);
    steps_on(harness);
}

pub(in crate::playing) fn track_of(harness: &Window, channel: &Channel) -> Track {
    let edited = harness.state().document.edited_scene().unwrap();
    let keys = edited.scene().nodes()[1].keys();
    keys.track(channel).unwrap().clone()
}

/// Shows the curve of a channel by a click at its name.
pub(in crate::playing) fn choose(harness: &mut Window, channel: &Channel) {
    let name = channel_name(harness.state(), channel);
    let rows = harness.get_all_by_role_and_label(Role::Button, &name);
    rows.last().unwrap().click();
    steps_on(harness);
}

/// Where the graph stands.
fn ground(harness: &Window) -> Rect {
    let name = harness.state().texts().timeline.graph_of_keys;
    harness.get_by_role_and_label(Role::Canvas, name).rect()
}

/// From numbers to the screen, as who reads the scale sees it: its first and its last line.
fn scale(harness: &Window) -> impl Fn(f64) -> f64 + use<> {
    let ground = ground(harness);
    let mut lines: Vec<(f64, f64)> = Vec::new();
    let shapes = &harness.output().shapes;
    let is_line = |y: f32| {
        shapes.iter().find_map(|shape| match shape.shape {
            Shape::LineSegment { points: [a, b], .. } if a.y == b.y && b.x - a.x > 100.0 => {
                (ground.contains(a) && (a.y - y).abs() < 0.6).then_some(a.y)
            }
            _ => None,
        })
    };
    for shape in shapes {
        if let Shape::Text(text) = &shape.shape
            && (text.pos.x - ground.left() - 12.0).abs() < 0.01
            && text.pos.y > ground.top() + 14.0
            && ground.contains(text.pos)
            && let Ok(value) = text.galley.text().replace('−', "-").parse::<f64>()
            && let Some(y) = is_line(text.pos.y + text.galley.size().y)
        {
            lines.push((value, f64::from(y)));
        }
    }
    let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.0.total_cmp(&b.0);
    let low = *lines.iter().min_by(by_value).expect("lines of the scale");
    let high = *lines.iter().max_by(by_value).unwrap();
    assert!(high.0 > low.0, "{lines:?}");
    move |value| low.1 + (value - low.0) / (high.0 - low.0) * (high.1 - low.1)
}

/// Where a number stands at a frame.
pub(in crate::playing) fn place(harness: &Window, frame: f64, value: f64) -> Pos2 {
    pos2(x_of(harness, frame), scale(harness)(value) as f32)
}

fn lines(harness: &Window) -> Vec<Vec<Pos2>> {
    let ground = ground(harness);
    let shapes = harness.output().shapes.iter();
    let all = shapes.filter_map(|shape| match &shape.shape {
        Shape::Path(path) if !path.closed && path.points.len() > 20 => {
            let from = path.points[0];
            (from.x <= ground.left() + 0.1 && ground.y_range().contains(from.y))
                .then(|| path.points.clone())
        }
        _ => None,
    });
    all.collect()
}

pub(in crate::playing) fn diamonds(harness: &Window) -> Vec<Pos2> {
    let ground = ground(harness);
    let shapes = harness.output().shapes.iter();
    let all = shapes.filter_map(|shape| match &shape.shape {
        Shape::Path(path) if path.closed && path.points.len() == 4 => {
            Some(shape.shape.visual_bounding_rect().center())
        }
        _ => None,
    });
    all.filter(|at| ground.contains(*at)).collect()
}

struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 31)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() * count as f64) as usize
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// A track of this interpolation.
    fn track(&mut self, by: &Interpolation) -> Track {
        use Channel::{Colour, Intensity, Position, Rotation, Scale, Visible};
        let value = Channel::parse("value:wind:2").unwrap();
        let all = [
            (Position, 3),
            (Scale, 3),
            (Intensity, 1),
            (Colour, 3),
            (value, 2),
            (Rotation, 4),
            (Visible, 1),
        ];
        let fits = |(channel, _): &&(Channel, usize)| {
            let mut names = Interpolation::names(Some(channel));
            let name = match by {
                Interpolation::Host(_) => "host:NAME".to_owned(),
                plain => plain.to_string(),
            };
            names.any(|known| known == name)
        };
        let fitting: Vec<_> = all.iter().filter(fits).collect();
        let (channel, width) = fitting[self.below(fitting.len())].clone();
        let euler = matches!(
            by,
            Interpolation::EulerLinear | Interpolation::EulerCatmullRom
        );
        let width = if euler { 3 } else { width };
        let count = 1 + self.below(9);
        let mut frames: Vec<f64> = (0..count).map(|_| self.within(-10.0, 130.0)).collect();
        frames.sort_by(f64::total_cmp);
        frames.dedup_by(|a, b| *a - *b < 0.2);
        let keys = frames.len();
        let size = 10_f64.powf(self.within(-2.0, 3.0));
        let number = |random: &mut Self| match channel {
            Visible => random.next().round(),
            Colour | Intensity => random.within(0.0, size),
            Rotation if euler => random.within(-400.0, 400.0),
            Rotation => random.within(-1.0, 1.0),
            _ => random.within(-size, size),
        };
        let values = (0..keys * width).map(|_| number(self)).collect();
        let shape = match by {
            Interpolation::Hermite => {
                let most = if channel == Rotation { 0.1 } else { 0.2 * size };
                (0..2 * keys * width)
                    .map(|_| self.within(-most, most))
                    .collect()
            }
            Interpolation::Tcb => (0..3 * keys).map(|_| self.within(-1.0, 1.0)).collect(),
            _ => Vec::new(),
        };
        let beyond = [
            Extrapolation::Hold,
            Extrapolation::Repeat,
            Extrapolation::PingPong,
            Extrapolation::Offset,
        ];
        let most = if channel == Visible { 3 } else { 4 };
        // A period that cannot be told from a line is none that is seen.
        let far = frames[keys - 1] - frames[0] > 3.0;
        let mut end = || {
            if far {
                beyond[self.below(most)]
            } else {
                Extrapolation::Hold
            }
        };
        let ends = (end(), end());
        let track = Track::new(channel, by.clone(), frames, values, shape).unwrap();
        track.with_extrapolation(ends.0, ends.1).unwrap()
    }
}

fn every_interpolation() -> Vec<Interpolation> {
    let half = |question: vides_engine::scene::host::Question<'_>, out: &mut [f64]| {
        // Its own way: slow behind a key, and fast before the next one.
        let behind = question
            .frames
            .partition_point(|key| *key <= question.frame);
        let from = behind.max(1) - 1;
        let to = behind.min(question.frames.len() - 1);
        let step = question.frames[to] - question.frames[from];
        let u = match step > 0.0 {
            true => (question.frame - question.frames[from]) / step,
            false => 0.0,
        };
        for (part, out) in out.iter_mut().enumerate() {
            let value = |key: usize| question.values[key * question.width + part];
            *out = value(from) + (value(to) - value(from)) * u * u;
        }
        true
    };
    let name = "graph_test";
    let _change = functions_change();
    vides_engine::scene::host::register(name, Some(std::sync::Arc::new(half))).unwrap();
    let plain = Interpolation::names(None).filter(|name| !name.starts_with("host:"));
    let plain = plain.map(|name| Interpolation::parse(name).unwrap());
    plain
        .chain([Interpolation::Host(name.to_owned())])
        .collect()
}

/// What the engine says, as the graph shows it.
fn engine(scene: &Scene, node: usize, track: &Track, frame: f64) -> Vec<f64> {
    let warnings = &mut Warnings::default();
    let value = scene.value(node, track.channel(), frame, warnings).unwrap();
    match (track.channel(), value.as_slice()) {
        (Channel::Rotation, &[w, x, y, z]) => {
            let q = glam::DQuat::from_xyzw(x, y, z, w);
            let EulerAngles { yaw, pitch, roll } = EulerAngles::from_quaternion(q);
            [yaw, pitch, roll].map(f64::to_degrees).to_vec()
        }
        _ => value,
    }
}

/// Whether two numbers of a channel say the same: of angles whole turns do not count, and near the
/// poles, where yaw and roll are one, nothing is compared.
fn alike(track: &Track, a: &[f64], b: &[f64], near: f64) -> bool {
    if *track.channel() != Channel::Rotation {
        return a.iter().zip(b).all(|(a, b)| (a - b).abs() <= near);
    }
    let turn = |angles: &[f64]| {
        let [yaw, pitch, roll] = [angles[0], angles[1], angles[2]].map(f64::to_radians);
        EulerAngles { yaw, pitch, roll }.quaternion()
    };
    let between = turn(a).dot(turn(b)).abs().min(1.0).acos().to_degrees() * 2.0;
    between <= 1e-3 + 3.0 * near
}

/// Curves and keys stand where the engine says, to half a pixel, for a thousand random tracks.
#[test]
#[expect(clippy::too_many_lines)] // told in one piece
fn curves_and_keys_stand_where_the_engine_says() {
    let mut random = Random(7);
    let mut harness = graph();
    let ruler = harness.get_by_label("Frame").rect();
    let rail = Rangef::new(ruler.left() + 8.0, ruler.right() - 8.0);
    let all = every_interpolation();
    let mut checked = [0; 2];
    for round in 0..1000 {
        let by = &all[round % all.len()];
        let track = random.track(by);
        let channel = track.channel().clone();
        let editor = harness.state_mut();
        let part = Part::track(1, channel.clone(), Some(track.clone())).unwrap();
        editor.document.apply(Edit::Part(Box::new(part))).unwrap();
        editor.playing.speeds.tracks.graph.chosen = vec![(1, channel)];
        // The keys may have changed the scene's range.
        harness.step();
        let editor = harness.state_mut();
        let frames = editor.playing.marks.range;
        let whole = Axis::new(rail, frames, None);
        let seen = match random.next() < 0.5 {
            true => whole.zoomed(rail.min + 500.0, 0.05 + random.next()),
            false => None,
        };
        editor.playing.see(seen);
        harness.step();
        harness.step();
        let (first, last) = match seen {
            Some(_) => {
                let axis = Axis::new(rail, frames, seen);
                (axis.first(), axis.last())
            }
            None => frames,
        };
        let frame_of =
            |x: f64| first + (x - f64::from(rail.min)) / f64::from(rail.span()) * (last - first);
        let x_of = |frame: f64| {
            f64::from(rail.min) + (frame - first) / (last - first) * f64::from(rail.span())
        };
        let (y_of, lines) = (scale(&harness), lines(&harness));
        let edited = harness.state().document.edited_scene().unwrap();
        let scene = edited.scene();
        let value_of = |y: f64| {
            let (a, b) = (y_of(0.0), y_of(1.0));
            (y - a) / (b - a)
        };
        let near = (value_of(0.0) - value_of(0.5)).abs();
        let width = if *track.channel() == Channel::Rotation {
            3
        } else {
            track.width()
        };
        assert_eq!(lines.len(), width, "{by} {:?}", track.channel());
        // What is drawn is what the engine says there, half a pixel to either side.
        for at in (0..lines[0].len()).step_by(3) {
            let x = f64::from(lines[0][at].x);
            if !rail.contains(lines[0][at].x) {
                continue;
            }
            let drawn: Vec<f64> = lines
                .iter()
                .map(|line| value_of(f64::from(line[at].y)))
                .collect();
            let around = (-10..=10).map(|step| frame_of(x + 0.05 * f64::from(step)));
            let keys = track
                .frames()
                .iter()
                .copied()
                .filter(|key| (x_of(*key) - x).abs() <= 0.5);
            // Where the next round begins the last value counts.
            let (first_key, last_key) = track.ends();
            let period = last_key - first_key;
            let round = ((frame_of(x) - first_key) / period).round();
            let seam = first_key + round * period;
            let seam = (period > 0.0 && (x_of(seam) - x).abs() <= 0.5).then_some(seam);
            let says: Vec<Vec<f64>> = around
                .chain(keys)
                .chain(seam)
                .map(|frame| engine(scene, 1, &track, frame))
                .collect();
            let exact = says.iter().any(|said| alike(&track, &drawn, said, near));
            // Where it is steep, between two of them.
            let between = (0..width).all(|part| {
                let said = says.iter().map(|said| said[part]);
                let low = said.clone().fold(f64::INFINITY, f64::min);
                let high = said.fold(f64::NEG_INFINITY, f64::max);
                (low - near..=high + near).contains(&drawn[part])
            });
            assert!(
                exact || between,
                "{by} {track:?} at {x}: {drawn:?}, not {says:?}"
            );
            checked[0] += 1;
        }
        // What the engine says is drawn.
        for _ in 0..40 {
            let frame = random.within(first, last);
            let said = engine(scene, 1, &track, frame);
            if *track.channel() == Channel::Rotation && track.width() == 3 {
                continue;
            }
            for (part, value) in said.iter().enumerate() {
                let at = pos2(x_of(frame) as f32, y_of(*value) as f32);
                let away = lines[part]
                    .windows(2)
                    .filter(|two| two[0].x <= at.x + 1.0 && two[1].x >= at.x - 1.0)
                    .map(|two| distance(at, [two[0], two[1]]))
                    .fold(f32::INFINITY, f32::min);
                assert!(
                    away <= 0.5,
                    "{by} {track:?} at {frame}: {value}, {away} away"
                );
            }
        }
        let painted = diamonds(&harness);
        for key in 0..track.frames().len() {
            let frame = track.frames()[key];
            let said = match (track.channel(), track.width()) {
                (Channel::Rotation, 3) => track.values()[3 * key..][..3].to_vec(),
                _ => engine(scene, 1, &track, frame),
            };
            for value in said {
                let at = pos2(x_of(frame) as f32, y_of(value) as f32);
                if !rail.contains(at.x) {
                    continue;
                }
                let exact = painted
                    .iter()
                    .any(|there| (*there - at).abs().max_elem() <= 0.5);
                // Another one of the same curve may stand for it.
                let close = painted
                    .iter()
                    .any(|there| (*there - at).abs().max_elem() <= 1.5);
                let crowded = track
                    .frames()
                    .iter()
                    .any(|other| *other != frame && (x_of(*other) - x_of(frame)).abs() < 1.0);
                assert!(exact || crowded && close, "{by} {at:?}: {painted:?}");
                checked[1] += 1;
            }
        }
    }
    assert!(checked[0] > 40_000 && checked[1] > 5_000, "{checked:?}");
}

fn distance(at: Pos2, [a, b]: [Pos2; 2]) -> f32 {
    let (way, to) = (b - a, at - a);
    let share = to.dot(way) / way.length_sq().max(f32::MIN_POSITIVE);
    at.distance(a + way * share.clamp(0.0, 1.0))
}

/// The same of what is computed for the screen, for a thousand tracks of each interpolation.
#[test]
fn curves_are_near_to_the_engine_for_every_interpolation() {
    let mut random = Random(11);
    let mut worst = 0.0_f64;
    for by in every_interpolation() {
        for _ in 0..1000 {
            let track = random.track(&by);
            let mut scene = Scene::new();
            let light = vides_engine::scene::Kind::Light(Default::default());
            scene.add(Node::new("lamp", light)).unwrap();
            scene.set_track(0, track.clone()).unwrap();
            let of = Of {
                scene: &scene,
                node: 0,
                track: &track,
            };
            let (low, columns) = (random.within(-20.0, 100.0), 1000.0);
            let high = low + random.within(5.0, 150.0);
            let column = (high - low) / columns;
            let rough = Curve::new(&of, (low, high), column, f64::INFINITY);
            let ground = Rect::from_min_max(Pos2::ZERO, pos2(1000.0, 160.0));
            let fit = Fit::new(range_of(rough.bounds()), ground);
            let curve = Curve::new(&of, (low, high), column, NEAR * fit.per_point);
            let fit = Fit::new(range_of(curve.bounds()), ground);
            let lines: Vec<Vec<Pos2>> = (0..of.width())
                .map(|part| {
                    let place =
                        |(frame, value)| pos2(((frame - low) / column) as f32, fit.y(value));
                    curve.line(part).map(place).collect()
                })
                .collect();
            for _ in 0..30 {
                let frame = random.within(low, high);
                if *track.channel() == Channel::Rotation && track.width() == 3 {
                    continue;
                }
                for (part, value) in engine(&scene, 0, &track, frame).into_iter().enumerate() {
                    let at = pos2(((frame - low) / column) as f32, fit.y(value));
                    let line = &lines[part];
                    let from = line.partition_point(|other| other.x < at.x - 1.0).max(1) - 1;
                    let to = line.partition_point(|other| other.x <= at.x + 1.0);
                    let away = line[from..(to + 1).min(line.len())]
                        .windows(2)
                        .map(|two| distance(at, [two[0], two[1]]))
                        .fold(f32::INFINITY, f32::min);
                    assert!(
                        away <= 0.5,
                        "{by} {track:?}, frame {frame}: {value}, {away}"
                    );
                    worst = worst.max(f64::from(away));
                }
            }
        }
    }
    println!("at most {worst:.3} points away");
}

#[test]
fn pictures() {
    for (language, size, theme, name) in [
        (Language::English, LARGE, Theme::Dark, "en-dark"),
        (Language::English, LARGE, Theme::Light, "en-light"),
        (Language::German, SMALL, Theme::Light, "de-light"),
        (Language::German, SMALL, Theme::Dark, "de-dark"),
    ] {
        let mut harness = graph_in(language, size, theme);
        set_track(&mut harness, apart(Interpolation::Hermite));
        let dot = place(&harness, 20.0, 5.0);
        click(&mut harness, dot, PointerButton::Primary);
        screenshot(&mut harness, &format!("graph-{name}.png"));
        let to = dot + vec2(30.0, -20.0);
        take(&mut harness, dot, to);
        screenshot(&mut harness, &format!("graph-{name}-drag.png"));
        release(&mut harness, to, PointerButton::Primary);
        steps_on(&mut harness);
        click(&mut harness, to, PointerButton::Secondary);
        screenshot(&mut harness, &format!("graph-{name}-menu.png"));
        motion(&mut harness, dot);
    }
}

/// A node that only follows a path has an empty graph; its tracks come back with another node.
#[test]
fn a_graph_without_tracks_is_empty() {
    let mut harness = graph();
    harness.state_mut().select_nodes(vec![2]);
    steps_on(&mut harness);
    assert!(lines(&harness).is_empty() && diamonds(&harness).is_empty());
    let middle = ground(&harness).center();
    drag(&mut harness, middle, middle + vec2(50.0, 20.0));
    click(&mut harness, middle, PointerButton::Secondary);
    assert!(harness.state().selected_keys().is_empty());
    harness.state_mut().select_nodes(vec![1]);
    steps_on(&mut harness);
    assert_eq!(lines(&harness).len(), 3);
}

/// A click at its name shows a track, with Ctrl besides others, and once more no longer.
#[test]
fn tracks_are_chosen_by_their_names() {
    let mut harness = graph();
    assert_eq!(lines(&harness).len(), 3);
    choose(&mut harness, &Channel::Intensity);
    assert_eq!(lines(&harness).len(), 1);
    hold(&mut harness, egui::Modifiers::CTRL);
    choose(&mut harness, &Channel::Position);
    assert_eq!(lines(&harness).len(), 4);
    choose(&mut harness, &Channel::Intensity);
    hold(&mut harness, egui::Modifiers::NONE);
    assert_eq!(lines(&harness).len(), 3);
    // Rows again.
    let name = harness.state().texts().timeline.graph_switch;
    harness.get_by_label(name).click();
    steps_on(&mut harness);
    let rows = harness.state().texts().timeline.tracks;
    assert!(
        harness
            .query_by_role_and_label(Role::Canvas, rows)
            .is_some()
    );
}
