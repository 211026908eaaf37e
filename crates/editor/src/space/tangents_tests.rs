//! Kinds of the curve, own tangents and what a key owns, as a user meets them.

use egui::{Event, Key, Modifiers, PointerButton, vec2};
use egui_kittest::kittest::Queryable;
use vides_document::{At, Edit};
use vides_engine::path;
use vides_engine::path::{CurveKind, CurveParameters, Tangents, UpVector, curve};

use super::pointer::PLANES;
use super::tangents::tip;
use super::tests::{
    editor, hold, image, key, message, motion, press, pyramid, release, shown, tap, text, window,
};
use super::*;
use crate::action::PathAction;
use crate::screenshots::screenshot;
use crate::setup::Theme;
use crate::state::space::{Joint, Side};
use crate::tests::{BOTH, LARGE, SMALL, Window, enter, poses, some_points};
use crate::texts::{Language, fill};

/// A point with neighbours on both sides.
const AT: usize = 4;
const SIDES: [Side; 2] = [Side::Before, Side::After];

fn at_point(language: Language) -> Window {
    let mut editor = editor(pyramid(), language);
    editor.document.select(AT, 0).unwrap();
    window(editor, LARGE.into(), 1.0)
}

/// Opens the choice of this name, and chooses.
fn choose(harness: &mut Window, name: &str, entry: &str) {
    harness.get_by_label(name).click();
    harness.run();
    harness.get_by_label(entry).click();
    harness.run();
}

/// A window whose current point owns tangents, the one before it half as long.
fn with_tangents(language: Language) -> Window {
    let mut harness = at_point(language);
    let old = curve::tangents(harness.state().document.path(), AT);
    let tangents = Some(Tangents {
        before: old.before / 2.0,
        after: old.after,
    });
    let edit = Edit::set(At::Point(AT), "tangents", tangents);
    harness.state_mut().document.apply(edit).unwrap();
    harness.run();
    harness
}

fn own(harness: &Window) -> Tangents {
    let tangents = harness.state().document.path().points[AT].tangents;
    tangents.expect("tangents of its own")
}

fn end(harness: &Window, side: Side) -> DVec3 {
    tip(&harness.state().document, side).expect("a handle")
}

/// Every place of the flight, bit by bit.
fn places(harness: &Window) -> Vec<[u64; 3]> {
    let poses = poses(harness.state());
    poses
        .iter()
        .map(|pose| pose.vrp.map(f64::to_bits))
        .collect()
}

/// One step, whose undoing restores every bit.
fn is_one_step(harness: &mut Window, before: &str) {
    assert!(!harness.state().document.in_step());
    assert_ne!(text(harness), before);
    assert!(harness.state_mut().document.undo());
    assert_eq!(text(harness), before);
    assert!(harness.state_mut().document.redo());
}

#[test]
fn a_point_owns_the_tangents_that_it_has_and_no_bit_of_the_curve_changes() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut harness = at_point(language);
        let (before, flight) = (text(&harness), places(&harness));
        choose(&mut harness, texts.choice, texts.own_tangents);
        assert_eq!(places(&harness), flight);
        is_one_step(&mut harness, &before);
        harness.run();
        let heading = format!("{}: {}", texts.curve, texts.tangents);
        assert!(harness.query_by_label(&heading).is_some());
        // T, C and B take their place, which is told.
        let owning = text(&harness);
        let tension = format!("{} (t1)", language.texts().curve.tension);
        let value = if language == Language::German {
            "0,5"
        } else {
            "0.5"
        };
        let field = crate::tests::number(&harness, &tension).rect().center();
        harness.hover_at(field);
        for _ in 0..80 {
            harness.step();
        }
        let told = |text: &String| text.contains(texts.in_place_of_tangents);
        assert!(shown(&harness).iter().any(told));
        enter(&mut harness, &tension, value);
        let point = harness.state().point().unwrap();
        assert_eq!(point.tangents, None);
        assert!(matches!(point.curve, CurveParameters::Own(tcb) if tcb.tension == 0.5));
        assert!(harness.state_mut().document.undo());
        assert_eq!(text(&harness), owning);
        harness.run();
        // So does a preset, the one that it had before, too.
        let used = match harness.state().point().unwrap().curve {
            CurveParameters::Preset(preset) => usize::from(preset),
            CurveParameters::Own(_) => 0,
        };
        let action = Action::Edit(Edit::set(
            At::Point(harness.state().document.selection().point),
            "preset",
            used,
        ));
        let context = harness.ctx.clone();
        harness.state_mut().act(action, &context);
        assert_eq!(harness.state().point().unwrap().tangents, None);
        assert!(harness.state_mut().document.undo());
        assert_eq!(text(&harness), owning);
        harness.run();
        choose(&mut harness, texts.choice, texts.by_shape);
        assert_eq!(text(&harness), before);
        enter(&mut harness, &tension, value);
        assert_ne!(text(&harness), before);
    }
}

/// What is switched holds for all that are selected; a drag bends at one alone.
#[test]
fn several_points_own_their_tangents_at_once() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut harness = at_point(language);
        let (before, flight) = (text(&harness), places(&harness));
        let context = harness.ctx.clone();
        let all = Action::Choose(crate::state::selected::SelectionChange::All);
        harness.state_mut().act(all, &context);
        choose(&mut harness, texts.choice, texts.own_tangents);
        let all = |harness: &Window| -> Vec<Option<Tangents>> {
            let points = &harness.state().document.path().points;
            points.iter().map(|point| point.tangents).collect()
        };
        let given = all(&harness);
        assert!(given.iter().all(Option::is_some));
        assert_eq!(places(&harness), flight);
        is_one_step(&mut harness, &before);
        harness.run();
        drag(&mut harness, Modifiers::NONE);
        let now = all(&harness);
        let changed: Vec<usize> = (0..given.len())
            .filter(|&at| now[at] != given[at])
            .collect();
        assert_eq!(changed, [AT]);
        assert_eq!(harness.state().all_selected().len(), given.len());
    }
}

#[test]
fn the_points_menu_has_the_switch_too() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut harness = at_point(language);
        let before = text(&harness);
        for entry in [texts.own_tangents, texts.by_shape] {
            tap(&mut harness, Key::F10, Modifiers::SHIFT);
            harness.run();
            harness.get_by_label(entry).click();
            harness.run();
            let owns = harness.state().joint().is_some();
            assert_eq!(owns, entry == texts.own_tangents);
        }
        assert_eq!(text(&harness), before);
    }
}

#[test]
fn the_ends_of_tangents_are_dragged_as_points_are() {
    for (side, (which, axis)) in SIDES
        .into_iter()
        .zip([PLANES; 2])
        .flat_map(|(side, planes)| planes.map(|plane| (side, plane)))
    {
        let language = BOTH[axis.index() % 2];
        let texts = &language.texts().space;
        let mut harness = with_tangents(language);
        let (before, first) = (text(&harness), own(&harness));
        let from = end(&harness, side);
        let start = image(&harness, from);
        motion(&mut harness, start);
        let name = match side {
            Side::Before => texts.before,
            Side::After => texts.after,
        };
        let hinted = |harness: &Window| shown(harness).iter().any(|text| text.starts_with(name));
        assert!(hinted(&harness), "{side:?}");
        press(&mut harness, start, which);
        for step in 1..=5_u8 {
            let pointer = start + vec2(-5.0, 4.0) * f32::from(step);
            motion(&mut harness, pointer);
            let now = end(&harness, side);
            assert!(image(&harness, now).distance(pointer) < 1e-3, "{axis:?}");
            let index = axis.index();
            assert_eq!(now[index].to_bits(), from[index].to_bits());
            let [led, was] = [own(&harness), first].map(|tangents| match side {
                Side::Before => tangents.before,
                Side::After => tangents.after,
            });
            assert_eq!(led[index].to_bits(), was[index].to_bits());
            assert!(hinted(&harness));
            let (said, error) = message(&harness).unwrap();
            let words = fill(texts.tangent_at, &[&"", &"", &""]);
            assert!(said.starts_with(&words[..4]) && !error, "{said}");
            // The curve passes with this tangent: a third of its derivative, as a
            // difference of second order gives it, leads to the handle.
            let path = harness.state().document.path();
            let (segment, u, h) = match side {
                Side::Before => (AT - 1, 1.0, -1e-4),
                Side::After => (AT, 0.0, 1e-4),
            };
            let curve = curve::segment(path, segment);
            let [p, q, r] = [0.0, 1.0, 2.0].map(|k| curve.point(u + k * h));
            let slope = (4.0 * q - 3.0 * p - r) / (2.0 * h);
            let to = p + slope / 3.0 * h.signum();
            assert!(to.distance(now) < 1e-6, "{to} {now}");
        }
        release(&mut harness, start + vec2(-25.0, 20.0), which);
        assert_eq!(crate::tests::said_besides_length(&harness), None);
        is_one_step(&mut harness, &before);
    }
}

/// Drags the end of the tangent behind the point while these keys are held.
fn drag(harness: &mut Window, held: Modifiers) {
    let start = image(harness, end(harness, Side::After));
    press(harness, start, PointerButton::Middle);
    hold(harness, held);
    motion(harness, start + vec2(22.0, 15.0));
    motion(harness, start + vec2(34.0, 21.0));
    release(harness, start + vec2(34.0, 21.0), PointerButton::Middle);
    hold(harness, Modifiers::NONE);
}

#[test]
fn the_other_tangent_turns_along_or_becomes_the_same_or_stays() {
    for language in BOTH {
        let texts = &language.texts().position;
        let words = [texts.smooth, texts.mirrored, texts.corner];
        for (joint, word) in Joint::ALL.into_iter().zip(words) {
            let mut harness = with_tangents(language);
            let (before, first) = (text(&harness), own(&harness));
            choose(&mut harness, texts.choice, word);
            assert_eq!(harness.state().joint(), Some(joint));
            // It is smooth already, and not yet mirrored.
            assert_eq!(text(&harness) != before, joint == Joint::Mirrored);
            let chosen = own(&harness);
            drag(&mut harness, Modifiers::NONE);
            let now = own(&harness);
            assert!(now.after.distance(chosen.after) > 0.1, "it was dragged");
            match joint {
                Joint::Smooth => {
                    assert!(now.before.angle_between(now.after) < 1e-7);
                    let length = now.before.length() - first.before.length();
                    assert!(length.abs() < 1e-12, "{length}");
                }
                Joint::Mirrored => {
                    let mean = (first.before.length() + first.after.length()) / 2.0;
                    assert!((chosen.before.length() - mean).abs() < 1e-12);
                    assert_eq!(now.before, now.after);
                }
                Joint::Corner => assert_eq!(now.before, first.before),
            }
            assert_eq!(harness.state().joint(), Some(joint));
        }
    }
}

#[test]
fn with_alt_one_tangent_is_dragged_alone_and_a_corner_becomes_smooth_again() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut harness = with_tangents(language);
        let first = own(&harness);
        drag(&mut harness, Modifiers::ALT);
        assert_eq!(own(&harness).before, first.before);
        assert_eq!(harness.state().joint(), Some(Joint::Corner));
        // A corner stays one, whoever drags.
        drag(&mut harness, Modifiers::NONE);
        assert_eq!(own(&harness).before, first.before);
        let old = own(&harness);
        choose(&mut harness, texts.choice, texts.smooth);
        let now = own(&harness);
        assert!(now.before.angle_between(now.after) < 1e-7);
        // Both have turned by as much, and kept their lengths.
        let turned = [(now.before, old.before), (now.after, old.after)];
        let [one, other] = turned.map(|(now, old)| {
            assert!((now.length() - old.length()).abs() < 1e-12);
            now.angle_between(old)
        });
        assert!((one - other).abs() < 1e-7 && one > 0.05, "{one} {other}");
        // Alt let go in the midst of a drag: the other one comes along again.
        let start = image(&harness, end(&harness, Side::After));
        press(&mut harness, start, PointerButton::Middle);
        hold(&mut harness, Modifiers::ALT);
        motion(&mut harness, start + vec2(30.0, 9.0));
        assert_eq!(own(&harness).before, now.before);
        hold(&mut harness, Modifiers::NONE);
        let along = own(&harness);
        assert!(along.before.angle_between(along.after) < 1e-7);
        release(&mut harness, start + vec2(30.0, 9.0), PointerButton::Middle);
    }
}

#[test]
fn a_tangent_goes_by_steps_finely_by_a_number_and_back() {
    let mut harness = with_tangents(Language::English);
    let before = text(&harness);
    let from = end(&harness, Side::After);
    let start = image(&harness, from);
    press(&mut harness, start, PointerButton::Middle);
    motion(&mut harness, start + vec2(30.0, 9.0));
    hold(&mut harness, Modifiers::CTRL);
    let snapped = end(&harness, Side::After);
    for axis in [0, 2] {
        let steps = snapped[axis] * 20.0;
        assert!((steps - steps.round()).abs() < 1e-9, "{snapped}");
    }
    hold(&mut harness, Modifiers::SHIFT);
    let place = |harness: &Window| image(harness, end(harness, Side::After));
    let seen = place(&harness);
    motion(&mut harness, start + vec2(50.0, 19.0));
    let way = place(&harness) - seen;
    assert!((way - vec2(2.0, 1.0)).length() < 0.01, "{way:?}");
    hold(&mut harness, Modifiers::NONE);
    // In another plane.
    let last = end(&harness, Side::After);
    key(&mut harness, Key::X, true, Modifiers::NONE);
    key(&mut harness, Key::X, false, Modifiers::NONE);
    motion(&mut harness, start + vec2(55.0, 29.0));
    let now = end(&harness, Side::After);
    assert_eq!(now.x.to_bits(), last.x.to_bits());
    assert!(now.y != last.y && now.z != last.z);
    harness.event(Event::Text("0.25".to_owned()));
    harness.step();
    let far = end(&harness, Side::After).distance(from);
    assert!((far - 0.25).abs() < 1e-9, "{far}");
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    assert_eq!(text(&harness), before);
    release(&mut harness, start, PointerButton::Middle);
    assert_eq!(text(&harness), before);
}

#[test]
fn an_open_path_has_a_handle_at_its_ends_where_the_curve_is() {
    let mut harness = at_point(Language::English);
    let last = harness.state().document.path().points.len() - 1;
    for (at, side) in [(0, Side::After), (last, Side::Before)] {
        harness.state_mut().select(at, 0);
        harness.state_mut().set_own_tangents(true);
        let sides = tangents::tips(&harness.state().document).map(|(side, _)| side);
        assert_eq!(sides.collect::<Vec<_>>(), [side]);
        // From outside of the cube it does not jump to its face.
        let path = harness.state().document.path();
        let position = path.points[at].position;
        let far = DVec3::new(1.6, 1.3, 1.5);
        let tangents = Some(match side {
            Side::After => Tangents {
                before: far,
                after: 3.0 * (far - position),
            },
            Side::Before => Tangents {
                before: 3.0 * (position - far),
                after: far,
            },
        });
        let edit = Edit::set(At::Point(at), "tangents", tangents);
        harness.state_mut().document.apply(edit).unwrap();
        harness.state_mut().setup.view.size = 0.5;
        harness.run();
        let start = image(&harness, far);
        press(&mut harness, start, PointerButton::Middle);
        motion(&mut harness, start + vec2(5.0, 0.0));
        assert!(end(&harness, side).distance(far) < 0.2);
        release(&mut harness, start, PointerButton::Middle);
    }
}

#[test]
fn the_kind_of_curve_is_chosen_and_what_cannot_be_is_told() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut harness = at_point(language);
        let before = text(&harness);
        for (kind, word) in [
            (CurveKind::Linear, texts.linear),
            (CurveKind::Cubic, texts.cubic),
        ] {
            choose(&mut harness, texts.choice, word);
            let path = harness.state().document.path();
            assert_eq!(path.curve, kind);
            let [p, q] = [AT - 1, AT].map(|at| path.points[at].position);
            let middle = curve::segment(path, AT - 1).point(0.5);
            let straight = middle.distance(p.midpoint(q)) < 1e-12;
            assert_eq!(straight, kind == CurveKind::Linear);
            let heading = format!("{}: {word}", texts.curve);
            assert!(harness.query_by_label(&heading).is_some());
            let chosen = text(&harness);
            let bias = format!("{} (b1)", language.texts().curve.bias);
            enter(&mut harness, &bias, "1");
            assert_eq!(text(&harness), chosen);
        }
        let context = harness.ctx.clone();
        harness
            .state_mut()
            .act(Action::Path(PathAction::SetUp(UpVector::Frenet)), &context);
        harness.run();
        let curved = text(&harness);
        choose(&mut harness, texts.choice, texts.tcb);
        let (said, error) = message(&harness).unwrap();
        let word = ["needs", "braucht"][usize::from(language == Language::German)];
        assert!(
            error && said.contains("frenet") && said.contains(word),
            "{said}"
        );
        choose(&mut harness, texts.choice, texts.own_tangents);
        assert!(message(&harness).is_some_and(|(_, error)| error));
        assert_eq!(text(&harness), curved);
        for _ in 0..3 {
            assert!(harness.state_mut().document.undo());
        }
        assert_eq!(text(&harness), before);
        assert!(!harness.state().document.can_undo());
    }
}

/// The curve window shows the curve that there is, of every kind.
#[test]
fn the_curve_window_says_what_its_numbers_do_to_tangents() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut harness = with_tangents(language);
        tap(&mut harness, Key::F2, Modifiers::NONE);
        harness.run();
        assert!(harness.query_by_label(texts.in_place_of_tangents).is_some());
        harness.state_mut().set_own_tangents(false);
        harness.run();
        assert!(harness.query_by_label(texts.in_place_of_tangents).is_none());
    }
}

#[test]
fn what_a_key_owns_is_given_back() {
    for language in BOTH {
        let texts = &language.texts().orientation;
        let mut document = some_points();
        document.select(2, 2).unwrap();
        let mut harness = window(editor(document, language), LARGE.into(), 1.0);
        let shows = |harness: &Window, name| harness.query_by_label(name).is_some();
        assert!(!shows(&harness, texts.own_turning));
        harness.get_by_label(language.texts().position.add).click();
        harness.run();
        assert_eq!(harness.state().document.selection().point, 3);
        assert!(shows(&harness, texts.own_turning));
        // The zoom has a slope of its own as well.
        let edit = harness.state().orientation_edit(|key| {
            key.own = key.own.with(|own| own.zoom_slope = Some(0.5)).unwrap();
        });
        harness.state_mut().document.apply(edit.unwrap()).unwrap();
        harness.run();
        for name in [texts.own_slope, texts.own_turning] {
            let before = text(&harness);
            harness.get_by_label(name).click();
            harness.run();
            assert!(!shows(&harness, name));
            is_one_step(&mut harness, &before);
        }
        let path = harness.state().document.path();
        let key = &path.points[3].orientations[0].own;
        assert!(key.velocities.is_none() && key.turning.is_none() && key.zoom_slope.is_none());
        // As smooth as any: the view turns equally fast on both sides of the key.
        let frames = |timeline: &path::Timeline| {
            let section = timeline.section_from(3, 0).expect("a section");
            (0..section)
                .map(|k| timeline.section(k).frames)
                .sum::<usize>()
        };
        let at = harness.state().document.timeline(frames).unwrap() as f64 + 1.0;
        let sampler = harness.state().document.sampler().unwrap();
        let view = |frame: f64| DVec3::from(sampler.pose(frame).unwrap().vpn);
        let [before, after] = [-0.01, 0.01].map(|h| (view(at + h) - view(at)) / h);
        let jump = before.distance(after) / before.length();
        assert!(jump < 0.02, "{jump}: {before} {after}");
    }
}

#[test]
fn pictures() {
    for (language, theme, size, name) in [
        (Language::German, Theme::Dark, LARGE, "de-dark"),
        (Language::English, Theme::Light, LARGE, "en-light"),
        (Language::German, Theme::Light, SMALL, "de-small"),
    ] {
        let mut document = some_points();
        document.select(2, 2).unwrap();
        let mut editor = editor(document, language);
        editor.setup.theme = Some(theme);
        let mut harness = window(editor, size.into(), 1.0);
        let texts = &language.texts().position;
        screenshot(&mut harness, &format!("tangents-{name}-before.png"));
        tap(&mut harness, Key::Insert, Modifiers::NONE);
        harness.run();
        let edit = harness.state().orientation_edit(|key| {
            key.own = key.own.with(|own| own.zoom_slope = Some(0.5)).unwrap();
        });
        harness.state_mut().document.apply(edit.unwrap()).unwrap();
        harness.run();
        let to = image(&harness, end(&harness, Side::After));
        press(&mut harness, to, PointerButton::Middle);
        motion(&mut harness, to + vec2(-25.0, 20.0));
        screenshot(&mut harness, &format!("tangents-{name}-drag.png"));
        release(&mut harness, to + vec2(-25.0, 20.0), PointerButton::Middle);
        harness.get_by_label(texts.choice).click();
        harness.run();
        screenshot(&mut harness, &format!("tangents-{name}-choice.png"));
        tap(&mut harness, Key::Escape, Modifiers::NONE);
        tap(&mut harness, Key::F2, Modifiers::NONE);
        harness.run();
        screenshot(&mut harness, &format!("tangents-{name}-window.png"));
    }
}
