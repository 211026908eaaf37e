use vides_document::Document;
use vides_engine::scene::{Kind, Mesh, Node, Object, Scene};

use super::*;
use crate::screenshots::screenshot;
use crate::tests::*;

const FRAMES: [f64; 4] = [1.0, 11.0, 31.0, 41.0];

/// Yaw, pitch and roll in degrees.
const ANGLES: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [80.0, 50.0, 20.0],
    [-60.0, -40.0, 130.0],
    [10.0, 5.0, 0.0],
];

type Q = [f64; 4];

fn product([a, b, c, d]: Q, [e, f, g, h]: Q) -> Q {
    [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]
}

/// w, x, y, z of a turn about y, then the turned x, then the turned z axis.
fn of([yaw, pitch, roll]: [f64; 3]) -> Q {
    let half = |degrees: f64| (0.5 * degrees.to_radians()).sin_cos();
    let ((sy, cy), (sp, cp), (sr, cr)) = (half(yaw), half(pitch), half(roll));
    product(
        product([cy, 0.0, sy, 0.0], [cp, sp, 0.0, 0.0]),
        [cr, 0.0, 0.0, sr],
    )
}

fn dot(a: Q, b: Q) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The angle at a frame between the great arc and the angles in a straight line.
fn expected(frame: f64) -> f64 {
    let frame = frame.clamp(FRAMES[0], FRAMES[3]);
    let k = FRAMES.iter().rposition(|key| *key <= frame).unwrap().min(2);
    let u = (frame - FRAMES[k]) / (FRAMES[k + 1] - FRAMES[k]);
    let angles = [0, 1, 2].map(|i| ANGLES[k][i] + u * (ANGLES[k + 1][i] - ANGLES[k][i]));
    let (a, mut b) = (of(ANGLES[k]), of(ANGLES[k + 1]));
    if dot(a, b) < 0.0 {
        b = b.map(|part| -part);
    }
    let wide = dot(a, b).clamp(-1.0, 1.0).acos();
    let shares = [(1.0 - u) * wide, u * wide].map(|part| part.sin() / wide.sin());
    let arc = [0, 1, 2, 3].map(|i| shares[0] * a[i] + shares[1] * b[i]);
    2.0 * dot(arc, of(angles)).abs().min(1.0).acos().to_degrees()
}

fn window_of_turns(language: Language, size: [f32; 2], theme: Theme) -> Window {
    let mut scene = Scene::new();
    let mut node = Node::new("propeller", Kind::Object(Object::default()));
    node.pivot = DVec3::new(0.1, 0.0, 0.0);
    scene.add(node).unwrap();
    let corner = |x, y, z| DVec3::new(x, y, z);
    let mesh = Mesh {
        points: vec![
            corner(-0.3, 0.0, 0.0),
            corner(0.5, 0.0, 0.0),
            corner(0.1, 0.3, 0.0),
            corner(0.1, 0.0, 0.2),
        ],
        triangles: vec![[0, 1, 2], [0, 1, 3], [1, 2, 3], [0, 2, 3]],
        ..Mesh::default()
    };
    scene.set_mesh(0, mesh).unwrap();
    let track = Track::new(
        Channel::Rotation,
        Interpolation::EulerLinear,
        FRAMES.to_vec(),
        ANGLES.concat(),
        Vec::new(),
    );
    scene.set_track(0, track.unwrap()).unwrap();
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
    let context = window.ctx.clone();
    let asked = [Action::SelectNodes(vec![0]), Action::CompareRotations];
    window.state_mut().act_all(asked, &context);
    window.run();
    window
}

#[test]
fn the_angle_is_that_between_the_arc_and_the_angles() {
    let mut window = window_of_turns(Language::English, LARGE, Theme::Dark);
    for frame in [1.0, 4.0, 11.0, 17.5, 25.0, 36.0, 41.0] {
        window.state_mut().set_frame(frame).unwrap();
        window.run();
        let made = window.state().windows.compare.as_ref().unwrap();
        let made = made.made.as_ref().unwrap();
        let [a, b] = at(&made.both, frame);
        let angle = between(a, b);
        // The arc cosine of the check loses half of its digits near 0.
        let slack = if expected(frame) < 0.01 { 3e-6 } else { 1e-8 };
        assert!((angle - expected(frame)).abs() < slack, "{frame}: {angle}");
        let told = fill(
            Language::English.texts().compare.angle,
            &[&Language::English.number(angle, 2)],
        );
        assert!(window.query_by_label(&told).is_some(), "{told}");
    }
    let made = window.state().windows.compare.as_ref().unwrap();
    let (largest, frame) = made.made.as_ref().unwrap().largest;
    let all = (1..=41_u8)
        .map(f64::from)
        .map(|frame| (expected(frame), frame));
    let (wanted, at) = all.fold((0.0, 1.0), |a, b| if b.0 > a.0 { b } else { a });
    assert!(
        (largest - wanted).abs() < 1e-8 && frame == at,
        "{largest} {frame} {wanted} {at}"
    );
    assert!(largest > 5.0, "else there is nothing to compare");
}

#[test]
fn what_is_used_becomes_the_track_in_one_step() {
    for language in BOTH {
        let texts = &language.texts().compare;
        let mut window = window_of_turns(language, LARGE, Theme::Dark);
        let track = |window: &Window| {
            let scene = window.state().document.scene().unwrap();
            scene.nodes()[0]
                .keys()
                .track(&Channel::Rotation)
                .unwrap()
                .clone()
        };
        let before = track(&window);
        let state = window.state().document.state_number();
        click(
            &mut window,
            &fill(texts.use_these_of, &[&texts.quaternions]),
        );
        let after = track(&window);
        assert_eq!(after.interpolation(), &Interpolation::Linear);
        assert_eq!(after.frames(), before.frames());
        for (value, angles) in after.values().chunks_exact(4).zip(ANGLES) {
            let found = [value[0], value[1], value[2], value[3]];
            assert!(dot(found, of(angles)).abs() > 1.0 - 1e-12);
        }
        assert!(window.state_mut().document.undo());
        assert_eq!(track(&window), before);
        assert_eq!(window.state().document.state_number(), state);
        window.run();
        // Smooth ones too.
        click(&mut window, language.texts().timeline.catmull_rom);
        click(&mut window, &fill(texts.use_these_of, &[&texts.angles]));
        let after = track(&window);
        assert_eq!(after.interpolation(), &Interpolation::EulerCatmullRom);
        assert_eq!(after.values(), before.values());
    }
}

#[test]
fn pictures() {
    for (language, size, theme, name) in [
        (Language::English, LARGE, Theme::Light, "en-light"),
        (Language::German, SMALL, Theme::Dark, "de-small"),
    ] {
        let mut window = window_of_turns(language, size, theme);
        window.state_mut().set_frame(22.0).unwrap();
        window.run();
        screenshot(&mut window, &format!("compare-{name}.png"));
        let context = window.ctx.clone();
        window
            .state_mut()
            .act(Action::SelectNodes(vec![1]), &context);
        window.run();
        assert!(
            window
                .query_by_label(language.texts().compare.no_keys)
                .is_some()
        );
    }
}
