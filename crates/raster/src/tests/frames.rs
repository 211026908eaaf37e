//! What is painted again is what changed, and it comes out as if all were.

use std::sync::Arc;

use egui::epaint::Primitive;
use egui::epaint::textures::TextureOptions;
use egui::{ClippedPrimitive, Color32, Pos2, Rect, TextureId, TexturesDelta, pos2, vec2};

use super::lines::primitive;
use super::rounded_rects;
use super::{Random, Screen, letters, mesh, texture, vertex};
use crate::rounded_rect::RoundedRect;
use crate::{Area, Line, Lines, Target};

fn line(random: &mut Random) -> Line {
    let from = pos2(random.between(-20.0, 270.0), random.between(-20.0, 220.0));
    let way = vec2(random.between(-50.0, 50.0), random.between(-50.0, 50.0));
    Line {
        from,
        to: from + way * random.between(0.0, 2.0),
        width: random.between(0.2, 5.0),
        color: random.color(),
    }
}

/// Pieces of a curve, one going on in the next.
fn curve(random: &mut Random) -> Vec<Line> {
    let first = line(random);
    let width = random.between(0.5, 4.0);
    let mut angle = random.between(0.0, 6.3);
    let mut from = first.from;
    let piece = |_| {
        angle += random.between(-0.15, 0.15);
        let to = from + random.between(3.0, 30.0) * vec2(angle.cos(), angle.sin());
        let line = Line {
            from,
            to,
            width,
            ..first
        };
        from = to;
        line
    };
    (0..12).map(piece).collect()
}

/// The same with one of its lines in another colour.
fn with_another_line(part: &ClippedPrimitive, random: &mut Random) -> Option<ClippedPrimitive> {
    let Primitive::Callback(callback) = &part.primitive else {
        return None;
    };
    let mut lines = Lines::of(callback)?.clone();
    let count = lines.lines.len();
    lines.lines.get_mut(random.below(count.max(1)))?.color = random.color();
    let mut other = primitive(&Arc::new(lines));
    other.clip_rect = part.clip_rect;
    Some(other)
}

/// A rounded rectangle, often at whole pixels.
fn rounded_rect(place: Pos2, random: &mut Random) -> RoundedRect {
    let size = vec2(random.between(1.0, 200.0), random.between(1.0, 150.0));
    let size = if random.below(2) == 0 {
        size.round()
    } else {
        size
    };
    RoundedRect {
        rect: Rect::from_min_size(place, size),
        radii: [(); 4].map(|()| random.between(-5.0, 0.5 * size.min_elem()).max(0.0)),
        fill: random.color(),
        border: random.between(-2.0, 3.0).max(0.0),
        border_color: random.color(),
    }
}

/// Rectangles, letters, triangles, rounded rectangles and lines, cut at random.
fn thing(random: &mut Random) -> ClippedPrimitive {
    let place = pos2(random.between(-50.0, 250.0), random.between(-50.0, 200.0)).round();
    let mut part = match random.below(6) {
        5 => rounded_rects::primitive(rounded_rect(place, random)),
        0 => {
            let lines = if random.below(2) == 0 {
                curve(random)
            } else {
                (0..random.below(20)).map(|_| line(random)).collect()
            };
            primitive(&Arc::new(Lines { lines }))
        }
        1 => {
            let mut corner = || {
                let way = vec2(random.between(-90.0, 90.0), random.between(-90.0, 90.0));
                let at = place + way;
                vertex(at.x, at.y, random.color())
            };
            mesh(vec![corner(), corner(), corner()], vec![0, 1, 2])
        }
        kind => {
            let far = match kind {
                2 => vec2(9.0, 12.0),
                3 => vec2(random.between(0.0, 300.0), random.between(0.0, 300.0)),
                // Covers tiles.
                _ => vec2(150.0, 150.0),
            };
            let color = random.color();
            let mut corners = Vec::new();
            for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
                let at = place + far * vec2(x, y);
                let mut corner = vertex(at.x, at.y, color);
                if kind == 2 {
                    corner.uv = pos2((3.0 + 9.0 * x) / 64.0, (5.0 + 12.0 * y) / 32.0);
                }
                corners.push(corner);
            }
            mesh(corners, vec![0, 1, 2, 2, 1, 3])
        }
    };
    if random.below(3) == 0 {
        let low = pos2(random.between(-10.0, 200.0), random.between(-10.0, 150.0));
        let size = vec2(random.between(0.0, 200.0), random.between(0.0, 200.0));
        part.clip_rect = Rect::from_min_size(low, size);
    }
    part
}

fn holds(area: &Area, x: u32, y: u32) -> bool {
    (area.x..area.x + area.width).contains(&x) && (area.y..area.y + area.height).contains(&y)
}

#[test]
fn a_sequence_of_frames_is_as_if_each_were_painted_whole() {
    let mut random = Random(21);
    for (width, height, scale) in [(250, 200, 1.0), (65, 64, 1.5), (256, 190, 2.0), (1, 1, 1.0)] {
        let mut screen = Screen::new(width, height, Color32::from_rgb(20, 30, 40));
        let mut whole = Screen::new(width, height, Color32::from_rgb(20, 30, 40));
        (screen.scale, whole.scale) = (scale, scale);
        let mut things: Vec<_> = (0..12).map(|_| thing(&mut random)).collect();
        let mut spared = 0;
        for round in 0..300 {
            match random.below(12) {
                7 | 8 if !things.is_empty() => {
                    let at = random.below(things.len());
                    if let Some(other) = with_another_line(&things[at], &mut random) {
                        things[at] = other;
                    }
                }
                0 => {
                    things.push(thing(&mut random));
                }
                1 if !things.is_empty() => {
                    let at = random.below(things.len());
                    things.remove(at);
                }
                2 if things.len() > 1 => {
                    let (a, b) = (random.below(things.len()), random.below(things.len()));
                    things.swap(a, b);
                }
                3 if !things.is_empty() => {
                    let at = random.below(things.len());
                    things[at] = thing(&mut random);
                }
                4 if !things.is_empty() => {
                    let at = random.below(things.len());
                    things[at].clip_rect = thing(&mut random).clip_rect;
                }
                5 => {
                    let image = if round % 2 == 0 {
                        letters()
                    } else {
                        let mut image = letters();
                        image.pixels[5 * 64 + 7] = Color32::from_white_alpha(round as u8);
                        image
                    };
                    for screen in [&mut screen, &mut whole] {
                        let id = TextureId::default();
                        let news = texture(id, image.clone(), TextureOptions::LINEAR);
                        screen.raster.update_textures(news);
                    }
                }
                6 if things.len() > 2 => {
                    things.truncate(things.len() - 2);
                }
                _ => {}
            }
            let before = screen.pixels.clone();
            let areas = screen.paint(&things);
            whole.raster.forget();
            whole.paint(&things);
            assert!(screen.pixels == whole.pixels, "round {round}");
            let mut painted = 0;
            for (i, (now, before)) in screen.pixels.iter().zip(&before).enumerate() {
                let (x, y) = (i as u32 % width, i as u32 / width);
                let count = areas.iter().filter(|area| holds(area, x, y)).count();
                assert!(count <= 1, "round {round}: areas lie on each other");
                assert!(now == before || count == 1, "round {round}: not said");
                painted += count;
            }
            spared += usize::from(painted < screen.pixels.len());
        }
        assert!(spared > 100 || width < 66);
    }
}

#[test]
fn what_stays_is_not_painted_again() {
    let mut random = Random(22);
    let things: Vec<_> = (0..20).map(|_| thing(&mut random)).collect();
    let mut screen = Screen::new(250, 200, Color32::BLACK);
    let whole = Area {
        x: 0,
        y: 0,
        width: 250,
        height: 200,
    };
    assert_eq!(screen.paint(&things), [whole]);
    assert_eq!(screen.paint(&things), []);
    // The same things in other memory.
    assert_eq!(screen.paint(&things.clone()), []);
    screen.raster.forget();
    assert_eq!(screen.paint(&things), [whole]);
    screen.raster.set_background(Color32::BLACK);
    assert_eq!(screen.paint(&things), []);
    screen.raster.set_background(Color32::WHITE);
    assert_eq!(screen.paint(&things), [whole]);
}

#[test]
fn one_line_repaints_its_tiles_only() {
    let line = |x: f32| Line {
        from: pos2(x, 70.0),
        to: pos2(x + 5.0, 75.0),
        width: 1.0,
        color: Color32::WHITE,
    };
    let paint = |screen: &mut Screen, lines: Vec<Line>| {
        screen.paint(&[primitive(&Arc::new(Lines { lines }))])
    };
    let mut screen = Screen::new(250, 200, Color32::BLACK);
    paint(&mut screen, vec![line(10.0), line(80.0), line(110.0)]);
    let tile = |x, width| Area {
        x,
        y: 64,
        width,
        height: 32,
    };
    let moved = paint(&mut screen, vec![line(10.0), line(81.0), line(110.0)]);
    assert_eq!(moved, [tile(64, 32)]);
    // From one tile into the next but one: both change.
    let moved = paint(&mut screen, vec![line(200.0), line(81.0), line(110.0)]);
    assert_eq!(moved, [tile(0, 32), tile(192, 32)]);
    // Neighbours become one area.
    let gone = paint(&mut screen, vec![line(200.0)]);
    assert_eq!(gone, [tile(64, 64)]);
}

#[test]
fn a_texture_is_kept_for_the_frame_that_comes_with_its_release() {
    let id = TextureId::User(5);
    let mut screen = Screen::new(10, 10, Color32::BLACK);
    let image = egui::ColorImage::filled([2, 2], Color32::RED);
    screen
        .raster
        .update_textures(texture(id, image, TextureOptions::NEAREST));
    let corners = [(0.0, 0.0), (20.0, 0.0), (0.0, 20.0)].map(|(x, y)| vertex(x, y, Color32::WHITE));
    let mut shown = mesh(corners.to_vec(), vec![0, 1, 2]);
    if let Primitive::Mesh(mesh) = &mut shown.primitive {
        mesh.texture_id = id;
    }
    let mut delta = TexturesDelta::default();
    delta.free(id);
    screen.raster.update_textures(delta);
    screen.paint(std::slice::from_ref(&shown));
    assert_eq!(screen.rgb(1, 1), [255, 0, 0]);
    screen.raster.update_textures(TexturesDelta::default());
    screen.paint(&[shown]);
    assert_eq!(screen.rgb(1, 1), [0; 3]);
}

/// A new letter in the atlas comes as a patch, and may be a coloured one.
/// What moved while a target was too small leaves nothing behind.
#[test]
fn a_target_that_was_refused_hides_no_change() {
    let at = |x: f32| {
        [rounded_rects::primitive(rounded_rect(
            pos2(x, 5.0),
            &mut Random(x as u64),
        ))]
    };
    for refused in [(0, 0), (120, 40)] {
        let mut screen = Screen::new(120, 40, Color32::BLACK);
        screen.paint(&at(2.0));
        let mut small = [7; 3];
        let mut target = Target {
            pixels: &mut small,
            stride: 120,
            width: refused.0,
            height: refused.1,
        };
        assert!(screen.raster.paint(&at(90.0), 1.0, &mut target).is_empty());
        screen.paint(&at(90.0));
        let mut anew = Screen::new(120, 40, Color32::BLACK);
        anew.paint(&at(90.0));
        assert!(screen.pixels == anew.pixels, "{refused:?}");
    }
}

/// A letter that comes into the picture of all letters changes nothing that is shown,
/// only what was to show that letter.
#[test]
fn what_a_patch_of_a_texture_does_not_touch_stays() {
    let mut screen = Screen::new(128, 32, Color32::BLACK);
    let letter = |left: f32, [u, v]: [f32; 2]| {
        let mut corners = Vec::new();
        for (x, y) in [(0.0, 0.0), (9.0, 0.0), (0.0, 12.0), (9.0, 12.0)] {
            let mut corner = vertex(left + x, 10.0 + y, Color32::WHITE);
            corner.uv = pos2((u + x) / 64.0, (v + y) / 32.0);
            corners.push(corner);
        }
        mesh(corners, vec![0, 1, 2, 2, 1, 3])
    };
    // In tiles of their own.
    let shown = [letter(10.0, [3.0, 5.0]), letter(74.0, [40.0, 16.0])];
    screen.paint(&shown);
    let image = egui::ColorImage::filled([4, 2], Color32::from_white_alpha(200));
    let mut patched = |at| {
        let patch = egui::epaint::ImageDelta::partial(at, image.clone(), TextureOptions::LINEAR);
        let mut delta = TexturesDelta::default();
        delta.push(TextureId::default(), patch);
        screen.raster.update_textures(delta);
        let areas = screen.paint(&shown);
        let pixels = screen.pixels.clone();
        screen.raster.forget();
        screen.paint(&shown);
        assert!(pixels == screen.pixels, "{at:?}");
        areas.iter().map(|area| area.x / 32).collect::<Vec<_>>()
    };
    assert_eq!(patched([26, 24]), []);
    assert_eq!(patched([8, 10]), [0]);
    // The same again.
    assert_eq!(patched([8, 10]), []);
    assert_eq!(patched([44, 24]), [2]);
    assert_eq!(patched([11, 16]), [0]);
}

#[test]
fn a_patch_of_a_texture_is_seen() {
    let id = TextureId::default();
    let mut screen = Screen::new(64, 32, Color32::BLACK);
    let mut corners = Vec::new();
    for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
        let mut corner = vertex(64.0 * x, 32.0 * y, Color32::WHITE);
        corner.uv = pos2(x, y);
        corners.push(corner);
    }
    let shown = [mesh(corners, vec![0, 1, 2, 2, 1, 3])];
    screen.paint(&shown);
    let before = screen.pixels.clone();
    for color in [Color32::from_white_alpha(77), Color32::from_rgb(1, 2, 3)] {
        let image = egui::ColorImage::filled([3, 40], color);
        let mut delta = TexturesDelta::default();
        let at = [62, 1];
        let patch = egui::epaint::ImageDelta::partial(at, image, TextureOptions::LINEAR);
        delta.push(id, patch);
        screen.raster.update_textures(delta);
        assert_eq!(screen.paint(&shown).len(), 1);
        for y in 0..32 {
            for x in 0..64 {
                if x >= 62 && y >= 1 {
                    let [r, g, b, _] = color.to_array();
                    assert_eq!(screen.rgb(x, y), [r, g, b]);
                } else {
                    assert_eq!(screen.pixels[y * 64 + x], before[y * 64 + x]);
                }
            }
        }
    }
}
