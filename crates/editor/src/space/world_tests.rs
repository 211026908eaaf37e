//! Spaces of other sizes and places: the same picture, the same motions, other numbers.

use egui::{Key, Modifiers, PointerButton, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use image::RgbaImage;
use vides_document::{At, Edit, ObjectPoint};
use vides_engine::path::space::Move;
use vides_engine::path::{Space, Up};
use vides_engine::scene::{Kind, Light, Node};

use super::projection::tests::{in_cube, view};
use super::tests::{
    editor, hold, image, motion, position, press, pyramid, pyramid_window, release, tap, viewport,
    window,
};
use super::*;
use crate::screenshots::screenshot;
use crate::state::selected::SelectionChange;
use crate::texts::Language;

/// The example in another space, with its object.
fn carried(space: Space) -> Document {
    let mut document = pyramid();
    let to = Move::new(document.path().space, space);
    let edit = Edit::SetSpace { space, fit: true };
    document.apply(edit).unwrap();
    let mut info = document.info().clone();
    let object = info.object.iter().map(|point| ObjectPoint {
        position: to.place(point.position),
        ..*point
    });
    info.object = object.collect::<Vec<_>>().into();
    document.apply(Edit::SetInfo(Box::new(info))).unwrap();
    document.select(3, 0).unwrap();
    document
}

fn far_away(half_size: f64) -> Space {
    Space {
        centre: DVec3::new(1000.0, -700.0, 300.0) * half_size,
        half_size,
        up: Up::Y,
    }
}

fn shown<'a>(space: Space) -> Harness<'a, Editor> {
    window(
        editor(carried(space), Language::English),
        vec2(1200.0, 800.0),
        1.0,
    )
}

/// The largest difference of two pictures within the movement window.
fn apart(a: &RgbaImage, b: &RgbaImage, viewport: Rect) -> u8 {
    let (left, right) = (viewport.left() as u32, viewport.right() as u32);
    let (top, bottom) = (viewport.top() as u32, viewport.bottom() as u32);
    let places = (top..bottom).flat_map(|y| (left..right).map(move |x| (x, y)));
    let differences = places.flat_map(|(x, y)| {
        let (a, b) = (a.get_pixel(x, y).0, b.get_pixel(x, y).0);
        [0, 1, 2].map(|part: usize| a[part].abs_diff(b[part]))
    });
    differences.max().unwrap_or(0)
}

/// Pictures at rest, turned, played, and in the midst of drags; and where the point
/// came to, in half sizes.
fn seen(space: Space) -> (Vec<RgbaImage>, Rect, DVec3) {
    let mut harness = shown(space);
    let name = format!("world-{:e}-{}.png", space.half_size, space.centre.x);
    let mut pictures = vec![screenshot(&mut harness, &name)];
    let at = |harness: &Harness<'_, Editor>| harness.state().document.path().points[3].position;
    for (which, modifiers) in [
        (PointerButton::Middle, Modifiers::NONE),
        (PointerButton::Secondary, Modifiers::CTRL),
    ] {
        let from = image(&harness, at(&harness));
        press(&mut harness, from, which);
        hold(&mut harness, modifiers);
        motion(&mut harness, from + vec2(40.0, 21.0));
        pictures.push(screenshot(&mut harness, "world-drag.png"));
        release(&mut harness, from + vec2(40.0, 21.0), which);
        hold(&mut harness, Modifiers::NONE);
    }
    harness.state_mut().setup.view.rotation = -35.0;
    harness.state_mut().scrub(180.0);
    harness.run();
    pictures.push(screenshot(&mut harness, "world-turned.png"));
    let place = (at(&harness) - space.centre) / space.half_size;
    (pictures, viewport(&harness), place)
}

#[test]
fn the_movement_window_looks_the_same_in_any_space() {
    let (wanted, viewport, place) = seen(Space::default());
    for half_size in [1e-6, 1.0, 1e6] {
        let (found, its, moved) = seen(far_away(half_size));
        assert_eq!(its, viewport);
        assert!((moved - place).length() < 1e-9, "{half_size}");
        for (number, (a, b)) in wanted.iter().zip(&found).enumerate() {
            let apart = apart(a, b, viewport);
            assert!(apart <= 1, "{half_size} {number}: {apart}");
        }
    }
}

#[test]
fn the_vertical_axis_stands_upright_on_the_screen() {
    use proptest::test_runner::TestRunner;
    let space = Space {
        centre: DVec3::new(30.0, -20.0, 10.0),
        half_size: 5.0,
        up: Up::Z,
    };
    let viewport = super::projection::tests::viewport();
    let all = (view(), in_cube());
    TestRunner::default()
        .run(&all, |(view, p)| {
            let plain = Projection::new(&view, viewport);
            let there = Projection::of(&view, viewport, space);
            let far = plain.image(p) - there.image(space.place(p));
            proptest::prop_assert!(far.length() < 1e-6);
            let up = there.image_of_way(DVec3::Z);
            proptest::prop_assert!(up.x.abs() < 1e-9 && up.y <= 1e-9);
            Ok(())
        })
        .unwrap();
}

#[test]
fn keys_and_fields_count_in_the_space() {
    for (half_size, at, after, shown_as) in [
        (1.0, 0.25, 0.26, "0.260"),
        (1000.0, 250.0, 260.0, "260"),
        (1e-3, 0.000_25, 0.000_26, "0.000260"),
    ] {
        let space = Space {
            half_size,
            ..Space::default()
        };
        let mut document = carried(space);
        let position = DVec3::new(at, 0.0, 0.0);
        let edit = Edit::set(At::Point(3), "position", position);
        document.apply(edit).unwrap();
        let mut harness = window(
            editor(document, Language::English),
            vec2(1200.0, 800.0),
            1.0,
        );
        harness.state_mut().setup.view = View {
            rotation: 0.0,
            tilt: 0.0,
            ..View::default()
        };
        harness.run();
        harness.key_press(Key::ArrowRight);
        harness.run();
        let moved = harness.state().document.path().points[3].position;
        assert_eq!(moved, DVec3::new(after, 0.0, 0.0), "{half_size}");
        let field = harness.get_by_label("Position x");
        assert_eq!(field.value().as_deref(), Some(shown_as));
    }
}

/// A field's value fits into it whole: nothing of a thousandth of the half size is lost.
#[test]
fn fields_of_a_far_space_show_a_thousandth_of_it() {
    for (half_size, shown_as) in [(1e-6, "0.000999750"), (1.0, "999.750"), (1e6, "999750000")] {
        let mut document = carried(far_away(half_size));
        let position = DVec3::new(999.75, -700.25, 300.5) * half_size;
        let edit = Edit::set(At::Point(3), "position", position);
        document.apply(edit).unwrap();
        let editor = editor(document, Language::English);
        let mut harness = window(editor, vec2(1200.0, 800.0), 1.0);
        let name = format!("far-fields-{half_size:e}.png");
        screenshot(&mut harness, &name);
        let field = harness.get_by_label("Position x");
        assert_eq!(field.value().as_deref(), Some(shown_as));
        let wide = field.rect().width();
        assert!(wide > 120.0, "{half_size}: {wide}");
    }
}

#[test]
fn the_space_window_changes_it_in_one_step() {
    for language in [Language::English, Language::German] {
        let texts = &language.texts().space_window;
        let mut harness = window(editor(pyramid(), language), vec2(1200.0, 800.0), 1.0);
        let before = harness.state().document.path().clone();
        let context = harness.ctx.clone();
        harness
            .state_mut()
            .act(crate::action::Action::Space, &context);
        harness.run();
        screenshot(&mut harness, &format!("space-window-{language:?}.png"));
        let press = |harness: &mut Harness<'_, Editor>, label: &str| {
            harness.get_by_label(label).click();
            harness.run();
        };
        press(&mut harness, "z");
        press(&mut harness, texts.fit);
        press(&mut harness, texts.apply);
        let path = harness.state().document.path();
        let z_up = Space {
            up: Up::Z,
            ..Space::default()
        };
        assert_eq!(path.space, z_up);
        let p = before.points[0].position;
        assert_eq!(path.points[0].position, DVec3::new(p.z, p.x, p.y));
        press(&mut harness, texts.to_path);
        press(&mut harness, texts.ok);
        assert!(harness.state().windows.space.is_none());
        let around = harness.state().document.path().space;
        assert!(around.half_size < 1.0 && around.up == Up::Z, "{around:?}");
        assert!(harness.state_mut().document.undo());
        assert!(harness.state_mut().document.undo());
        assert_eq!(*harness.state().document.path(), before);
    }
}

/// Another upright axis turns no camera on its side, in a path and in a scene, beside another middle.
#[test]
fn another_upright_axis_keeps_the_views_as_seen() {
    let light = Node::new("light", Kind::Light(Light::Point));
    let mut scene = pyramid();
    scene.apply(Edit::AddNodes(vec![light])).unwrap();
    for (document, language) in [
        (pyramid(), Language::English),
        (pyramid(), Language::German),
        (scene, Language::English),
    ] {
        let texts = &language.texts().space_window;
        let mut harness = window(editor(document, language), vec2(1200.0, 800.0), 1.0);
        let before = crate::tests::poses(harness.state());
        let old = harness.state().document.path().space;
        let context = harness.ctx.clone();
        let open = crate::action::Action::Space;
        harness.state_mut().act(open, &context);
        harness.run();
        harness.get_by_label("z").click();
        harness.run();
        let pending = harness.state_mut().windows.space.as_mut().unwrap();
        pending.space.centre.x += 0.25;
        harness.get_by_label(texts.apply).click();
        harness.run();
        let document = &harness.state().document;
        let space = document.path().space;
        assert_eq!((space.up, space.centre.x), (Up::Z, old.centre.x + 0.25));
        if let Some(edited) = document.edited_scene() {
            assert_eq!(edited.scene().space(), space);
        }
        let after = crate::tests::poses(harness.state());
        assert_eq!(after.len(), before.len());
        for (now, then) in after.iter().zip(&before) {
            for (a, b) in [
                (now.vrp, then.vrp),
                (now.vpn, then.vpn),
                (now.vup, then.vup),
            ] {
                assert!(DVec3::from(a).distance(b.into()) < 1e-9, "{now:?} {then:?}");
            }
        }
        assert!(harness.state_mut().document.undo());
        assert_eq!(harness.state().document.path().space, old);
    }
}

#[test]
fn the_path_goes_along_into_a_space_that_is_found_for_it() {
    for language in [Language::English, Language::German] {
        let texts = &language.texts().space_window;
        for found in [texts.to_object, texts.to_path] {
            let mut harness = window(editor(pyramid(), language), vec2(1200.0, 800.0), 1.0);
            let before = harness.state().document.path().clone();
            let context = harness.ctx.clone();
            harness
                .state_mut()
                .act(crate::action::Action::Space, &context);
            harness.run();
            for label in [texts.fit, found] {
                harness.get_by_label(label).click();
                harness.run();
            }
            screenshot(&mut harness, &format!("space-window-fit-{language:?}.png"));
            harness.get_by_label(texts.ok).click();
            harness.run();
            let path = harness.state().document.path();
            let space = path.space;
            assert_ne!(space, before.space);
            for (now, then) in path.points.iter().zip(&before.points) {
                let wanted = space.centre + then.position * space.half_size;
                assert!(now.position.distance(wanted) < 1e-9, "{}", now.position);
            }
        }
    }
}

/// Alone it has the cube and its own place; with others what is left for all of them.
#[test]
fn a_point_outside_the_space_stays_until_it_comes_in() {
    let mut harness = pyramid_window();
    let to = |at, place: DVec3| Edit::set(At::Point(at), "position", place);
    let document = &mut harness.state_mut().document;
    document.apply(to(1, DVec3::new(1.5, 0.0, 0.25))).unwrap();
    document.apply(to(2, DVec3::new(0.5, -0.75, 0.0))).unwrap();
    let (low, high) = (DVec3::NEG_ONE, DVec3::new(1.5, 1.0, 1.0));
    let choose = |harness: &mut Harness<'_, Editor>, points: &[usize]| {
        let context = harness.ctx.clone();
        let choice = SelectionChange::These(points.to_vec());
        harness.state_mut().act(Action::Choose(choice), &context);
        harness.step();
    };
    let positions = |harness: &Harness<'_, Editor>| [1, 2].map(|at| position(harness, at));
    choose(&mut harness, &[1]);
    assert_eq!(harness.state().room_of(1), [low, high]);
    choose(&mut harness, &[1, 2]);
    let low = DVec3::new(0.0, -0.25, -0.75);
    assert_eq!(harness.state().room_of(1), [low, high]);
    let by = DVec3::new(1.0, 0.75, 0.25);
    assert_eq!(harness.state().room_of(2), [low - by, high - by]);
    choose(&mut harness, &[1, 2]);
    for &key in &keyboard::NUDGES[..6] {
        let from = positions(&harness);
        tap(&mut harness, key, Modifiers::SHIFT);
        let now = positions(&harness);
        let by = now[0] - from[0];
        assert!((now[1] - from[1]).distance(by) < 1e-12, "{key:?}");
        assert!(now[0].x <= from[0].x, "{key:?} {by}");
    }
    assert!(positions(&harness)[0].x < 1.5);
}
