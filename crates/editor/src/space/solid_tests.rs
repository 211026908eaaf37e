//! What is hidden, held against rays through a box.

use egui::{Context, RawInput};
use vides_document::{Document, Info, Object};
use vides_engine::path::{CameraPath, Space, Target};

use super::super::camera_picture;
use super::super::cameras::Camera;
use super::super::projection::Projection;
use super::super::tests::{image, motion, viewport};
use super::*;
use crate::screenshots::screenshot;
use crate::setup::{Colours, View};
use crate::space::surface::projection_of;
use crate::state::space::solid::Eye;
use crate::tests::*;
use crate::theme::contrast;

const HALF: f64 = 0.4;

/// A box about the middle, each face divided into `cells` by `cells` squares.
fn box_of(cells: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for (axis, sign) in (0..3).flat_map(|axis| [(axis, -1.0), (axis, 1.0)]) {
        let first = mesh.points.len() as u32;
        for at in 0..(cells + 1).pow(2) {
            let [across, along] = [at % (cells + 1), at / (cells + 1)]
                .map(|at| HALF * (2.0 * f64::from(at) / f64::from(cells) - 1.0));
            let mut point = DVec3::ZERO;
            point[axis] = HALF * sign;
            point[(axis + 1) % 3] = across;
            point[(axis + 2) % 3] = along;
            mesh.points.push(point);
        }
        for at in 0..cells * cells {
            let corner = first + at / cells * (cells + 1) + at % cells;
            let [a, b, c, d] = [corner, corner + 1, corner + cells + 1, corner + cells + 2];
            mesh.triangles.extend([[a, b, d], [a, d, c]]);
        }
    }
    mesh
}

fn document(mesh: Mesh) -> Document {
    let info = Info {
        object: Object::features_of(mesh).unwrap(),
        ..Info::default()
    };
    Document::from_parts(CameraPath::default(), info).unwrap()
}

fn window_with(mesh: Mesh, theme: Theme) -> Window {
    let options = Options {
        document: document(mesh),
        ..options(Language::English)
    };
    window_of(options, LARGE, 1.0, theme)
}

/// In a pass of a window that has nothing else.
fn at_time<R>(context: &Context, time: f64, look: impl FnOnce() -> R) -> R {
    context.begin_pass(RawInput {
        time: Some(time),
        ..RawInput::default()
    });
    let result = look();
    context.end_pass().textures_delta.clear();
    result
}

/// Whether the box lies between a place and the viewer: on the way from there towards him.
fn behind_box(place: DVec3, toward: DVec3, far: f64, margin: f64) -> bool {
    let half = DVec3::splat(HALF + margin);
    part_between(place, place + toward * far, -half, half).is_some()
}

#[test]
fn what_lies_behind_a_box_is_hidden_and_nothing_else() {
    let window = window_with(box_of(3), Theme::Dark);
    let editor = window.state();
    let rect = Rect::from_min_size(egui::pos2(20.0, 30.0), egui::vec2(700.0, 600.0));
    for (pixels_per_point, rotation, tilt) in
        [(1.0, 28.0, 20.0), (1.5, -110.0, -35.0), (3.0, 0.0, 90.0)]
    {
        let view = View {
            rotation,
            tilt,
            ..View::default()
        };
        let projection = Projection::of(&view, rect, Space::default());
        let parallel = Eye {
            matrix: projection.matrix(pixels_per_point),
            front: 0.0,
            slack: [1.5, 0.0],
            lights: projection.lights(),
            rect,
            pixels_per_point,
            of_path: true,
        };
        let camera = Camera {
            position: DVec3::new(0.9, 0.5, 0.8),
            view: DVec3::new(-0.9, -0.5, -0.8).normalize(),
            up: DVec3::Y,
            zoom: 20.0,
        };
        let up = camera.view.cross(DVec3::Y).normalize().cross(camera.view);
        let camera = Camera { up, ..camera };
        let perspective = camera_picture::eye(editor, &camera, rect, pixels_per_point)
            .unwrap()
            .1;
        for (eye, from) in [(parallel, None), (perspective, Some(camera.position))] {
            let context = Context::default();
            let mut solid = Solid::default();
            let sight = at_time(&context, 0.0, || {
                solid.update(editor, &context, eye).cloned()
            });
            let sight = sight.unwrap();
            let mut counts = [0; 2];
            for at in 0..20_000_u32 {
                let part = |step: f64| (f64::from(at) * step).fract() * 2.0 - 1.0;
                let place = DVec3::new(part(0.618_033_9), part(0.754_877_6), part(0.569_840_2));
                let (toward, far) = match from {
                    None => (projection.toward(), 9.0),
                    Some(from) => ((from - place).normalize(), (from - place).length()),
                };
                let image = eye.matrix * place.extend(1.0);
                if image.w < eye.front {
                    continue;
                }
                // Near outlines and faces, within some pixels, either is right.
                let inner = behind_box(place, toward, far, -0.03);
                if inner != behind_box(place, toward, far, 0.03) {
                    continue;
                }
                let [x, y] = [image.x / image.w, image.y / image.w].map(|at| at / pixels_per_point);
                let seen = rect.shrink(3.0).contains(egui::pos2(x as f32, y as f32));
                if seen {
                    assert_eq!(sight.hides(place), inner, "{place} {eye:?}");
                    counts[usize::from(inner)] += 1;
                }
            }
            assert!(counts.iter().all(|&count| count > 300), "{counts:?}");
            // The parts of a line: without gaps, in order, hidden where their middles are.
            for at in 0..200_u32 {
                let part = |step: f64| (f64::from(at) * step).fract() * 2.0 - 1.0;
                let from = DVec3::new(part(0.618), part(0.754), part(0.569));
                let to = DVec3::new(part(0.311), part(0.877), part(0.133));
                let mut last = 0.0;
                sight.parts(from, to, |start, end, hidden| {
                    assert!(start == last && end > start, "{start} {end}");
                    last = end;
                    let middle = from.lerp(to, 0.5 * (start + end));
                    if end - start > 0.05 {
                        let image = eye.matrix * middle.extend(1.0);
                        if image.w > eye.front {
                            assert_eq!(sight.hides(middle), hidden);
                        }
                    }
                });
                assert_eq!(last, 1.0);
            }
        }
    }
}

/// Faces are shaded, each in its own tone; the wireframe is a choice that is kept.
#[test]
fn faces_are_shaded_until_a_wireframe_is_chosen() {
    for theme in [Theme::Dark, Theme::Light] {
        let mut window = window_with(box_of(1), theme);
        let space = window
            .get_by_label(window.state().texts().space.name)
            .rect();
        let projection = Projection::of(&View::default(), space, Space::default());
        let ground = window.state().setup.colours().of(Element::Background);
        let at = |image: &image::RgbaImage, place: DVec3| {
            let pos = projection.pos(place);
            let [r, g, b, _] = image.get_pixel(pos.x as u32, pos.y as u32).0;
            Color32::from_rgb(r, g, b)
        };
        let faces = [
            DVec3::new(-HALF, -0.3, -0.3),
            DVec3::new(0.17, HALF, 0.21),
            DVec3::new(0.17, 0.21, HALF),
        ];
        let image = screenshot(&mut window, &format!("shaded-{theme:?}.png"));
        let shaded = faces.map(|face| at(&image, face));
        let differ = shaded.iter().all(|&tone| tone != ground);
        assert!(
            differ && shaded[0] != shaded[1] && shaded[1] != shaded[2],
            "{shaded:?}"
        );
        let texts = &Language::English.texts().space;
        click(&mut window, texts.view_menu);
        click(&mut window, texts.wireframe);
        assert!(window.state().setup.wireframe);
        press(&mut window, egui::Modifiers::NONE, egui::Key::Escape);
        let image = screenshot(&mut window, &format!("wires-{theme:?}.png"));
        assert_eq!(faces.map(|face| at(&image, face)), [ground; 3]);
    }
}

/// A large mesh is coarser while the view moves, and whole once it rests.
#[test]
fn a_large_mesh_is_coarse_while_it_moves() {
    let mesh = box_of(150);
    let few = vides_document::coarse(&mesh).unwrap().len();
    assert!(
        mesh.triangles.len() > 200_000 && (10_000..90_000).contains(&few),
        "{few}"
    );
    let window = window_with(mesh, Theme::Dark);
    let rect = Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(600.0, 600.0));
    let eye = |rotation: f64| {
        let view = View {
            rotation,
            ..View::default()
        };
        let projection = Projection::of(&view, rect, Space::default());
        Eye {
            matrix: projection.matrix(1.0),
            front: 0.0,
            slack: [1.5, 0.0],
            lights: projection.lights(),
            rect,
            pixels_per_point: 1.0,
            of_path: true,
        }
    };
    let context = Context::default();
    let mut solid = Solid::default();
    let mut made = |time: f64, rotation: f64| {
        at_time(&context, time, || {
            solid.update(window.state(), &context, eye(rotation));
            (solid.number, solid.quick)
        })
    };
    assert_eq!(made(10.0, 0.0), (1, false));
    assert_eq!(made(10.01, 0.0), (1, false));
    assert_eq!(made(10.02, 5.0), (2, true));
    assert_eq!(made(10.1, 6.0), (3, true));
    assert_eq!(made(10.2, 6.0), (3, true));
    assert_eq!(made(10.5, 6.0), (4, false));
    assert_eq!(made(11.0, 6.0), (4, false));
}

/// What the path is drawn with stands out from faces in any light (WCAG 1.4.11).
#[test]
fn the_path_stands_out_from_faces() {
    for colours in [Colours::DARK, Colours::LIGHT] {
        let [ground, base] = [Element::Background, Element::Object].map(|of| colours.of(of));
        for lit in [0.0, 0.5, 1.0] {
            let tone = tone(ground, base, None, lit);
            for element in [
                Element::Curve,
                Element::Segment,
                Element::Crosses,
                Element::Player,
            ] {
                let found = contrast(colours.of(element), tone);
                assert!(found >= 3.0, "{element:?} {lit}: {found}");
            }
        }
    }
}

#[test]
fn f7_aims_at_the_face_under_the_pointer() {
    let mut window = window_with(box_of(1), Theme::Dark);
    window.run();
    let toward = projection_of(window.state(), viewport(&window)).toward();
    for axis in 0..3 {
        // On the side that is seen, beside its middle.
        let mut place = DVec3::new(0.11, -0.07, 0.05);
        place[axis] = HALF * toward[axis].signum();
        let at = image(&window, place);
        motion(&mut window, at);
        window.run();
        press(&mut window, Modifiers::NONE, egui::Key::F7);
        let points = &window.state().document.path().points;
        for view in points.iter().flat_map(|point| &point.orientations) {
            let Target::Absolute(target) = view.target else {
                panic!("{:?}", view.target);
            };
            // As exact as a pixel.
            assert!(target.distance(place) < 0.01, "{target} {place}");
        }
    }
}
