//! Colours over colours, held against the rule in numbers with fractions.

use egui::Color32;
use egui::epaint::textures::{TextureOptions, TextureWrapMode};

use egui::{ColorImage, TextureId, pos2};

use super::{Random, Screen, mesh, texture, vertex};
use crate::tile::{FULL, Ink};

/// `color`, premultiplied, taken by a weight of 0…1, over a pixel.
fn over(below: u32, color: Color32, weight: f64) -> [f64; 3] {
    let [_, below @ ..] = below.to_be_bytes().map(f64::from);
    let [r, g, b, a] = color.to_array().map(|c| f64::from(c) * weight);
    let mixed = |below: f64, c: f64| (below * (1.0 - a / 255.0) + c).min(255.0);
    [mixed(below[0], r), mixed(below[1], g), mixed(below[2], b)]
}

#[test]
fn ink_lies_over_pixels_as_egui_says() {
    let mut random = Random(3);
    for i in 0..200_000 {
        let below = random.bits() as u32 & 0x00FF_FFFF;
        let color = match i % 3 {
            // Light that is added, too.
            0 => Color32::from_rgba_premultiplied(
                random.below(256) as u8,
                random.below(256) as u8,
                random.below(256) as u8,
                random.below(256) as u8,
            ),
            _ => random.color(),
        };
        let weight = random.below(FULL as usize + 1) as u32;
        let mut pixel = [below];
        Ink::new(color).lay(&mut pixel, std::iter::once(weight));
        let [zero, found @ ..] = pixel[0].to_be_bytes();
        assert_eq!(zero, 0);
        let exact = over(below, color, f64::from(weight) / f64::from(FULL));
        for (found, exact) in found.into_iter().zip(exact) {
            let off = (f64::from(found) - exact).abs();
            let most = if color.a() == 255 { 0.5 } else { 1.1 };
            assert!(
                off <= most,
                "{below:06x} {color:?} {weight}: {found} {exact}"
            );
        }
        if weight == 0 {
            assert_eq!(pixel[0], below);
        }
    }
}

/// Colours between three corners.
#[test]
fn colours_run_evenly_from_corner_to_corner() {
    let mut random = Random(4);
    for round in 0..200 {
        let corners: [([f64; 2], Color32); 3] = std::array::from_fn(|i| {
            let at =
                [0.0; 2].map(|_: f32| f64::from((random.between(0.0, 60.0) * 8.0).round() / 8.0));
            let color = match round % 2 {
                0 => random.color(),
                _ if i == 0 => Color32::TRANSPARENT,
                _ => Color32::from_rgba_premultiplied(100, 20, 200, 220),
            };
            (at, color)
        });
        let below = 0x0020_8060;
        let mut screen = Screen::new(60, 60, Color32::from_rgb(0x20, 0x80, 0x60));
        let vertices = corners.map(|([x, y], color)| vertex(x as f32, y as f32, color));
        screen.paint(&[mesh(vertices.to_vec(), vec![0, 1, 2])]);
        let [a, b, c] = corners.map(|(at, _)| at);
        let twice = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
            (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])
        };
        let area = twice(a, b, c);
        for y in 0..60 {
            for x in 0..60 {
                let p = [x as f64 + 0.5, y as f64 + 0.5];
                let shares = [twice(p, b, c), twice(a, p, c), twice(a, b, p)].map(|v| v / area);
                if area == 0.0 || shares.iter().any(|&share| share < 1e-9) {
                    continue;
                }
                let channel = |i: usize| -> f64 {
                    let value = |k: usize| f64::from(corners[k].1.to_array()[i]);
                    (0..3).map(|k| shares[k] * value(k)).sum()
                };
                let alpha = channel(3) / 255.0;
                let [_, ground @ ..] = u32::to_be_bytes(below).map(f64::from);
                for (i, found) in screen.rgb(x, y).into_iter().enumerate() {
                    let exact = ground[i] * (1.0 - alpha) + channel(i);
                    let off = (f64::from(found) - exact).abs();
                    assert!(off <= 1.6, "{corners:?} at {x}, {y}: {found} {exact}");
                }
            }
        }
    }
}

/// A picture on a turned and stretched rectangle, or wrapped round.
#[test]
fn pictures_are_mixed_between_texels() {
    let mut random = Random(5);
    let size = [7, 5];
    for wrap_mode in [
        TextureWrapMode::ClampToEdge,
        TextureWrapMode::Repeat,
        TextureWrapMode::MirroredRepeat,
    ] {
        let pixels: Vec<Color32> = (0..35).map(|_| random.color()).collect();
        let id = TextureId::User(3);
        let options = TextureOptions {
            wrap_mode,
            ..TextureOptions::LINEAR
        };
        let mut screen = Screen::new(64, 64, Color32::BLACK);
        let image = ColorImage::new(size, pixels.clone());
        screen.raster.update_textures(texture(id, image, options));
        // Once upright, once turned: u and v by x and y.
        for turn in [0.0_f32, 0.4] {
            let corner = |x: f32, y: f32| {
                let mut vertex = vertex(x, y, Color32::WHITE);
                let (x, y) = ((x - 20.0) / 21.0, (y - 12.0) / 25.0);
                vertex.uv = pos2(x + turn * y, y - turn * x);
                vertex
            };
            let corners = vec![
                corner(0.0, 0.0),
                corner(64.0, 0.0),
                corner(0.0, 64.0),
                corner(64.0, 64.0),
            ];
            let mut shown = mesh(corners, vec![0, 1, 2, 2, 1, 3]);
            if let egui::epaint::Primitive::Mesh(mesh) = &mut shown.primitive {
                mesh.texture_id = id;
            }
            screen.paint(&[shown]);
            for y in 0..64 {
                for x in 0..64 {
                    let turn = f64::from(turn);
                    let (s, t) = ((x as f64 - 19.5) / 21.0, (y as f64 - 11.5) / 25.0);
                    let (u, v) = ((s + turn * t) * 7.0 - 0.5, (t - turn * s) * 5.0 - 0.5);
                    let texel = |x: i64, y: i64, i: usize| {
                        let at = |v: i64, n: i64| match wrap_mode {
                            TextureWrapMode::ClampToEdge => v.clamp(0, n - 1),
                            TextureWrapMode::Repeat => v.rem_euclid(n),
                            TextureWrapMode::MirroredRepeat => {
                                let v = v.rem_euclid(2 * n);
                                v.min(2 * n - 1 - v)
                            }
                        };
                        f64::from(pixels[(at(y, 5) * 7 + at(x, 7)) as usize].to_array()[i])
                    };
                    let (u0, v0) = (u.floor() as i64, v.floor() as i64);
                    let (fu, fv) = (u - u.floor(), v - v.floor());
                    for (i, found) in screen.rgb(x, y).into_iter().enumerate() {
                        let row = |v: i64| texel(u0, v, i) * (1.0 - fu) + texel(u0 + 1, v, i) * fu;
                        let exact = row(v0) * (1.0 - fv) + row(v0 + 1) * fv;
                        let off = (f64::from(found) - exact).abs();
                        assert!(
                            off <= 0.6,
                            "{wrap_mode:?} {turn} at {x}, {y}: {found} {exact}"
                        );
                    }
                }
            }
        }
    }
}
