//! Tests of [`super`].

use egui_kittest::kittest::Queryable as _;
use proptest::prelude::*;

use super::*;
use crate::math::orientation::{unit, up_from_roll};

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
        f64::from(ASPECT),
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
                way.dot(right) / depth / half_height / f64::from(ASPECT),
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
    use crate::Language;
    use crate::tests::{LARGE, SMALL, window};
    let pane = |window: &crate::tests::Window| {
        let id = egui::Id::unique("camera view");
        let rect = window.ctx.memory(|memory| memory.area_rect(id));
        (rect.unwrap(), window.get_by_label("Movement window").rect())
    };
    let mut window = window(Language::English);
    let (large, _) = pane(&window);
    assert!((large.width() - WIDTH).abs() < 4.0, "{large:?}");
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
