//! Poses that were recorded become a path of few points, which is changed and saved:
//!
//! ```sh
//! cargo run --example recording -- OUT.vid
//! ```

use std::path::Path;

use vides::document::{Document, Edit, Info};
use vides::glam::{DQuat, DVec3};
use vides::path::Pose;
use vides::tools::fit::{Tolerance, fit};

fn main() -> vides::Result<()> {
    // A camera on a helix, as a tracker might have seen it.
    let poses: Vec<Pose> = (0..250)
        .map(|frame| {
            let angle = 0.02 * f64::from(frame);
            let position = DVec3::new(angle.sin(), 0.1 * angle, angle.cos());
            Pose::new(position, DQuat::from_rotation_y(angle), 30.0)
        })
        .collect();
    let tolerance = Tolerance {
        position: 0.002,
        angle: 0.2,
    };
    let fitted = fit(&poses, None, 25.0, &tolerance.into(), &mut |_, _| true)?;
    let mut document = Document::from_parts(fitted.path, Info::default())?;
    let last = document.path().points.len() - 1;
    println!("{} poses became {} points", poses.len(), last + 1);
    document.apply(Edit::FitFrames {
        first: 0,
        last,
        frames: 500,
    })?;
    if let Some(file) = std::env::args_os().nth(1) {
        document.save(Path::new(&file))?;
    }
    Ok(())
}
