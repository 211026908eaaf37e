//! Surfaces: each pixel shows the nearest triangle at its middle, found by barycentric coordinates.

use std::sync::Arc;

use egui::epaint::Primitive;
use egui::{ClippedPrimitive, Color32, Rect, Shape};

use super::{Random, Screen, everywhere};
use crate::{Area, Corner3, Surfaces};

const SIDE: u32 = 80;
const AREA: Area = Area {
    x: 5,
    y: 9,
    width: 61,
    height: 53,
};

fn primitive(surfaces: &Arc<Surfaces>) -> ClippedPrimitive {
    let Shape::Callback(callback) = Surfaces::shape(surfaces, Rect::EVERYTHING) else {
        unreachable!("surfaces are a callback");
    };
    everywhere(Primitive::Callback(callback))
}

/// How near a triangle is at a place, if it is there; `Err` within a hair of its border.
fn nearness(corners: &[Corner3; 3], x: f64, y: f64) -> Result<Option<f64>, ()> {
    let [a, b, c] = corners;
    let area = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1])
    };
    let [pa, pb, pc] = [a, b, c].map(|p| [p[0], p[1]]);
    let at = [x, y];
    let whole = area(pa, pb, pc);
    let shares = [area(at, pb, pc), area(pa, at, pc), area(pa, pb, at)].map(|part| part / whole);
    let least = shares.into_iter().fold(f64::INFINITY, f64::min);
    if least.abs() < 1e-6 {
        return Err(());
    }
    let near = shares[0] * a[2] + shares[1] * b[2] + shares[2] * c[2];
    Ok((least > 0.0).then_some(near))
}

fn some_triangles(random: &mut Random, count: usize) -> Vec<([Corner3; 3], Color32)> {
    let far = |random: &mut Random| match random.below(8) {
        0 => 5e4,
        _ => 60.0,
    };
    let number = |random: &mut Random| {
        let reach = far(random);
        f64::from(random.between(-reach, reach + 70.0))
    };
    (0..count)
        .map(|at| {
            let corners = [(); 3].map(|()| {
                let place = [number(random), number(random)];
                [place[0], place[1], f64::from(random.between(-9.0, 9.0))]
            });
            (corners, Color32::from_rgb(at as u8, 200 - at as u8, 77))
        })
        .collect()
}

#[test]
fn each_pixel_shows_the_nearest_triangle() {
    let mut random = Random(5);
    let mut compared = 0;
    for round in 0..40 {
        let triangles = some_triangles(&mut random, 1 + round % 12);
        let mut surfaces = Surfaces::new(AREA, false).unwrap();
        for &(corners, color) in &triangles {
            surfaces.triangle(corners, color);
        }
        surfaces.settle().unwrap();
        let surfaces = Arc::new(surfaces);
        let mut screen = Screen::new(SIDE, SIDE, Color32::BLACK);
        screen.paint(&[primitive(&surfaces)]);
        for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
            let inside = (AREA.x..AREA.x + AREA.width).contains(&x)
                && (AREA.y..AREA.y + AREA.height).contains(&y);
            let middle = [x, y].map(|at| f64::from(at) + 0.5);
            let found: Result<Vec<_>, ()> = triangles
                .iter()
                .map(|(corners, color)| {
                    Ok(nearness(corners, middle[0], middle[1])?.map(|near| (near, *color)))
                })
                .collect();
            let Ok(found) = found else { continue };
            let mut found: Vec<_> = found.into_iter().flatten().filter(|_| inside).collect();
            found.sort_by(|a, b| b.0.total_cmp(&a.0));
            if let [first, second, ..] = found[..]
                && first.0 - second.0 < 1e-3
            {
                continue;
            }
            let shown = found.first().map_or(Color32::BLACK, |&(_, color)| color);
            let [r, g, b, _] = shown.to_array();
            assert_eq!(
                screen.rgb(x as usize, y as usize),
                [r, g, b],
                "{round}: {x} {y}"
            );
            compared += 1;
            // Who stands before it is seen; behind it and all beside, hidden.
            if let Some(&(near, _)) = found.first() {
                assert!(!surfaces.hides([middle[0], middle[1], near + 0.01]));
            }
        }
    }
    assert!(compared > 200_000, "{compared}");
}

/// Two triangles of a square share a side: no pixel is left out, whatever its place.
#[test]
fn there_is_no_gap_between_neighbours() {
    let mut random = Random(6);
    for _ in 0..200 {
        let [a, b] = [(); 2].map(|()| [(); 2].map(|()| f64::from(random.between(-90.0, 160.0))));
        let corner = |[x, y]: [f64; 2]| [x, y, 0.0];
        let outer = [
            [-400.0, -400.0],
            [500.0, -400.0],
            [500.0, 500.0],
            [-400.0, 500.0],
        ]
        .map(corner);
        let mut surfaces = Surfaces::new(AREA, false).unwrap();
        // A fan round a line within a large square.
        let [a, b] = [a, b].map(corner);
        let mut fan = vec![[a, b, outer[0]], [a, b, outer[2]]];
        for at in 0..4 {
            let side = [outer[at], outer[(at + 1) % 4]];
            fan.extend([a, b].map(|tip| [tip, side[0], side[1]]));
        }
        for corners in fan {
            surfaces.triangle(corners, Color32::WHITE);
        }
        let surfaces = Arc::new(surfaces);
        let mut screen = Screen::new(SIDE, SIDE, Color32::BLACK);
        screen.paint(&[primitive(&surfaces)]);
        for y in AREA.y..AREA.y + AREA.height {
            for x in AREA.x..AREA.x + AREA.width {
                assert_eq!(screen.rgb(x as usize, y as usize), [255; 3], "{x} {y}");
            }
        }
    }
}

#[test]
fn outlines_are_smooth_where_that_was_asked() {
    // The lower left half of a square: its long side cuts through pixels.
    let corners = [[10.0, 10.0, 0.0], [10.0, 60.0, 0.0], [60.0, 60.0, 0.0]];
    let mut surfaces = Surfaces::new(AREA, true).unwrap();
    surfaces.triangle(corners, Color32::WHITE);
    surfaces.settle().unwrap();
    let mut screen = Screen::new(SIDE, SIDE, Color32::BLACK);
    screen.paint(&[primitive(&Arc::new(surfaces))]);
    for at in 12..58 {
        let [r, ..] = screen.rgb(at, at);
        assert!((60..200).contains(&r), "{at}: {r}");
        assert_eq!(screen.rgb(at - 2, at), [255; 3]);
        assert_eq!(screen.rgb(at + 2, at), [0; 3]);
    }
}

/// The same picture again paints nothing; another one only where it differs.
#[test]
fn only_what_changed_is_painted() {
    let made = |far: f64| {
        let mut surfaces = Surfaces::new(AREA, false).unwrap();
        surfaces.triangle(
            [[6.0, 10.0, 0.0], [6.0, 20.0, 0.0], [16.0, 20.0, 0.0]],
            Color32::RED,
        );
        surfaces.triangle(
            [[50.0, 40.0, 0.0], [50.0, far, 0.0], [60.0, far, 0.0]],
            Color32::BLUE,
        );
        surfaces.settle().unwrap();
        Arc::new(surfaces)
    };
    let mut screen = Screen::new(SIDE, SIDE, Color32::BLACK);
    assert!(!screen.paint(&[primitive(&made(50.0))]).is_empty());
    assert_eq!(screen.paint(&[primitive(&made(50.0))]), []);
    let areas = screen.paint(&[primitive(&made(55.0))]);
    assert!(
        !areas.is_empty() && areas.iter().all(|area| area.x >= 32),
        "{areas:?}"
    );
    // Gone, all of it goes.
    screen.paint(&[]);
    assert!(screen.pixels.iter().all(|&pixel| pixel == 0));
}

#[test]
fn what_is_no_number_or_has_no_area_does_no_harm() {
    let odd = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        1e300,
        -1e300,
        0.0,
        30.0,
    ];
    let mut random = Random(9);
    let mut surfaces = Surfaces::new(AREA, true).unwrap();
    for _ in 0..20_000 {
        let corners = [(); 3].map(|()| [(); 3].map(|()| odd[random.below(odd.len())]));
        surfaces.triangle(corners, Color32::WHITE);
        let _ = surfaces.hides(corners[0]);
    }
    let nowhere = [[1.0, 1.0], [30.0, 2.0], [5.0, 30.0]].map(|[x, y]| [x, y, f64::NAN]);
    surfaces.triangle(nowhere, Color32::WHITE);
    surfaces.settle().unwrap();
    let nothing = Surfaces::new(Area::default(), true).unwrap();
    let mut screen = Screen::new(SIDE, SIDE, Color32::BLACK);
    screen.paint(&[
        primitive(&Arc::new(surfaces)),
        primitive(&Arc::new(nothing)),
    ]);
}

/// Beyond the rim of what is seen, faces go on.
#[test]
fn a_face_hides_what_is_behind_it_up_to_the_rim() {
    let area = Area {
        width: 4,
        height: 3,
        ..Area::default()
    };
    let mut surfaces = Surfaces::new(area, false).unwrap();
    let corners = [[-9.0, -9.0, 5.0], [40.0, -9.0, 5.0], [-9.0, 40.0, 5.0]];
    surfaces.triangle(corners, Color32::WHITE);
    surfaces.settle().unwrap();
    for (x, y) in (0..4).flat_map(|x| (0..3).map(move |y| (x, y))) {
        let [x, y] = [x, y].map(|at| f64::from(at) + 0.5);
        assert!(surfaces.hides([x, y, 4.0]) && !surfaces.hides([x, y, 6.0]));
    }
    assert!(!surfaces.hides([4.5, 1.0, 4.0]) && !surfaces.hides([-0.5, 1.0, 4.0]));
}
