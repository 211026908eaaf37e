//! The orientations of support points.

use std::ffi::{CStr, c_char, c_int};
use std::ptr::null_mut;

use glam::DVec3;

use super::border::border;
use super::path::{edit, edit_by, insert, read};
use super::pointers::{
    Growing, GrowingOut, Out, count, index, init, optional, read_growing, read_vector, text,
};
use super::points::point;
use super::status::{Answer, V_ERR_INTERNAL};
use super::types::{V_ORIENTATION, V_PATH};
use crate::document::{Document, Edit, Info};
use crate::error::{Invalid, OutOfRange, Refused};
use crate::path::{
    Orientation, OrientationOverrides, Overrides, Target, Tcb, Up, UpPath, UpVector,
};

fn to_c(orientation: &Orientation) -> V_ORIENTATION {
    let (absolute, target) = match orientation.target {
        Target::Absolute(target) => (1, target),
        Target::Relative(target) => (0, target),
    };
    V_ORIENTATION {
        size: size_of::<V_ORIENTATION>(),
        absolute,
        target: target.to_array(),
        roll: orientation.roll,
        zoom: orientation.zoom,
        tension: orientation.turning.tension,
        continuity: orientation.turning.continuity,
        bias: orientation.turning.bias,
        speed: orientation.speeds,
        // At most MAX_HOLD, which fits.
        hold: c_int::try_from(orientation.hold).unwrap_or(c_int::MAX),
    }
}

// SAFETY: `repr(C)` with `size` first; numbers only.
unsafe impl Growing for V_ORIENTATION {
    const NAME: &'static str = "V_ORIENTATION";
    const FIRST: usize = size_of::<V_ORIENTATION>();
    const DEFAULTS: Self = Self {
        size: size_of::<V_ORIENTATION>(),
        absolute: 0,
        target: [0.0, 0.0, -0.4],
        roll: 0.0,
        zoom: 24.0,
        tension: 0.0,
        continuity: 0.0,
        bias: 0.0,
        speed: [50.0; 10],
        hold: 0,
    };
}

/// Converts an orientation from C without checking its values.
fn from_c(o: &V_ORIENTATION) -> Answer<Orientation> {
    let target = DVec3::from_array(o.target);
    Ok(Orientation {
        target: if o.absolute == 0 {
            Target::Relative(target)
        } else {
            Target::Absolute(target)
        },
        roll: o.roll,
        zoom: o.zoom,
        turning: Tcb::new(o.tension, o.continuity, o.bias),
        speeds: o.speed,
        hold: u32::try_from(o.hold).map_err(|_| OutOfRange::Hold)?,
        own: Overrides::default(),
    })
}

/// Changes an orientation named by C's indices.
fn change(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
    change: impl FnOnce(&mut Orientation) -> Answer<()>,
) -> Answer<c_int> {
    edit_by(path, |document| {
        let mut orientation = orientation(document, point, at)?.clone();
        change(&mut orientation)?;
        Ok(Edit::SetOrientation {
            point: index(point, "point")?,
            at: index(at, "at")?,
            orientation,
        })
    })
}

/// Changes the overrides of an orientation.
fn change_own(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
    set: impl FnOnce(&mut OrientationOverrides),
) -> Answer<c_int> {
    change(path, point, at, |orientation| {
        orientation.own = orientation.own.with(set)?;
        Ok(())
    })
}

/// An orientation named by C's indices.
fn orientation(document: &Document, point: c_int, at: c_int) -> Answer<&Orientation> {
    let (point, support) = self::point(document, point, "point")?;
    let (orientation, all) = (index(at, "at")?, &support.orientations);
    all.get(orientation).ok_or_else(|| {
        let last = all.len() - 1;
        Refused::NoOrientation {
            orientation,
            point,
            last,
        }
        .into()
    })
}

///
/// # Safety
/// `o` is NULL or points to a struct as its `size` says.
unsafe fn read_orientation(o: *const V_ORIENTATION) -> Answer<Orientation> {
    // SAFETY: as required of the caller.
    from_c(&unsafe { read_growing(o, "o") }?)
}

/// ==== Orientations: how the camera looks at a point ====
///
/// Fills in an orientation: relative target (0, 0, -0.4), roll 0, zoom 24, tension,
/// continuity and bias 0, all speeds 50, hold 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_orientation_init(o: *mut V_ORIENTATION) {
    border((), || {
        // SAFETY: room for the struct of version 1.0, as the header says.
        unsafe { init(o, V_ORIENTATION::DEFAULTS, V_ORIENTATION::FIRST, "o") }
    });
}

/// Gets the number of orientations of a point, 1 to 10. The camera arrives in the
/// first, turns from one to the next, and leaves in the last.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_orientation_count(
    path: *const V_PATH,
    point: c_int,
    count: *mut c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(count, "count")?;
        let orientations = read(path, |document| {
            self::count(self::point(document, point, "point")?.1.orientations.len())
        })?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(orientations) }
    })
}

/// Inserts an orientation before index at; if at is their number, appends it. NULL
/// copies the one before it, or the first one if at is 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_insert_orientation(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
    o: *const V_ORIENTATION,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a struct as its size says, as the header demands.
        let orientation = optional(o, |o| unsafe { read_orientation(o) })?;
        let (point, at) = (index(point, "point")?, index(at, "at")?);
        edit(
            path,
            Edit::InsertOrientation {
                point,
                at,
                orientation,
            },
        )
    })
}

/// Removes an orientation. The only one of a point cannot be removed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_remove_orientation(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (point, at) = (index(point, "point")?, index(at, "at")?);
        edit(path, Edit::RemoveOrientation { point, at })
    })
}

/// Sets all values of an orientation. Settings that V_ORIENTATION does not have (ease,
/// distance curve, fixed frames, looking ahead, up) are unchanged.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_orientation(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
    o: *const V_ORIENTATION,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a struct as its size says, as the header demands.
        let mut values = unsafe { read_orientation(o) }?;
        change(path, point, at, |old| {
            // Keep what C's struct does not have.
            values.own = std::mem::take(&mut old.own);
            *old = values;
            Ok(())
        })
    })
}

/// Gets the values of an orientation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_orientation(
    path: *const V_PATH,
    point: c_int,
    at: c_int,
    o: *mut V_ORIENTATION,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a struct as its size says, as the header demands.
        let out = unsafe { GrowingOut::new(o, "o") }?;
        let values = read(path, |document| Ok(to_c(orientation(document, point, at)?)))?;
        // SAFETY: as above.
        unsafe { out.answer(values) }
    })
}

/// Makes the target of an orientation absolute (not 0) or relative (0). The view does
/// not change.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_absolute(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
    absolute: c_int,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (point, at) = (index(point, "point")?, index(at, "at")?);
        edit(
            path,
            Edit::SetAbsolute {
                point,
                at,
                absolute: absolute != 0,
            },
        )
    })
}

/// Sets which way is up for an orientation, before its roll.
///
/// up  "axis"     the up axis of the space, the default
///     "point"    towards up_point
///     "path"     towards the position on up_path at the same fraction of its length
///     "minimal"  starts with the up axis and is carried on without turning about the
///                view, through all consecutive orientations that have it; on a closed
///                path, the angle missing at the end is spread over the length
///     "frenet"   the normal of the curve, only of kind "cubic" without custom tangents
///     "y", "z"   this axis, whatever the space's up axis
/// Arguments that an up does not need may be NULL. A path has at most 10 different up
/// paths of at most 1000 points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_up(
    path: *mut V_PATH,
    point: c_int,
    at: c_int,
    up: *const c_char,
    up_point: *const f64,
    up_path: *const V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a string or NULL, as the header demands.
        let up = match unsafe { text(up, "up") }? {
            "axis" => UpVector::Axis,
            "minimal" => UpVector::Minimal,
            "frenet" => UpVector::Frenet,
            "y" => UpVector::Fixed(Up::Y),
            "z" => UpVector::Fixed(Up::Z),
            // SAFETY: three doubles or NULL, as the header demands.
            "point" => UpVector::Point(unsafe { read_vector(up_point, "up_point") }?),
            "path" => UpVector::Path(
                read(up_path, |document| Ok(UpPath::of(document.path())?))
                    .map_err(|failure| failure.named("up_path"))?,
            ),
            other => return Err(Invalid::NoUp(other.into()).into()),
        };
        change_own(path, point, at, |own| own.up = up)
    })
}

const UPS: [&CStr; 7] = [
    c"axis", c"point", c"path", c"minimal", c"frenet", c"y", c"z",
];

/// Gets the up of an orientation (a constant text), the point of "point" or zeros,
/// and an open path with the curve of "path", which you free, or NULL.
/// cbindgen:ptrs-as-arrays=[[up_point; 3]]
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_up(
    path: *const V_PATH,
    point: c_int,
    at: c_int,
    up: *mut *const c_char,
    up_point: *mut f64,
    up_path: *mut *mut V_PATH,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let (name, place) = (
            Out::optional(up, "up")?,
            Out::optional_array(up_point, "up_point")?,
        );
        let made = Out::optional(up_path, "up_path")?;
        let (found, space) = read(path, |document| {
            let own = &orientation(document, point, at)?.own;
            Ok((own.up.clone(), document.path().space))
        })?;
        let (position, handle) = match &found {
            UpVector::Point(position) => (*position, null_mut()),
            UpVector::Path(curve) if !up_path.is_null() => {
                let document = Document::from_parts(curve.as_path(space)?, Info::default())?;
                (DVec3::ZERO, insert(document)?)
            }
            _ => (DVec3::ZERO, null_mut()),
        };
        let known = |text: &&&CStr| text.to_bytes() == found.name().as_bytes();
        let text = UPS.iter().find(known).unwrap_or(&UPS[0]);
        // SAFETY: room for two pointers and three doubles, as the header says.
        unsafe {
            name.write(text.as_ptr());
            place.write(position.to_array());
            made.answer(handle)
        }
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_names_of_ups_are_those_of_the_engine() {
        let names = super::UPS.map(|name| name.to_str().unwrap());
        assert_eq!(names, crate::path::UpVector::NAMES);
    }
}
