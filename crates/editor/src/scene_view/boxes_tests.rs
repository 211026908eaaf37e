use vides_document::Document;
use vides_engine::scene::{Interpolation, Mesh, Node, Scene, Track};

use super::*;
use crate::screenshots::screenshot;
use crate::tests::*;

/// A bar of 1 × 2 × 1 that is twisted about y, by 90° at frame 11, in a group that is turned.
fn window_of_bar(language: Language, size: [f32; 2], theme: Theme) -> Window {
    let mut scene = Scene::new();
    let mut group = Node::new("group", Kind::Group);
    group.rest.position = DVec3::new(0.1, 0.2, 0.3);
    group.rest.scale = DVec3::new(0.5, 0.25, 0.5);
    scene.add(group).unwrap();
    let mut bar = Node::new("bar", Kind::Object(Object::default()));
    bar.parent = Some(0);
    bar.rest.position = DVec3::new(0.0, -0.5, 0.0);
    scene.add(bar).unwrap();
    let ends = [-1.0, 1.0];
    let corners = ends.iter().flat_map(|x| ends.iter().map(move |y| (x, y)));
    let corners = corners.flat_map(|(x, y)| ends.map(|z| DVec3::new(0.5 * x, *y, 0.5 * z)));
    let mesh = Mesh {
        points: corners.collect(),
        lines: vec![
            [0, 1],
            [2, 3],
            [4, 5],
            [6, 7],
            [0, 2],
            [1, 3],
            [4, 6],
            [5, 7],
        ],
        ..Mesh::default()
    };
    scene.set_mesh(1, mesh).unwrap();
    let twist = Deformation::new("twist", &[1.0, 0.0]).unwrap();
    scene.add_deformation(1, twist, None).unwrap();
    let parameter = "angle".to_owned();
    let channel = Channel::Deformation { at: 0, parameter };
    let frames = vec![1.0, 11.0];
    let track = Track::new(
        channel,
        Interpolation::Linear,
        frames,
        vec![0.0, 90.0],
        Vec::new(),
    );
    scene.set_track(1, track.unwrap()).unwrap();
    scene
        .add(Node::new("camera", Kind::Camera(Default::default())))
        .unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let options = crate::Options {
        document: document.as_opened(),
        ..options(language)
    };
    let mut window = window_of(options, size, 1.0, theme);
    window.state_mut().select_nodes(vec![1]);
    window.state_mut().set_frame(11.0).unwrap();
    window.run();
    window
}

fn cage(window: &Window) -> Cage {
    window.state().cage_in_space().expect("a cage")
}

#[test]
fn the_cage_is_the_box_as_the_deformation_makes_it_at_the_playhead() {
    let language = Language::English;
    let texts = &language.texts().node;
    let mut window = window_of_bar(language, LARGE, Theme::Dark);
    assert!(window.state().cage_in_space().is_none());
    let name = format!("1. {}", language.tool("twist"));
    window.get_by_label(&name).click_accesskit();
    window.run();
    // (x, y, z) turned about y by 90°·(w + 1)/2, then into the space.
    let place = |x: f64, y: f64, z: f64, w: f64| {
        let (sin, cos) = (0.5 * std::f64::consts::FRAC_PI_2 * (w + 1.0)).sin_cos();
        let turned = DVec3::new(x * cos + z * sin, y, z * cos - x * sin);
        DVec3::new(0.1, 0.2, 0.3)
            + DVec3::new(0.5, 0.25, 0.5) * (turned + DVec3::new(0.0, -0.5, 0.0))
    };
    let has = |cage: &Cage, wanted: DVec3| {
        let mut all = cage.lines.iter().flatten();
        all.any(|found| found.distance(wanted) < 1e-12)
    };
    for (x, z) in [(0.5, 0.5), (-0.5, 0.5), (0.5, -0.5)] {
        for w in [-1.0, 0.0, 1.0] {
            assert!(has(&cage(&window), place(x, w, z, w)), "{x} {w} {z}");
        }
    }
    // Half of the bar alone is twisted then.
    let before = window.state().document.to_toml().unwrap();
    let low = format!("{name}: {} y", texts.box_low);
    number(&window, &low).scroll_to_me();
    window.run();
    enter(&mut window, &low, "0");
    let of = window.state().document.scene().unwrap();
    let Kind::Object(object) = &of.nodes()[1].kind else {
        panic!("an object")
    };
    let bounds = object.deformations()[0].1.expect("a box of its own");
    assert_eq!(bounds.min().to_array(), [-0.5, 0.0, -0.5]);
    assert_eq!(bounds.max().to_array(), [0.5, 1.0, 0.5]);
    for (y, w) in [(0.0, -1.0), (0.5, 0.0), (1.0, 1.0)] {
        assert!(has(&cage(&window), place(0.5, y, 0.5, w)), "{y}");
    }
    // A lowest corner above the highest one is told, and nothing changes.
    let one = window.state().document.to_toml().unwrap();
    enter(&mut window, &low, "3");
    assert!(
        window
            .state()
            .message
            .as_ref()
            .is_some_and(|message| message.error)
    );
    assert_eq!(window.state().document.to_toml().unwrap(), one);
    // The box of the mesh again.
    let back = fill(texts.box_of_mesh_of, &[&name]);
    window.get_by_label(&back).click_accesskit();
    window.run();
    assert_eq!(window.state().document.to_toml().unwrap(), before);
    assert!(window.state_mut().document.undo());
    assert_eq!(window.state().document.to_toml().unwrap(), one);
    assert!(window.state_mut().document.undo());
    assert_eq!(window.state().document.to_toml().unwrap(), before);
}

#[test]
fn pictures_of_a_box() {
    for (language, size, theme, name) in [
        (Language::English, LARGE, Theme::Light, "en-light"),
        (Language::German, SMALL, Theme::Dark, "de-small"),
    ] {
        let mut window = window_of_bar(language, size, theme);
        let button = format!("1. {}", language.tool("twist"));
        window.get_by_label(&button).click_accesskit();
        window.run();
        let low = format!("{button}: {} y", language.texts().node.box_low);
        number(&window, &low).scroll_to_me();
        window.run();
        screenshot(&mut window, &format!("box-{name}.png"));
    }
}
