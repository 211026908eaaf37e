//! The three files as text. An image has two lines, the second with its points, which may be empty.

use glam::{DQuat, DVec3};

use super::model::{Image, KINDS, Model, unknown_kind};
use crate::error::{Cause, Place, Result, Wanted};
use crate::rows;
use crate::source::utf8;

/// Takes the next word of a line.
fn word<'a>(line: &mut &'a str) -> Option<&'a str> {
    let text = line.trim_start();
    let end = text.find(char::is_whitespace).unwrap_or(text.len());
    let (word, rest) = text.split_at(end);
    *line = rest;
    (!word.is_empty()).then_some(word)
}

fn whole(place: &Place, line: &mut &str) -> Result<u64> {
    let number = word(line).and_then(|word| word.parse().ok());
    number.ok_or_else(|| place.clone().expected(Wanted::WholeNumber))
}

fn number(place: &Place, line: &mut &str) -> Result<f64> {
    let number: Option<f64> = word(line).and_then(|word| word.parse().ok());
    let number = number.ok_or_else(|| place.clone().expected(Wanted::Number))?;
    if number.is_finite() {
        Ok(number)
    } else {
        Err(place.clone().wrong(Cause::NotFinite))
    }
}

fn numbers<const N: usize>(place: &Place, line: &mut &str) -> Result<[f64; N]> {
    let mut numbers = [0.0; N];
    for one in &mut numbers {
        *one = number(place, line)?;
    }
    Ok(numbers)
}

/// Lines `CAMERA_ID MODEL WIDTH HEIGHT PARAMS…`.
pub(super) fn cameras(bytes: &[u8], model: &mut Model) -> Result<()> {
    for (place, mut line) in rows::rows(utf8(bytes)?) {
        let line = &mut line;
        let id = whole(&place, line)?;
        let name = word(line).unwrap_or("");
        let kind = KINDS.iter().find(|kind| kind.name == name);
        let kind = kind.ok_or_else(|| unknown_kind(&place, name))?;
        let size = numbers::<2>(&place, line)?;
        let found = line.split_whitespace().count();
        let wanted = kind.parameters;
        if found != wanted {
            return Err(place.wrong(Cause::NumberCount { wanted, found }));
        }
        let mut parameters = [0.0; 16];
        for parameter in &mut parameters[..wanted] {
            *parameter = number(&place, line)?;
        }
        model.add_camera(id, &place, kind, size, &parameters[..wanted])?;
    }
    Ok(())
}

/// Lines `IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME`, each with one of points `X Y POINT3D_ID`
/// behind it.
pub(super) fn images(bytes: &[u8], model: &mut Model) -> Result<()> {
    let mut lines = utf8(bytes)?.lines().enumerate();
    while let Some((at, line)) = lines.next() {
        let mut line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let place = Place::Line(at + 1);
        let line = &mut line;
        whole(&place, line)?;
        let [w, x, y, z] = numbers(&place, line)?;
        let translation: [f64; 3] = numbers(&place, line)?;
        let camera = whole(&place, line)?;
        let name = line.trim();
        if name.is_empty() {
            return Err(place.expected(Wanted::Text));
        }
        let image = Image {
            name: name.to_owned(),
            rotation: DQuat::from_xyzw(x, y, z, w),
            translation: DVec3::from_array(translation),
            camera,
        };
        model.add_image(&place, image)?;
        // A file whose empty lines were dropped would lose every second image without a word.
        let Some((at, points)) = lines.next() else {
            break;
        };
        let last = points.split_whitespace().next_back();
        let is_point = last.is_none_or(|word| word.parse::<i64>().is_ok());
        if points.split_whitespace().count() % 3 != 0 || !is_point {
            return Err(Place::Line(at + 1).expected(Wanted::ImagePoints));
        }
    }
    Ok(())
}

/// Lines `POINT3D_ID X Y Z R G B ERROR TRACK…`.
pub(super) fn points(bytes: &[u8], model: &mut Model) -> Result<()> {
    for (place, mut line) in rows::rows(utf8(bytes)?) {
        whole(&place, &mut line)?;
        model.add_point(numbers(&place, &mut line)?)?;
    }
    Ok(())
}
