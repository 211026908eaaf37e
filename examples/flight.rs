//! A flight round an object, written for another program, one pose a line:
//!
//! ```sh
//! cargo run --example flight
//! ```

use vides::glam::DVec3;
use vides::math::camera::CameraAxes;
use vides::path::{CameraPath, Up};

fn main() -> vides::Result<()> {
    let corners = [
        [4.0, 0.0, 1.0],
        [0.0, 5.0, 2.0],
        [-4.0, 0.0, 3.0],
        [0.0, -5.0, 2.0],
    ];
    let path = CameraPath::through(corners.map(DVec3::from))
        .looking_at(DVec3::new(0.0, 0.0, 1.0))
        .up(Up::Z)
        .zoom(35.0)
        .closed()
        .frames(200)
        .build()?;
    for (frame, pose) in path.sampler()?.iter().enumerate() {
        let pose = pose?;
        let matrix = pose.to_world(CameraAxes::OpenGl)?;
        println!(
            "{} {:.3} {:?}",
            frame + 1,
            pose.field_of_view(),
            matrix.to_cols_array()
        );
    }
    Ok(())
}
