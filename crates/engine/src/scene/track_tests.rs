use proptest::prelude::*;

use super::*;

fn track(
    channel: &str,
    interpolation: &str,
    frames: &[f64],
    values: &[f64],
    shape: &[f64],
) -> Result<Track> {
    Track::new(
        Channel::parse(channel).unwrap(),
        Interpolation::parse(interpolation).unwrap(),
        frames.to_vec(),
        values.to_vec(),
        shape.to_vec(),
    )
}

fn number(track: &Track, frame: f64) -> f64 {
    let mut out = [0.0];
    track.numbers(frame, &mut out, &mut Warnings::default());
    out[0]
}

fn refused(result: Result<Track>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn what_is_no_track_is_refused_with_channel_and_key() {
    let two = [1.0, 2.0];
    let six = [0.0; 6];
    let position =
        |frames: &[f64], values: &[f64]| track("position", "linear", frames, values, &[]);
    assert_eq!(
        refused(position(&[2.0, 2.0], &six)),
        "channel \"position\": key 2: its frame must lie behind that of the key before"
    );
    assert_eq!(
        refused(position(&two, &[0.0, 0.0, 0.0, 0.0, f64::NAN, 0.0])),
        "channel \"position\": key 2: a value must be a finite number"
    );
    assert!(refused(position(&[f64::NAN, 2.0], &six)).contains("key 1: a frame must be"));
    assert!(refused(position(&two, &six[..5])).contains("2 keys cannot share 5 numbers"));
    assert!(refused(position(&two, &six[..4])).contains("a key has 3 numbers here, not 2"));
    assert!(refused(position(&[], &[])).contains("a track needs a key"));
    assert!(refused(position(&two, &[2e9; 6])).contains("must not exceed 1e9"));
    let eight = [0.0; 8];
    assert!(refused(track("rotation", "linear", &two, &eight, &[])).contains("not zero"));
    assert!(refused(track("rotation", "cubic", &two, &[1.0; 8], &[])).contains("\"cubic\""));
    assert!(refused(track("scale", "euler-linear", &two, &six, &[])).contains("euler-linear"));
    assert!(refused(track("visible", "linear", &two, &two, &[])).contains("\"linear\""));
    assert!(refused(track("visible", "step", &two, &two, &[])).contains("outside the range"));
    assert!(refused(track("position", "tcb", &two, &six, &[])).contains("needs 6 numbers"));
    assert!(refused(track("position", "tcb", &two, &six, &[2.0; 6])).contains("tension"));
    let steep = [f64::INFINITY; 12];
    assert!(refused(track("position", "hermite", &two, &six, &steep)).contains("a tangent"));
    let near = [0.0, 1e-300, 2.0];
    let rough = [0.0, 1.0, 0.0];
    assert!(refused(track("roll", "cubic", &near, &rough, &[])).contains("too close"));
    assert!(track("roll", "linear", &near, &rough, &[]).is_ok());
    let offset = track("visible", "step", &two, &[0.0, 1.0], &[]).unwrap();
    assert!(
        offset
            .with_extrapolation(Extrapolation::Hold, Extrapolation::Offset)
            .is_err()
    );
    for name in ["", "Linear", "host:", "spline"] {
        assert!(Interpolation::parse(name).is_err());
    }
}

#[test]
fn one_key_is_a_track() {
    for name in ["step", "linear", "ramp", "catmull-rom", "cubic"] {
        for beyond in [
            Extrapolation::Hold,
            Extrapolation::Repeat,
            Extrapolation::PingPong,
            Extrapolation::Offset,
        ] {
            let one = track("roll", name, &[5.0], &[7.0], &[]).unwrap();
            let one = one.with_extrapolation(beyond, beyond).unwrap();
            for frame in [-3.0, 5.0, 9.5] {
                assert_eq!(number(&one, frame), 7.0);
            }
        }
    }
}

#[test]
fn offsets_go_on_from_the_end() {
    let steps = track("roll", "linear", &[0.0, 10.0], &[5.0, 8.0], &[]).unwrap();
    let steps = steps
        .with_extrapolation(Extrapolation::Offset, Extrapolation::Offset)
        .unwrap();
    assert!((number(&steps, 25.0) - 12.5).abs() < 1e-12);
    assert!((number(&steps, -5.0) - 3.5).abs() < 1e-12);
    // A quarter turn about y in each round.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let values = [1.0, 0.0, 0.0, 0.0, half, 0.0, half, 0.0];
    let turn = track("rotation", "linear", &[0.0, 10.0], &values, &[]).unwrap();
    let turn = turn
        .with_extrapolation(Extrapolation::Offset, Extrapolation::Offset)
        .unwrap();
    for frame in [-35.0, -5.0, 3.0, 17.0, 44.0] {
        let q = turn.rotation(frame, &mut Warnings::default());
        let want = DQuat::from_rotation_y(frame * std::f64::consts::FRAC_PI_2 / 10.0);
        assert!(q.dot(want).abs() > 1.0 - 1e-14, "{frame}");
    }
}

#[test]
fn a_wheel_turns_more_than_once() {
    let wheel = track(
        "rotation",
        "euler-linear",
        &[0.0, 8.0],
        &[0.0, 0.0, 0.0, 0.0, 720.0, 0.0],
        &[],
    )
    .unwrap();
    let q = wheel.rotation(1.0, &mut Warnings::default());
    let want = DQuat::from_rotation_x(std::f64::consts::FRAC_PI_2);
    assert!(q.dot(want).abs() > 1.0 - 1e-15);
}

#[test]
fn a_hosts_function_that_fails_lets_the_track_step() {
    let make = |name: &str| {
        let name = format!("host:{name}");
        track("roll", &name, &[0.0, 10.0], &[1.0, 3.0], &[]).unwrap()
    };
    let said = |track: &Track, want: f64| {
        let (mut out, mut warnings) = ([0.0], Warnings::default());
        track.numbers(5.0, &mut out, &mut warnings);
        assert_eq!(out[0], want);
        warnings.first().map(|(_, message)| message.to_string())
    };
    let missing = make("test-missing");
    assert!(
        said(&missing, 1.0)
            .unwrap()
            .contains("no interpolation \"host:test-missing\"")
    );
    let set = |name: &str, function: Option<std::sync::Arc<host::Function>>| {
        host::register(name, function).unwrap();
    };
    set(
        "test-half",
        Some(std::sync::Arc::new(
            |question: Question<'_>, out: &mut [f64]| {
                out[0] = question.frame / 2.0 + question.values[0];
                true
            },
        )),
    );
    assert_eq!(said(&make("test-half"), 3.5), None);
    set(
        "test-fails",
        Some(std::sync::Arc::new(|_: Question<'_>, _: &mut [f64]| false)),
    );
    assert!(said(&make("test-fails"), 1.0).unwrap().contains("failed"));
    set(
        "test-nan",
        Some(std::sync::Arc::new(|_: Question<'_>, out: &mut [f64]| {
            out[0] = f64::NAN;
            true
        })),
    );
    assert!(
        said(&make("test-nan"), 1.0)
            .unwrap()
            .contains("cannot be used")
    );
    for name in ["test-half", "test-fails", "test-nan"] {
        set(name, None);
    }
    assert!(said(&make("test-half"), 1.0).is_some());
}

/// Keys at unequal times.
fn keys() -> impl Strategy<Value = (Vec<f64>, Vec<f64>)> {
    prop::collection::vec((0.2..5.0f64, -10.0..10.0f64), 2..9).prop_map(|keys| {
        let mut frame = -4.0;
        let frames = keys.iter().map(|key| {
            frame += key.0;
            frame
        });
        (frames.collect(), keys.iter().map(|key| key.1).collect())
    })
}

/// First or second derivative from one side, by differences of three points:
/// exact for cubics but for rounding and the third derivative.
fn derivative(track: &Track, at: f64, h: f64, order: i32) -> f64 {
    let f = |k: f64| number(track, at + k * h);
    if order == 1 {
        // Exact for cubics: four points.
        (-11.0 * f(0.0) + 18.0 * f(1.0) - 9.0 * f(2.0) + 2.0 * f(3.0)) / (6.0 * h)
    } else {
        (2.0 * f(0.0) - 5.0 * f(1.0) + 4.0 * f(2.0) - f(3.0)) / (h * h)
    }
}

proptest! {
    #[test]
    fn keys_are_hit_and_all_is_finite((frames, values) in keys(), frame in -1e9..1e9f64) {
        for name in ["step", "linear", "ramp", "sine", "parabolic", "catmull-rom", "cubic"] {
            let plain = track("roll", name, &frames, &values, &[]).unwrap();
            for (frame, value) in frames.iter().zip(&values) {
                prop_assert_eq!(number(&plain, *frame).to_bits(), value.to_bits());
            }
            use Extrapolation::{Hold, Offset, PingPong, Repeat};
            for beyond in [Hold, Repeat, PingPong, Offset] {
                let track = plain.clone().with_extrapolation(beyond, beyond).unwrap();
                prop_assert!(number(&track, frame).is_finite());
            }
        }
    }

    #[test]
    fn smooth_tracks_are_smooth((frames, values) in keys()) {
        let h = 0.02;
        for (name, order) in [("catmull-rom", 1), ("cubic", 1), ("cubic", 2)] {
            let track = track("roll", name, &frames, &values, &[]).unwrap();
            for &frame in &frames[1..frames.len() - 1] {
                let after = derivative(&track, frame, h, order);
                let before = derivative(&track, frame, -h, order);
                let near = 1e-13 / h.powi(order) * 1e3 * (1.0 + after.abs());
                prop_assert!((after - before).abs() < near, "{} {}: {} {}", name, order, before, after);
            }
        }
    }

    #[test]
    fn periodic_cubics_are_smooth_at_the_seam((frames, mut values) in keys()) {
        let last = values.len() - 1;
        values[last] = values[0];
        let track = track("roll", "cubic", &frames, &values, &[]).unwrap();
        let track = track.with_extrapolation(Extrapolation::Hold, Extrapolation::Repeat).unwrap();
        let (end, h) = (frames[last], 0.02);
        for order in [1, 2] {
            let after = derivative(&track, end, h, order);
            let before = derivative(&track, end, -h, order);
            let near = 1e-13 / h.powi(order) * 1e3 * (1.0 + after.abs());
            prop_assert!((after - before).abs() < near, "{}: {} {}", order, before, after);
        }
    }

    /// Angular velocity on both sides of a key, by small steps.
    #[test]
    fn smooth_turns_have_one_velocity(
        steps in prop::collection::vec((0.5..5.0f64, prop::array::uniform3(-0.6..0.6f64)), 3..7),
    ) {
        let (mut frame, mut q) = (0.0, DQuat::IDENTITY);
        let (mut frames, mut values) = (Vec::new(), Vec::new());
        for (step, turn) in steps {
            frames.push(frame);
            values.extend(wxyz(q));
            frame += step;
            q = (DQuat::from_scaled_axis(turn.into()) * q).normalize();
        }
        let track = track("rotation", "catmull-rom", &frames, &values, &[]).unwrap();
        let at = |frame| track.rotation(frame, &mut Warnings::default());
        for &frame in &frames[1..frames.len() - 1] {
            let velocity = |h: f64| {
                let turn = |h: f64| (at(frame + h) * at(frame).conjugate()).to_scaled_axis() / h;
                // Richardson: the error of first order goes.
                2.0 * turn(h / 2.0) - turn(h)
            };
            let jump = (velocity(1e-4) - velocity(-1e-4)).length();
            prop_assert!(jump < 1e-6, "{}", jump);
        }
    }
}

/// The rotation of a track of numbers in place of it: its share of the way between two keys,
/// and slerp by its definition (Shoemake 1985); angles by a track that stands still at them.
#[test]
fn rotations_follow_the_numbers_of_their_kind() {
    let frames = [1.0, 8.0, 30.0];
    let quaternions = [
        [0.5, 0.5, -0.5, 0.5],
        [0.1, -0.7, 0.1, 0.7],
        [-0.8, 0.0, 0.6, 0.0],
    ];
    let units = quaternions.map(|[w, x, y, z]| DQuat::from_xyzw(x, y, z, w).normalize());
    let values = quaternions.concat();
    let slerp = |a: DQuat, b: DQuat, t: f64| {
        let cosine = a.dot(b);
        let b = if cosine < 0.0 { -b } else { b };
        let angle = cosine.abs().acos();
        (a * ((1.0 - t) * angle).sin() + b * (t * angle).sin()) * angle.sin().recip()
    };
    let same = |a: DQuat, b: DQuat| 1.0 - a.dot(b).abs() < 1e-12;
    let warnings = &mut Warnings::default();
    for kind in ["step", "ramp", "sine", "parabolic"] {
        let turned = track("rotation", kind, &frames, &values, &[]).unwrap();
        for key in 0..2 {
            let ends = [frames[key], frames[key + 1]];
            let share = track("value:x", kind, &ends, &[0.0, 1.0], &[]).unwrap();
            for part in 0..20 {
                let frame = ends[0] + (ends[1] - ends[0]) * f64::from(part) / 20.0;
                let wanted = slerp(units[key], units[key + 1], number(&share, frame));
                let found = turned.rotation(frame, warnings);
                assert!(same(found, wanted), "{kind} {frame}: {found} {wanted}");
            }
        }
    }
    let angles = [10.0, 40.0, -20.0, 400.0, -60.0, 15.0, 350.0, 0.0, 720.0];
    let turned = track("rotation", "euler-catmull-rom", &frames, &angles, &[]).unwrap();
    let plain = track("value:x:3", "catmull-rom", &frames, &angles, &[]).unwrap();
    for part in 0..=58 {
        let frame = 1.0 + 0.5 * f64::from(part);
        let mut now = [0.0; 3];
        plain.numbers(frame, &mut now, warnings);
        let still = track("rotation", "euler-linear", &[1.0], &now, &[]).unwrap();
        let (found, wanted) = (
            turned.rotation(frame, warnings),
            still.rotation(frame, warnings),
        );
        assert!(same(found, wanted), "{frame}: {found} {wanted}");
    }
}

/// Two keys: of numbers the tension acts (the cubic with both slopes (1 − t)·mean, by Hermite's
/// basis), a rotation goes by the great arc as a path does.
#[test]
fn between_two_keys_tension_acts_on_numbers_alone() {
    let (frames, shape) = ([1.0, 11.0], [0.75, 0.5, -0.5, 0.75, 0.5, -0.5]);
    let tense = track("roll", "tcb", &frames, &[0.0, 1.0], &shape).unwrap();
    let [from, to] = [DQuat::IDENTITY, DQuat::from_rotation_y(2.0)];
    let values = [wxyz(from), wxyz(to)].concat();
    let turned = track("rotation", "tcb", &frames, &values, &shape).unwrap();
    for part in 0..=10 {
        let (u, frame) = (f64::from(part) / 10.0, f64::from(part + 1));
        let slopes = 0.25 * u * (1.0 - u) * (1.0 - 2.0 * u);
        let wanted = u * u * (3.0 - 2.0 * u) + slopes;
        assert!((number(&tense, frame) - wanted).abs() < 1e-14, "{u}");
        let q = turned.rotation(frame, &mut Warnings::default());
        assert!(q.abs_diff_eq(DQuat::from_rotation_y(2.0 * u), 1e-14), "{u}");
    }
}
