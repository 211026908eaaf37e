use std::f64::consts::TAU;

use super::round::round;
use super::seen::LEAST;
use super::*;
use crate::path::test_support::Random;
use crate::path::{CameraPath, Pose, Sampler, Target, Up};
use crate::tools::check::{CheckContext, check};

/// A grid of u × v places made a surface; either way round.
fn surface(u: usize, v: usize, at: impl Fn(f64, f64) -> DVec3, turned: bool) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..=u {
        for j in 0..=v {
            mesh.points
                .push(at(i as f64 / u as f64, j as f64 / v as f64));
        }
    }
    for i in 0..u as u32 {
        for j in 0..v as u32 {
            let w = v as u32 + 1;
            let [a, b, c, d] = [
                i * w + j,
                (i + 1) * w + j,
                (i + 1) * w + j + 1,
                i * w + j + 1,
            ];
            let both = if turned {
                [[b, a, c], [a, d, c]]
            } else {
                [[a, b, c], [a, c, d]]
            };
            mesh.triangles.extend(both);
        }
    }
    mesh
}

fn torus(turned: bool) -> Mesh {
    let ring = |a: f64, b: f64| {
        let (out, high) = (3.0 + (TAU * b).cos(), (TAU * b).sin());
        DVec3::new(out * (TAU * a).cos(), high, out * (TAU * a).sin())
    };
    surface(40, 16, ring, turned)
}

/// The faces of a box, each of n × n squares.
fn cube(n: usize) -> Mesh {
    let mut all = Mesh::default();
    for side in 0..6 {
        let face = |a: f64, b: f64| {
            let mut p = [0.0; 3];
            let axis = side % 3;
            p[axis] = if side < 3 { 1.0 } else { -1.0 };
            (p[(axis + 1) % 3], p[(axis + 2) % 3]) = (2.0 * a - 1.0, 2.0 * b - 1.0);
            DVec3::from_array(p)
        };
        let made = surface(n, n, face, side >= 3);
        let first = all.points.len() as u32;
        all.points.extend(made.points);
        all.triangles
            .extend(made.triangles.iter().map(|t| t.map(|at| first + at)));
    }
    all
}

fn made(mesh: &Mesh, request: &TourRequest) -> Result<Tour> {
    tour(mesh, request, &mut |done, all| {
        assert!(done <= all);
        true
    })
}

/// What a check with the limits of the request finds.
fn found(mesh: &Mesh, tour: &Tour, request: &TourRequest) -> Vec<String> {
    let object = Clearance::new(mesh).unwrap();
    let against = CheckContext {
        fps: request.fps,
        space: Some(tour.path.space.into()),
        object: Some(&object),
        limits: request.limits,
    };
    let found = check(&tour.path, &against).unwrap();
    found.iter().map(ToString::to_string).collect()
}

/// The share of the surface whose middles rays reach from the points of a path.
fn reached(mesh: &Mesh, path: &CameraPath) -> f64 {
    let object = Clearance::new(mesh).unwrap();
    let (mut seen, mut all) = (0.0, 0.0);
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|at| mesh.points[at as usize]);
        let (middle, normal) = ((a + b + c) / 3.0, (b - a).cross(c - a));
        let met = path.points.iter().any(|point| {
            let way = middle - point.position;
            let Target::Absolute(target) = point.orientations[0].target else {
                return false;
            };
            let camera = Camera::new(point.position, target, path.space.up, ZOOM).unwrap();
            let clear = object.ahead(point.position, way.normalize(), 0.0);
            camera.holds(middle)
                && normal.normalize().dot(-way.normalize()).abs() > LEAST
                && clear.is_some_and(|far| far > way.length() * (1.0 - 1e-6))
        });
        all += normal.length();
        seen += if met { normal.length() } else { 0.0 };
    }
    seen / all
}

#[test]
fn a_ring_is_shown_by_a_clean_flight() {
    let request = TourRequest::default();
    for turned in [false, true] {
        let mesh = torus(turned);
        let tour = made(&mesh, &request).unwrap();
        println!("{tour}");
        assert!(tour.coverage >= 0.95 && tour.seconds == 60.0);
        assert_eq!(found(&mesh, &tour, &request), [""; 0]);
        let reached = reached(&mesh, &tour.path);
        // Points between the places show something, too.
        assert!(reached > tour.surface - 0.01, "{reached} {}", tour.surface);
        let all = tour.surface + tour.left_out + tour.narrow + tour.hidden;
        assert!((all - 1.0).abs() < 1e-9, "{all}");
        let again = made(&mesh, &request).unwrap();
        assert_eq!(tour.path, again.path);
    }
}

/// Whole frames make no place slower that anybody would see.
#[test]
fn a_tour_is_even_whatever_time_it_takes() {
    let mesh = torus(false);
    for seconds in [28.0, 28.1, 28.2, 30.0, 31.7, 44.1, 57.0] {
        let request = TourRequest {
            seconds,
            ..TourRequest::default()
        };
        let path = made(&mesh, &request).unwrap().path;
        let timeline = Timeline::new(&path).unwrap();
        let sampler = Sampler::new(&path, &timeline).unwrap();
        let mut poses = vec![Pose::default(); timeline.frame_count().unwrap()];
        sampler.sample(1, &mut poses).unwrap();
        let steps = poses.windows(2);
        let steps: Vec<f64> = steps
            .map(|pair| DVec3::from_array(pair[0].vrp).distance(pair[1].vrp.into()))
            .collect();
        let mean = steps.iter().sum::<f64>() / steps.len() as f64;
        let least = steps[3..steps.len() - 3]
            .iter()
            .copied()
            .fold(f64::INFINITY, f64::min);
        assert!(least > 0.9 * mean, "{seconds} s: {}", least / mean);
    }
}

#[test]
fn stills_are_a_frame_for_each_view() {
    let request = TourRequest {
        stills: true,
        coverage: 1.0,
        ..TourRequest::default()
    };
    let tour = made(&torus(false), &request).unwrap();
    let sampler = Sampler::new(&tour.path, &Timeline::new(&tour.path).unwrap()).unwrap();
    assert_eq!(sampler.frame_count(), tour.path.points.len());
    assert_eq!(tour.places, tour.path.points.len());
    for (k, point) in tour.path.points.iter().enumerate() {
        let pose = sampler.pose(k as f64 + 1.0).unwrap();
        assert!((DVec3::from(pose.vrp) - point.position).length() < 1e-9);
        let view = point.orientations[0].view(point.position);
        assert!(DVec3::from(pose.vpn).distance(view) < 1e-9);
    }
}

#[test]
fn a_tour_begins_where_it_shall_and_takes_what_stands_upright() {
    let mesh = torus(false);
    let start = DVec3::new(9.0, 2.0, 1.0);
    for up in [Up::Y, Up::Z] {
        let request = TourRequest {
            start: Some(start),
            seconds: 45.0,
            up,
            ..TourRequest::default()
        };
        let tour = made(&mesh, &request).unwrap();
        assert!(!tour.path.closed && tour.path.points[0].position == start);
        assert!(tour.path.space.up == up && tour.seconds == 45.0);
        assert_eq!(found(&mesh, &tour, &request), [""; 0]);
    }
    let within = TourRequest {
        start: Some(DVec3::X * 3.0),
        ..TourRequest::default()
    };
    let beside = TourRequest {
        start: Some(DVec3::X * 2.0),
        ..TourRequest::default()
    };
    for request in [within, beside] {
        let refused = made(&mesh, &request).unwrap_err();
        assert_eq!(refused, Error::Argument(Invalid::TourStart));
    }
}

#[test]
fn a_room_is_shown_from_within() {
    let mesh = cube(6);
    let request = TourRequest {
        inside: true,
        ..TourRequest::default()
    };
    let tour = made(&mesh, &request).unwrap();
    println!("{tour}");
    assert!(tour.coverage >= 0.95 && tour.surface > 0.94);
    for point in &tour.path.points {
        assert!(point.position.abs().max_element() < 1.0);
    }
    assert_eq!(found(&mesh, &tour, &request), [""; 0]);
    // A sheet has no inside.
    let sheet = surface(4, 4, |a, b| DVec3::new(a, 0.1 * a * b, b), false);
    assert_eq!(
        made(&sheet, &request).unwrap_err(),
        Error::Argument(Invalid::NoRoomInside)
    );
}

#[test]
fn small_and_odd_objects_have_tours() {
    let one = Mesh {
        points: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let sheet = surface(5, 5, |a, b| DVec3::new(a, 0.0, b), false);
    let mut odd = torus(false);
    // A triangle without area, a point that is nobody's, far away.
    odd.triangles.push([3, 3, 4]);
    odd.points.push(DVec3::splat(1e6));
    for mesh in [one, sheet, odd] {
        let request = TourRequest::default();
        let tour = made(&mesh, &request).unwrap();
        assert!(tour.coverage >= 0.95 && tour.places >= 1, "{tour}");
        assert_eq!(found(&mesh, &tour, &request), [""; 0]);
    }
}

#[test]
fn what_will_not_do_is_refused() {
    let mesh = torus(false);
    let usual = TourRequest::default();
    for (request, cause) in [
        (
            TourRequest {
                seconds: 0.0,
                ..usual
            },
            Error::from(Invalid::PaceTime),
        ),
        (
            TourRequest {
                seconds: f64::NAN,
                ..usual
            },
            Invalid::PaceTime.into(),
        ),
        (
            TourRequest {
                coverage: 0.0,
                ..usual
            },
            OutOfRange::Coverage.into(),
        ),
        (
            TourRequest {
                coverage: f64::NAN,
                ..usual
            },
            OutOfRange::Coverage.into(),
        ),
        (
            TourRequest {
                coverage: 1.1,
                ..usual
            },
            OutOfRange::Coverage.into(),
        ),
        (
            TourRequest {
                distance: -1.0,
                ..usual
            },
            OutOfRange::TourDistance.into(),
        ),
        (
            TourRequest {
                distance: 1e300,
                ..usual
            },
            OutOfRange::TourDistance.into(),
        ),
        (
            TourRequest {
                start: Some(DVec3::NAN),
                ..usual
            },
            Invalid::TourStart.into(),
        ),
    ] {
        assert_eq!(made(&mesh, &request).unwrap_err(), cause);
    }
    let short = made(
        &mesh,
        &TourRequest {
            seconds: 0.5,
            ..usual
        },
    )
    .unwrap_err();
    assert!(matches!(short, Error::Argument(Invalid::PaceSeconds { least, .. }) if least > 0.5));
    // While it looks, and while the pace is computed.
    for stops in [|done, _| done < 20, |done, all| done < all] {
        let stopped = tour(&mesh, &usual, &mut { stops }).unwrap_err();
        assert_eq!(stopped, Error::Argument(Invalid::Cancelled));
    }
    let mut wrong = mesh.clone();
    wrong.points[0] = DVec3::NAN;
    assert!(made(&wrong, &usual).is_err());
    wrong.points[0] = DVec3::splat(1e300);
    assert!(made(&wrong, &usual).is_err());
    let none = Mesh {
        triangles: Vec::new(),
        ..mesh.clone()
    };
    let flat = Mesh {
        points: vec![DVec3::X; 3],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    for mesh in [none, flat] {
        let refused = made(&mesh, &usual).unwrap_err();
        assert_eq!(refused, Error::Argument(Invalid::NoSurface));
    }
}

/// Sets of a small number of things: against all choices there are.
#[test]
fn few_pictures_are_taken() {
    let mut random = Random(5);
    for _ in 0..200 {
        let areas: Vec<f64> = (0..70).map(|_| random.unit()).collect();
        let sets: Vec<Set> = (0..10)
            .map(|_| {
                let mut set = vec![0; 2];
                (0..70)
                    .filter(|_| random.unit() < 0.4)
                    .for_each(|at: usize| {
                        set[at / 64] |= 1 << (at % 64);
                    });
                set
            })
            .collect();
        let area = |which: &[usize]| -> f64 {
            let has = |at: usize| {
                which
                    .iter()
                    .any(|k| sets[*k][at / 64] >> (at % 64) & 1 == 1)
            };
            (0..70).filter(|at| has(*at)).map(|at| areas[at]).sum()
        };
        let all: Vec<usize> = (0..10).collect();
        let wanted = 0.9 * area(&all);
        let taken = fewest(&sets, &areas, wanted).unwrap();
        assert!(area(&taken) >= wanted * (1.0 - 1e-9));
        let best = (1_usize..1 << 10)
            .map(|bits| -> Vec<usize> { (0..10).filter(|k| bits >> k & 1 == 1).collect() })
            .filter(|which| area(which) >= wanted)
            .map(|which| which.len())
            .min();
        assert!(taken.len() <= best.unwrap() + 1, "{taken:?} {best:?}");
        // None of them is needless.
        for k in 0..taken.len() {
            let mut others = taken.clone();
            others.remove(k);
            assert!(area(&others) < wanted);
        }
    }
}

/// Rounds through eight places: against all orders.
#[test]
fn rounds_are_short() {
    fn orders(left: &mut Vec<usize>, order: &mut Vec<usize>, see: &mut dyn FnMut(&[usize])) {
        if left.is_empty() {
            see(order);
        }
        for k in 0..left.len() {
            order.push(left.swap_remove(k));
            orders(left, order, see);
            let at = order.pop().unwrap();
            left.push(at);
            let last = left.len() - 1;
            left.swap(k, last);
        }
    }
    let mut random = Random(9);
    let mut missed = 0;
    for closed in [true, false].into_iter().cycle().take(40) {
        let mut vector = || DVec3::from_array(std::array::from_fn(|_| random.unit()));
        let places: Vec<DVec3> = (0..8).map(|_| vector()).collect();
        let far: Vec<Vec<f64>> = places
            .iter()
            .map(|a| places.iter().map(|b| a.distance(*b)).collect())
            .collect();
        let length = |order: &[usize]| -> f64 {
            let legs = order.windows(2).map(|leg| far[leg[0]][leg[1]]);
            legs.sum::<f64>() + if closed { far[order[7]][order[0]] } else { 0.0 }
        };
        let mut best = f64::INFINITY;
        orders(&mut (1..8).collect(), &mut vec![0], &mut |order| {
            best = best.min(length(order));
        });
        let order = round(&far, closed).unwrap();
        let mut all = order.clone();
        all.sort_unstable();
        assert_eq!(all, (0..8).collect::<Vec<_>>());
        assert!(order[0] == 0 && length(&order) < 1.1 * best);
        missed += u32::from(length(&order) > best * (1.0 + 1e-9));
    }
    assert!(missed <= 6, "{missed} of 40");
}

/// A heap of triangles, against a ray to the middle of each.
#[test]
fn pictures_show_what_rays_reach() {
    let mut random = Random(3);
    let mut mesh = Mesh::default();
    for k in 0..600 {
        let mut vector =
            |by: f64| DVec3::from_array(std::array::from_fn(|_| by * (2.0 * random.unit() - 1.0)));
        let at = vector(1.0);
        mesh.points.extend([(); 3].map(|()| at + vector(0.15)));
        mesh.triangles.push([3 * k, 3 * k + 1, 3 * k + 2]);
    }
    let object = Clearance::new(&mesh).unwrap();
    let mut surface = Surface::new(&mesh, false).unwrap();
    assert!(!surface.one_sided);
    surface.distance = 3.0;
    let mut picture = Picture::new(&surface).unwrap();
    let (mut reached, mut shown, mut wrong) = (0.0, 0.0, 0.0);
    for eye in directions(24) {
        // From outside, and from among them: triangles reach behind the camera.
        for eye in [3.0 * eye, 0.3 * eye] {
            let camera = Camera::new(eye, 0.1 * DVec3::X, Up::Y, ZOOM).unwrap();
            let mut seen = surface.nothing().unwrap();
            picture.look(&surface, &camera, &mut seen);
            for (at, middle) in surface.middles.iter().enumerate() {
                let way = *middle - eye;
                let first = object.ahead(eye, way.normalize(), 0.0).unwrap_or(0.0);
                let met = surface.faces(at, eye)
                    && camera.holds(*middle)
                    && first > way.length() * (1.0 - 1e-9);
                let drawn = seen[at / 64] >> (at % 64) & 1 == 1;
                reached += if met { surface.areas[at] } else { 0.0 };
                shown += if drawn { surface.areas[at] } else { 0.0 };
                wrong += if met == drawn { 0.0 } else { surface.areas[at] };
            }
        }
    }
    println!("{reached} by rays, {shown} shown, {wrong} of them not both");
    assert!((shown - reached).abs() < 0.02 * reached && wrong < 0.08 * reached);
}
