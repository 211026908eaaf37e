//! The panels (thesis A.4.1, A.4.2, A.4.4), sentence by sentence.

use egui_kittest::kittest::NodeT as _;

use crate::document::{At, Selection};
use crate::limits;
use crate::path::{CurveParameters, Tcb, Up, UpVector};
use crate::tests::*;

fn selection(window: &Window) -> Selection {
    window.state().document.selection()
}

fn points(window: &Window) -> usize {
    window.state().document.path().points.len()
}

fn orientations(window: &Window) -> usize {
    let point = selection(window).point;
    window.state().document.path().points[point]
        .orientations
        .len()
}

fn large(language: Language) -> Window {
    window_with_points(language, LARGE, 1.0, Theme::Dark)
}

#[test]
fn the_panels_name_all_that_the_thesis_has_there() {
    let window = large(Language::German);
    for name in [
        "+ Punkt",
        "− Punkt",
        "Position: 3 von 6",
        "Bias (b1)",
        "Continuity (c1)",
        "Tension (t1)",
        "Bias (b2)",
        "Continuity (c2)",
        "Tension (t2)",
        "Form der Kurve",
        "+ Blick",
        "− Blick",
        "Blick: 1 von 3 · blickt auf einen Ort",
        "Ziel",
        "Richtung",
        "Zoom",
    ] {
        assert!(window.query_by_label(name).is_some(), "{name}");
    }
    let window = large(Language::English);
    for name in ["Position: 3 of 6", "View: 1 of 3 · looks at a place"] {
        assert!(window.query_by_label(name).is_some(), "{name}");
    }
}

#[test]
fn a_point_is_inserted_half_way_and_the_flight_stays_as_it_is() {
    for (key, points) in [
        ((Modifiers::NONE, Key::Insert), 1),
        ((Modifiers::CTRL, Key::I), 7),
    ] {
        let mut window = window(Language::German);
        enter(&mut window, "Zoomwert", "35");
        window.state_mut().set_orientation(|orientation| {
            orientation.roll = 20.0;
            orientation.speeds[0] = 3.0;
        });
        window.run();
        let before = poses(window.state());
        press(&mut window, key.0, key.1);
        if points > 1 {
            press(&mut window, Modifiers::NONE, Key::Num7);
        }
        assert_eq!(
            (self::points(&window), selection(&window).point),
            (2 + points, 1)
        );
        let after = poses(window.state());
        assert_eq!(after.len(), before.len());
        for (frame, (a, b)) in before.iter().zip(&after).enumerate() {
            let moved = DVec3::from(a.vrp).distance(b.vrp.into());
            let turned = DVec3::from(a.vpn).angle_between(b.vpn.into());
            assert!(
                moved < 1e-9 && turned < 1e-6,
                "{points}, frame {frame}: {moved}, {turned}"
            );
            assert!((a.zoom - b.zoom).abs() < 1e-6);
        }
        // Within half of the fastest frame's way of where they would be.
        let path = window.state().document.path();
        let frame = before
            .windows(2)
            .map(|pair| DVec3::from(pair[0].vrp).distance(pair[1].vrp.into()));
        let fastest = frame.fold(0.0, f64::max);
        for pair in path.points.windows(2) {
            let way = pair[1].position.distance(pair[0].position);
            assert!((way - 1.2 / (points + 1) as f64).abs() < fastest, "{way}");
        }
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(self::points(&window), 2);
    }
}

#[test]
fn with_shift_a_new_point_has_all_of_its_predecessor() {
    let mut window = window(Language::German);
    enter(&mut window, "Zoomwert", "35");
    window
        .get_by_label("+ Punkt")
        .click_modifiers(Modifiers::SHIFT);
    window.run();
    assert_eq!((points(&window), selection(&window).point), (3, 1));
    let path = window.state().document.path();
    let middle = path.points[1].position;
    assert!((middle - DVec3::new(0.0, 0.2, 0.8)).length() < 1e-9);
    assert_eq!(path.points[1].orientations, path.points[0].orientations);
    assert_eq!(path.points[1].orientations[0].zoom, 35.0);
    assert_eq!(said(&window), None);
}

#[test]
fn several_points_are_asked_for_in_a_small_window() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut window = window(language);
        press(&mut window, Modifiers::CTRL, Key::I);
        assert!(window.query_by_label(texts.how_many).is_some());
        click(&mut window, "10");
        assert_eq!((points(&window), selection(&window).point), (12, 1));
        assert!(window.query_by_label(texts.how_many).is_none());
        let path = window.state().document.path();
        for pair in path.points.windows(2) {
            let way = pair[1].position - pair[0].position;
            // As near as whole frames come to it.
            assert!((way.length() - 1.2 / 11.0).abs() <= 0.01 + 1e-9);
        }
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(points(&window), 2);
        // By the keyboard alone: a digit.
        press(&mut window, Modifiers::CTRL, Key::I);
        press(&mut window, Modifiers::NONE, Key::Num3);
        assert_eq!(points(&window), 5);
        press(&mut window, Modifiers::CTRL, Key::I);
        press(&mut window, Modifiers::NONE, Key::Escape);
        assert_eq!(points(&window), 5);
        assert!(window.query_by_label(texts.how_many).is_none());
    }
}

#[test]
fn behind_the_last_point_there_is_a_message() {
    for language in BOTH {
        let texts = &language.texts().position;
        for key in [(Modifiers::NONE, Key::Insert), (Modifiers::CTRL, Key::I)] {
            let mut window = window(language);
            press(&mut window, Modifiers::CTRL, Key::PageDown);
            press(&mut window, key.0, key.1);
            assert_eq!(said(&window).as_deref(), Some(texts.last_point));
            assert!(
                window
                    .state()
                    .message
                    .as_ref()
                    .is_some_and(|message| message.error)
            );
            assert_eq!(points(&window), 2);
            // It stays until the next action.
            window.run();
            assert_eq!(said(&window).as_deref(), Some(texts.last_point));
            press(&mut window, Modifiers::CTRL, Key::PageUp);
            assert_eq!(said(&window), None);
        }
        // A closed path has a segment there.
        let mut window = window(language);
        press(&mut window, Modifiers::CTRL, Key::PageDown);
        click(&mut window, language.texts().menu.edit);
        click(&mut window, language.texts().menu.close);
        click(&mut window, texts.add);
        assert_eq!((points(&window), selection(&window).point), (3, 2));
    }
}

#[test]
fn the_predecessor_of_a_removed_point_becomes_current_and_two_remain() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut window = large(language);
        click(&mut window, texts.remove);
        assert_eq!(
            (points(&window), selection(&window)),
            (5, Selection::at(1, 0))
        );
        click(&mut window, texts.remove);
        click(&mut window, texts.remove);
        assert_eq!((points(&window), selection(&window).point), (3, 0));
        press(&mut window, Modifiers::NONE, Key::Delete);
        assert_eq!(points(&window), 2);
        click(&mut window, texts.remove);
        assert_eq!(points(&window), 2);
        assert_eq!(said(&window).as_deref(), Some(texts.two_remain));
        // Undo brings back what was current.
        for _ in 0..4 {
            press(&mut window, Modifiers::CTRL, Key::Z);
        }
        assert_eq!(
            (points(&window), selection(&window)),
            (6, Selection::at(2, 0))
        );
        assert!(!window.state().document.is_modified());
    }
}

#[test]
fn the_choice_of_a_point_goes_round() {
    let mut window = large(Language::German);
    let mut seen = Vec::new();
    for _ in 0..6 {
        press(&mut window, Modifiers::CTRL, Key::PageDown);
        seen.push(selection(&window).point);
    }
    assert_eq!(seen, [3, 4, 5, 0, 1, 2]);
    press(
        &mut window,
        Modifiers::CTRL | Modifiers::SHIFT,
        Key::PageDown,
    );
    press(&mut window, Modifiers::CTRL, Key::PageUp);
    // Another point begins with its first orientation.
    assert_eq!(selection(&window), Selection::at(1, 0));
    press(&mut window, Modifiers::CTRL, Key::PageUp);
    press(&mut window, Modifiers::CTRL, Key::PageUp);
    assert_eq!(selection(&window).point, 5);
    assert!(window.query_by_label("Position: 6 von 6").is_some());
}

#[test]
fn bias_continuity_and_tension_of_this_point_and_the_next_are_shown() {
    let mut window = large(Language::German);
    assert_eq!(value(&window, "Continuity (c1)"), "0,00");
    assert_eq!(value(&window, "Continuity (c2)"), "−0,50");
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    assert_eq!(value(&window, "Continuity (c1)"), "−0,50");
    assert!(window.query_by_label("Kurve: 5 Ecke").is_some());
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    // Behind the last point there is none.
    for name in ["Bias (b2)", "Continuity (c2)", "Tension (t2)"] {
        assert_eq!(value(&window, name), "–");
    }
    window.state_mut().edit(Edit::set(At::Path, "closed", true));
    window.run();
    assert_eq!(value(&window, "Bias (b2)"), "0,00");
}

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
            crate::action::Action::AimAt(DVec3::ZERO),
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
        info.object = crate::document::Object::of_mesh(mesh).unwrap();
        window
            .state_mut()
            .edit(crate::document::Edit::SetInfo(Box::new(info)));
        window.run();
        click(&mut window, texts.whole);
        let target = window.state().orientation().unwrap().target;
        let middle = DVec3::new(0.05, 0.15, -0.9);
        assert!(
            matches!(target, crate::path::Target::Absolute(at) if at.abs_diff_eq(middle, 1e-12))
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

#[test]
fn each_orientation_has_a_zoom_of_its_own() {
    for language in BOTH {
        let texts = &language.texts().zoom;
        let mut window = large(language);
        enter(&mut window, texts.value, "50");
        let heading = format!("{}: {}°", texts.heading, language.number(26.991_466, 1));
        assert!(window.query_by_label(&heading).is_some(), "{heading}");
        let path = window.state().document.path();
        let zooms: Vec<f64> = path.points[2].orientations.iter().map(|o| o.zoom).collect();
        assert_eq!(zooms, [50.0, 24.0, 24.0]);
        enter(&mut window, texts.value, "2001");
        let errors = &language.texts().errors;
        let message = fill(errors.out_of_range, &[&texts.value, &1, &2000]);
        assert_eq!(said(&window), Some(message));
        assert_eq!(window.state().orientation().expect("there").zoom, 50.0);
    }
}

#[test]
fn the_zoom_slider_is_dragged_in_one_step() {
    let mut window = window(Language::German);
    let rect = window.get_by_label("Zoom").rect();
    let y = rect.center().y;
    window.drag_at(egui::pos2(rect.left() + 60.0, y));
    window.run();
    for x in 61..140 {
        window.hover_at(egui::pos2(rect.left() + x as f32, y));
        window.run();
    }
    window.drop_at(egui::pos2(rect.left() + 140.0, y));
    window.run();
    let zoom = window.state().orientation().expect("there").zoom;
    assert!((70.0..90.0).contains(&zoom), "{zoom}");
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(window.state().orientation().expect("there").zoom, 24.0);
    assert!(!window.state().document.can_undo());
}

#[test]
fn the_section_is_shown_with_its_frames_and_seconds() {
    let mut window = window(Language::German);
    assert!(
        window
            .query_by_label("Zeiten: 120 Bilder · 4,80 s")
            .is_some()
    );
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    assert!(window.query_by_label("Zeiten: Ende der Bahn").is_some());
    open_menu(&mut window, 1);
    click(&mut window, "Zeitkurve …");
    assert!(window.state().windows.speed.is_some());
    click(&mut window, "Form der Kurve");
    click(&mut window, "Ändern … F2");
    assert!(window.state().windows.curve.is_some());
}

#[test]
fn holding_takes_whole_frames() {
    let mut window = window(Language::English);
    enter(&mut window, "Hold", "12");
    assert_eq!(window.state().orientation().expect("there").hold, 12);
    enter(&mut window, "Hold", "2.5");
    assert_eq!(
        said(&window).as_deref(),
        Some("Hold must be a whole number")
    );
    enter(&mut window, "Hold", "-1");
    assert_eq!(window.state().orientation().expect("there").hold, 12);
}

#[test]
fn a_preset_is_chosen_in_the_panel() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut window = large(language);
        let curve = |window: &Window| window.state().point().expect("there").curve;
        let before = curve(&window);
        click(&mut window, texts.choice);
        let word = language.texts().curve.corner_outwards;
        let value = language.number(0.5, 2);
        let entry = format!("{} {word}  c {value}", fill(texts.preset, &[&6]));
        click(&mut window, &entry);
        assert_eq!(curve(&window), CurveParameters::Preset(6));
        let heading = format!("{}: 6 {word}", texts.curve);
        assert!(window.query_by_label(&heading).is_some());
        assert!(window.query_by_label(&entry).is_none());
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(curve(&window), before);
        // By the keyboard, too.
        window.get_by_label(texts.choice).focus();
        window.run();
        press(&mut window, Modifiers::NONE, Key::Enter);
        press(&mut window, Modifiers::NONE, Key::ArrowDown);
        press(&mut window, Modifiers::NONE, Key::ArrowDown);
        press(&mut window, Modifiers::NONE, Key::Enter);
        assert_eq!(curve(&window), CurveParameters::Preset(1));
    }
}

/// Beside each preset stands what it makes of the curve, as it is at the moment.
#[test]
fn a_presets_shape_is_told_in_words() {
    for (language, words) in [
        (
            Language::German,
            [
                "straffer  t 0,30",
                "Ecke  c −0,50",
                "biegt später  b 0,50",
                "glatt",
            ],
        ),
        (
            Language::English,
            [
                "tighter  t 0.30",
                "corner  c −0.50",
                "turns late  b 0.50",
                "smooth",
            ],
        ),
    ] {
        let mut window = large(language);
        let texts = language.texts();
        let mut presets = window.state().document.path().presets;
        presets[2] = Tcb::new(-0.25, 0.0, -1.0);
        let edit = Edit::set(At::Path, "presets", presets);
        window.state_mut().edit(edit);
        click(&mut window, texts.position.choice);
        for (preset, words) in [1, 5, 7, 9].into_iter().zip(words) {
            let entry = format!("{} {words}", fill(texts.position.preset, &[&preset]));
            assert!(window.query_by_label(&entry).is_some(), "{entry}");
        }
        let changed = match language {
            Language::German => "Standard 2 runder  t −0,25, biegt früher  b −1,00",
            Language::English => "Preset 2 rounder  t −0.25, turns early  b −1.00",
        };
        assert!(window.query_by_label(changed).is_some(), "{changed}");
    }
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

/// A click or Enter on a heading folds its panel and no other; the next window has it so, too.
#[test]
fn panels_are_folded_and_stay_so() {
    for language in BOTH {
        let texts = language.texts();
        let folder = tempfile::tempdir().unwrap();
        let start = || {
            let folders = Folders {
                setup: Some(folder.path().to_owned()),
                ..Folders::default()
            };
            let options = Options {
                folders,
                ..options(language)
            };
            window_of(options, LARGE, 1.0, Theme::Dark)
        };
        let tension = format!("{} (t1)", texts.curve.tension);
        let position = fill(texts.position.coordinate, &[&"x"]);
        let direction = fill(texts.orientation.direction, &[&"x"]);
        let inside = [
            position.as_str(),
            &tension,
            &direction,
            texts.zoom.value,
            texts.timing.hold,
        ];
        let headings = [
            texts.position.heading,
            texts.position.curve,
            texts.orientation.heading,
            texts.zoom.heading,
            texts.timing.heading,
        ];
        let open = |window: &Window| {
            inside.map(|name| {
                let mut all = window.query_all_by_role_and_label(Role::SpinButton, name);
                all.next().is_some()
            })
        };
        let heading = |window: &mut Window, at: usize, by_key: bool| {
            let label = format!("{}: ", headings[at]);
            let mut all = window.query_all_by_role(Role::DisclosureTriangle);
            let begins = |node: &egui_kittest::Node<'_>| {
                let name = node.accesskit_node().label();
                name.is_some_and(|name| name.starts_with(&label))
            };
            let node = all.find(begins).expect("a heading");
            match by_key {
                true => node.focus(),
                false => node.click(),
            }
            drop(all);
            window.run();
            if by_key {
                press(window, Modifiers::NONE, Key::Enter);
            }
        };
        let mut window = start();
        assert_eq!(open(&window), [true; 5]);
        let mut wanted = [true; 5];
        for at in [1, 4, 0, 3, 2] {
            heading(&mut window, at, at % 2 == 0);
            wanted[at] = false;
            assert_eq!(open(&window), wanted, "{at}");
            assert_eq!(open(&start()), wanted, "{at}");
        }
        heading(&mut window, 2, false);
        wanted[2] = true;
        assert_eq!(open(&window), wanted);
        assert_eq!(open(&start()), wanted);
        // It is no step, and the headings still tell what they told.
        assert!(!window.state().document.can_undo());
        let zoom = format!("{}: ", texts.zoom.heading);
        assert!(window.query_by_label_contains(&zoom).is_some());
    }
}
