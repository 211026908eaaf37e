//! What the thesis's A.3 says is to be seen of the current camera and of a drag,
//! told from the picture with an element and without it.

use egui::{PointerButton, vec2};
use egui_kittest::Harness;

use super::tests::{image, position, press, pyramid_window, release, tips};
use crate::setup::Element;
use crate::state::Editor;

/// Where the pixels lie that are there because of an element.
fn pixels_of(harness: &mut Harness<'_, Editor>, element: Element) -> Vec<egui::Pos2> {
    let with = harness.render().unwrap();
    harness.state_mut().setup.shown.set(element, false);
    harness.step();
    let without = harness.render().unwrap();
    harness.state_mut().setup.shown.set(element, true);
    harness.step();
    let pixels = with.enumerate_pixels().zip(without.pixels());
    pixels
        .filter(|((_, _, with), without)| with != without)
        .map(|((x, y, _), _)| egui::pos2(x as f32 + 0.5, y as f32 + 0.5))
        .collect()
}

#[test]
fn view_up_and_its_circle_are_shown_at_the_current_point() {
    for point in [0, 4] {
        let mut harness = pyramid_window();
        // The small picture of what the camera sees would change as well.
        harness.state_mut().setup.camera_view = false;
        harness.state_mut().document.select(point, 0).unwrap();
        harness.run();
        let tips = tips(&harness);
        let centre = image(&harness, tips.position);
        for (element, tip) in [(Element::Vpn, tips.target), (Element::Vup, tips.up_tip)] {
            let tip = image(&harness, tip);
            let reach = egui::Rect::from_two_pos(centre, tip).expand(14.0);
            let pixels = pixels_of(&mut harness, element);
            assert!(pixels.len() > 20, "{element:?} {}", pixels.len());
            assert!(
                pixels.iter().all(|&pixel| reach.contains(pixel)),
                "{element:?}"
            );
            let near = pixels.iter().any(|pixel| pixel.distance(tip) < 4.0);
            assert!(near, "{element:?} ends at its tip");
        }
        // The circle goes round the point and through the tip of VUP.
        let pixels = pixels_of(&mut harness, Element::Circle);
        let tip = image(&harness, tips.up_tip);
        let across = centre - (tip - centre);
        let near = |to: egui::Pos2| pixels.iter().any(|pixel| pixel.distance(to) < 2.0);
        assert!(pixels.len() > 50 && near(across));
    }
}

#[test]
fn the_plane_and_the_three_axes_are_shown_as_soon_as_a_button_goes_down() {
    for which in [
        PointerButton::Primary,
        PointerButton::Middle,
        PointerButton::Secondary,
    ] {
        let mut harness = pyramid_window();
        harness.state_mut().setup.camera_view = false;
        let at = image(&harness, position(&harness, 4));
        harness.event(egui::Event::PointerMoved(at));
        harness.run();
        for element in [Element::Plane, Element::Axes] {
            assert_eq!(pixels_of(&mut harness, element).len(), 0, "{element:?}");
        }
        press(&mut harness, at, which);
        for way in [vec2(0.0, 0.0), vec2(12.0, 8.0)] {
            harness.event(egui::Event::PointerMoved(at + way));
            for _ in 0..30 {
                harness.step();
            }
            for element in [Element::Plane, Element::Axes] {
                let count = pixels_of(&mut harness, element).len();
                assert!(count > 100, "{which:?} {element:?} {way:?} {count}");
            }
        }
        // All three axes, both ways, nearly to the faces.
        let pixels = pixels_of(&mut harness, Element::Axes);
        for axis in 0..3 {
            for end in [-0.97, 0.97] {
                let mut place = position(&harness, 4);
                place[axis] = end;
                let place = image(&harness, place);
                let near = pixels.iter().any(|pixel| pixel.distance(place) < 2.0);
                assert!(near, "{which:?}: axis {axis} to {end}");
            }
        }
        release(&mut harness, at + vec2(12.0, 8.0), which);
        harness.run();
        for element in [Element::Plane, Element::Axes] {
            assert_eq!(pixels_of(&mut harness, element).len(), 0, "{element:?}");
        }
    }
}
