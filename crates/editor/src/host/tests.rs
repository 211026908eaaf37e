//! What the host is told of the playhead, and its view taken over.

use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;
use glam::DQuat;
use vides_document::Document;
use vides_engine::path::UpVector;

use super::*;
use crate::setup::Theme;
use crate::space::cameras::Camera;
use crate::state::{HostView, Options};
use crate::tests::{
    BOTH, LARGE, Window, click, options, press, said, some_points, window_of, window_with_points,
};
use crate::texts::Language;

fn bits(pose: &Pose) -> [u64; 10] {
    let [p, v, u] = [pose.vrp, pose.vpn, pose.vup];
    let all = [
        p[0], p[1], p[2], v[0], v[1], v[2], u[0], u[1], u[2], pose.zoom,
    ];
    all.map(f64::to_bits)
}

/// The pose of a path without anything computed before.
fn afresh(editor: &Editor, frame: f64) -> Pose {
    let copy = Document::from_toml(&editor.document.to_toml().unwrap()).unwrap();
    copy.sampler().unwrap().pose(frame).unwrap()
}

fn window() -> Window {
    window_with_points(Language::English, LARGE, 1.0, Theme::Dark)
}

#[test]
fn the_host_is_told_the_pose_of_the_path_bit_by_bit() {
    let mut window = window();
    for orientation in 0..3 {
        window.state_mut().edit(Edit::SetOrientation {
            point: 2,
            at: orientation,
            orientation: Orientation {
                hold: 7 * orientation as u32,
                ..Orientation::default()
            },
        });
    }
    window.run();
    let points = window.state().document.path().points.clone();
    for (point, of_point) in points.iter().enumerate() {
        for orientation in 0..of_point.orientations.len() {
            window.state_mut().select_key(point, orientation).unwrap();
            window.run();
            let editor = window.state();
            let (pose, frame) = editor.view().unwrap();
            assert_eq!(frame, editor.position_on_bar(), "{point}.{orientation}");
            assert_eq!(bits(&pose), bits(&afresh(editor, frame)));
            let key = Camera::at(&editor.document, point, orientation).unwrap();
            assert_eq!(pose.vrp, key.position.to_array());
            assert_eq!(pose.vpn, key.view.to_array());
        }
    }
    for frame in [1.0, 2.5, 30.0, 77.25] {
        window.state_mut().set_frame(frame).unwrap();
        window.run();
        let (pose, at) = window.state().view().unwrap();
        assert_eq!(at, frame);
        assert_eq!(bits(&pose), bits(&afresh(window.state(), frame)));
    }
    let before = window.state().standing();
    for wrong in [0.0, f64::NAN, 1e9] {
        assert!(window.state_mut().set_frame(wrong).is_err(), "{wrong}");
    }
    assert!(window.state_mut().select_key(99, 0).is_err());
    assert_eq!(window.state().standing(), before);
}

#[test]
fn what_led_there_is_told_apart() {
    let mut window = window();
    let mut last = window.state().standing();
    let mut reason = |window: &Window| {
        let before = std::mem::replace(&mut last, window.state().standing());
        (last != before).then(|| last.reason(&before))
    };
    assert_eq!(reason(&window), None);
    window.state_mut().select_key(1, 0).unwrap();
    window.run();
    assert_eq!(reason(&window), Some(Reason::Selected));
    window.state_mut().set_frame(20.5).unwrap();
    window.run();
    assert_eq!(reason(&window), Some(Reason::Scrubbed));
    // To a key, by the bar: the same.
    let key = window.state().playing.mark_of(Selection::at(1, 0)).unwrap();
    window.state_mut().set_frame(key.first()).unwrap();
    window.run();
    assert_eq!(window.state().standing().frame, None);
    assert_eq!(reason(&window), Some(Reason::Scrubbed));
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    assert_eq!(reason(&window), Some(Reason::Selected));
    press(&mut window, Modifiers::NONE, Key::Delete);
    assert_eq!(reason(&window), Some(Reason::Edited));
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(reason(&window), Some(Reason::Edited));
    window.state_mut().set_playing(true);
    window.step();
    assert!(window.state().is_under_way());
    assert_eq!(reason(&window), Some(Reason::Played));
    window.state_mut().set_playing(false);
    window.run();
    assert!(!window.state().is_under_way());
    assert_eq!(reason(&window), Some(Reason::Played));
    window.run();
    assert_eq!(reason(&window), None);
}

/// Whatever the camera's lengths and attitude, straight up and down, too.
#[test]
fn a_view_is_taken_over_as_it_is() {
    let mut window = window();
    let before = window.state().document.path().points.len();
    let mut attitudes = vec![DQuat::from_rotation_x(std::f64::consts::FRAC_PI_2)];
    attitudes.push(DQuat::from_rotation_x(-std::f64::consts::FRAC_PI_2));
    attitudes.push(DQuat::from_rotation_x(std::f64::consts::FRAC_PI_2 + 1e-9));
    for n in 0..40 {
        let n = f64::from(n);
        attitudes.push(DQuat::from_euler(glam::EulerRot::YXZ, n, 1.3 * n, 0.7 * n));
    }
    for (n, attitude) in attitudes.into_iter().enumerate() {
        let (view, up) = (attitude * DVec3::Z, attitude * DVec3::Y);
        let given = Pose {
            vrp: [0.01 * n as f64, -0.5, 0.25],
            vpn: (view * 1e-3).to_array(),
            // Of any length, not quite upright.
            vup: (up * 700.0 + view * 30.0).to_array(),
            // A lens of 135 mm, and longer ones.
            zoom: 24.0 + 37.0 * n as f64,
        };
        let replace = n % 2 == 1;
        // Whatever was up there before.
        let ups = [
            UpVector::Axis,
            UpVector::Minimal,
            UpVector::Point(DVec3::new(0.3, 0.9, -0.2)),
        ];
        let context = window.ctx.clone();
        let other = Action::Path(PathAction::SetUp(ups[n / 2 % 3].clone()));
        window.state_mut().act(other, &context);
        let old = window.state().document.selection();
        window.state_mut().take_over(Some(&given), replace);
        window.run();
        let editor = window.state();
        assert_eq!(editor.message, None, "{n}");
        let at = editor.document.selection();
        assert_eq!(at.point, if replace { old.point } else { old.point + 1 });
        let (pose, _) = editor.view().unwrap();
        assert_eq!((pose.vrp, pose.zoom), (given.vrp, given.zoom));
        assert!(DVec3::from(pose.vpn).distance(view) < 1e-12, "{n}");
        assert!(DVec3::from(pose.vup).distance(up) < 1e-12, "{n}");
        // One step, and it can be taken back.
        window.state_mut().document.undo();
        assert_eq!(window.state().document.selection(), old);
        window.state_mut().document.redo();
    }
    assert_eq!(window.state().document.path().points.len(), before + 22);
}

/// A host that follows `on_view` has the view of the current key, rounded to `float`.
#[test]
fn the_view_of_the_current_key_is_not_taken_over_again() {
    let mut window = window();
    window.state_mut().select_key(1, 0).unwrap();
    window.run();
    let (pose, _) = window.state().view().unwrap();
    let rounded = |v: [f64; 3]| v.map(|x| f64::from(x as f32));
    let held = Pose {
        vrp: rounded(pose.vrp),
        vpn: rounded(pose.vpn),
        vup: rounded(pose.vup),
        zoom: f64::from(pose.zoom as f32),
    };
    let before = window.state().document.path().clone();
    for replace in [false, true] {
        window.state_mut().take_over(Some(&held), replace);
        window.run();
        assert_eq!(
            said(&window).as_deref(),
            Some("Point 2 already has this view")
        );
        assert_eq!(*window.state().document.path(), before);
        assert!(!window.state().is_unsaved());
    }
    // Another one is.
    let [x, y, z] = held.vrp;
    let aside = Pose {
        vrp: [x + 0.001, y, z],
        ..held
    };
    window.state_mut().take_over(Some(&aside), false);
    window.run();
    assert_eq!(
        window.state().document.path().points.len(),
        before.points.len() + 1
    );
}

#[test]
fn what_is_no_view_is_refused_in_words() {
    for language in BOTH {
        let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
        let good = window.state().view().unwrap().0;
        let state = window.state().document.state_number();
        let texts = &language.texts().space;
        window.state_mut().take_over(None, false);
        window.run();
        assert_eq!(
            said(&window),
            Some(fill(texts.no_host_view, &[&texts.host_view]))
        );
        let up_along = Pose {
            vup: good.vpn.map(|x| -3.0 * x),
            ..good
        };
        let wrong = [
            up_along,
            Pose {
                vpn: [0.0; 3],
                ..good
            },
            Pose {
                vrp: [f64::NAN, 0.0, 0.0],
                ..good
            },
            Pose {
                vrp: [1e300, 0.0, 0.0],
                ..good
            },
            Pose { zoom: 0.5, ..good },
            Pose {
                zoom: 2001.0,
                ..good
            },
        ];
        for pose in wrong {
            assert!(window.state_mut().set_ghost(Some(&pose)).is_err());
            window.state_mut().take_over(Some(&pose), false);
            window.run();
            let start = fill(texts.host_view_refused, &[&texts.host_view, &""]);
            let said = said(&window).expect("a sentence");
            assert!(said.starts_with(start.trim_end()), "{said}");
            assert_eq!(window.state().document.state_number(), state);
        }
    }
}

#[test]
fn the_ghost_has_a_name_and_a_button() {
    for language in BOTH {
        let mut window = window_of(
            Options {
                document: some_points(),
                host_view: HostView {
                    name: Some("Viewer".to_owned()),
                    captures: true,
                    ..HostView::default()
                },
                ..options(language)
            },
            LARGE,
            1.0,
            Theme::Dark,
        );
        let texts = &language.texts().space;
        assert!(window.query_by_label(texts.take_over).is_none());
        let ghost = Pose {
            vrp: [0.3, 0.5, 0.2],
            ..window.state().view().unwrap().0
        };
        window.state_mut().set_ghost(Some(&ghost)).unwrap();
        window.run();
        click(&mut window, texts.take_over);
        let asked = Request::Capture { replace: false };
        assert_eq!(window.state_mut().next_request(), Some(asked));
        press(&mut window, Modifiers::CTRL | Modifiers::SHIFT, Key::Enter);
        let asked = Request::Capture { replace: true };
        assert_eq!(window.state_mut().next_request(), Some(asked));
        let count = window.state().document.path().points.len();
        // Whoever cannot be asked has shown it.
        window.state_mut().host_view.captures = false;
        press(&mut window, Modifiers::CTRL, Key::Enter);
        assert_eq!(window.state().document.path().points.len(), count + 1);
        assert_eq!(
            window.state().point().unwrap().position.to_array(),
            ghost.vrp
        );
        window.state_mut().set_ghost(None).unwrap();
        window.run();
        assert!(window.query_by_label(texts.take_over).is_none());
    }
}
