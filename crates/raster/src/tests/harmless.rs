//! Whatever comes: no panic, no endless work, no pixel outside.

use std::sync::Arc;

use egui::epaint::textures::{TextureOptions, TextureWrapMode};
use egui::epaint::{PaintCallback, Primitive};
use egui::{ClippedPrimitive, Color32, ColorImage, Pos2, Rect, TextureId, pos2, vec2};

use super::lines::primitive;
use super::rounded_rects;
use super::{Random, Screen, everywhere, mesh, texture, vertex};
use crate::rounded_rect::RoundedRect;
use crate::{Line, Lines, Target};

const ODD: [f32; 16] = [
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::MAX,
    f32::MIN,
    f32::MIN_POSITIVE,
    -0.0,
    0.5,
    1e10,
    -1e10,
    2_147_483_648.0,
    -2_147_483_904.0,
    8_388_608.0,
    1e-30,
    30.0,
    63.999_996,
];

fn odd(random: &mut Random) -> f32 {
    match random.below(3) {
        0 => random.between(-100.0, 200.0),
        1 => f32::from_bits(random.bits() as u32),
        _ => ODD[random.below(ODD.len())],
    }
}

fn odd_place(random: &mut Random) -> Pos2 {
    pos2(odd(random), odd(random))
}

#[test]
fn odd_numbers_do_no_harm() {
    let mut random = Random(31);
    let mut screen = Screen::new(150, 100, Color32::BLACK);
    for (user, wrap_mode) in [TextureWrapMode::Repeat, TextureWrapMode::MirroredRepeat]
        .into_iter()
        .enumerate()
    {
        let options = TextureOptions {
            wrap_mode,
            ..TextureOptions::LINEAR
        };
        let image = ColorImage::filled([3, 2], Color32::RED);
        let id = TextureId::User(user as u64);
        screen.raster.update_textures(texture(id, image, options));
    }
    for _ in 0..3000 {
        let mut things = Vec::new();
        let lines = (0..20).map(|_| Line {
            from: odd_place(&mut random),
            to: odd_place(&mut random),
            width: odd(&mut random),
            color: random.color(),
        });
        things.push(primitive(&Arc::new(Lines {
            lines: lines.collect(),
        })));
        things.push(rounded_rects::primitive(RoundedRect {
            rect: Rect::from_min_max(odd_place(&mut random), odd_place(&mut random)),
            radii: [(); 4].map(|()| odd(&mut random)),
            fill: random.color(),
            border: odd(&mut random),
            border_color: random.color(),
        }));
        let vertices = (0..20).map(|_| {
            let at = odd_place(&mut random);
            let mut vertex = vertex(at.x, at.y, random.color());
            vertex.uv = odd_place(&mut random);
            vertex
        });
        let vertices = vertices.collect();
        // Some of no vertex, and one too many for whole triangles.
        let indices = (0..61).map(|_| random.below(21) as u32).collect();
        let mut shown = mesh(vertices, indices);
        shown.clip_rect = match random.below(2) {
            0 => Rect::EVERYTHING,
            _ => Rect::from_min_max(odd_place(&mut random), odd_place(&mut random)),
        };
        if let Primitive::Mesh(mesh) = &mut shown.primitive {
            let user = random.below(4) as u64;
            if user < 3 {
                mesh.texture_id = TextureId::User(user);
            }
        }
        things.push(shown);
        screen.paint(&things);
    }
    screen.scale = f32::NAN;
    screen.paint(&[mesh(vec![vertex(0.0, 0.0, Color32::RED); 3], vec![0, 1, 2])]);
    assert!(screen.pixels.iter().all(|pixel| pixel >> 24 == 0));
}

fn odd_things() -> Vec<ClippedPrimitive> {
    let corners = [(0.0, 0.0), (9000.0, 0.0), (0.0, 9000.0)];
    let corners = corners.map(|(x, y)| vertex(x, y, Color32::from_rgb(9, 8, 7)));
    let line = Line {
        from: pos2(-5.0, -5.0),
        to: pos2(9000.0, 9000.0),
        width: 3.0,
        color: Color32::WHITE,
    };
    let foreign = PaintCallback {
        rect: Rect::EVERYTHING,
        callback: Arc::new(5),
    };
    vec![
        mesh(corners.to_vec(), vec![0, 1, 2]),
        everywhere(Primitive::Callback(foreign)),
        primitive(&Arc::new(Lines { lines: vec![line] })),
    ]
}

#[test]
fn any_size_and_any_stride() {
    for (width, height) in [
        (1, 1),
        (1, 300),
        (300, 1),
        (63, 65),
        (64, 64),
        (8000, 3),
        (3, 8000),
        (0, 0),
        (0, 5),
        (5, 0),
    ] {
        for beside in [0_usize, 1, 13] {
            let stride = width as usize + beside;
            let mut pixels = vec![0xFF12_3456; stride * height as usize];
            let mut screen = Screen::new(0, 0, Color32::BLACK);
            let mut target = Target {
                pixels: &mut pixels,
                stride,
                width,
                height,
            };
            let areas = screen.raster.paint(&odd_things(), 1.0, &mut target);
            let area: u32 = areas.iter().map(|a| a.width * a.height).sum();
            assert_eq!(area, width * height);
            for (i, pixel) in pixels.iter().enumerate() {
                let inside = i % stride < width as usize;
                assert_eq!(*pixel != 0xFF12_3456, inside, "{width} {height} {i}");
            }
        }
    }
}

/// A target with less memory than it says is left alone.
#[test]
fn a_target_that_is_too_small() {
    let mut pixels = [5; 100];
    let mut screen = Screen::new(0, 0, Color32::BLACK);
    for (stride, width, height) in [
        (10, 11, 9),
        (10, 10, 11),
        (usize::MAX, 10, 10),
        (10, 10, u32::MAX),
    ] {
        let mut target = Target {
            pixels: &mut pixels,
            stride,
            width,
            height,
        };
        assert_eq!(screen.raster.paint(&odd_things(), 1.0, &mut target), []);
    }
    assert_eq!(pixels, [5; 100]);
}

#[test]
fn textures_of_odd_sizes() {
    let mut screen = Screen::new(50, 50, Color32::BLACK);
    let id = TextureId::User(1);
    let empty = ColorImage {
        size: [0, 7],
        source_size: vec2(0.0, 7.0),
        pixels: Vec::new(),
    };
    let wrong = ColorImage {
        size: [usize::MAX, 2],
        source_size: vec2(1.0, 1.0),
        pixels: vec![Color32::RED],
    };
    for image in [empty, wrong] {
        screen
            .raster
            .update_textures(texture(id, image, TextureOptions::LINEAR));
        let corners = [(0.0, 0.0), (50.0, 0.0), (0.0, 50.0)];
        let corners = corners.map(|(x, y)| vertex(x, y, Color32::RED));
        let mut shown = mesh(corners.to_vec(), vec![0, 1, 2]);
        if let Primitive::Mesh(mesh) = &mut shown.primitive {
            mesh.texture_id = id;
        }
        screen.paint(&[shown]);
        assert_eq!(screen.rgb(3, 3), [0; 3]);
    }
}
