//! What any bytes at all may do as a `.vid` file. Used by the tests and, by
//! path, by the fuzzer in `fuzz/`, so that both ask the same.

use vides::Error;
use vides::document::Document;
use vides::path::{Pose, Sampler};

/// Frames that are looked at, from each end of the sequence.
const LOOKED_AT: usize = 64;

/// Loads bytes as a file. They are refused with one sentence, or they give a
/// document that is in order, can be saved and loaded without a bit changing,
/// and yields poses.
///
/// # Panics
/// If any of that does not hold.
pub(crate) fn check(bytes: &[u8]) {
    let mut reader = bytes;
    let document = match Document::load_from(&mut reader, "a.vid") {
        Ok(document) => document,
        Err(error) => return check_refusal(bytes, &error),
    };
    document.path().check().expect("a path in order");
    document.info().check().expect("what a file says besides");
    let text = document.to_toml().expect("a text");
    let again = Document::from_toml(&text)
        .unwrap_or_else(|error| panic!("saved and then refused: {error}\n{text}"));
    assert_eq!(content(&again), content(&document), "{text}");
    assert_eq!(again.to_toml().expect("a text"), text);
    match document.sampler() {
        Ok(sampler) => check_poses(sampler),
        Err(Error::Limit(reason)) => assert!(reason.to_string().contains("frames"), "{reason}"),
        Err(error) => panic!("a path in order gives no poses: {error}"),
    }
}

/// Everything of a document; `{:?}` tells 0 from −0 and gives every digit.
fn content(document: &Document) -> String {
    format!("{:?} {:?}", document.path(), document.info())
}

fn check_refusal(bytes: &[u8], error: &Error) {
    let sentence = error.to_string();
    assert!(!sentence.chars().any(char::is_control), "{sentence:?}");
    let said = sentence.strip_prefix("a.vid: ").expect("the file's name");
    let number = said
        .strip_prefix("line ")
        .and_then(|rest| rest.split_once(": "))
        .and_then(|(number, _)| number.parse::<usize>().ok());
    let lines = 1 + bytes.iter().filter(|&&byte| byte == b'\n').count();
    assert!(
        number.is_some_and(|number| (1..=lines).contains(&number)),
        "{sentence} (of {lines} lines)"
    );
}

fn check_poses(sampler: &Sampler) {
    let frames = sampler.frame_count();
    let mut poses = vec![Pose::default(); frames.min(LOOKED_AT)];
    for first in [1, 1 + frames - poses.len()] {
        sampler.sample(first, &mut poses).expect("poses");
        for pose in &poses {
            let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let unit = |a: [f64; 3]| (dot(a, a) - 1.0).abs() < 2e-12;
            assert!(unit(pose.vpn) && unit(pose.vup), "{pose:?}");
            assert!(dot(pose.vpn, pose.vup).abs() < 1e-12, "{pose:?}");
            assert!(pose.vrp.iter().all(|x| x.is_finite()), "{pose:?}");
            assert!((1.0..=100.0).contains(&pose.zoom), "{pose:?}");
        }
    }
}
