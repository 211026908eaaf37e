//! Tests of [`super::orientation`] (thesis A.4.2), sentence by sentence.

use egui_kittest::kittest::NodeT as _;
use vides_document::Selection;
use vides_engine::limits;
use vides_engine::path::{Up, UpVector};

use super::tests::{large, orientations, selection};
use crate::action::{Action, PathAction};
use crate::tests::*;

#[test]
fn orientations_come_and_go_between_one_and_ten() {
    for language in BOTH {
        let texts = &language.texts().orientation;
        let mut window = window(language);
        enter(&mut window, texts.roll, "30");
        for count in 2..=10 {
            click(&mut window, texts.add);
            assert_eq!(orientations(&window), count);
            assert_eq!(selection(&window).orientation, count - 1);
            let path = window.state().document.path();
            assert_eq!(path.points[0].orientations[count - 1].roll, 30.0);
        }
        click(&mut window, texts.add);
        assert_eq!(orientations(&window), 10);
        let message = fill(texts.at_most, &[&limits::MAX_ORIENTATIONS]);
        assert_eq!(said(&window), Some(message));
        assert!(
            window
                .query_by_label_contains(&fill(texts.count, &[&10, &10]))
                .is_some()
        );
        for count in (1..10).rev() {
            click(&mut window, texts.remove);
            assert_eq!(orientations(&window), count);
            assert_eq!(selection(&window).orientation, count - 1);
        }
        click(&mut window, texts.remove);
        assert_eq!(said(&window).as_deref(), Some(texts.one_remains));
        assert_eq!(orientations(&window), 1);
        press(
            &mut window,
            Modifiers::CTRL | Modifiers::SHIFT,
            Key::PageDown,
        );
        assert_eq!(said(&window).as_deref(), Some(texts.only_one));
    }
}

#[test]
fn removing_the_first_orientation_makes_the_new_first_current() {
    let mut window = large(Language::German);
    click_button(&mut window, |texts| texts.orientation.remove);
    assert_eq!(selection(&window), Selection::at(2, 0));
    assert!(window.query_by_label_contains("Blick: 1 von 2").is_some());
}

#[test]
fn the_choice_of_an_orientation_goes_round() {
    let mut window = large(Language::German);
    let mut seen = Vec::new();
    for _ in 0..3 {
        press(
            &mut window,
            Modifiers::CTRL | Modifiers::SHIFT,
            Key::PageDown,
        );
        seen.push(selection(&window).orientation);
    }
    assert_eq!(seen, [1, 2, 0]);
    press(&mut window, Modifiers::CTRL | Modifiers::SHIFT, Key::PageUp);
    assert_eq!(selection(&window), Selection::at(2, 2));
    assert!(window.query_by_label_contains("Blick: 3 von 3").is_some());
}

/// Where two orientations are half a turn apart, or a tracked target lies on the
/// way, the window says so.
#[test]
fn what_the_path_leaves_open_is_said() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = window(language);
        let direction = fill(texts.orientation.direction, &[&"z"]);
        enter(&mut window, &direction, "0.3");
        let half = fill(texts.output.half_turn, &[&1, &2]);
        assert_eq!(said(&window), Some(half.clone()));
        enter(&mut window, &direction, "-0.3");
        assert_eq!(said(&window), None);
        press(&mut window, Modifiers::CTRL, Key::PageDown);
        enter(&mut window, texts.orientation.roll, "180");
        assert_eq!(said(&window), Some(half));
        enter(&mut window, texts.orientation.roll, "0");

        // Both look at a place half-way between them.
        for _ in 0..2 {
            click(&mut window, texts.orientation.absolute);
            for (axis, value) in [("x", "0"), ("y", "0.2"), ("z", "0.8")] {
                enter(
                    &mut window,
                    &fill(texts.orientation.target, &[&axis]),
                    value,
                );
            }
            press(&mut window, Modifiers::CTRL, Key::PageDown);
        }
        enter(&mut window, texts.orientation.roll, "1");
        assert_eq!(said(&window), Some(fill(texts.output.at_target, &[&1, &2])));
        for _ in 0..2 {
            enter(&mut window, &fill(texts.orientation.target, &[&"y"]), "0");
            press(&mut window, Modifiers::CTRL, Key::PageDown);
        }
        enter(&mut window, texts.orientation.roll, "2");
        assert_eq!(
            said(&window),
            Some(fill(texts.output.over_target, &[&1, &2]))
        );
    }
}

#[test]
fn an_absolute_target_stays_and_a_relative_one_goes_along() {
    let mut window = window(Language::German);
    let target = |window: &Window| window.state().orientation().expect("there").target;
    let view = |window: &Window| {
        let editor = window.state();
        let position = editor.point().expect("there").position;
        editor.orientation().expect("there").view(position)
    };
    let before = view(&window);
    click_button(&mut window, |texts| texts.orientation.absolute);
    let Target::Absolute(place) = target(&window) else {
        panic!("absolute");
    };
    assert!((view(&window) - before).length() < 1e-12);
    enter(&mut window, "Position y", "0,5");
    assert_eq!(target(&window), Target::Absolute(place));
    assert!((view(&window) - before).length() > 0.1);
    click_button(&mut window, |texts| texts.orientation.relative);
    let relative = target(&window);
    assert!(matches!(relative, Target::Relative(_)));
    let before = view(&window);
    enter(&mut window, "Position y", "-0.5");
    assert_eq!(target(&window), relative);
    assert_eq!(view(&window), before);
}

/// The way from one pose to the next, and where the camera looks.
fn apart_from_the_way(window: &Window, frames: std::ops::Range<usize>) -> f64 {
    let poses = poses(window.state());
    let pairs = poses[frames].windows(2);
    let angles = pairs.map(|pair| {
        let [from, to] = [pair[0].vrp, pair[1].vrp].map(DVec3::from);
        let [before, after] = [pair[0].vpn, pair[1].vpn].map(DVec3::from);
        (to - from).angle_between(before + after)
    });
    angles.fold(0.0, f64::max).to_degrees()
}

#[test]
fn the_camera_looks_along_the_way_until_it_is_aimed() {
    for language in [Language::English, Language::German] {
        let texts = &language.texts().orientation;
        let mut window = window(language);
        assert!(apart_from_the_way(&window, 0..60) > 10.0);
        click(&mut window, texts.ahead);
        press(&mut window, Modifiers::CTRL, Key::PageDown);
        click(&mut window, texts.ahead);
        let end = poses(window.state()).len();
        let off = apart_from_the_way(&window, 0..end);
        assert!(off < 0.2, "{off} degrees");
        assert!(window.query_by_label_contains(texts.along_way).is_some());
        // At a place ahead: it looks into the curve.
        enter(&mut window, texts.distance, "0.3");
        let own = |window: &Window| window.state().orientation().unwrap().own.ahead;
        assert_eq!(own(&window), Some(0.3));
        // The view stays as it was seen when it looks in a direction from now on.
        let here = |window: &Window| DVec3::from(poses(window.state())[end - 1].vpn);
        let before = here(&window);
        click(&mut window, texts.relative);
        assert_eq!(own(&window), None);
        assert!(here(&window).abs_diff_eq(before, 1e-9));
        click(&mut window, texts.ahead);
        window.state_mut().act(
            Action::Path(PathAction::AimAt(DVec3::ZERO)),
            &egui::Context::default(),
        );
        assert_eq!(own(&window), None);
        let pose = poses(window.state())[end - 1];
        let [position, view] = [pose.vrp, pose.vpn].map(DVec3::from);
        assert!(view.abs_diff_eq(-position.normalize(), 1e-9));
    }
}

/// The button is there with an object only; then its middle is the target, and all of it is seen.
#[test]
fn one_orientation_shows_the_whole_object() {
    for language in [Language::English, Language::German] {
        let texts = &language.texts().orientation;
        let mut window = window(language);
        assert!(window.query_by_label(texts.whole).is_none());
        let mut info = window.state().document.info().clone();
        let corners = [[-0.2, -0.1, -0.9], [0.3, 0.0, -1.0], [0.1, 0.4, -0.8]];
        let mesh = vides_engine::scene::Mesh {
            points: corners.map(DVec3::from_array).to_vec(),
            ..Default::default()
        };
        info.object = vides_document::Object::of_mesh(mesh).unwrap();
        window
            .state_mut()
            .edit(vides_document::Edit::SetInfo(Box::new(info)));
        window.run();
        click(&mut window, texts.whole);
        let target = window.state().orientation().unwrap().target;
        let middle = DVec3::new(0.05, 0.15, -0.9);
        assert!(
            matches!(target, vides_engine::path::Target::Absolute(at) if at.abs_diff_eq(middle, 1e-12))
        );
        let pose = poses(window.state())[0];
        let mut most = 0.0_f64;
        for corner in corners {
            let way = DVec3::from(corner) - pose.position();
            let aside = way.dot(pose.view().cross(pose.up())).abs() / 18.0;
            let share = aside.max(way.dot(pose.up()).abs() / 12.0) * pose.zoom;
            most = most.max(share / way.dot(pose.view()));
        }
        assert!(most <= 0.8 && most > 0.799, "{most}");
    }
}

#[test]
fn which_way_is_up_is_chosen_in_a_menu() {
    for language in [Language::English, Language::German] {
        let texts = &language.texts().orientation;
        let mut window = window(language);
        let up = |window: &Window| window.state().orientation().unwrap().own.up.clone();
        let pose = |window: &Window| poses(window.state())[0];
        let before = pose(&window);
        let choose = |window: &mut Window, from: &str, to: &str| {
            let menu = fill(texts.up, &[&""]);
            let shown = window.get_by_label(menu.trim_end());
            assert_eq!(shown.accesskit_node().value().as_deref(), Some(from));
            click(window, menu.trim_end());
            click(window, to);
        };
        choose(&mut window, texts.up_axis, texts.up_place);
        assert!(matches!(up(&window), UpVector::Point(_)));
        // The point that it begins with leaves the picture as it is.
        for (a, b) in before.vup.iter().zip(pose(&window).vup) {
            assert!((a - b).abs() < 1e-9);
        }
        // The camera of the first point is rolled until its picture's up leads there.
        enter(&mut window, &fill(texts.up_at, &[&"x"]), "0.9");
        let UpVector::Point(place) = up(&window) else {
            panic!("{:?}", up(&window));
        };
        assert_eq!(place.x, 0.9);
        let [position, view, seen] =
            [pose(&window).vrp, pose(&window).vpn, pose(&window).vup].map(DVec3::from);
        let wanted = (place - position).reject_from(view).normalize();
        assert!(seen.abs_diff_eq(wanted, 1e-9));
        choose(&mut window, texts.up_place, texts.up_minimal);
        assert_eq!(up(&window), UpVector::Minimal);
        // A curve of this kind has no normal to go by: that is said, and nothing changes.
        choose(&mut window, texts.up_minimal, texts.up_frenet);
        assert_eq!(up(&window), UpVector::Minimal);
        assert!(said(&window).is_some_and(|said| said.contains("minimal")));
        choose(&mut window, texts.up_minimal, texts.up_y);
        assert_eq!(up(&window), UpVector::Fixed(Up::Y));
        for (a, b) in before.vup.iter().zip(pose(&window).vup) {
            assert!((a - b).abs() < 1e-9);
        }
        choose(&mut window, texts.up_y, texts.up_z);
        assert_eq!(up(&window), UpVector::Fixed(Up::Z));
        choose(&mut window, texts.up_z, texts.up_axis);
        assert_eq!(up(&window), UpVector::Axis);
        for (a, b) in before.vup.iter().zip(pose(&window).vup) {
            assert!((a - b).abs() < 1e-9);
        }
    }
}

#[test]
fn the_numbers_of_the_target_are_those_of_its_kind() {
    let mut window = window(Language::German);
    assert_eq!(value(&window, "Richtung z"), "−0,400");
    enter(&mut window, "Richtung x", "0,3");
    assert_eq!(
        window.state().orientation().expect("there").target,
        Target::Relative(DVec3::new(0.3, 0.0, -0.4))
    );
    click_button(&mut window, |texts| texts.orientation.absolute);
    assert_eq!(value(&window, "Ziel x"), "−0,300");
    assert!(window.query_by_label("Richtung x").is_none());
    // A target on the camera's own position is refused.
    enter(&mut window, "Ziel x", "-0,6");
    enter(&mut window, "Ziel z", "0,8");
    let message = Language::German.texts().orientation.on_position;
    assert_eq!(said(&window).as_deref(), Some(message));
    assert_eq!(value(&window, "Ziel z"), "0,400");
    // And so is a position on the target.
    enter(&mut window, "Position z", "0,4");
    let message = Language::German.texts().position.on_target;
    assert_eq!(said(&window).as_deref(), Some(message));
}

/// The three numbers below say what they are: a place, or a direction.
#[test]
fn the_orientations_heading_says_how_it_looks() {
    for language in BOTH {
        let texts = &language.texts().orientation;
        let mut window = large(language);
        let says = |window: &Window, how: &str| {
            let heading = format!("{}: 1 ", texts.heading);
            let heading = window.get_by_label_contains(&heading);
            let label = heading.accesskit_node().label();
            label.is_some_and(|label| label.ends_with(how))
        };
        click(&mut window, texts.absolute);
        assert!(says(&window, texts.at_place) && !says(&window, texts.in_direction));
        click(&mut window, texts.relative);
        assert!(says(&window, texts.in_direction) && !says(&window, texts.at_place));
    }
}
