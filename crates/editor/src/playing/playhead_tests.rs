//! Tests of [`super`].

use egui::{Event, Key, Modifiers, PointerButton, Pos2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use vides_engine::path::{Space, SupportPoint, Up};

use super::*;
use crate::action::{Action, PathAction};
use crate::space::tests::{
    editor, hold, motion, press, pyramid, pyramid_window, release, tap, window,
};
use crate::tests::poses;
use crate::texts::Language;

/// The keys with the frames in which they are reached, by the sampler's own counts.
fn keys(harness: &Harness<'_, Editor>) -> Vec<(Selection, f64)> {
    let document = &harness.state().document;
    let points = &document.path().points;
    let mut frame = 1;
    let mut found = Vec::new();
    document
        .timeline(|timeline| {
            for index in 0..timeline.section_count() {
                let section = timeline.section(index);
                let at = Selection::at(section.point, section.orientation);
                found.push((at, f64::from(frame)));
                let hold = points[at.point].orientations[at.orientation].hold;
                frame += hold + u32::try_from(section.frames).unwrap();
            }
        })
        .unwrap();
    let last = points.len() - 1;
    let at = Selection::at(last, points[last].orientations.len() - 1);
    found.push((at, f64::from(frame)));
    found
}

fn text(harness: &Harness<'_, Editor>) -> String {
    harness.state().document.to_toml().unwrap()
}

/// Where a frame lies on the bar.
fn place(harness: &Harness<'_, Editor>, frame: f64) -> Pos2 {
    let bar = harness.get_by_label("Frame").rect().shrink2(vec2(8.0, 0.0));
    let last = keys(harness).last().unwrap().1;
    #[allow(clippy::cast_possible_truncation)]
    let share = ((frame - 1.0) / (last - 1.0)) as f32;
    pos2(bar.left() + bar.width() * share, bar.center().y)
}

/// All but this point.
fn others(harness: &Harness<'_, Editor>, but: Option<usize>) -> Vec<SupportPoint> {
    let points = harness.state().document.path().points.iter().enumerate();
    let others = points.filter(|&(at, _)| Some(at) != but);
    others.map(|(_, point)| point.clone()).collect()
}

/// The points are where they were and look as they did; what they own so that the
/// flight stays as it is does not count.
fn assert_same(points: &[SupportPoint], before: &[SupportPoint]) {
    let plain = |point: &SupportPoint| {
        let views = point.orientations.iter();
        let views = views.map(|view| (view.target, view.roll, view.zoom, view.hold, view.speeds));
        (
            point.name.clone(),
            point.position,
            point.curve,
            views.collect::<Vec<_>>(),
        )
    };
    let [points, before] = [points, before].map(|all| all.iter().map(plain).collect::<Vec<_>>());
    assert_eq!(points, before);
}

/// A frame on the way from the second point to the third.
fn on_the_way(harness: &Harness<'_, Editor>) -> f64 {
    let keys = keys(harness);
    ((keys[1].1 + keys[2].1) / 2.0).floor()
}

#[test]
fn at_a_mark_the_playhead_selects_that_key() {
    let mut harness = pyramid_window();
    for (at, frame) in keys(&harness) {
        harness.state_mut().scrub(frame);
        harness.run();
        assert_eq!(harness.state().document.selection(), at);
        // And it is the key that is seen, not a frame.
        assert_eq!(harness.state().shown_frame(), None);
        assert_eq!(harness.state().position_on_bar(), frame);
        let shown = harness.state().shown().unwrap();
        assert_eq!((shown.at, shown.missing), (at, Missing::Nothing));
    }
    // From there frame by frame: selected is the key that it comes from.
    for frame in 1..=keys(&harness).last().unwrap().1 as u32 {
        let frame = f64::from(frame);
        harness.state_mut().scrub(frame);
        let before = |&&(_, at): &&(Selection, f64)| at <= frame;
        let keys = keys(&harness);
        let (at, first) = *keys.iter().rfind(before).unwrap();
        assert_eq!(harness.state().document.selection(), at, "frame {frame}");
        let hold = harness.state().orientation().unwrap().hold;
        let rests = frame <= first + f64::from(hold);
        let shown = harness.state().shown().unwrap();
        assert_eq!(shown.missing == Missing::Nothing, rests, "frame {frame}");
    }
}

#[test]
fn a_click_near_a_mark_means_the_mark() {
    let mut harness = pyramid_window();
    for (at, frame) in keys(&harness) {
        for by in [-5.0, 0.0, 5.0] {
            let pos = place(&harness, frame) + vec2(by, 0.0);
            press(&mut harness, pos, PointerButton::Primary);
            release(&mut harness, pos, PointerButton::Primary);
            assert_eq!(harness.state().document.selection(), at, "{by}");
            assert_eq!(harness.state().position_on_bar(), frame);
        }
    }
    // A drag goes through all frames, also those beside a mark.
    let frame = keys(&harness)[1].1;
    let from = place(&harness, on_the_way(&harness));
    press(&mut harness, from, PointerButton::Primary);
    let beside = place(&harness, frame) + vec2(4.0, 0.0);
    motion(&mut harness, beside);
    assert_ne!(harness.state().position_on_bar(), frame);
    release(&mut harness, beside, PointerButton::Primary);
}

#[test]
fn with_ctrl_or_shift_marks_select_points() {
    let mut harness = pyramid_window();
    let marks: Vec<_> = keys(&harness)
        .into_iter()
        .filter(|(at, _)| at.orientation == 0)
        .map(|(at, frame)| (at.point, frame))
        .collect();
    let click = |harness: &mut Harness<'_, Editor>, at: usize, held: Modifiers| {
        let pos = place(harness, marks[at].1) + vec2(2.0, 0.0);
        hold(harness, held);
        press(harness, pos, PointerButton::Primary);
        release(harness, pos, PointerButton::Primary);
        hold(harness, Modifiers::NONE);
    };
    let selected = |harness: &Harness<'_, Editor>| harness.state().all_selected();
    click(&mut harness, 1, Modifiers::NONE);
    assert_eq!(selected(&harness), [1]);
    click(&mut harness, 4, Modifiers::CTRL);
    assert_eq!(selected(&harness), [1, 4]);
    click(&mut harness, 1, Modifiers::CTRL);
    assert_eq!(selected(&harness), [4]);
    click(&mut harness, 2, Modifiers::SHIFT);
    assert_eq!(selected(&harness), [2, 3, 4]);
    click(&mut harness, 0, Modifiers::NONE);
    assert_eq!(selected(&harness), [0]);
}

#[test]
fn beside_the_keys_the_roll_is_that_about_the_spaces_own_up() {
    let mut harness = pyramid_window();
    let space = Space {
        centre: DVec3::new(6.0, 4.0, 2.5),
        half_size: 15.0,
        up: Up::Z,
    };
    let edit = Edit::SetSpace { space, fit: true };
    harness.state_mut().document.apply(edit).unwrap();
    harness.run();
    let frame = on_the_way(&harness);
    harness.state_mut().scrub(frame);
    harness.run();
    let editor = harness.state();
    let pose = editor.document.sampler().unwrap().pose(frame).unwrap();
    let shown = editor.shown().unwrap();
    assert_ne!(shown.missing, Missing::Nothing);
    let roll = shown.orientation.roll.to_radians();
    let up = space.up.up_from_roll(pose.vpn.into(), roll);
    assert!(up.abs_diff_eq(pose.vup.into(), 1e-9), "{roll}");
}

#[test]
fn beside_the_keys_the_panels_show_what_the_camera_does() {
    for language in [Language::English, Language::German] {
        let texts = language.texts();
        let mut harness = window(editor(pyramid(), language), vec2(1200.0, 800.0), 1.0);
        let frame = on_the_way(&harness);
        assert!(harness.query_by_label(texts.position.add_here).is_none());
        harness.state_mut().scrub(frame);
        harness.run();
        let pose = harness
            .state()
            .document
            .sampler()
            .unwrap()
            .pose(frame)
            .unwrap();
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            let name = crate::texts::fill(texts.position.coordinate, &[&letter]);
            let value = harness.get_by_label(&name).value().unwrap();
            assert_eq!(value, language.number(pose.vrp[axis], 3));
        }
        let shown = harness.state().shown().unwrap();
        assert!(
            shown
                .orientation
                .view(shown.position)
                .abs_diff_eq(pose.vpn.into(), 1e-9)
        );
        let up = orientation::up_from_roll(pose.vpn.into(), shown.orientation.roll.to_radians());
        assert!(up.abs_diff_eq(pose.vup.into(), 1e-9));
        assert_eq!(shown.orientation.zoom, pose.zoom);
        // Fainter than what somebody has set.
        let colours = |harness: &Harness<'_, Editor>| {
            let wanted = language.number(pose.vrp[0], 3);
            let panels = harness.ctx.content_rect().right() - 260.0;
            let shapes = harness.output().shapes.iter();
            let texts = shapes.filter_map(|clipped| match &clipped.shape {
                egui::Shape::Text(text) if text.pos.x > panels => Some(text),
                _ => None,
            });
            let found = texts.filter(|text| text.galley.text() == wanted);
            found
                .map(|text| text.galley.job.sections[0].format.color)
                .collect::<Vec<_>>()
        };
        let palette = harness.state().setup.theme().palette();
        assert_eq!(colours(&harness), [palette.weak]);
        // The button makes a point of it, there and nowhere else, in one step.
        let before = (text(&harness), others(&harness, None));
        let flight = poses(harness.state());
        harness.get_by_label(texts.position.add_here).click();
        harness.run();
        assert_eq!(harness.state().document.selection(), Selection::at(2, 0));
        assert_same(&others(&harness, Some(2)), &before.1);
        let (point, new) = (
            harness.state().point().unwrap(),
            harness.state().orientation().unwrap(),
        );
        assert!(point.position.abs_diff_eq(shown.position, 1e-12));
        let view = |orientation: &Orientation| orientation.view(shown.position);
        assert!(view(new).abs_diff_eq(view(&shown.orientation), 1e-9));
        assert!((new.roll - shown.orientation.roll).abs() < 1e-9);
        assert!((new.zoom - shown.orientation.zoom).abs() < 1e-9);
        // The flight is what it was.
        for (a, b) in flight.iter().zip(&poses(harness.state())) {
            assert!(DVec3::from(a.vrp).abs_diff_eq(b.vrp.into(), 1e-9));
            assert!(DVec3::from(a.vpn).abs_diff_eq(b.vpn.into(), 1e-6));
        }
        assert_eq!(colours(&harness), [palette.text]);
        assert!(harness.query_by_label(texts.position.add_here).is_none());
        assert!(harness.state_mut().document.undo());
        assert_eq!(text(&harness), before.0);
        assert!(!harness.state().document.can_undo());
    }
}

#[test]
fn what_is_typed_beside_the_keys_makes_a_point_and_changes_no_other() {
    for (name, value) in [("Position y", 0.77), ("Zoom value", 35.0), ("Roll", 12.0)] {
        let mut harness = pyramid_window();
        let frame = on_the_way(&harness);
        harness.state_mut().scrub(frame);
        harness.run();
        let before = (text(&harness), others(&harness, None));
        let pose = harness
            .state()
            .document
            .sampler()
            .unwrap()
            .pose(frame)
            .unwrap();
        let field = |harness: &Harness<'_, Editor>| {
            let all = harness.get_all_by_role_and_label(egui::Role::SpinButton, name);
            all.last().unwrap().rect().center()
        };
        let at = field(&harness);
        press(&mut harness, at, PointerButton::Primary);
        release(&mut harness, at, PointerButton::Primary);
        harness.event(Event::Text(value.to_string()));
        harness.run();
        tap(&mut harness, Key::Enter, Modifiers::NONE);
        harness.run();
        assert_same(&others(&harness, Some(2)), &before.1);
        let point = harness.state().point().unwrap().clone();
        let [only] = point.orientations.as_slice() else {
            panic!("one orientation");
        };
        let found = match name {
            "Roll" => only.roll,
            "Zoom value" => only.zoom,
            _ => point.position.y,
        };
        assert_eq!(found, value, "{name}");
        assert!((point.position.x - pose.vrp[0]).abs() < 1e-12);
        assert!(harness.state_mut().document.undo());
        assert_eq!(text(&harness), before.0, "{name}");
        // The same by a drag, and Escape takes the point away again.
        for ends in [true, false] {
            harness.state_mut().scrub(frame);
            harness.run();
            let at = field(&harness);
            press(&mut harness, at, PointerButton::Primary);
            for step in 1..20_u8 {
                motion(&mut harness, at + vec2(f32::from(step) * 2.0, 0.0));
            }
            assert_same(&others(&harness, Some(2)), &before.1);
            if !ends {
                tap(&mut harness, Key::Escape, Modifiers::NONE);
            }
            release(&mut harness, at + vec2(40.0, 0.0), PointerButton::Primary);
            harness.run();
            assert_eq!(harness.state_mut().document.undo(), ends, "{name}");
            assert_eq!(text(&harness), before.0, "{name}");
        }
    }
}

#[test]
fn in_a_pan_an_orientation_is_made() {
    let mut harness = pyramid_window();
    let keys = keys(&harness);
    let pan = keys.iter().position(|(at, _)| at.orientation == 1).unwrap();
    let point = keys[pan].0.point;
    let rest = f64::from(harness.state().document.path().points[point].orientations[0].hold);
    let frame = ((keys[pan - 1].1 + rest + keys[pan].1) / 2.0).floor();
    harness.state_mut().scrub(frame);
    harness.run();
    let shown = harness.state().shown().unwrap();
    assert_eq!(shown.missing, Missing::Orientation);
    let count = harness.state().point().unwrap().orientations.len();
    let before = others(&harness, Some(point));
    tap(&mut harness, Key::K, Modifiers::CTRL);
    harness.run();
    assert_eq!(
        harness.state().document.selection(),
        Selection::at(point, 1)
    );
    assert_eq!(
        harness.state().point().unwrap().orientations.len(),
        count + 1
    );
    assert_eq!(harness.state().orientation(), Some(&shown.orientation));
    assert_eq!(others(&harness, Some(point)), before);
    // There is a key now.
    tap(&mut harness, Key::K, Modifiers::CTRL);
    harness.run();
    let said = harness.state().message.as_ref().unwrap().text.clone();
    assert_eq!(said, harness.state().texts().position.is_a_key);
    assert_eq!(
        harness.state().point().unwrap().orientations.len(),
        count + 1
    );
}

#[test]
fn whoever_types_stops_the_flight() {
    let mut harness = pyramid_window();
    harness.get_by_label("Play").click();
    for _ in 0..50 {
        harness.step();
    }
    assert!(harness.state().playing.is_playing());
    harness.get_by_label("Position y").click();
    for _ in 0..4 {
        harness.step();
    }
    assert!(!harness.state().playing.is_playing());
    let frame = harness.state().position_on_bar();
    let before = others(&harness, None);
    harness.event(Event::Text("0.9".to_owned()));
    harness.run();
    tap(&mut harness, Key::Enter, Modifiers::NONE);
    harness.run();
    let at = harness.state().document.selection().point;
    assert_eq!(harness.state().point().unwrap().position.y, 0.9);
    assert_same(&others(&harness, Some(at)), &before);
    assert!(frame > 1.0);
}

#[test]
fn beside_the_keys_a_key_with_another_up_shows_what_it_becomes() {
    for up in [
        UpVector::Minimal,
        UpVector::Point(DVec3::new(0.4, 3.0, 0.3)),
    ] {
        let mut harness = pyramid_window();
        let context = harness.ctx.clone();
        let count = harness.state().document.path().points.len();
        for point in 0..count {
            let document = &mut harness.state_mut().document;
            document.select(point, 0).unwrap();
            let action = Action::Path(PathAction::SetUp(up.clone()));
            harness.state_mut().act(action, &context);
        }
        let frame = on_the_way(&harness);
        harness.state_mut().scrub(frame);
        harness.run();
        let pose = |harness: &Harness<'_, Editor>| {
            let sampler = harness.state().document.sampler().unwrap();
            sampler.pose(frame).unwrap()
        };
        let before = pose(&harness);
        let shown = harness.state().shown().unwrap();
        assert_eq!(shown.missing, Missing::Point);
        assert_eq!(shown.orientation.own.up.name(), up.name());
        harness
            .state_mut()
            .act(Action::Path(PathAction::AddHere), &context);
        harness.run();
        // The key that comes has what was shown, and the picture stays.
        let made = harness.state().orientation().unwrap();
        assert_eq!(made.own.up.name(), up.name());
        // As near as an insertion keeps views.
        let off = made.roll - shown.orientation.roll;
        assert!(off.abs() < 0.1, "{off}");
        let after = pose(&harness);
        for (a, b) in before.vup.iter().zip(after.vup) {
            assert!((a - b).abs() < 2e-3, "{} {before:?} {after:?}", up.name());
        }
        for (a, b) in before.vrp.iter().zip(after.vrp) {
            assert!((a - b).abs() < 1e-3);
        }
    }
}
