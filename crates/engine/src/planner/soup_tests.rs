//! Objects as bad as they come: triangles at random, each as large as all of the object, so that a
//! question to any tree of boxes may visit most of them.

use glam::DVec3;

use super::*;
use crate::error::{Error, Invalid, Result};
use crate::path::test_support::Random;
use crate::path::{CameraPath, Orientation, SupportPoint, Target};
use crate::planner::picture::keep_all_in_picture;
use crate::scene::Mesh;
use crate::tools::check::{CheckContext, Limits, check_watched};
use crate::tools::clearance::Clearance;
use crate::tools::fit::Progress;

fn soup(count: u32) -> Mesh {
    let mut random = Random(9);
    let mut number = || 2.0 * random.unit() - 1.0;
    Mesh {
        points: (0..3 * count)
            .map(|_| DVec3::new(number(), number(), number()))
            .collect(),
        triangles: (0..count).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
        ..Mesh::default()
    }
}

/// Round the object `far` away from its middle.
fn round(far: f64) -> CameraPath {
    let point = |k: usize| SupportPoint {
        orientations: vec![Orientation {
            target: Target::Absolute(DVec3::ZERO),
            zoom: 20.0,
            ..Orientation::default()
        }],
        ..SupportPoint::new(far * DVec3::new((k as f64).cos(), 0.1, (k as f64).sin()))
    };
    CameraPath {
        points: (0..60).map(point).collect(),
        ..CameraPath::default()
    }
}

/// Seconds of the processor that this thread has had: others may be busy.
fn used() -> f64 {
    let line = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
    line.split(' ').next().unwrap().parse::<f64>().unwrap() / 1e9
}

/// Each planner that takes longer asks all the time whether to go on, and ends soon.
#[test]
fn whatever_the_object_planners_ask_and_end() {
    let mesh = soup(30_000);
    let tree = Clearance::new(&mesh).unwrap();
    let (near, far) = (round(1.6), round(6.0));
    let keeps = |what: What, go_on: Progress<'_>| {
        let request = PictureRequest {
            margin: 0.1,
            what,
            limits: Limits::default(),
            fps: 25.0,
        };
        keep_all_in_picture(&far, &tree, &request, go_on).map(drop)
    };
    let tours = |inside: bool, go_on: Progress<'_>| {
        let request = TourRequest {
            inside,
            ..TourRequest::default()
        };
        tour(&mesh, &request, go_on).map(drop)
    };
    let avoids = |go_on: Progress<'_>| {
        let request = AvoidRequest {
            clearance: 0.5,
            radius: 0.0,
        };
        avoid_object(&near, &tree, &request, go_on).map(drop)
    };
    let checks = |go_on: Progress<'_>| {
        let against = CheckContext {
            fps: 25.0,
            space: None,
            object: Some(&tree),
            limits: Limits::default(),
        };
        check_watched(&near, &against, go_on).map(drop)
    };
    type Planner<'a> = &'a dyn Fn(Progress<'_>) -> Result<()>;
    let all: [(&str, Planner<'_>); 7] = [
        ("check", &checks),
        ("avoid", &avoids),
        ("zoom", &|go_on| keeps(What::Zoom, go_on)),
        ("distance", &|go_on| keeps(What::Distance, go_on)),
        ("view", &|go_on| keeps(What::View, go_on)),
        ("tour", &|go_on| tours(false, go_on)),
        ("inside", &|go_on| tours(true, go_on)),
    ];
    for (name, planner) in all {
        let start = used();
        let (mut last, mut pause, mut ended) = (start, 0.0_f64, false);
        let made = planner(&mut |done, all| {
            assert!(done <= all, "{name}: {done} of {all}");
            let now = used();
            pause = pause.max(now - last);
            last = now;
            ended = now - start > 1.5;
            !ended
        });
        pause = pause.max(used() - last);
        assert!(pause < 0.5, "{name}: {pause} s between two questions");
        let cancelled = made == Err(Error::Argument(Invalid::Cancelled));
        assert_eq!(cancelled, ended, "{name}: {made:?}");
    }
}
