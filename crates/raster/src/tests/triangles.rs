//! Triangles: which pixels are theirs.

use egui::epaint::{Primitive, Vertex};
use egui::{ClippedPrimitive, Color32, Rect, pos2};

use super::{Random, Screen, mesh, vertex};

/// A translucent area cut into triangles at random is painted once everywhere,
/// and nowhere else.
#[test]
fn no_pixel_is_missing_or_painted_twice_along_edges() {
    let mut random = Random(11);
    let color = Color32::from_rgba_premultiplied(40, 20, 10, 128);
    let mut whole = 0;
    'round: for round in 0..400 {
        let (across, down) = (1 + random.below(8), 1 + random.below(8));
        // Corners on eighths of a pixel, so that many edges meet middles.
        let steps = [2.0, 4.0, 8.0, 256.0][round % 4];
        let area = Rect::from_min_max(pos2(3.5, 4.0), pos2(130.5, 97.25));
        let mut vertices = Vec::new();
        for y in 0..=down {
            for x in 0..=across {
                let even = pos2(x as f32 / across as f32, y as f32 / down as f32);
                let mut at = area.min + area.size() * even.to_vec2();
                let free = 0.45;
                if x > 0 && x < across {
                    at.x += random.between(-free, free) * area.width() / across as f32;
                    at.x = (at.x * steps).round() / steps;
                }
                if y > 0 && y < down {
                    at.y += random.between(-free, free) * area.height() / down as f32;
                    at.y = (at.y * steps).round() / steps;
                }
                // The border stays straight.
                let at = pos2(
                    if x == 0 {
                        area.min.x
                    } else if x == across {
                        area.max.x
                    } else {
                        at.x
                    },
                    if y == 0 {
                        area.min.y
                    } else if y == down {
                        area.max.y
                    } else {
                        at.y
                    },
                );
                vertices.push(Vertex::untextured(at, color));
            }
        }
        let mut triangles = Vec::new();
        for y in 0..down {
            for x in 0..across {
                let a = (y * (across + 1) + x) as u32;
                let [b, c] = [a + 1, a + across as u32 + 1];
                let d = c + 1;
                // Along one diagonal or the other; both may be right.
                let cuts = [[[a, b, c], [b, d, c]], [[a, b, d], [a, d, c]]];
                let which = random.below(2);
                let right = |cut: &&[[u32; 3]; 2]| cut.iter().all(|&t| turn(&vertices, t) > 0.0);
                let cut = [&cuts[which], &cuts[1 - which]].into_iter().find(right);
                let Some(&[mut one, mut two]) = cut else {
                    continue 'round;
                };
                // Any direction, any corner first.
                one.rotate_left(random.below(3));
                two.rotate_left(random.below(3));
                if random.below(2) == 0 {
                    one.swap(0, 1);
                }
                triangles.extend([one, two]);
            }
        }
        whole += 1;
        for i in (1..triangles.len()).rev() {
            triangles.swap(i, random.below(i + 1));
        }
        let mut screen = Screen::new(140, 100, Color32::from_rgb(90, 90, 90));
        screen.paint(&[mesh(vertices, triangles.concat())]);
        let once = [
            90.0 * (127.0 / 255.0) + 40.0,
            90.0 * 127.0 / 255.0 + 20.0,
            90.0 * 127.0 / 255.0 + 10.0,
        ];
        for y in 0..100 {
            for x in 0..140 {
                // A middle on the left or upper border counts.
                let inside = (3..130).contains(&x) && (4..97).contains(&y);
                let found = screen.rgb(x, y);
                for (found, once) in found.into_iter().zip(once) {
                    let exact: f64 = if inside { once } else { 90.0 };
                    let off = (f64::from(found) - exact).abs();
                    assert!(off <= 1.1, "round {round} at {x}, {y}: {found} {exact}");
                }
            }
        }
    }
    assert!(whole > 200, "{whole}");
}

fn turn(vertices: &[Vertex], triangle: [u32; 3]) -> f32 {
    let [a, b, c] = triangle.map(|i| vertices[i as usize].pos);
    (b - a).x * (c - a).y - (c - a).x * (b - a).y
}

/// Each pixel held against the triangle in whole numbers.
#[test]
fn a_triangle_has_the_pixels_whose_middles_it_has() {
    let mut random = Random(12);
    for round in 0..500 {
        let reach = [70, 70, 3000][round % 3];
        let mut corner = || {
            let mut at = || random.below(8 * reach) as i64 - 4 * (reach as i64 - 70);
            [at(), at()]
        };
        let corners = [corner(), corner(), corner()];
        let vertices = corners.map(|[x, y]| vertex(x as f32 / 8.0, y as f32 / 8.0, Color32::WHITE));
        let mut screen = Screen::new(70, 70, Color32::BLACK);
        screen.paint(&[mesh(vertices.to_vec(), vec![0, 1, 2])]);
        for y in 0..70 {
            for x in 0..70 {
                let p = [8 * x as i64 + 4, 8 * y as i64 + 4];
                let side = |i: usize| {
                    let ([ax, ay], [bx, by]) = (corners[i], corners[(i + 1) % 3]);
                    (bx - ax) * (p[1] - ay) - (p[0] - ax) * (by - ay)
                };
                let sides = [side(0), side(1), side(2)];
                if sides.contains(&0) {
                    continue;
                }
                let inside = sides.iter().all(|&s| s > 0) || sides.iter().all(|&s| s < 0);
                assert_eq!(
                    screen.rgb(x, y) == [255; 3],
                    inside,
                    "{corners:?} at {x}, {y}"
                );
            }
        }
    }
}

/// The short way for upright rectangles gives what two triangles give.
#[test]
fn rectangles_are_two_triangles() {
    let mut random = Random(13);
    for round in 0..400 {
        let mut place = |scale: f32| {
            let at = random.between(-10.0, 90.0);
            let to = at + random.between(0.0, 60.0);
            let snap = |v: f32| (v * scale).round() / scale;
            (snap(at), snap(to))
        };
        let snap = [1.0, 2.0, 7.0, 256.0][round % 4];
        let ((x0, x1), (y0, y1)) = (place(snap), place(snap));
        let color = random.color();
        // One colour; letters at their own size; a picture at any size.
        let uv = match round % 3 {
            0 => [0.0; 4],
            1 => {
                let (u, v) = (random.below(20) as f32, random.below(10) as f32);
                [
                    u / 64.0,
                    v / 32.0,
                    (u + x1 - x0) / 64.0,
                    (v + y1 - y0) / 32.0,
                ]
            }
            _ => [0.1, 0.2, random.between(0.2, 1.5), random.between(0.2, 1.0)],
        };
        let corner = |x: f32, y: f32, u: f32, v: f32| {
            let mut vertex = vertex(x, y, color);
            vertex.uv = pos2(u, v);
            vertex
        };
        let corners = vec![
            corner(x0, y0, uv[0], uv[1]),
            corner(x1, y0, uv[2], uv[1]),
            corner(x0, y1, uv[0], uv[3]),
            corner(x1, y1, uv[2], uv[3]),
        ];
        let paint = |indices: Vec<u32>| {
            let mut screen = Screen::new(100, 100, Color32::from_rgb(10, 200, 90));
            screen.paint(&[mesh(corners.clone(), indices)]);
            screen
        };
        let short = paint(vec![0, 1, 2, 2, 1, 3]);
        // A triangle without area between the two hides what they are.
        let long = paint(vec![0, 1, 2, 0, 0, 0, 2, 1, 3]);
        for y in 0..100 {
            for x in 0..100 {
                for (a, b) in short.rgb(x, y).into_iter().zip(long.rgb(x, y)) {
                    assert!(a.abs_diff(b) <= 2, "round {round} at {x}, {y}: {a} {b}");
                }
            }
        }
    }
}

#[test]
fn the_clip_is_rounded_to_pixels() {
    let mut screen = Screen::new(20, 20, Color32::BLACK);
    screen.scale = 1.5;
    let corners = [(0.0, 0.0), (40.0, 0.0), (0.0, 40.0)];
    let white = corners.map(|(x, y)| vertex(x, y, Color32::WHITE));
    let ClippedPrimitive { primitive, .. } = mesh(white.to_vec(), vec![0, 1, 2]);
    assert!(matches!(primitive, Primitive::Mesh(_)));
    screen.paint(&[ClippedPrimitive {
        // 2.1 · 1.5 = 3.15 and 5 · 1.5 = 7.5
        clip_rect: Rect::from_min_max(pos2(2.1, 2.1), pos2(5.0, 5.0)),
        primitive,
    }]);
    for y in 0..20 {
        for x in 0..20 {
            let inside = (3..8).contains(&x) && (3..8).contains(&y);
            assert_eq!(screen.rgb(x, y), [if inside { 255 } else { 0 }; 3]);
        }
    }
}
