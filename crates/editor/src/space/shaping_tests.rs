//! What is drawn, and what is deformed by squares in the space, as a user does it.

use egui::{Key, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::{DVec2, DVec3};
use vides_document::tool::tools;
use vides_document::{At, Edit};

use super::projection::{from_pos, to_pos};
use super::tests::{
    editor, empty, image, motion, press, pyramid, pyramid_window, release, tap, text, viewport,
    window,
};
use super::*;
use crate::action::ToolAction;
use crate::screenshots::screenshot;
use crate::texts::Language;

type Window<'a> = Harness<'a, Editor>;

const LEFT: PointerButton = PointerButton::Primary;
const RIGHT: PointerButton = PointerButton::Secondary;

fn begin(harness: &mut Window<'_>, name: &str) {
    let context = harness.ctx.clone();
    let tool = tools().find(|tool| tool.name == name).unwrap();
    harness
        .state_mut()
        .act(Action::Tool(ToolAction::Open(tool)), &context);
    harness.step();
    harness.step();
    if tool.can_add() {
        let replaces = harness.state().language().choice("replace");
        harness.get_by_label(replaces).click();
        harness.step();
        harness.step();
    }
}

fn end(harness: &mut Window<'_>, keeps: bool) {
    let context = harness.ctx.clone();
    harness
        .state_mut()
        .act(Action::Tool(ToolAction::End { keeps }), &context);
    harness.step();
}

fn positions(harness: &Window<'_>) -> Vec<DVec3> {
    let points = &harness.state().document.path().points;
    points.iter().map(|point| point.position).collect()
}

fn nodes(harness: &Window<'_>) -> Vec<DVec3> {
    let window = harness.state().windows.tool.as_ref().unwrap();
    window.cage().unwrap().nodes.clone()
}

/// Bernstein's polynomials of degree 3, of a coordinate in [−1, 1].
fn weights(u: f64) -> [f64; 4] {
    let t = f64::midpoint(u, 1.0);
    [0, 1, 2, 3].map(|k| {
        let binomial = [1.0, 3.0, 3.0, 1.0][k as usize];
        binomial * t.powi(k) * (1.0 - t).powi(3 - k)
    })
}

#[test]
fn a_square_that_is_dragged_deforms_the_path_around_it() {
    let mut harness = pyramid_window();
    let before = text(&harness);
    let places = positions(&harness);
    begin(&mut harness, "free-form");
    // Untouched it leaves everything where it is.
    for (at, place) in positions(&harness).iter().enumerate() {
        assert!(place.distance(places[at]) < 1e-12);
    }
    let low = places.iter().copied().reduce(DVec3::min).unwrap();
    let high = places.iter().copied().reduce(DVec3::max).unwrap();
    let squares = nodes(&harness);
    assert_eq!((squares[0], squares[63]), (low, high));
    // The right button keeps z.
    let node = 1 + 4 * 2 + 16;
    let at = image(&harness, squares[node]);
    press(&mut harness, at, RIGHT);
    motion(&mut harness, at + vec2(20.0, -30.0));
    let moved = nodes(&harness)[node] - squares[node];
    assert!(moved.length() > 0.05 && moved.z == 0.0, "{moved}");
    assert!((image(&harness, nodes(&harness)[node]) - at - vec2(20.0, -30.0)).length() < 0.01);
    for (at, place) in positions(&harness).iter().enumerate() {
        let [i, j, k] = [0, 1, 2].map(|axis: usize| {
            let [low, high] = [low[axis], high[axis]];
            weights((2.0 * places[at][axis] - low - high) / (high - low))
        });
        let expected = places[at] + i[1] * j[2] * k[1] * moved;
        assert!(place.distance(expected) < 1e-12, "{at}: {place} {expected}");
    }
    // Escape brings the square back, and the tool goes on.
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    release(&mut harness, at, RIGHT);
    assert!(nodes(&harness)[node].distance(squares[node]) < 1e-12);
    assert!(harness.state().windows.tool.is_some());
    // As far as a number says.
    press(&mut harness, at, RIGHT);
    motion(&mut harness, at + vec2(20.0, -30.0));
    harness.event(egui::Event::Text("0.25".to_owned()));
    harness.step();
    release(&mut harness, at + vec2(20.0, -30.0), RIGHT);
    assert!((nodes(&harness)[node].distance(squares[node]) - 0.25).abs() < 1e-12);
    // The fields show that square.
    let window = harness.state().windows.tool.as_ref().unwrap();
    assert_eq!(window.control(), node);
    screenshot(&mut harness, "tool-free-form.png");
    end(&mut harness, true);
    assert_ne!(text(&harness), before);
    let document = &mut harness.state_mut().document;
    assert_eq!(
        document.step_names()[0],
        Some(vides_document::StepName::Tool("free-form"))
    );
    assert!(document.undo());
    assert!(!document.can_undo());
    assert_eq!(text(&harness), before);
}

#[test]
fn other_tools_show_the_box_that_they_deform() {
    let mut harness = pyramid_window();
    let places = positions(&harness);
    for name in ["taper", "bulge", "twist", "bend"] {
        begin(&mut harness, name);
        let window = harness.state().windows.tool.as_ref().unwrap();
        let cage = window.cage().unwrap();
        assert!(cage.nodes.is_empty() && cage.lines.len() == 24);
        // What is deformed lies within the hull of what its box becomes.
        let line = || cage.lines.iter().flatten().copied();
        let low = line().reduce(DVec3::min).unwrap() - 1e-9;
        let high = line().reduce(DVec3::max).unwrap() + 1e-9;
        for place in positions(&harness) {
            assert!(place.cmpge(low).all() && place.cmple(high).all(), "{name}");
        }
        screenshot(&mut harness, &format!("tool-{name}.png"));
        end(&mut harness, false);
        assert_eq!(positions(&harness), places);
    }
    begin(&mut harness, "move");
    let window = harness.state().windows.tool.as_ref().unwrap();
    assert!(window.cage().is_none());
}

/// A wave on the screen, from left to right.
fn wave(harness: &Window<'_>) -> Vec<Pos2> {
    let centre = viewport(harness).center();
    (0..=60u8)
        .map(|step| {
            let x = f32::from(step) * 2.0 - 60.0;
            centre + vec2(x, 25.0 * (x / 14.0).sin())
        })
        .collect()
}

fn draw(harness: &mut Window<'_>, line: &[Pos2]) {
    press(harness, line[0], LEFT);
    for &at in &line[1..] {
        motion(harness, at);
    }
    release(harness, line[line.len() - 1], LEFT);
}

#[test]
fn a_line_that_is_drawn_becomes_a_path() {
    let mut harness = pyramid_window();
    // As deep as the middle of the space, so that no face of it is near.
    let position = DVec3::new(0.1, 0.05, -0.1);
    let edit = Edit::set(At::Point(0), "position", position);
    let document = &mut harness.state_mut().document;
    document.apply(edit).unwrap();
    *document = Document::from_toml(&document.to_toml().unwrap()).unwrap();
    let before = text(&harness);
    let depth = |harness: &Window<'_>, place: DVec3| {
        projection_of(harness.state(), viewport(harness))
            .toward()
            .dot(place)
    };
    let current = harness.state().point().unwrap().position;
    let view = harness.state().orientation().unwrap().target;
    begin(&mut harness, "draw");
    assert_eq!(text(&harness), before);
    // Escape gives up a line, and no more than that.
    let line = wave(&harness);
    press(&mut harness, line[0], LEFT);
    motion(&mut harness, line[30]);
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    release(&mut harness, line[30], LEFT);
    assert_eq!(text(&harness), before);
    assert!(harness.state().windows.tool.is_some());

    draw(&mut harness, &line);
    let document = &harness.state().document;
    let points = document.path().points.len();
    assert!((3..=12).contains(&points), "{points}");
    let projection = projection_of(harness.state(), viewport(&harness));
    let poses = document.sampler().unwrap();
    let mut farthest = 0.0f64;
    for frame in 0..poses.frame_count() {
        let place = DVec3::from_array(poses.pose(frame as f64 + 1.0).unwrap().vrp);
        let off = depth(&harness, place) - depth(&harness, current);
        assert!(off.abs() < 1e-9, "{frame}: {off} {place}");
        let seen = projection.image(place);
        let away = line.windows(2).map(|ends| {
            let [a, b] = [ends[0], ends[1]].map(from_pos);
            let share = (seen - a).dot(b - a) / (b - a).length_squared();
            seen.distance(a.lerp(b, share.clamp(0.0, 1.0)))
        });
        farthest = farthest.max(away.fold(f64::MAX, f64::min));
    }
    // The tolerance of a hundredth of the half size.
    assert!(farthest <= 0.01 * projection.scale() + 0.5, "{farthest}");
    let ends = [0, points - 1].map(|at| to_pos(projection.image(positions(&harness)[at])));
    assert!((ends[0] - line[0]).length() < 4.0 && (ends[1] - line[60]).length() < 4.0);
    let all = harness.state().document.path().points.iter();
    assert!(
        all.flat_map(|point| &point.orientations)
            .all(|of| of.target == view)
    );
    screenshot(&mut harness, "tool-draw.png");

    // Another line takes its place; the first is no step.
    let back: Vec<_> = line.iter().rev().copied().collect();
    draw(&mut harness, &back);
    end(&mut harness, true);
    let first = to_pos(projection.image(positions(&harness)[0]));
    assert!((first - back[0]).length() < 4.0);
    let document = &mut harness.state_mut().document;
    assert!(document.undo());
    assert!(!document.can_undo());
    assert_eq!(text(&harness), before);

    // Without the tool the left button turns the space as ever.
    let turned = harness.state().setup.view;
    draw(&mut harness, &line);
    assert_ne!(harness.state().setup.view, turned);
    assert_eq!(text(&harness), before);
}

/// Where the camera's picture shows a place: by its view, right and up.
fn in_picture(harness: &Window<'_>, place: DVec3) -> Pos2 {
    let texts = &harness.state().texts().space;
    let (camera, _) = harness.state().camera().unwrap();
    let away = place - camera.position;
    let deep = away.dot(camera.view) * 12.0 / camera.zoom;
    let right = camera.view.cross(camera.up);
    let room = harness.get_by_label(texts.camera_picture).rect();
    let ratio = harness.state().setup.camera_aspect.ratio();
    let width = room.width().min(room.height() * ratio);
    let picture = Rect::from_center_size(room.center(), vec2(width, width / ratio));
    let aspect = f64::from(ratio);
    let at = DVec2::new(away.dot(right) / deep / aspect, -away.dot(camera.up) / deep);
    let half = from_pos((picture.size() / 2.0).to_pos2());
    to_pos(from_pos(picture.center()) + at * half)
}

/// Along an edge of the pyramid, from its tip downwards, then on beside it.
#[test]
fn a_line_in_the_cameras_picture_lies_on_the_object() {
    for large in [false, true] {
        let mut harness = pyramid_window();
        if large {
            harness.state_mut().setup.camera_place = crate::setup::CameraPlace::Beside;
            harness.step();
        }
        let before = text(&harness);
        let object = &harness.state().document.info().object;
        let (ends, _) = object.lines().nth(4).unwrap();
        let ends = if ends[0].y > ends[1].y {
            ends
        } else {
            [ends[1], ends[0]]
        };
        let [top, foot] = [ends[0].lerp(ends[1], 0.02), ends[0].lerp(ends[1], 0.4)];
        let line: Vec<Pos2> = (0..=40)
            .map(|part| in_picture(&harness, top.lerp(foot, f64::from(part) / 40.0)))
            .collect();
        begin(&mut harness, "draw");
        // Given up.
        press(&mut harness, line[0], LEFT);
        motion(&mut harness, line[20]);
        motion(&mut harness, line[30]);
        tap(&mut harness, Key::Escape, Modifiers::NONE);
        release(&mut harness, line[30], LEFT);
        assert_eq!(text(&harness), before);
        assert!(harness.state().windows.tool.is_some());

        press(&mut harness, line[0], LEFT);
        for &at in &line[1..30] {
            motion(&mut harness, at);
        }
        screenshot(&mut harness, &format!("tool-draw-on-object-{large}.png"));
        for &at in &line[30..] {
            motion(&mut harness, at);
        }
        release(&mut harness, line[40], LEFT);
        let sampler = harness.state().document.sampler().unwrap();
        let mut places = Vec::new();
        for frame in 1..=sampler.frame_count() {
            places.push(DVec3::from_array(sampler.pose(frame as f64).unwrap().vrp));
        }
        // Within the tolerance of the fit of the edge, from end to end.
        let way = (foot - top).normalize();
        for place in &places {
            let off = (*place - top).reject_from_normalized(way).length();
            assert!(off < 0.02, "{large}: {place} is {off} beside the edge");
        }
        let [first, last] = [places[0], places[places.len() - 1]];
        let off = [first.distance(top), last.distance(foot)];
        assert!(off[0].max(off[1]) < 0.02, "{large}: {off:?}");
        end(&mut harness, true);
        let document = &mut harness.state_mut().document;
        assert!(document.undo());
        assert_eq!(text(&harness), before);
    }
}

#[test]
fn a_place_that_is_drawn_faces_the_viewer() {
    let harness = pyramid_window();
    let projection = projection_of(harness.state(), viewport(&harness));
    let point = DVec3::new(0.2, -0.3, 0.4);
    let image = DVec2::new(400.0, 300.0);
    let place = projection.point_facing(point, image);
    assert!(projection.image(place).distance(image) < 1e-9);
    assert!((place - point).dot(projection.toward()).abs() < 1e-12);
}

/// The texts that are painted.
fn painted(harness: &Window<'_>) -> Vec<String> {
    let shapes = harness.output().shapes.iter();
    let texts = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Text(text) => Some(text.galley.job.text.clone()),
        _ => None,
    });
    texts.collect()
}

#[test]
fn while_a_line_is_waited_for_the_hint_says_what_the_left_button_does() {
    for language in [Language::English, Language::German] {
        let mut harness = window(editor(pyramid(), language), vec2(1200.0, 800.0), 1.0);
        let texts = &language.texts().space;
        let nothing = empty(&harness);
        let says =
            |harness: &Window<'_>, hint: &str| painted(harness).iter().any(|text| text == hint);
        motion(&mut harness, nothing);
        harness.step();
        assert!(says(&harness, texts.empty_hint));
        for several in [false, true] {
            if several {
                tap(&mut harness, Key::A, Modifiers::CTRL);
            }
            begin(&mut harness, "draw");
            motion(&mut harness, nothing);
            harness.step();
            assert!(says(&harness, texts.draw_hint));
            assert!(!says(&harness, texts.empty_hint));
            screenshot(&mut harness, &format!("draw-hint-{language:?}.png"));
            end(&mut harness, false);
            assert!(!says(&harness, texts.draw_hint));
        }
    }
}
