use vides_engine::path::fit_frames::frames_between;

use super::*;
use crate::Info;

fn flight(points: usize) -> Document {
    let mut document = Document::new();
    document
        .apply(Edit::DivideSegment {
            segment: 0,
            points: points - 2,
        })
        .unwrap();
    for at in 0..points {
        let position = glam::DVec3::new(0.2 * at as f64 - 0.6, 0.3 * (at % 2) as f64, 0.1);
        let edit = Edit::set(crate::At::Point(at), "position", position);
        document.apply(edit).unwrap();
    }
    document.as_opened()
}

fn frames(document: &Document, from: usize, to: usize) -> usize {
    let path = document.path();
    let frames = document.timeline(|timeline| frames_between(path, timeline, from, to));
    frames.unwrap()
}

#[test]
fn copied_text_keeps_the_times() {
    let document = flight(7);
    for points in [vec![0, 1], vec![1, 2, 3, 5], vec![2, 6], vec![0, 3, 6]] {
        let text = document.points_as_text(&points).unwrap();
        let copied = Document::points_of_text(&text).unwrap().unwrap();
        for (now, pair) in points.windows(2).enumerate() {
            let before = frames(&document, pair[0], pair[1]);
            assert_eq!(frames(&copied, now, now + 1), before, "{points:?}");
        }
    }
}

#[test]
fn at_another_rate_the_whole_takes_as_long() {
    for fps in [24.0, 25.0, 29.97, 60.0, 120.0] {
        let copied = flight(7);
        let info = Info {
            fps,
            ..Info::default()
        };
        let path = CameraPath::default();
        let mut document = Document::from_parts(path, info).unwrap();
        document.paste_points(0, &copied, false).unwrap();
        let seconds = frames(&document, 1, 7) as f64 / fps;
        let before = frames(&copied, 0, 6) as f64 / copied.info().fps;
        assert!(
            (seconds - before).abs() <= 0.5 / fps + 1e-12,
            "{fps} {seconds} {before}"
        );
    }
}

#[test]
fn what_cannot_be_removed_changes_nothing() {
    let mut document = flight(4);
    let state = document.state_number();
    assert!(document.remove_points(&[0, 1, 2]).is_err());
    assert!(document.remove_points(&[9]).is_err());
    assert_eq!(document.state_number(), state);
    document.remove_points(&[1]).unwrap();
    assert!(document.undo());
    assert_eq!(document.state_number(), state);
}
