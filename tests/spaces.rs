//! A path in another space is the same path: where its world's numbers are those of
//! the cube [−1, 1]³ carried there, its frames are the same and its poses carried
//! there too; z upright is y upright with the axes exchanged.

mod common;

use common::{Random, all_poses, prepared};
use glam::DVec3;
use vides::document::{Document, Edit, Info};
use vides::path::{
    CameraPath, Change, Pose, Space, Tangents, Target, Up, Velocities, ambiguity, insertion,
};

/// y upright to z upright, by hand.
fn exchanged(v: DVec3, up: Up) -> DVec3 {
    match up {
        Up::Y => v,
        Up::Z => DVec3::new(v.z, v.x, v.y),
    }
}

fn place(p: DVec3, to: Space) -> DVec3 {
    to.centre + to.half_size * exchanged(p, to.up)
}

/// The path of the space [−1, 1]³, y upright, in another space.
fn carried(path: &CameraPath, to: Space) -> CameraPath {
    let mut path = path.clone();
    let offset = |v| to.half_size * exchanged(v, to.up);
    for point in &mut path.points {
        point.position = place(point.position, to);
        point.tangents = point.tangents.map(|own| Tangents {
            before: offset(own.before),
            after: offset(own.after),
        });
        for orientation in &mut point.orientations {
            orientation.target = match orientation.target {
                Target::Absolute(target) => Target::Absolute(place(target, to)),
                Target::Relative(v) => Target::Relative(offset(v)),
            };
            let own = orientation.own.with(|own| {
                own.ahead = own.ahead.map(|distance| distance * to.half_size);
                own.velocities = own.velocities.map(|own| Velocities {
                    reach: exchanged(own.reach, to.up),
                    leave: exchanged(own.leave, to.up),
                });
            });
            orientation.own = own.unwrap();
        }
    }
    path.space = to;
    path
}

/// A random path whose targets lie at some distance, so that its views are known as
/// well as its places are; some points and orientations own what they may.
fn some_path(random: &mut Random) -> CameraPath {
    let ahead = random.chance(0.3);
    let mut path = random.path(60.0);
    for point in &mut path.points {
        let tangents = Tangents {
            before: random.vector(),
            after: random.vector(),
        };
        point.tangents = random.chance(0.1).then_some(tangents);
        for orientation in &mut point.orientations {
            if let Target::Absolute(target) = orientation.target {
                orientation.target = Target::Absolute(6.0 * target.normalize());
            }
            let velocities = Velocities {
                reach: random.vector(),
                leave: random.vector(),
            };
            let which = random.below(20);
            let own = orientation.own.with(|own| match which {
                0 => own.velocities = Some(velocities),
                1 if ahead => own.ahead = Some(0.0),
                2 if ahead => own.ahead = Some(0.3),
                _ => {}
            });
            orientation.own = own.unwrap();
        }
    }
    path
}

/// By how much rounding is enlarged: the velocity of a view along the way is a quotient
/// of differences over 1/16384 of a section.
fn enlarged(path: &CameraPath) -> f64 {
    let mut all = path.points.iter().flat_map(|point| &point.orientations);
    if all.any(|orientation| orientation.own.ahead.is_some()) {
        16384.0
    } else {
        1.0
    }
}

/// Whether a count of frames lies so near to a half that rounding decides it.
fn undecided(path: &CameraPath) -> bool {
    let (timeline, _) = prepared(path);
    (0..timeline.section_count()).any(|section| {
        let frames = timeline.unrounded_frames(path, section);
        (frames.fract() - 0.5).abs() < 1e-6
    })
}

/// The largest differences of places, in half sizes, and of views.
fn apart(here: &[Pose], there: &[Pose], space: Space) -> (f64, f64) {
    let far = |a: [f64; 3], b: DVec3| (DVec3::from(a) - b).length();
    let (mut places, mut views) = (0.0f64, 0.0f64);
    for (here, there) in here.iter().zip(there) {
        assert!((here.zoom - there.zoom).abs() < 1e-12);
        let moved = place(here.vrp.into(), space);
        places = places.max(far(there.vrp, moved) / space.half_size);
        for (a, b) in [(here.vpn, there.vpn), (here.vup, there.vup)] {
            views = views.max(far(b, exchanged(a.into(), space.up)));
        }
    }
    (places, views)
}

/// Powers of two and no shift lose no bit, however far from 1.
#[test]
fn scaling_alone_is_exact() {
    let mut random = Random::new(71);
    for round in 0..300 {
        let path = some_path(&mut random);
        let space = Space {
            half_size: [2f64.powi(-80), 2f64.powi(-20), 2f64.powi(20), 2f64.powi(90)][round % 4],
            ..Space::default()
        };
        let (timeline, sampler) = prepared(&path);
        let moved = carried(&path, space);
        let (other_timeline, other) = prepared(&moved);
        assert_eq!(sampler.frame_count(), other.frame_count(), "{round}");
        let difference = apart(&all_poses(&sampler), &all_poses(&other), space);
        assert_eq!(difference, (0.0, 0.0), "{round}");
        assert_eq!(
            space.half_size * timeline.length(),
            other_timeline.length(),
            "{round}"
        );
        for section in 0..timeline.section_count() {
            assert_eq!(
                ambiguity(&path, &timeline, section),
                ambiguity(&moved, &other_timeline, section)
            );
        }
    }
}

#[test]
fn anywhere_in_the_world_a_path_is_the_same() {
    let mut random = Random::new(72);
    let (mut places, mut views, mut tried) = (0.0f64, 0.0f64, 0);
    for round in 0..600 {
        let path = some_path(&mut random);
        if undecided(&path) {
            continue;
        }
        let half_size = [1e-6, 1.0, 1e6][round % 3];
        let space = Space {
            centre: DVec3::new(1000.0, -700.0, 300.0) * half_size,
            half_size,
            up: [Up::Y, Up::Z][round / 3 % 2],
        };
        let (_, sampler) = prepared(&path);
        let (_, other) = prepared(&carried(&path, space));
        assert_eq!(sampler.frame_count(), other.frame_count(), "{round}");
        let (far, turned) = apart(&all_poses(&sampler), &all_poses(&other), space);
        (places, views) = (places.max(far), views.max(turned / enlarged(&path)));
        tried += 1;
    }
    eprintln!("{tried} paths: {places:e} {views:e}");
    assert!(tried > 500);
    // A coordinate 1,000 half sizes away is known to 1e-13 of them.
    assert!(places < 1e-12 && views < 1e-12, "{places:e} {views:e}");
}

#[test]
fn z_upright_is_y_upright_with_the_axes_exchanged() {
    let mut random = Random::new(73);
    let space = Space {
        up: Up::Z,
        ..Space::default()
    };
    for round in 0..400 {
        let path = some_path(&mut random);
        let (_, sampler) = prepared(&path);
        let (_, other) = prepared(&carried(&path, space));
        let (here, there) = (all_poses(&sampler), all_poses(&other));
        assert_eq!(here.len(), there.len());
        let (places, views) = apart(&here, &there, space);
        assert!(
            places < 1e-14 && views < 1e-14 * enlarged(&path),
            "{round} {places:e} {views:e}"
        );
        // The plain way to one pose as well.
        for _ in 0..5 {
            let frame = random.between(1.0, here.len() as f64);
            let one = |sampler: &vides::path::Sampler| [sampler.pose(frame).unwrap()];
            let (places, views) = apart(&one(&sampler), &one(&other), space);
            assert!(
                places < 1e-14 && views < 1e-14 * enlarged(&path),
                "{round} {frame} {places:e} {views:e}"
            );
        }
    }
}

#[test]
fn what_the_vertical_decides_is_where_it_should_be() {
    // A target straight below is over a pole of its own in either space.
    for (up, below) in [(Up::Y, DVec3::NEG_Y), (Up::Z, DVec3::NEG_Z)] {
        let mut path = CameraPath::default();
        path.space.up = up;
        for (point, x) in path.points.iter_mut().zip([-1.0, 1.0]) {
            point.position = exchanged(DVec3::X * x, up);
            point.orientations[0].target = Target::Absolute(below);
        }
        let (timeline, sampler) = prepared(&path);
        assert_eq!(
            ambiguity(&path, &timeline, 0),
            Some(vides::path::Ambiguity::OverTarget),
            "{up:?}"
        );
        for pose in all_poses(&sampler) {
            // Level: the picture's horizon lies across the vertical.
            let side = DVec3::from(pose.vpn).cross(pose.vup.into());
            assert!(side[up.index()].abs() < 1e-15);
            assert!(pose.vup[up.index()] >= 0.0);
        }
    }
}

#[test]
fn a_new_point_keeps_the_motion_in_any_space() {
    let mut random = Random::new(74);
    let mut tried = 0;
    for round in 0..200 {
        let space = Space {
            centre: random.vector() * 5e3,
            half_size: 2.5e3,
            up: [Up::Y, Up::Z][round % 2],
        };
        let path = carried(&some_path(&mut random), space);
        let (_, sampler) = prepared(&path);
        let frame = random.between(1.0, sampler.frame_count() as f64);
        let Ok(insertion) = insertion::on_curve(&path, frame) else {
            continue;
        };
        let (_, after) = prepared(&insertion.path);
        let (here, there) = (all_poses(&sampler), all_poses(&after));
        assert_eq!(here.len(), there.len(), "{round}");
        let plain = |a: &Pose, b: &Pose| {
            let far = |a: [f64; 3], b: [f64; 3]| (DVec3::from(a) - DVec3::from(b)).length();
            far(a.vpn, b.vpn).max(far(a.vup, b.vup)) + far(a.vrp, b.vrp) / space.half_size
        };
        let worst = here.iter().zip(&there).map(|(a, b)| plain(a, b));
        let worst = worst.fold(0.0, f64::max);
        assert!(worst < 1e-6, "{round} {worst:e}");
        tried += 1;
    }
    assert!(tried > 60, "{tried}");
}

#[test]
fn a_path_goes_along_into_a_new_space_or_keeps_its_numbers() {
    let mut random = Random::new(75);
    for round in 0..100 {
        let path = some_path(&mut random);
        let mut document = Document::from_parts(path.clone(), Info::default()).unwrap();
        let before = format!("{:?}", document.path());
        let space = Space {
            centre: DVec3::new(3.0, 1.0, -2.0),
            half_size: 4.0,
            up: [Up::Z, Up::Y][round % 2],
        };
        document.apply(Edit::SetSpace { space, fit: true }).unwrap();
        assert_eq!(*document.path(), carried(&path, space));
        assert!(document.undo());
        assert_eq!(format!("{:?}", document.path()), before);
        document
            .apply(Edit::SetSpace { space, fit: false })
            .unwrap();
        let kept = CameraPath {
            space,
            ..path.clone()
        };
        assert_eq!(*document.path(), kept);
        // A way counts in half sizes now.
        let sections = |document: &Document| {
            let all = |timeline: &vides::path::Timeline| {
                (0..timeline.section_count())
                    .map(|section| timeline.section(section))
                    .filter(|section| section.change == Change::Position)
                    .map(|section| section.amount)
                    .collect::<Vec<_>>()
            };
            document.timeline(all).unwrap()
        };
        let counted = sections(&document);
        assert!(document.undo());
        for (in_half_sizes, length) in counted.iter().zip(sections(&document)) {
            assert!((4.0 * in_half_sizes - length).abs() <= 1e-15 * length);
        }
    }
}

#[test]
fn a_space_that_cannot_be_is_refused_and_changes_nothing() {
    let mut document = Document::new();
    let before = document.to_toml().unwrap();
    for (half_size, x, says) in [
        (0.0, 0.0, "half size"),
        (-1.0, 0.0, "half size"),
        (f64::NAN, 0.0, "half size"),
        (1e-300, 0.0, "half size"),
        (1e300, 0.0, "half size"),
        (1.0, f64::NAN, "centre"),
        (1.0, 1e300, "centre"),
        (1e-12, 0.0, "point 1: "),
    ] {
        for fit in [false, true] {
            let space = Space {
                centre: DVec3::X * x,
                half_size,
                up: Up::Y,
            };
            let done = document.apply(Edit::SetSpace { space, fit });
            if fit && says == "point 1: " {
                done.unwrap();
                document.undo();
            } else {
                let error = done.unwrap_err().to_string();
                assert!(error.contains(says), "{half_size} {x}: {error}");
            }
            assert_eq!(document.to_toml().unwrap(), before);
        }
    }
}

#[test]
fn a_space_is_made_around_path_and_object() {
    let mut document = Document::new();
    assert!(document.space_around_object().is_err());
    let around = document.space_around_path().unwrap();
    assert_eq!(around.centre, DVec3::new(0.0, 0.2, 0.8));
    assert!((around.half_size - 0.66).abs() < 1e-12);
    document
        .apply(Edit::SetSpace {
            space: around,
            fit: false,
        })
        .unwrap();
    let text = document.to_toml().unwrap();
    let again = Document::from_toml(&text).unwrap();
    assert_eq!(again.path().space, around);
}
