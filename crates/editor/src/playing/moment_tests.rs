//! One count of frames: what plays, where the playhead stays, what people read and what programs get.

use egui::{Key, Modifiers, accesskit::Role};
use egui_kittest::kittest::{NodeT, Queryable};
use vides_document::{At, Document, Edit};
use vides_engine::path::CameraPath;
use vides_engine::scene::{
    Channel, Extrapolation, FollowPath, Interpolation, Kind, Light, Node, Scene, Track,
};

use crate::playing::playhead::Missing;
use crate::screenshots::screenshot;
use crate::setup::Theme;
use crate::space::tests as space;
use crate::state::Options;
use crate::tests::*;
use crate::texts::Language;

/// Cameras on paths, one that repeats from frame 21 and one that holds from frame −3.5, and a lamp
/// with keys from 5 to 400; people count from 101 on.
fn document(pingpong: Extrapolation) -> Document {
    let mut scene = Scene::new();
    for (name, start, beyond) in [
        ("first", 21.0, pingpong),
        ("second", -3.5, Extrapolation::Hold),
    ] {
        let mut node = Node::new(name, Kind::Camera(Default::default()));
        let path = FollowPath::new(CameraPath::default(), start, beyond).unwrap();
        node.set_path(Some(path)).unwrap();
        scene.add(node).unwrap();
    }
    let lamp = Node::new("lamp", Kind::Light(Light::Point));
    let lamp = scene.add(lamp).unwrap();
    let track = Track::new(
        Channel::Position,
        Interpolation::Linear,
        vec![5.0, 400.0],
        vec![0.0, 1.0, 0.0, 1.0, 1.0, 0.0],
        Vec::new(),
    );
    scene.set_track(lamp, track.unwrap()).unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let mut info = document.info().clone();
    info.first_frame = 101;
    document.apply(Edit::SetInfo(Box::new(info))).unwrap();
    document.as_opened()
}

fn window_with(beyond: Extrapolation, language: Language) -> Window {
    let options = Options {
        document: document(beyond),
        ..options(language)
    };
    window_of(options, LARGE, 1.0, Theme::Dark)
}

/// Its passes are short enough to see it play.
fn played() -> Window {
    let editor = space::editor(document(Extrapolation::Hold), Language::English);
    space::window(editor, LARGE.into(), 1.0)
}

fn steps(window: &mut Window, count: usize) {
    for _ in 0..count {
        window.step();
    }
}

/// The frame in the bar, its range and the ruler are the scene's, whichever node is selected.
#[test]
fn the_playhead_stays_and_runs_over_the_scene_whatever_is_selected() {
    for language in BOTH {
        let mut window = window_with(Extrapolation::Hold, language);
        let texts = &language.texts().space;
        let scene = window.state().document().scene().unwrap();
        let range = scene.frame_range();
        assert_eq!(range, (-3.5, 400.0));
        window.state_mut().set_frame(30.0).unwrap();
        window.run();
        for nodes in [vec![1], vec![2], vec![], vec![0], vec![2, 0], vec![1]] {
            window.state_mut().select_nodes(nodes.clone());
            window.run();
            let editor = window.state();
            assert_eq!(editor.frame().unwrap(), 30.0, "{nodes:?}");
            assert_eq!(editor.playing.marks.range, range);
            assert_eq!(editor.playing.axis, range);
            assert_eq!(value(&window, texts.frame_number), "130");
            let last = value(&window, texts.last_frame);
            assert_eq!(last, "500");
            // All of it can be reached, and nothing else.
            for frame in [-3.5, 1.0, 7.25, 30.5, 399.0, 400.0] {
                window.state_mut().set_frame(frame).unwrap();
                window.run();
                assert_eq!(window.state().frame().unwrap(), frame, "{nodes:?}");
                let (pose, _) = window.state().view().unwrap();
                let camera = scene.nodes()[0].path().unwrap();
                let wanted = camera.pose(frame).unwrap();
                for (a, b) in pose.vrp.iter().zip(wanted.vrp) {
                    assert!((a - b).abs() < 1e-12, "{frame}: {pose:?} {wanted:?}");
                }
            }
            for beyond in [-4.0, 400.5, f64::NAN, f64::INFINITY] {
                assert!(window.state_mut().set_frame(beyond).is_err(), "{beyond}");
            }
            window.state_mut().set_frame(30.0).unwrap();
            window.run();
        }
        // Undo brings back another node's path, not its frames.
        let points = window.state().document().path().points.len();
        window.state_mut().select_nodes(vec![0]);
        window.run();
        click(&mut window, language.texts().position.add_here);
        assert_eq!(window.state().document().path().points.len(), points + 1);
        window.state_mut().set_frame(33.0).unwrap();
        window.state_mut().select_nodes(vec![2]);
        window.run();
        press(&mut window, Modifiers::CTRL, Key::Z);
        let edited = window.state().document().edited_scene().unwrap();
        assert_eq!(edited.node(), Some(0));
        assert_eq!(window.state().frame().unwrap(), 33.0);
    }
}

/// By typing and from the ruler: what people read is 100 more than what programs get.
#[test]
fn people_read_what_the_first_frame_makes_of_it() {
    let mut window = window_with(Extrapolation::Hold, Language::English);
    let texts = &Language::English.texts().space;
    enter(&mut window, texts.frame_number, "222");
    window.run();
    assert_eq!(window.state().frame().unwrap(), 122.0);
    // The heading of the camera's picture, too.
    let heading = Language::English.texts().scene.shown_camera;
    let heading = window.get_by_role_and_label(Role::ComboBox, heading);
    let heading = heading.value().unwrap_or_default();
    assert!(heading.starts_with("first, frame 222"), "{heading}");
    // So does the list of points.
    let list = |window: &Window| {
        let shapes = window.output().shapes.iter();
        let words = shapes.filter_map(|clipped| match &clipped.shape {
            egui::Shape::Text(text) => Some(text.galley.text().to_owned()),
            _ => None,
        });
        words.collect::<Vec<String>>()
    };
    let words = list(&window);
    assert!(words.iter().any(|word| word == "121"), "{words:?}");
    assert!(words.iter().any(|word| word == "241"), "{words:?}");
    window.state_mut().select_nodes(vec![1]);
    window.run();
    let words = list(&window);
    assert!(words.iter().any(|word| word == "96.5"), "{words:?}");
    window.state_mut().select_nodes(vec![0]);
    window.state_mut().set_frame(21.0).unwrap();
    window.run();
    // The seconds are those from frame 1 on.
    assert_eq!(value(&window, texts.second), "0.80 s");
    window.get_by_label(texts.timeline).focus();
    window.run();
    press(&mut window, Modifiers::NONE, Key::End);
    assert_eq!(window.state().frame().unwrap(), 400.0);
    press(&mut window, Modifiers::NONE, Key::Home);
    assert_eq!(window.state().frame().unwrap(), -3.5);
    press(&mut window, Modifiers::NONE, Key::ArrowRight);
    assert_eq!(window.state().frame().unwrap(), -3.0);
}

/// A path that has not begun or is over is shown as it is there, and is not changed.
#[test]
fn outside_its_frames_a_path_is_only_shown() {
    for language in BOTH {
        for beyond in [
            Extrapolation::Hold,
            Extrapolation::PingPong,
            Extrapolation::Repeat,
        ] {
            let mut window = window_with(beyond, language);
            let texts = &language.texts().position;
            let before = window.state().document().scene().unwrap();
            let follow = before.nodes()[0].path().unwrap();
            let (first, last) = follow.first_and_last();
            let why = crate::texts::fill(texts.outside, &[&(first + 100.0), &(last + 100.0)]);
            for frame in [2.0, 20.0, last + 1.0, last + 30.25] {
                window.state_mut().set_frame(frame).unwrap();
                window.run();
                let shown = window.state().shown().unwrap();
                assert_eq!(shown.missing, Missing::Outside, "{frame}");
                let wanted = follow.pose(frame).unwrap();
                let off = shown.position.distance(wanted.vrp.into());
                assert!(off < 1e-12, "{frame}: {off}");
                assert!(window.query_all_by_label(&why).next().is_some(), "{why}");
                let add = window.get_by_label(texts.add_here);
                assert!(add.accesskit_node().is_disabled());
                let name = crate::texts::fill(texts.coordinate, &[&"x"]);
                let x = number(&window, &name);
                assert!(x.accesskit_node().is_disabled());
                // By its key, too.
                window.state_mut().add_here();
                assert_eq!(said(&window).as_ref(), Some(&why));
                assert_eq!(window.state().document().scene().unwrap(), before);
            }
            screenshot(
                &mut window,
                &format!("outside-{language:?}-{}.png", beyond.name()),
            );
            window.state_mut().message = None;
            for frame in [first, first + 3.0, last] {
                window.state_mut().set_frame(frame).unwrap();
                window.run();
                assert_ne!(window.state().shown().unwrap().missing, Missing::Outside);
                assert!(window.query_by_label(&why).is_none());
            }
        }
    }
}

/// One switch limits playing and looping to the frames in which what is selected moves.
#[test]
fn only_what_is_selected_is_played() {
    let mut window = played();
    let texts = &Language::English.texts().space;
    let seen = |window: &mut Window, count| {
        let mut all = Vec::new();
        for _ in 0..count {
            window.step();
            all.push(window.state().frame().unwrap());
        }
        all.sort_by(f64::total_cmp);
        (all[0], *all.last().unwrap())
    };
    let (first, last) = {
        let scene = window.state().document().scene().unwrap();
        scene.nodes()[0].path().unwrap().first_and_last()
    };
    click(&mut window, texts.only_selected);
    window.state_mut().select_nodes(vec![0]);
    window.state_mut().set_frame(last - 10.0).unwrap();
    window.run();
    click(&mut window, texts.again);
    window.get_by_label(texts.play).click();
    steps(&mut window, 2);
    let (low, high) = seen(&mut window, 400);
    assert_eq!((low, high), (first, last));
    window.get_by_label(texts.again).click();
    steps(&mut window, 2);
    // Without looping it ends at the selection's end, and not at the scene's.
    steps(&mut window, 400);
    assert!(!window.state().playing.is_playing());
    assert_eq!(window.state().frame().unwrap(), last);
    // From elsewhere it begins at the selection's begin.
    window.state_mut().set_frame(3.0).unwrap();
    window.get_by_label(texts.play).click();
    steps(&mut window, 2);
    assert!((first..first + 4.0).contains(&window.state().frame().unwrap()));
    window.get_by_label(texts.only_selected).click();
    window.state_mut().scrub(last - 2.0);
    steps(&mut window, 2);
    window.get_by_label(texts.play).click();
    let (_, high) = seen(&mut window, 60);
    assert!(high > last + 5.0, "all of it plays: {high}");
}

/// What the check finds of a path is a frame of that; the playhead goes to the scene's.
#[test]
fn a_finding_leads_to_the_frame_of_the_scene() {
    let mut window = window_with(Extrapolation::Hold, Language::English);
    let position = glam::DVec3::new(0.5, 1.5, 0.8);
    let edit = Edit::set(At::Point(1), "position", position);
    assert!(window.state_mut().edit(edit));
    let found = window.state().document().check(None).unwrap();
    let outside = found.iter().find(|finding| finding.kind.name() == "space");
    let finding = *outside.unwrap();
    window.state_mut().go_to(&finding);
    window.run();
    let frame = 20.0 + finding.first_frame;
    assert_eq!(window.state().frame().unwrap(), frame);
    let follow = window.state().document().scene().unwrap();
    let pose = follow.nodes()[0].path().unwrap().pose(frame).unwrap();
    assert!(pose.vrp[1] > 1.0, "there it is outside: {pose:?}");
}

/// A path alone has no such switch.
#[test]
fn a_path_alone_has_no_switch_for_what_is_selected() {
    let window = window(Language::English);
    let name = Language::English.texts().space.only_selected;
    assert!(window.query_by_label(name).is_none());
}

/// Another node goes on playing, and the axis stays while a bar is dragged.
#[test]
fn selecting_another_node_does_not_stop_the_playing() {
    let mut window = played();
    window.state_mut().set_frame(50.0).unwrap();
    window.get_by_label("Play").click();
    steps(&mut window, 10);
    window.state_mut().select_nodes(vec![1]);
    steps(&mut window, 10);
    assert!(window.state().playing.is_playing());
    let frame = window.state().frame().unwrap();
    assert!((51.0..70.0).contains(&frame), "{frame}");
}
