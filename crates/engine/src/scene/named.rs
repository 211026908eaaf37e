//! Channels and interpolations of the names that callers and files give.

use super::channel::{self, Channel};
use super::host;
use super::interpolation::{self, Interpolation};
use crate::error::{Invalid, OutOfRange, Result};
use crate::limits::{MAX_CHANNEL_WIDTH, MAX_NAME_BYTES};
use crate::path::checks::check_name;

impl Channel {
    /// By its name: `position`, `deformation.2.angle`, `value:radius`, `value:wind:3` (width 3).
    ///
    /// # Errors
    /// [`crate::Error::Argument`], [`crate::Error::Range`] or [`crate::Error::Limit`].
    pub fn parse(name: &str) -> Result<Self> {
        if let Some((_, channel)) = channel::PLAIN.iter().find(|(plain, _)| *plain == name) {
            return Ok(channel.clone());
        }
        if let Some(rest) = name.strip_prefix("value:") {
            return Self::parse_value(rest);
        }
        if let Some(rest) = name.strip_prefix("deformation.")
            && let Some((at, parameter)) = rest.split_once('.')
            && let Some(at) = whole(at)
            && parameter.len() <= MAX_NAME_BYTES
        {
            return Ok(Self::Deformation {
                at,
                parameter: parameter.to_owned(),
            });
        }
        check_name(name)?;
        Err(Invalid::NoChannel(name.into()).into())
    }

    fn parse_value(rest: &str) -> Result<Self> {
        let (name, width) = match rest.split_once(':') {
            Some((name, width)) => (name, whole(width)),
            None => (rest, Some(1)),
        };
        check_name(name)?;
        if name.is_empty() {
            return Err(Invalid::ChannelWithoutName.into());
        }
        match width {
            Some(width) if (1..=MAX_CHANNEL_WIDTH).contains(&width) => Ok(Self::Value {
                name: name.to_owned(),
                width,
            }),
            _ => Err(OutOfRange::ChannelWidth.into()),
        }
    }
}

/// A whole number in its one spelling: digits without leading zeros.
fn whole(digits: &str) -> Option<usize> {
    let plain = digits.bytes().all(|byte| byte.is_ascii_digit());
    let number = digits.parse().ok()?;
    (plain && (digits.len() == 1 || !digits.starts_with('0'))).then_some(number)
}

impl Interpolation {
    /// An interpolation by its name.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] or [`crate::Error::Limit`].
    pub fn parse(name: &str) -> Result<Self> {
        if let Some((_, plain)) = interpolation::PLAIN
            .iter()
            .find(|(plain, _)| *plain == name)
        {
            return Ok(plain.clone());
        }
        if let Some(name) = name.strip_prefix("host:") {
            host::check_function_name(name)?;
            return Ok(Self::Host(name.to_owned()));
        }
        check_name(name)?;
        Err(Invalid::NoInterpolation(name.into()).into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_back() {
        for name in [
            "position",
            "aim_weight",
            "deformation.12.phi_min",
            "value:radius",
            "value:wind:3",
        ] {
            assert_eq!(Channel::parse(name).unwrap().to_string(), name);
        }
        let one = Channel::parse("value:a:1").unwrap();
        assert_eq!(one.to_string(), "value:a");
        assert!(one.same_as(&Channel::parse("value:a:16").unwrap()));
        for wrong in [
            "",
            "Position",
            "value:",
            "value:a:0",
            "value:a:17",
            "value:a:b:2",
            "value:a\n",
            "deformation.x.angle",
            "deformation.01.angle",
            "deformation.1",
        ] {
            assert!(Channel::parse(wrong).is_err(), "{wrong}");
        }
    }
}
