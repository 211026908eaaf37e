//! The ways of a track from one key to the next, by name.

use std::fmt;

use super::channel::Channel;

/// How a track goes from one key to the next.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Interpolation {
    /// The last key's value.
    Step,
    /// Straight; rotations by the shorter great arc.
    Linear,
    /// 3u²−2u³ of the way.
    Ramp,
    /// (1 − cos πu)/2 of the way (lecture 9.2.1).
    Sine,
    /// 2u², then 1−2(1−u)² of the way (lecture 9.2.1).
    Parabolic,
    /// C¹ in time, with quadratic ends.
    CatmullRom,
    /// Given tangents; rotations componentwise, normalised.
    Hermite,
    /// Kochanek and Bartels, weighted for unequal times.
    Tcb,
    /// C²: natural, or periodic where the track repeats and ends as it begins.
    Cubic,
    /// Rotations by yaw, pitch and roll in degrees, straight.
    EulerLinear,
    /// The same, C¹.
    EulerCatmullRom,
    /// A function of the host's.
    Host(String),
}

pub(super) const PLAIN: [(&str, Interpolation); 11] = [
    ("step", Interpolation::Step),
    ("linear", Interpolation::Linear),
    ("ramp", Interpolation::Ramp),
    ("sine", Interpolation::Sine),
    ("parabolic", Interpolation::Parabolic),
    ("catmull-rom", Interpolation::CatmullRom),
    ("hermite", Interpolation::Hermite),
    ("tcb", Interpolation::Tcb),
    ("cubic", Interpolation::Cubic),
    ("euler-linear", Interpolation::EulerLinear),
    ("euler-catmull-rom", Interpolation::EulerCatmullRom),
];

impl Interpolation {
    /// The names of all, or of those that a channel takes.
    #[doc(hidden)]
    pub fn names(channel: Option<&Channel>) -> impl Iterator<Item = &'static str> + Clone {
        let fits = move |by: &Self| channel.is_none_or(|channel| by.fits(channel));
        let plain = PLAIN.iter().filter(move |(_, plain)| fits(plain));
        let host = fits(&Self::Host(String::new())).then_some("host:NAME");
        plain.map(|(name, _)| *name).chain(host)
    }

    pub(super) fn fits(&self, channel: &Channel) -> bool {
        match self {
            Self::Cubic => !matches!(channel, Channel::Rotation | Channel::Visible),
            Self::EulerLinear | Self::EulerCatmullRom => *channel == Channel::Rotation,
            Self::Step => true,
            _ => *channel != Channel::Visible,
        }
    }

    pub(super) const fn euler(&self) -> bool {
        matches!(self, Self::EulerLinear | Self::EulerCatmullRom)
    }
}

impl fmt::Display for Interpolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Self::Host(name) = self {
            return write!(f, "host:{name}");
        }
        let found = PLAIN.iter().find(|(_, plain)| plain == self);
        f.write_str(found.map_or("", |(name, _)| name))
    }
}
