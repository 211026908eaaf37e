//! What one may choose when a file is written or read: the command's long options and C's.

use vides_engine::limits::{MAX_FPS, MAX_HALF_SIZE};
use vides_engine::path::Up;

use super::error::{Error, Result};

/// The most decimals of a line: what is worth writing in the smallest spaces that are used.
pub const MAX_DECIMALS: usize = 30;

/// The size of a picture where neither file nor user says.
pub(super) const DEFAULT_SIZE: [u32; 2] = [1920, 1080];

/// What the motion of a camera becomes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum As {
    /// A path of few points, fitted.
    Path,
    /// A camera with one key for each pose.
    Keys,
}

/// When poses are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Times {
    /// At each frame.
    Frames,
    /// At the camera's own keys: those of a list come back at their times.
    Own,
}

/// What was chosen; the default is what holds without a word.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The node that is written; none: the shown camera.
    pub node: Option<String>,
    /// The animation that is read; none: all that move different things.
    pub clip: Option<String>,
    /// First and last frame, in the numbers that people see; none: all of the range.
    pub frames: Option<(f64, f64)>,
    /// Frames per second; none: those of the document, of a file that is read its own, else 25.
    pub fps: Option<f64>,
    /// When poses are written; none: at each frame.
    pub times: Option<Times>,
    /// The time of the first pose in formats whose poses have times, in seconds; none: 0.
    pub start: Option<f64>,
    /// Width and height of a picture in pixels; none: 1920 × 1080; a file that is read
    /// may say it itself.
    pub size: Option<[u32; 2]>,
    /// Which axis is up in the file; none: as the format says.
    pub up: Option<Up>,
    /// Lengths in the file for one of the document's; > 0.
    pub scale: f64,
    /// What the camera's motion becomes; none: of a list of poses a path, keys stay keys.
    pub as_: Option<As>,
    /// How far a fitted path may be from the positions; none: 1/1000 of their bounds' diagonal.
    pub tolerance: Option<f64>,
    /// By how many degrees its views and fields of view may be off.
    pub angle: f64,
    /// How far curves of few keys may be from the motion; none: a key for each frame.
    pub compact: Option<f64>,
    /// Decimals of ASCII lines; none: 4.
    pub digits: Option<usize>,
    /// The order of the turns in `.chan` files: numbers of axes, the first turn first.
    pub rotation_order: [usize; 3],
}

impl Default for Options {
    fn default() -> Self {
        Self {
            node: None,
            clip: None,
            frames: None,
            fps: None,
            times: None,
            start: None,
            size: None,
            up: None,
            scale: 1.0,
            as_: None,
            tolerance: None,
            angle: 0.5,
            compact: None,
            digits: None,
            rotation_order: [2, 0, 1],
        }
    }
}

/// An option's names and meaning.
pub struct OptionRow {
    /// The long name, without dashes.
    pub name: &'static str,
    /// What stands for its value.
    pub value: &'static str,
    /// What it does.
    pub help: &'static str,
    /// What values it takes.
    wanted: &'static str,
    set: fn(&mut Options, &str) -> Option<()>,
}

impl OptionRow {
    /// Whether it takes this value.
    ///
    /// # Errors
    /// What it takes, as a sentence.
    pub fn check(&self, value: &str) -> Result<(), String> {
        let may = (self.set)(&mut Options::default(), value);
        may.ok_or_else(|| format!("{} is wanted", self.wanted))
    }
}

/// All options, in the order of the manual.
pub const OPTIONS: &[OptionRow] = &[
    OptionRow {
        name: "node",
        value: "NAME",
        help: "The node of a scene that is written [default: the shown camera]",
        wanted: "the name of a node",
        set: |options, text| {
            options.node = Some(text.to_owned());
            Some(())
        },
    },
    OptionRow {
        name: "clip",
        value: "NAME",
        help: "The animation of a glTF file that is read [default: all that move different things]",
        wanted: "the name of an animation",
        set: |options, text| {
            options.clip = Some(text.to_owned());
            Some(())
        },
    },
    OptionRow {
        name: "frames",
        value: "A..B",
        help: "The frames that are written, first and last, as people count them [default: all]",
        wanted: "two frames, as 1..250,",
        set: |options, text| {
            let (first, last) = text.split_once("..")?;
            let (first, last) = (number(first)?, number(last)?);
            options.frames = Some((first, last));
            (first <= last).then_some(())
        },
    },
    OptionRow {
        name: "fps",
        value: "NUMBER",
        help: "Frames per second of what is written, in the same time; of a file that has none \
               when it is read",
        wanted: "a number greater than 0 and at most 100000",
        set: |options, text| {
            options.fps = Some(number(text).filter(|fps| *fps > 0.0 && *fps <= MAX_FPS)?);
            Some(())
        },
    },
    OptionRow {
        name: "times",
        value: "WHEN",
        help: "frames: a pose for each frame; own: at the keys of the camera, for tum, euroc, osg, \
               kitti and matrices [default: own where a list becomes a list, without --fps and --frames]",
        wanted: "frames or own",
        set: |options, text| {
            options.times = Some(match text {
                "frames" => Times::Frames,
                "own" => Times::Own,
                _ => return None,
            });
            Some(())
        },
    },
    OptionRow {
        name: "start",
        value: "SECONDS",
        help: "The time of the first pose in files of the formats tum, euroc and osg \
               [default: that of a list that becomes a list, else 0]",
        wanted: "a number of seconds, at most 1e12,",
        set: |options, text| {
            // So that two frames are two times.
            options.start = Some(number(text).filter(|start| start.abs() <= 1e12)?);
            Some(())
        },
    },
    OptionRow {
        name: "size",
        value: "WxH",
        help: "Width and height of the picture in pixels [default: 1920x1080]",
        wanted: "two whole numbers from 1 to 65535, as 1920x1080,",
        set: |options, text| {
            let (width, height) = text.split_once('x')?;
            let side = |text: &str| text.parse::<u16>().ok().filter(|side| *side > 0);
            options.size = Some([side(width)?.into(), side(height)?.into()]);
            Some(())
        },
    },
    OptionRow {
        name: "up",
        value: "AXIS",
        help: "The up axis of the file [default: as the format says]",
        wanted: "y or z",
        set: |options, text| {
            options.up = Some(Up::named(text)?);
            Some(())
        },
    },
    OptionRow {
        name: "scale",
        value: "NUMBER",
        help: "Lengths in the file for one of the path's [default: 1]",
        wanted: "a number between 1e-30 and 1e30",
        set: |options, text| {
            let sane = |scale: &f64| *scale > 1.0 / MAX_HALF_SIZE && *scale < MAX_HALF_SIZE;
            options.scale = number(text).filter(sane)?;
            Some(())
        },
    },
    OptionRow {
        name: "as",
        value: "KIND",
        help: "What the camera's motion becomes: a path of few points (path) or keys (keys) \
               [default: of a list of poses a path; keys stay keys]",
        wanted: "path or keys",
        set: |options, text| {
            options.as_ = Some(match text {
                "path" => As::Path,
                "keys" => As::Keys,
                _ => return None,
            });
            Some(())
        },
    },
    OptionRow {
        name: "tolerance",
        value: "LENGTH",
        help: "How far a fitted path may be from the positions [default: 1/1000 of the diagonal \
               of their bounds]",
        wanted: "a length greater than 0",
        set: |options, text| {
            options.tolerance = Some(positive(text)?);
            Some(())
        },
    },
    OptionRow {
        name: "angle",
        value: "DEGREES",
        help: "How far its view, up and field of view may be from theirs [default: 0.5]",
        wanted: "a number of degrees from 0 to 180",
        set: |options, text| {
            options.angle = positive(text).filter(|angle| *angle <= 180.0)?;
            Some(())
        },
    },
    OptionRow {
        name: "compact",
        value: "LENGTH",
        help: "Curves of few keys that stay this near, for formats that have curves [default: a \
               key for each frame]",
        wanted: "a length greater than 0",
        set: |options, text| {
            options.compact = Some(positive(text)?);
            Some(())
        },
    },
    OptionRow {
        name: "digits",
        value: "NUMBER",
        help: "Decimals of the format ascii, at most 30 [default: 4]",
        wanted: "a whole number from 0 to 30",
        set: |options, text| {
            let digits = text.parse().ok();
            options.digits = Some(digits.filter(|digits| *digits <= MAX_DECIMALS)?);
            Some(())
        },
    },
    OptionRow {
        name: "rotation-order",
        value: "AXES",
        help: "The order of the turns in files of the format chan [default: zxy]",
        wanted: "x, y and z in some order, as zxy,",
        set: |options, text| {
            let mut order = [0; 3];
            for axis in 0..3 {
                let axis_name = ["x", "y", "z"][axis];
                let at = text.find(axis_name).filter(|_| text.len() == 3)?;
                order[at] = axis;
            }
            options.rotation_order = order;
            Some(())
        },
    },
];

fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

fn positive(text: &str) -> Option<f64> {
    number(text).filter(|number| *number > 0.0)
}

impl Options {
    /// Chooses by name, as in `--name value`.
    ///
    /// # Errors
    /// [`Error::NoOption`], [`Error::Value`]; nothing has changed then.
    pub fn set(&mut self, name: &str, value: &str) -> Result<()> {
        let row = OPTIONS.iter().find(|row| row.name == name);
        let row = row.ok_or_else(|| Error::NoOption(name.into()))?;
        let mut changed = self.clone();
        (row.set)(&mut changed, value).ok_or_else(|| Error::Value {
            name: row.name,
            wanted: row.wanted,
            given: value.into(),
        })?;
        *self = changed;
        Ok(())
    }

    /// What lines of `name=value` choose; empty lines choose nothing.
    ///
    /// # Errors
    /// As [`Options::set`].
    pub fn parse(lines: &str) -> Result<Self> {
        let mut options = Self::default();
        for line in lines.lines().filter(|line| !line.trim().is_empty()) {
            let (name, value) = line.split_once('=').unwrap_or((line, ""));
            options.set(name.trim(), value.trim())?;
        }
        Ok(options)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_choose() {
        let options = Options::parse("fps=30\n\nframes = -5..12.5\nsize=640x480\nup=z\n").unwrap();
        assert_eq!(
            (options.fps, options.frames),
            (Some(30.0), Some((-5.0, 12.5)))
        );
        assert_eq!((options.size, options.up), (Some([640, 480]), Some(Up::Z)));
        assert_eq!(
            Options::parse("rotation-order=xyz").unwrap().rotation_order,
            [0, 1, 2]
        );
        for (line, said) in [
            (
                "fps=0",
                "fps: a number greater than 0 and at most 100000 is wanted, not \"0\"",
            ),
            (
                "frames=3..1",
                "frames: two frames, as 1..250, is wanted, not \"3..1\"",
            ),
            (
                "rotation-order=xxy",
                "rotation-order: x, y and z in some order, as zxy, is wanted, not \"xxy\"",
            ),
            (
                "size=0x3",
                "size: two whole numbers from 1 to 65535, as 1920x1080, is wanted, not \"0x3\"",
            ),
            (
                "angle=nan",
                "angle: a number of degrees from 0 to 180 is wanted, not \"nan\"",
            ),
            ("as", "as: path or keys is wanted, not \"\""),
        ] {
            assert_eq!(Options::parse(line).unwrap_err().to_string(), said);
        }
        let unknown = Options::parse("speed=1").unwrap_err().to_string();
        assert!(
            unknown.starts_with("there is no option \"speed\"; options are node, clip, frames")
        );
    }
}
