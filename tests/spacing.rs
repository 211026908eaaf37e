//! With constant speed the camera covers the same distance from pose to pose.
//!
//! The oracle walks along the curve by its own quadrature (Gauss and Legendre,
//! ten nodes, halved until it settles) and finds where pose k must be. A pose
//! that lies within half of 1e-9 of a step from there is a distance from both
//! its neighbours that is right to 1e-9. Places are compared, not parameters:
//! at a cusp the parameter is ill-determined, the place is not. Where the curve
//! is a straight line, no quadrature is needed: the coordinate is the distance.

mod common;

use common::{Random, all_poses, closed, path_through, prepared, set_speeds, shaped};
use glam::DVec3;
use vides::path::hermite::Cubic;
use vides::path::{CameraPath, CurveParameters, Tcb};

/// Share of a step by which a pose may lie beside its place.
const TOLERANCE: f64 = 0.5e-9;

/// Positive nodes of the 10-point rule, and their weights.
const RULE: [(f64, f64); 5] = [
    (0.148_874_338_981_631_2, 0.295_524_224_714_752_9),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_3),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_1),
];

fn rule(curve: &Cubic, from: f64, to: f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let speed = |t| curve.derivative(t).length();
    let pair = |&(x, w): &(f64, f64)| w * (speed(middle - half * x) + speed(middle + half * x));
    half * RULE.iter().map(pair).sum::<f64>()
}

/// A curve with the parameters of its least speeds. At a cusp, where the speed
/// has a kink, a rule that runs across it settles by chance on a wrong value;
/// so none does.
struct Measured<'a> {
    curve: &'a Cubic,
    slowest: Vec<f64>,
}

impl<'a> Measured<'a> {
    fn new(curve: &'a Cubic) -> Self {
        // The speed is least where P′·P″ goes from falling to rising.
        let rising = |t| curve.derivative(t).dot(curve.second_derivative(t)) > 0.0;
        let mut slowest = Vec::new();
        for k in 0..64 {
            let (mut low, mut high) = (f64::from(k) / 64.0, f64::from(k + 1) / 64.0);
            if rising(low) || !rising(high) {
                continue;
            }
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if rising(middle) {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            slowest.push(high);
        }
        Self { curve, slowest }
    }

    /// Distance along the curve, to `enough` or to rounding.
    fn distance(&self, from: f64, to: f64, enough: f64) -> f64 {
        let mut start = from;
        let mut sum = 0.0;
        for &end in self.slowest.iter().chain([&to]) {
            if end > start && end <= to {
                let whole = rule(self.curve, start, end);
                sum += self.halve(start, end, whole, enough, 45);
                start = end;
            }
        }
        sum
    }

    fn halve(&self, from: f64, to: f64, whole: f64, enough: f64, depth: u32) -> f64 {
        let middle = 0.5 * (from + to);
        let a = rule(self.curve, from, middle);
        let b = rule(self.curve, middle, to);
        if (a + b - whole).abs() <= enough.max(5e-15 * whole) || depth == 0 {
            return a + b;
        }
        self.halve(from, middle, a, enough, depth - 1)
            + self.halve(middle, to, b, enough, depth - 1)
    }

    fn length(&self) -> f64 {
        let enough = 1e-18 * rule(self.curve, 0.0, 1.0);
        let mut sum = Sum::default();
        for k in 0..512 {
            let (from, to) = (f64::from(k) / 512.0, f64::from(k + 1) / 512.0);
            sum.add(self.distance(from, to, enough));
        }
        sum.0 + sum.1
    }
}

/// A sum that loses nothing (Neumaier).
#[derive(Default)]
struct Sum(f64, f64);

impl Sum {
    fn add(&mut self, x: f64) {
        let sum = self.0 + x;
        self.1 += if self.0.abs() >= x.abs() {
            (self.0 - sum) + x
        } else {
            (x - sum) + self.0
        };
        self.0 = sum;
    }
    /// `target` less the sum.
    fn missing(&self, target: f64) -> f64 {
        (target - self.0) - self.1
    }
}

/// The places that lie `step`, 2·`step`, … from the start.
struct Walk<'a> {
    on: Measured<'a>,
    step: f64,
    t: f64,
    gone: Sum,
    count: f64,
}

impl Iterator for Walk<'_> {
    type Item = DVec3;

    fn next(&mut self) -> Option<DVec3> {
        self.count += 1.0;
        let ahead = self.gone.missing(self.count * self.step);
        let enough = 1e-14 * self.step;
        let (mut low, mut high) = (self.t, 1.0);
        let mut t = self.t;
        let mut covered = 0.0;
        for _ in 0..200 {
            let error = covered - ahead;
            let speed = self.on.curve.derivative(t).length();
            // The second bound is the rounding of t.
            if error.abs() <= (1e-13 * self.step).max(2e-16 * speed) {
                break;
            }
            if error > 0.0 {
                high = t;
            } else {
                low = t;
            }
            let newton = t - error / speed;
            t = if newton > low && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
            covered = self.on.distance(self.t, t, enough);
        }
        self.gone.add(covered);
        self.t = t;
        Some(self.on.curve.point(t))
    }
}

fn walk(curve: &Cubic, steps: usize) -> Walk<'_> {
    let on = Measured::new(curve);
    Walk {
        step: on.length() / steps as f64,
        on,
        t: 0.0,
        gone: Sum::default(),
        count: 0.0,
    }
}

/// Checks every segment of a path whose longest one is to take `frames`.
/// The way from point to point must be the only section of each segment.
fn check_spacing(name: &str, mut path: CameraPath, frames: f64) {
    set_speeds(&mut path, 1.0);
    let lengths = prepared(&path).0;
    let longest = (0..lengths.segment_count())
        .map(|segment| lengths.segment_length(segment))
        .fold(0.0, f64::max);
    set_speeds(&mut path, frames / longest);
    let (timeline, sampler) = prepared(&path);
    let poses = all_poses(&sampler);
    let mut worst = 0.0f64;
    for index in 0..timeline.section_count() {
        let section = timeline.section(index);
        let curve = timeline.curve(section.point);
        let first = sampler.first_frame(index);
        let mut walk = walk(curve, section.frames);
        let step = walk.step;
        for number in first..first + section.frames - 1 {
            let place = walk.next().unwrap();
            let mut beside = (DVec3::from(poses[number - 1].vrp) - place).length() / step;
            if number % 101 == 0 {
                let plain = DVec3::from(sampler.pose(number as f64).unwrap().vrp);
                beside = beside.max((plain - place).length() / step);
            }
            assert!(beside < TOLERANCE, "{name}: {beside:e} at frame {number}");
            worst = worst.max(beside);
        }
    }
    println!("{name}: {} frames, {worst:e} of a step", poses.len());
}

/// Paths that have been hard for somebody.
fn hard_paths() -> Vec<(&'static str, CameraPath)> {
    let zigzag = [
        [-0.7, 0.1, 0.3],
        [0.2, 0.8, -0.5],
        [0.9, -0.6, 0.1],
        [-0.3, -0.2, 0.7],
    ];
    let own = |path: CameraPath, t, c, b| shaped(path, Tcb::new(t, c, b));
    let one_tight = |at: usize| {
        let mut path = path_through(&zigzag);
        path.points[at].curve = CurveParameters::Own(Tcb::new(1.0, 0.0, 0.0));
        path
    };
    // With tension −1 the tangents are whole chords: those of the middle
    // segment are (6, ±1), for which P′(1/2) = 0 exactly.
    let cusp = |nearly: f64| {
        let cusp = [
            [-5.0 - nearly, -1.0, 0.0],
            [-1.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [5.0, -1.0, 0.0],
        ];
        own(path_through(&cusp), -1.0, 0.0, 0.0)
    };
    let loops = [
        [-0.7, 0.1, 0.3],
        [0.2, 0.8, -0.5],
        [0.2, 0.8, -0.5],
        [0.9, -0.6, 0.1],
    ];
    let scales = [
        [0.0, 0.0, 0.0],
        [1e-6, 0.0, 0.0],
        [1e6, 3e5, -2e5],
        [1e6, 3e5, 0.0],
    ];
    vec![
        ("plain", path_through(&zigzag)),
        ("closed", closed(path_through(&zigzag))),
        ("closed triangle", closed(path_through(&zigzag[..3]))),
        (
            "there and back, closed",
            closed(own(path_through(&zigzag[..2]), 0.0, 0.7, 0.4)),
        ),
        ("loop at coincident points", path_through(&loops)),
        (
            "overshooting loop",
            own(path_through(&loops), -1.0, 0.3, 1.0),
        ),
        (
            "tight at every point",
            own(path_through(&zigzag), 1.0, 0.0, 0.0),
        ),
        ("tight at the first point", one_tight(0)),
        ("tight inside", one_tight(1)),
        ("tight at the last point", one_tight(3)),
        ("corners", own(path_through(&zigzag), 0.0, -1.0, 0.0)),
        (
            "inverted corners",
            own(path_through(&zigzag), 0.0, 1.0, 0.0),
        ),
        (
            "round and biased",
            own(path_through(&zigzag), -1.0, 1.0, -1.0),
        ),
        ("cusp", cusp(0.0)),
        ("nearly a cusp", cusp(1e-3)),
        ("hardly not a cusp", cusp(1e-9)),
        (
            "line that runs back",
            path_through(&[[0.0, 0.0, 0.0], [0.3, 0.1, -0.2], [-3.0, -1.0, 2.0]]),
        ),
        ("short and long, rounded", path_through(&scales)),
        (
            "short and long, corners",
            own(path_through(&scales), 0.0, -1.0, 0.0),
        ),
    ]
}

#[test]
fn equal_distances_on_hard_curves() {
    for (name, path) in hard_paths() {
        for frames in [10_000.0, 150.0] {
            check_spacing(name, path.clone(), frames);
        }
    }
}

#[test]
fn equal_distances_on_random_curves() {
    let mut random = Random::new(21);
    for round in 0..30 {
        let mut path = path_through(&[[0.0; 3]; 4]);
        for point in &mut path.points {
            point.position = random.vector();
            point.curve = CurveParameters::Own(random.tcb());
        }
        path.closed = random.chance(0.5);
        let frames = [30.0, 300.0, 3000.0][round % 3];
        check_spacing("random", path, frames);
    }
}

/// Tension 1 and continuity −1 between two points are straight lines in one
/// direction: pose k of N lies k/N of the way.
#[test]
fn straight_lines_are_divided_evenly() {
    let ends = [[-0.9, 0.4, 0.3], [0.8, -0.3, 0.5]];
    for tcb in [
        Tcb::default(),
        Tcb::new(1.0, 0.0, 0.0),
        Tcb::new(0.0, -1.0, 0.0),
        Tcb::new(-0.5, 0.0, 0.0),
    ] {
        let mut path = shaped(path_through(&ends), tcb);
        let [from, to] = ends.map(DVec3::from_array);
        // As long as it takes for 10,000 frames; with tension −0.5 the line
        // overshoots at neither end, since the tangents are 1.5 chords.
        set_speeds(&mut path, 10_000.0 / (to - from).length());
        let (_, sampler) = prepared(&path);
        assert_eq!(sampler.frame_count(), 10_001);
        let step = (to - from).length() / 10_000.0;
        for (k, pose) in all_poses(&sampler).iter().enumerate() {
            let place = from + (to - from) * (k as f64 / 10_000.0);
            let beside = (DVec3::from(pose.vrp) - place).length();
            assert!(beside < TOLERANCE * step, "{tcb:?} {k} {beside:e}");
        }
    }
}

/// x(t) of the last segment runs past its end and comes back; between two
/// turning points the coordinate itself is the distance.
#[test]
fn a_line_that_runs_back_is_divided_evenly() {
    // Tangents by hand: at 4 it is (4 − 0)/2 + (3 − 4)/2 = 1.5; at the end
    // (3·(−1) − 4)/2 = −3.5. x′ = 1.5 + 2·b·t + 3·a·t² with a = 1.5 − 3.5 + 2
    // = 0, b = −3 − 3 + 3.5 = −2.5: a parabola that turns at t = 0.3.
    let mut path = path_through(&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [3.0, 0.0, 0.0]]);
    let turn = 4.0 + 1.5 * 0.3 - 2.5 * 0.09;
    let length = (turn - 4.0) + (turn - 3.0);
    let frames = 9_999;
    set_speeds(&mut path, frames as f64 / length);
    let (timeline, sampler) = prepared(&path);
    assert!((timeline.segment_length(1) - length).abs() < 1e-14);
    assert_eq!(timeline.section(1).frames, frames);
    let first = sampler.first_frame(1);
    let poses = all_poses(&sampler);
    let step = length / frames as f64;
    for k in 1..=frames {
        let s = k as f64 * step;
        let place = if s < turn - 4.0 {
            4.0 + s
        } else {
            turn - (s - (turn - 4.0))
        };
        let beside = (poses[first + k - 2].vrp[0] - place).abs();
        assert!(beside < TOLERANCE * step, "{k} {beside:e}");
    }
}

/// A segment of 1e-6 beside two of 1e6 has one frame only; between its two
/// poses the way is divided as evenly. Closed, since an end has a parabola's
/// tangent, which would swing the short segment far out.
#[test]
fn a_short_segment_beside_long_ones_is_divided_evenly() {
    let corners = [[0.0, 0.0, 0.0], [1e-6, 0.0, 0.0], [1e6, 1e5, 0.0]];
    for tcb in [Tcb::new(0.0, -1.0, 0.0), Tcb::new(1.0, 0.0, 0.0)] {
        let mut path = closed(shaped(path_through(&corners), tcb));
        set_speeds(&mut path, 0.01);
        let (timeline, sampler) = prepared(&path);
        assert_eq!(timeline.section(0).frames, 1);
        let step = 1e-6 / 512.0;
        for k in 1..512 {
            let pose = sampler.pose(1.0 + f64::from(k) / 512.0).unwrap();
            let beside = (DVec3::from(pose.vrp) - DVec3::X * (step * f64::from(k))).length();
            assert!(beside < TOLERANCE * step, "{tcb:?} {k} {beside:e}");
        }
    }
}
