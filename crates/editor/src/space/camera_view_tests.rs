//! Tests of [`super`].

use egui::Modifiers;
use egui_kittest::kittest::Queryable as _;
use glam::{DMat4, DVec2, DVec3};
use proptest::prelude::*;
use vides_engine::math::camera::{CameraAxes, Clip};
use vides_engine::math::orientation::{unit, up_from_roll};
use vides_engine::math::view::View;

use super::super::camera_picture::{FRONT, on_picture, seen};
use super::*;

const ASPECT: f64 = 1.5;

fn camera() -> impl Strategy<Value = Camera> {
    let vector = || prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from_array);
    (vector(), vector(), -180.0..180.0f64, 1.0..100.0f64)
        .prop_filter("a direction", |(_, view, ..)| view.length() > 0.01)
        .prop_map(|(position, view, roll, zoom)| {
            let view = unit(view);
            Camera {
                position,
                view,
                up: up_from_roll(view, roll.to_radians()),
                zoom,
            }
        })
}

fn matrix(camera: &Camera, back: f64) -> DMat4 {
    View::from_pose(
        camera.position,
        camera.view,
        camera.up,
        camera.zoom,
        ASPECT,
        FRONT,
        back,
    )
    .unwrap()
    .matrix()
    .unwrap()
}

proptest! {
    /// A pinhole: as far to the side as to the front times the tangent.
    #[test]
    fn it_is_what_a_pinhole_sees(
        camera in camera(), from in prop::array::uniform3(-1.0..1.0f64),
        to in prop::array::uniform3(-1.0..1.0f64),
    ) {
        let [from, to] = [from, to].map(DVec3::from_array);
        let found = seen(&matrix(&camera, 20.0), FRONT / 20.0, from, to);
        let right = camera.view.cross(camera.up);
        let half_height = 12.0 / camera.zoom;
        let pinhole = |p: DVec3| {
            let way = p - camera.position;
            let depth = way.dot(camera.view);
            let image = DVec2::new(
                way.dot(right) / depth / half_height / ASPECT,
                way.dot(camera.up) / depth / half_height,
            );
            (depth, image)
        };
        for step in 0..=300 {
            let (depth, image) = pinhole(from.lerp(to, f64::from(step) / 300.0));
            // Within the picture by a margin: that point is on the line that
            // was found. Outside by a margin: it is not.
            let size = image.abs().max_element();
            if depth > FRONT * 1.001 && size < 0.999 {
                let Some([a, b]) = found else {
                    prop_assert!(false, "a line is missing");
                    return Ok(());
                };
                let way = b - a;
                let t = ((image - a).dot(way) / way.length_squared().max(1e-300)).clamp(0.0, 1.0);
                prop_assert!((a + way * t).distance(image) < 1e-6);
            }
        }
        for end in found.into_iter().flatten() {
            prop_assert!(end.abs().max_element() <= 1.0 + 1e-9);
        }
    }

    /// What a program draws by the matrices for OpenGL lies on the picture's pixels.
    #[test]
    fn it_is_what_opengl_draws(
        camera in camera(), place in prop::array::uniform3(-1.0..1.0f64),
    ) {
        let place = DVec3::from_array(place);
        let size = vec2(300.0, 200.0);
        let picture = Rect::from_min_size(Pos2::new(7.0, 9.0), size);
        let eye = CameraAxes::OpenGl.from_world(camera.position, camera.view, camera.up).unwrap();
        let clip = Clip { from_minus_one: true, reversed: false, y_down: false };
        let projection = clip.projection(camera.zoom, ASPECT, FRONT, 20.0).unwrap();
        let drawn = projection * (eye * place.extend(1.0));
        let drawn = drawn / drawn.w;
        if let Some([seen, _]) = seen(&matrix(&camera, 20.0), FRONT / 20.0, place, place) {
            // As glViewport has it, from the lower left.
            let x = 7.0 + (drawn.x + 1.0) / 2.0 * f64::from(size.x);
            let y = 9.0 + 200.0 - (drawn.y + 1.0) / 2.0 * f64::from(size.y);
            let seen = on_picture(seen, picture);
            prop_assert!((f64::from(seen.x) - x).hypot(f64::from(seen.y) - y) < 1e-3);
            prop_assert!(drawn.z.abs() <= 1.0 + 1e-9);
        } else {
            prop_assert!(drawn.abs().max_element() > 1.0 - 1e-9);
        }
    }
}

#[test]
fn the_picture_is_upright_and_not_mirrored() {
    let picture = Rect::from_min_size(Pos2::ZERO, vec2(300.0, 200.0));
    let camera = Camera {
        position: DVec3::new(0.0, 0.0, 3.0),
        view: DVec3::NEG_Z,
        up: DVec3::Y,
        zoom: 24.0,
    };
    let matrix = matrix(&camera, 20.0);
    let at = |p: DVec3| {
        let line = seen(&matrix, FRONT / 20.0, p, DVec3::ZERO).unwrap();
        on_picture(line[0], picture)
    };
    // 3 before it half the picture's height is 1.5.
    let near = |a: Pos2, b: Pos2| assert!(a.distance(b) < 1e-3, "{a} and {b}");
    near(at(DVec3::X), Pos2::new(150.0 + 100.0 / 1.5, 100.0));
    near(at(DVec3::Y), Pos2::new(150.0, 100.0 - 100.0 / 1.5));
    assert_eq!(
        seen(&matrix, FRONT / 20.0, DVec3::Z * 3.5, DVec3::Z * 9.0),
        None
    );
}

/// In a window that becomes small it becomes small too, and stays in its corner;
/// where somebody has put it, it stays as large as it is.
#[test]
fn the_pane_goes_along_with_the_window() {
    use crate::tests::{LARGE, SMALL, window};
    use crate::texts::Language;
    let pane = |window: &crate::tests::Window| {
        let id = egui::Id::unique("camera view");
        let rect = window.ctx.memory(|memory| memory.area_rect(id));
        (rect.unwrap(), window.get_by_label("Movement window").rect())
    };
    let mut window = window(Language::English);
    let (large, viewport) = pane(&window);
    assert!(
        (large.width() - first_width(viewport)).abs() < 4.0,
        "{large:?}"
    );
    assert!(large.width() > 1.4 * (WIDTH / 2.0), "{large:?}");
    let resize = |window: &mut crate::tests::Window, size: [f32; 2]| {
        window.set_size(vec2(size[0], size[1]));
        window.run();
        window.run();
    };
    for size in [SMALL, LARGE, SMALL] {
        resize(&mut window, size);
        let (rect, viewport) = pane(&window);
        assert!(
            (rect.width() - first_width(viewport)).abs() < 4.0,
            "{rect:?}"
        );
        let away = rect.right_top() - corner(viewport);
        assert!(away.length() < 4.0, "{rect:?} in {viewport:?}");
    }
    let (small, _) = pane(&window);
    let from = small.center();
    window.hover_at(from);
    window.run();
    window.drag_at(from);
    window.step();
    window.hover_at(from + vec2(-60.0, 90.0));
    window.step();
    window.drop_at(from + vec2(-60.0, 90.0));
    window.run();
    let (moved, _) = pane(&window);
    assert!((moved.min - small.min - vec2(-60.0, 90.0)).length() < 2.0);
    resize(&mut window, LARGE);
    let (after, _) = pane(&window);
    assert!((after.min - moved.min).length() < 2.0 && (after.width() - moved.width()).abs() < 2.0);
}

use crate::screenshots::screenshot;
use crate::setup::{Aspect, CameraPlace};
use crate::space::tests::{motion, press, pyramid_window, release, tap};
use vides_document::Selection;

type Harness = egui_kittest::Harness<'static, Editor>;

fn picture(harness: &Harness) -> Rect {
    harness.get_by_label("What the camera sees").rect()
}

#[test]
fn a_key_puts_the_picture_beside_the_space_in_its_place_and_back() {
    let mut harness = pyramid_window();
    let space = |harness: &Harness| harness.get_by_label("Movement window").rect();
    let (whole, small) = (space(&harness), picture(&harness));
    tap(&mut harness, Key::B, Modifiers::NONE);
    harness.step();
    screenshot(&mut harness, "camera-beside.png");
    let (left, right) = (space(&harness), picture(&harness));
    assert!(left.right() <= right.left() && left.width() < 0.51 * whole.width());
    assert!(whole.contains_rect(right) && right.area() > 4.0 * small.area());
    tap(&mut harness, Key::C, Modifiers::SHIFT);
    harness.step();
    harness.state_mut().setup.safe_frame = true;
    screenshot(&mut harness, "camera-whole.png");
    assert!(picture(&harness).width() > 0.95 * whole.width());
    // What it covers is not meant by the mouse.
    let before = harness.state().document.path().clone();
    let at = harness.state().document.path().points[0].position;
    let at = crate::space::tests::image(&harness, at);
    press(&mut harness, at, PointerButton::Primary);
    motion(&mut harness, at + vec2(40.0, 10.0));
    release(&mut harness, at + vec2(40.0, 10.0), PointerButton::Primary);
    assert_eq!(*harness.state().document.path(), before);
    tap(&mut harness, Key::C, Modifiers::SHIFT);
    harness.step();
    assert_eq!((space(&harness), picture(&harness)), (whole, small));
}

#[test]
fn the_picture_has_a_menu_of_its_own() {
    let mut harness = pyramid_window();
    harness
        .get_by_label("Options of the camera's picture")
        .click();
    harness.run();
    screenshot(&mut harness, "camera-menu.png");
    for (name, place, aspect, safe) in [
        ("16:9", CameraPlace::Corner, Aspect::Wide, false),
        ("Safe frame", CameraPlace::Corner, Aspect::Wide, true),
        (
            "Camera beside the space",
            CameraPlace::Beside,
            Aspect::Wide,
            true,
        ),
    ] {
        let entries = harness.query_all_by_label(name);
        // The menu lies above the caption's own buttons.
        entries.last().expect(name).click();
        harness.run();
        let setup = &harness.state().setup;
        assert_eq!(setup.camera_place, place, "{name}");
        assert_eq!((setup.camera_aspect, setup.safe_frame), (aspect, safe));
    }
}

#[test]
fn the_border_beside_the_space_is_dragged() {
    let mut harness = pyramid_window();
    let space = |harness: &Harness| harness.get_by_label("Movement window").rect();
    tap(&mut harness, Key::B, Modifiers::NONE);
    harness.step();
    let path = harness.state().document.path().clone();
    for (by, known) in [
        (-100.0, Some(100.0)),
        (-2000.0, None),
        (120.0, Some(-120.0)),
    ] {
        let before = space(&harness);
        let border = harness
            .get_by_label("Border of the camera's picture")
            .rect();
        let at = border.center();
        motion(&mut harness, at);
        press(&mut harness, at, PointerButton::Primary);
        motion(&mut harness, at + vec2(by / 2.0, 0.0));
        motion(&mut harness, at + vec2(by, 0.0));
        release(&mut harness, at + vec2(by, 0.0), PointerButton::Primary);
        harness.step();
        let (left, right) = (space(&harness), picture(&harness));
        assert!(left.right() <= right.left() && left.width() > 0.24 * before.width());
        if let Some(known) = known {
            assert!((before.width() - left.width() - known).abs() <= 4.0, "{by}");
        }
    }
    screenshot(&mut harness, "camera-border.png");
    assert_eq!(*harness.state().document.path(), path);
}

#[test]
fn what_was_flown_to_is_taken_over_as_a_point() {
    let mut harness = pyramid_window();
    tap(&mut harness, Key::B, Modifiers::NONE);
    harness.step();
    let at = picture(&harness).center();
    let first = harness.state().camera().unwrap().0;
    press(&mut harness, at, PointerButton::Primary);
    motion(&mut harness, at + vec2(8.0, 0.0));
    motion(&mut harness, at + vec2(80.0, 30.0));
    release(&mut harness, at + vec2(80.0, 30.0), PointerButton::Primary);
    let flown = harness.state().flown().expect("a free view");
    assert_eq!(flown.position, first.position);
    assert!(flown.view.dot(first.view) < 0.99);
    // Round what is in the middle, and towards it.
    press(&mut harness, at, PointerButton::Secondary);
    motion(&mut harness, at + vec2(-8.0, 0.0));
    motion(&mut harness, at + vec2(-60.0, 0.0));
    release(
        &mut harness,
        at + vec2(-60.0, 0.0),
        PointerButton::Secondary,
    );
    let flown = harness.state().flown().expect("a free view");
    assert!(flown.position != first.position);
    screenshot(&mut harness, "camera-flown.png");
    // Escape forgets it, and nothing has changed.
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    assert_eq!(harness.state().flown(), None);
    assert!(!harness.state().document.is_modified());
    // Again, and taken over behind the first point, in one step.
    press(&mut harness, at, PointerButton::Primary);
    motion(&mut harness, at + vec2(8.0, 0.0));
    motion(&mut harness, at + vec2(90.0, -20.0));
    release(&mut harness, at + vec2(90.0, -20.0), PointerButton::Primary);
    let flown = harness.state().flown().expect("a free view");
    let points = harness.state().document.path().points.len();
    harness.get_by_label("Take over the view").click();
    harness.step();
    harness.step();
    let editor = harness.state();
    assert_eq!(editor.document.path().points.len(), points + 1);
    assert_eq!(editor.document.selection(), Selection::at(1, 0));
    assert_eq!(editor.flown(), None);
    let taken = editor.camera().unwrap().0;
    assert!(taken.position.abs_diff_eq(flown.position, 1e-12));
    assert!(taken.view.abs_diff_eq(flown.view, 1e-12) && taken.up.abs_diff_eq(flown.up, 1e-9));
    tap(&mut harness, Key::Z, Modifiers::CTRL);
    assert!(!harness.state().document.is_modified());
}

/// It stands within the space when nobody moves the mouse any more.
#[test]
fn the_pane_is_whole_at_once_after_the_window_is_enlarged() {
    use crate::tests::{Window, window};
    let mut window = window(crate::Language::English);
    let whole = |window: &Window| {
        let pane = window.ctx.memory(|memory| memory.area_rect(id())).unwrap();
        let viewport = window.get_by_label("Movement window").rect();
        let away = pane.right_top() - corner(viewport);
        assert!(away.length() < 2.0, "{pane:?} in {viewport:?}");
        let close = window.get_by_label("Close the camera view").rect();
        assert!(viewport.contains_rect(close), "{close:?} in {viewport:?}");
    };
    for size in [
        [1100.0, 800.0],
        [1300.0, 850.0],
        [800.0, 600.0],
        [1400.0, 870.0],
    ] {
        window.set_size(vec2(size[0], size[1]));
        window.run();
        whole(&window);
        screenshot(&mut window, &format!("camera-enlarged-{}.png", size[0]));
    }
}
