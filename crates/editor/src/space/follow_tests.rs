//! The space as it follows the hand is the space as a whole pass shows it.

use egui::epaint::{ClippedShape, ImageDelta};
use egui::{
    ClippedPrimitive, Color32, Event, Modifiers, PointerButton, Pos2, RawInput, TextureId,
    TextureOptions, TexturesDelta, Vec2, vec2,
};
use egui_kittest::Harness;

use super::tests::{image, motion, press, pyramid_window, release, tips, viewport};
use super::*;
use crate::raster::{self, Raster, Target};

/// The input of the last pass with nothing but a motion in it.
fn motions(harness: &Harness<'_, Editor>, to: Pos2) -> RawInput {
    let mut input = harness.ctx.input(|input| input.raw.clone());
    input.events = vec![Event::PointerMoved(to)];
    input
}

/// What is painted of shapes, at one pixel for a point.
fn meshes(harness: &Harness<'_, Editor>, shapes: &[ClippedShape]) -> Vec<ClippedPrimitive> {
    raster::primitives(&harness.ctx, shapes.to_vec(), 1.0)
}

/// The pixels that become of them.
fn pixels(
    harness: &Harness<'_, Editor>,
    raster: &mut Raster,
    primitives: &[ClippedPrimitive],
) -> Vec<u32> {
    let size = harness.ctx.content_rect().size();
    let (width, height) = (size.x as u32, size.y as u32);
    let mut pixels = vec![0; (width * height) as usize];
    let font = harness.ctx.fonts(|fonts| fonts.image());
    let font = ImageDelta::full(font, TextureOptions::LINEAR);
    let mut textures = TexturesDelta::default();
    textures.set.insert(TextureId::default(), [font].into());
    raster.update_textures(textures);
    raster.forget();
    let mut target = Target {
        pixels: &mut pixels,
        stride: width as usize,
        width,
        height,
    };
    raster.paint(primitives, 1.0, &mut target);
    pixels
}

/// Presses, moves, follows and has a pass show the same.
fn follows_as_a_pass_shows(button: PointerButton, place: impl Fn(&Harness<'_, Editor>) -> Pos2) {
    let mut harness = pyramid_window();
    harness.state_mut().document.select(1, 0).unwrap();
    harness.run();
    let from = place(&harness);
    let mut raster = Raster::new(Color32::BLACK);
    press(&mut harness, from, button);
    motion(&mut harness, from + vec2(10.0, 0.0));
    for step in 0..12_u8 {
        let way = Vec2::angled(f32::from(step)) * 40.0;
        let before = harness.output().shapes.clone();
        let input = motions(&harness, from + way);
        let context = harness.ctx.clone();
        let path = harness.state().document.path().clone();
        let view = harness.state().setup.view;
        let followed = harness.state_mut().follow(&context, &input);
        let followed = followed.expect("a drag");
        let state = harness.state();
        assert!(
            *state.document.path() != path || state.setup.view != view,
            "step {step}: nothing moved"
        );
        let range = harness.state().shapes_of_space(before.len());
        let mut exchanged = before.clone();
        exchanged.splice(range, followed);
        let mut exchanged = meshes(&harness, &exchanged);
        let picture = harness.state().camera_lines().cloned().expect("a picture");
        let mut places = exchanged.iter_mut().filter(|some| picture.are_in(some));
        let place = places.next().expect("its place");
        let seen = harness.state_mut().follow_by_camera().expect("a camera");
        seen.put_into(place);
        let exchanged = pixels(&harness, &mut raster, &exchanged);
        let before = meshes(&harness, &before);
        let before = pixels(&harness, &mut raster, &before);
        motion(&mut harness, from + way);
        let shown = meshes(&harness, &harness.output().shapes);
        let shown = pixels(&harness, &mut raster, &shown);
        let viewport = viewport(&harness);
        for y in 0..800 {
            for x in 0..1200 {
                let at = y * 1200 + x;
                let inside = viewport.contains(egui::pos2(x as f32 + 0.5, y as f32 + 0.5));
                let wanted = if inside { shown[at] } else { before[at] };
                assert_eq!(exchanged[at], wanted, "step {step}: {x}, {y}");
            }
        }
    }
    release(&mut harness, from, button);
}

#[test]
fn a_point() {
    follows_as_a_pass_shows(PointerButton::Middle, |harness| {
        image(harness, tips(harness).position)
    });
}

#[test]
fn the_tip_of_vpn() {
    follows_as_a_pass_shows(PointerButton::Secondary, |harness| {
        image(harness, tips(harness).target)
    });
}

#[test]
fn the_tip_of_vup() {
    follows_as_a_pass_shows(PointerButton::Primary, |harness| {
        image(harness, tips(harness).up_tip)
    });
}

#[test]
fn the_view() {
    follows_as_a_pass_shows(PointerButton::Primary, |harness| {
        viewport(harness).right_bottom() - vec2(60.0, 60.0)
    });
}

/// Everything else needs a pass.
#[test]
fn nothing_but_motion_is_followed() {
    let mut harness = pyramid_window();
    let from = image(&harness, tips(&harness).position);
    let to = from + vec2(30.0, 10.0);
    let follow = |harness: &mut Harness<'_, Editor>, change: &dyn Fn(&mut RawInput)| {
        let mut input = motions(harness, to);
        change(&mut input);
        let context = harness.ctx.clone();
        harness.state_mut().follow(&context, &input).is_some()
    };
    let before = harness.state().document.path().clone();
    assert!(!follow(&mut harness, &|_| {}), "no button is held");
    press(&mut harness, from, PointerButton::Middle);
    assert!(!follow(&mut harness, &|_| {}), "nothing has moved yet");
    assert_eq!(*harness.state().document.path(), before);
    motion(&mut harness, to);
    let before = harness.state().document.path().clone();
    let key = Event::Key {
        key: egui::Key::X,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    let larger = egui::Rect::from_min_size(Pos2::ZERO, vec2(1300.0, 800.0));
    let changes: [&dyn Fn(&mut RawInput); 5] = [
        &|input| input.events.clear(),
        &|input| input.events.push(key.clone()),
        &|input| input.screen_rect = Some(larger),
        &|input| input.focused = !input.focused,
        &|input| {
            let viewport = input.viewports.entry(input.viewport_id).or_default();
            viewport.native_pixels_per_point = Some(3.0);
        },
    ];
    for (number, change) in changes.into_iter().enumerate() {
        assert!(!follow(&mut harness, change), "{number}");
    }
    assert_eq!(*harness.state().document.path(), before);
    assert!(follow(&mut harness, &|_| {}));
}
