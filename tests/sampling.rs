//! The two ways to a pose, many at a time and one by one, agree; and what is
//! promised of every path holds on random ones.

mod common;

use common::Random;
use glam::DVec3;
use vides::path::{CameraPath, Pose, Sampler, Timeline};

fn sampled(path: &CameraPath) -> (Sampler, Vec<Pose>) {
    path.check().unwrap();
    let timeline = Timeline::new(path).unwrap();
    let sampler = Sampler::new(path, &timeline).unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    (sampler, poses)
}

fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (DVec3::from(a) - DVec3::from(b)).length()
}

fn bits(pose: &Pose) -> [u64; 10] {
    let mut numbers = [pose.zoom; 10];
    numbers[..9].copy_from_slice([pose.vrp, pose.vpn, pose.vup].as_flattened());
    numbers.map(f64::to_bits)
}

/// At whole frames bit for bit, beside them to rounding.
#[test]
fn many_at_a_time_and_one_by_one_agree() {
    let mut random = Random::new(11);
    let (mut place, mut view, mut up, mut zoom) = (0.0f64, 0.0f64, 0.0f64, 0.0f64);
    for round in 0..300 {
        let path = random.path(if round % 10 == 0 { 3000.0 } else { 100.0 });
        let (sampler, poses) = sampled(&path);
        for (i, fast) in poses.iter().enumerate() {
            if poses.len() > 2000 && i % 7 != 0 {
                continue;
            }
            let frame = (i + 1) as f64;
            let whole = sampler.pose(frame).unwrap();
            assert_eq!(bits(&whole), bits(fast), "{round}: frame {frame}");
            // A hair before a whole frame it goes the other way; the zoom goes on meanwhile.
            let before = frame.next_down().max(1.0);
            let plain = sampler.pose(before).unwrap();
            let step = (fast.zoom - poses[i.saturating_sub(1)].zoom).abs();
            let on = 2.0 * step * (frame - before);
            place = place.max(apart(fast.vrp, plain.vrp));
            view = view.max(apart(fast.vpn, plain.vpn));
            up = up.max(apart(fast.vup, plain.vup));
            zoom = zoom.max((fast.zoom - plain.zoom).abs() - on);
        }
        println!("{round} {} {place:e} {view:e} {up:e} {zoom:e}", poses.len());
    }
    assert!(place < 1e-12 && view < 1e-12 && up < 1e-12 && zoom < 1e-12);
}
