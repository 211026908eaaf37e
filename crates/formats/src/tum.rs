//! Trajectories of the TUM RGB-D benchmark (Sturm et al. 2012): a line `t x y z qx qy qz qw` a pose,
//! seconds and camera to world; the camera has x right, y down, z forward. `#` begins a comment.

use std::io::Write;

use glam::{DQuat, DVec3};
use vides_engine::math::camera::CameraAxes;

use super::content::{Content, DEFAULT_ZOOM, Recording};
use super::convention;
use super::error::{Cause, Place, Result};
use super::euroc;
use super::flight::Flight;
use super::format::Format;
use super::loss::{Loss, Report};
use super::rows;
use super::source::Source;

pub(super) static TUM: Format = Format {
    name: "tum",
    title: "TUM",
    endings: &["tum"],
    recognises: |source| {
        let beginning = source.beginning();
        rows::first(beginning).is_some_and(rows::turns_last) && !euroc::has_heading(beginning)
    },
    read: Some(|source, _, report| read(source, CameraAxes::OpenCv, report)),
    write: Some(|flight, out, report| {
        let head = b"# timestamp tx ty tz qx qy qz qw\n";
        write(flight, head, CameraAxes::OpenCv, out, report)
    }),
    own_times: true,
    ..Format::PLAIN
};

/// The poses of lines `t x y z qx qy qz qw`, of cameras with these axes.
pub(super) fn read(source: &Source, axes: CameraAxes, report: &mut Report) -> Result<Content> {
    let mut trajectory = Trajectory::default();
    for (place, row) in rows::rows(source.text()?) {
        let [t, x, y, z, turn @ ..] = rows::numbers::<8>(&place, row)?;
        let (position, turn) = (DVec3::new(x, y, z), DQuat::from_array(turn));
        trajectory.push(place, t, position, turn, axes)?;
    }
    Ok(trajectory.content(report))
}

/// Poses with their times; of poses at the same time the first counts.
#[derive(Default)]
pub(super) struct Trajectory {
    pub(super) recording: Recording,
    seconds: Vec<f64>,
    repeated: usize,
}

impl Trajectory {
    /// Appends the pose of a line.
    ///
    /// # Errors
    /// [`Cause::Order`] if the time is before the last one; [`Cause::NoRotation`].
    pub(super) fn push(
        &mut self,
        place: Place,
        seconds: f64,
        position: DVec3,
        turn: DQuat,
        axes: CameraAxes,
    ) -> Result<()> {
        match self.seconds.last() {
            Some(&before) if seconds < before => return Err(place.wrong(Cause::Order)),
            Some(&before) if seconds == before => {
                self.repeated += 1;
                return Ok(());
            }
            _ => {}
        }
        let pose = place.pose(position, turn, axes, DEFAULT_ZOOM)?;
        self.recording.push(pose)?;
        self.seconds.try_reserve(1)?;
        self.seconds.push(seconds);
        Ok(())
    }

    pub(super) fn content(mut self, report: &mut Report) -> Content {
        report.count(self.repeated, Loss::RepeatedTimes);
        report.add(Loss::FieldOfView);
        self.recording.seconds = Some(self.seconds);
        Content::Poses(self.recording)
    }
}

/// Writes `head`, then the lines that [`read`] takes.
pub(super) fn write(
    flight: &mut Flight<'_>,
    head: &[u8],
    axes: CameraAxes,
    out: &mut dyn Write,
    report: &mut Report,
) -> Result<()> {
    report.add(Loss::FieldOfView);
    flight.write_poses(head.into(), out, |flight, text, index, pose| {
        let turn = convention::rotation(pose, axes).to_array();
        let place = [flight.time(index)].into_iter().chain(pose.vrp);
        rows::push(text, place.chain(turn), " ");
        text.push(b'\n');
    })
}

#[cfg(test)]
mod tests {
    use crate::{As, Options, Source, Times, by_name, export_to, import};

    /// Stamps in nanoseconds or microseconds make the film that the same ones in seconds make, and
    /// this is said; in other lists, too.
    #[test]
    fn stamps_may_count_nanoseconds_or_microseconds() {
        let film = |name: &str, row: &dyn Fn(usize) -> String| {
            let lines: Vec<String> = (0..40).map(row).collect();
            let source = Source::of_bytes(name, lines.join("\n").into_bytes());
            let read = import(&source, None, &Options::default()).unwrap();
            let losses: Vec<String> = read
                .report
                .losses()
                .iter()
                .map(ToString::to_string)
                .collect();
            let frames = read.document.scene.frame_count().unwrap();
            (
                read.start.unwrap(),
                read.document.info.fps,
                frames,
                losses.join("; "),
            )
        };
        let place = |k: usize| format!("{} 0.5 0 0 0 0 1", (0.1 * k as f64).sin());
        let seconds = film("a.tum", &|k| {
            format!("{:.2} {}", 1.7e9 + 0.05 * k as f64, place(k))
        });
        assert_eq!((seconds.1, seconds.2), (20.0, 40));
        assert!(!seconds.3.contains("count nanoseconds"));
        let units = [(50_000_000, 9, "nanoseconds"), (50_000, 6, "microseconds")];
        for (step, digits, unit) in units {
            let first = 1_700_000_000 * 10_i64.pow(digits);
            let stamp = |k: usize| first + step * k as i64;
            let made = film("a.tum", &|k| format!("{} {}", stamp(k), place(k)));
            let heading = |k: usize| format!("{k},{},0.5,0,0,0,1,0,1,0,30", (0.1 * k as f64).sin());
            let listed = film("a.csv", &|k| format!("{},{}", heading(k), stamp(k)));
            for made in [made, listed] {
                assert!((made.0 - seconds.0).abs() < 1e-6, "{}", made.0);
                assert_eq!((made.1, made.2), (seconds.1, seconds.2), "{unit}");
                let said = format!("times beyond 1e11 are no seconds: they count {unit}");
                assert!(made.3.contains(&said), "{}", made.3);
            }
        }
    }

    /// A list with uneven times of today comes back line by line.
    #[test]
    fn own_times_come_back() {
        let lines = [
            "1305031102.1758 1 2 3 0 0 0 1",
            "1305031102.2113 1.5 2 3 0 0 0.6 0.8",
            "1305031102.3 1.25 2 3 0 0 1 0",
            "1305031103.9 1.75 2.5 3 0.6 0 0.8 0",
        ];
        let keys = Options {
            as_: Some(As::Keys),
            ..Options::default()
        };
        let read = import(
            &Source::of_bytes("a.tum", lines.join("\n").into_bytes()),
            None,
            &keys,
        )
        .unwrap();
        let options = Options {
            times: Some(Times::Own),
            start: read.start,
            ..keys
        };
        let written = |options: &Options, name: &str| {
            let mut out = Vec::new();
            let done = export_to(
                &read.document,
                &mut out,
                by_name(name).unwrap(),
                options,
                &mut |_, _| {},
            );
            done.map(|_| String::from_utf8(out).unwrap())
                .map_err(|error| error.to_string())
        };
        let text = written(&options, "tum").unwrap();
        let rows = |text: &str| -> Vec<Vec<f64>> {
            let lines = text.lines().filter(|line| !line.starts_with('#'));
            lines
                .map(|line| line.split(' ').map(|word| word.parse().unwrap()).collect())
                .collect()
        };
        let (was, is) = (rows(&lines.join("\n")), rows(&text));
        assert_eq!(was.len(), is.len());
        for (was, is) in was.iter().zip(&is) {
            // What the rounding of such stamps hides was a whole frame.
            assert!((was[0] - is[0]).abs() < 2.4e-6, "{} {}", was[0], is[0]);
            // Both signs of a quaternion are the same rotation.
            let sign = (4..8).map(|at| was[at] * is[at]).sum::<f64>().signum();
            let is = is[1..4]
                .iter()
                .copied()
                .chain(is[4..].iter().map(|part| sign * part));
            for (was, is) in was[1..].iter().zip(is) {
                assert!((was - is).abs() < 1e-12, "{was} {is}");
            }
        }
        assert_eq!(written(&options, "kitti").unwrap().lines().count(), 4);
        let refused =
            "times=own is for the formats tum, euroc, osg, kitti and matrices, without fps";
        assert_eq!(written(&options, "chan").unwrap_err(), refused);
        let fps = Options {
            fps: Some(10.0),
            ..options
        };
        assert_eq!(written(&fps, "tum").unwrap_err(), refused);
    }
}
