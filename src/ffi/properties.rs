//! Properties of paths by name.

use std::cell::UnsafeCell;
use std::ffi::{CString, c_char, c_int};
use std::fmt::{self, Write as _};
use std::sync::OnceLock;

use super::border::border;
use super::by_name::{by_name, get, get_numbers, get_text, numbers_given, set, text_given};
use super::path;
use super::pointers::{Growing, GrowingOut, Out, count, index, text};
use super::status::{Failure, V_ERR_INTERNAL};
use super::types::V_PATH;
use crate::document::{Document, Form, Given, SpaceTable, properties};
use crate::property::{Kind, Owner, list};
use crate::tools::check::FindingKind;

/// Kinds of property, and the functions for each.
///
/// V_PROPERTY_NUMBER   v_path_set_number(), v_scene_set_number()
/// V_PROPERTY_NUMBERS  v_path_set_numbers(), v_scene_set_numbers()
/// V_PROPERTY_TEXT     v_path_set_text(), v_scene_set_text()
/// V_PROPERTY_FLAG     v_path_set_flag(), v_scene_set_flag()
pub const V_PROPERTY_NUMBER: c_int = 0;
pub const V_PROPERTY_NUMBERS: c_int = 1;
pub const V_PROPERTY_TEXT: c_int = 2;
pub const V_PROPERTY_FLAG: c_int = 3;

/// What is known of a property. The texts are constant.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct v_property {
    pub size: usize,
    /// its name, with N for a number from 1 or, of nodes, a name: "point.N.view.N.zoom_mm"
    pub name: *const c_char,
    /// V_PROPERTY_...
    pub kind: c_int,
    /// how many numbers it has; 0: any number
    pub count: usize,
    /// of its numbers: "degrees", "mm", "frames", "lengths" (of your world), that of a
    /// finding, or ""
    pub unit: *const c_char,
    /// the least and the greatest number, or -INFINITY and INFINITY
    pub least: f64,
    pub most: f64,
    /// what a new path or node has, as in a file; "": nothing
    pub usual: *const c_char,
    /// what it is
    pub about: *const c_char,
}

pub type V_PROPERTY = v_property;

// SAFETY: a number of bytes first, then pointers and numbers.
unsafe impl Growing for V_PROPERTY {
    const NAME: &'static str = "V_PROPERTY";
    const FIRST: usize = size_of::<V_PROPERTY>();
}

/// A row with its texts for C.
struct Known {
    texts: [CString; 4],
    kind: c_int,
    count: usize,
    range: (f64, f64),
}

fn known() -> &'static [Known] {
    static KNOWN: OnceLock<Vec<Known>> = OnceLock::new();
    KNOWN.get_or_init(|| {
        let text = |text: &str| CString::new(text).unwrap_or_default();
        let known = |name: &str, kind: Kind, [unit, usual, about]: [&str; 3], range| Known {
            texts: [name, unit, usual, about].map(text),
            kind: match Form::of(kind) {
                Form::Number => V_PROPERTY_NUMBER,
                Form::Numbers => V_PROPERTY_NUMBERS,
                Form::Text => V_PROPERTY_TEXT,
                Form::Flag => V_PROPERTY_FLAG,
            },
            count: match Form::of(kind) {
                Form::Numbers => Form::width(kind),
                _ => 1,
            },
            range,
        };
        let all = properties().into_iter().map(|row| {
            let before = match row.owner {
                Owner::Path => "",
                Owner::Point => "point.N.",
                Owner::View => "point.N.view.N.",
                Owner::Node => "node.N.",
            };
            let texts = [row.unit.name(), &row.new, row.does];
            let range = row.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            known(&format!("{before}{}", row.key), row.kind, texts, range)
        });
        let limits = FindingKind::all().map(|kind| {
            let limit = kind.limit();
            let (name, usual) = (format!("check.{}", limit.name), limit.default.to_string());
            let about = format!("Limit of a check: {}", limit.does);
            let range = (limit.least, f64::INFINITY);
            let unit = kind.unit().replace("half sizes", "lengths");
            known(&name, Kind::Number, [&unit, &usual, &about], range)
        });
        let mut space = Vec::new();
        list(Owner::Path, &SpaceTable::NEW, &mut space);
        let space = space.iter().map(|row| {
            let texts = [row.unit.name(), &row.new, row.does];
            let range = row.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            known(&format!("space.{}", row.key), row.kind, texts, range)
        });
        all.chain(space).chain(limits).collect()
    })
}

/// ==== Properties: values of paths and scenes by their names in .vid files ====
///
/// Gets what is known of a property of paths, scenes or checks, counted from 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_property_info(at: c_int, property: *mut V_PROPERTY) -> c_int {
    border(V_ERR_INTERNAL, || {
        // SAFETY: a struct as its size says, as the header demands.
        let out = unsafe { GrowingOut::new(property, "property") }?;
        let (at, all) = (index(at, "at")?, known());
        let (what, count) = ("property", all.len());
        let found = all.get(at).ok_or(Failure::NoEntry { what, at, count })?;
        let [name, unit, usual, about] = found.texts.each_ref().map(|text| text.as_ptr());
        let property = v_property {
            size: size_of::<V_PROPERTY>(),
            name,
            kind: found.kind,
            count: found.count,
            unit,
            least: found.range.0,
            most: found.range.1,
            usual,
            about,
        };
        // SAFETY: as above.
        unsafe { out.answer(property) }
    })
}

/// Gets the number of properties that v_property_info() knows.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_property_count(count: *mut c_int) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(count, "count")?;
        let all = self::count(known().len())?;
        // SAFETY: room for an int, as the header says.
        unsafe { out.answer(all) }
    })
}

/// Writes the name of a property into a buffer of this thread; one that is too long is cut short,
/// and then no property matches.
pub(super) fn thread_key(name: fmt::Arguments<'_>) -> *const c_char {
    struct Key([u8; 128], usize);
    impl fmt::Write for Key {
        fn write_str(&mut self, s: &str) -> fmt::Result {
            let room = &mut self.0[self.1..127];
            let length = s.len().min(room.len());
            room[..length].copy_from_slice(&s.as_bytes()[..length]);
            self.1 += length;
            Ok(())
        }
    }
    thread_local! {
        static KEY: UnsafeCell<Key> = const { UnsafeCell::new(Key([0; 128], 0)) };
    }
    let mut key = Key([0; 128], 0);
    let _ = key.write_fmt(name);
    KEY.with(|buffer| {
        // SAFETY: the cell belongs to this thread, and the reference ends here.
        let buffer = unsafe { &mut *buffer.get() };
        *buffer = key;
        buffer.0.as_ptr().cast()
    })
}

/// Returns the name of a property of an orientation, counted from 0, for loops:
/// v_path_key(1, 2, "zoom") is "point.2.view.3.zoom"; with orientation -1 one of the
/// point, "point.2.position". Valid until the same thread's next call of this
/// function or v_scene_key(); "" if an argument is not valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_key(
    point: c_int,
    orientation: c_int,
    key: *const c_char,
) -> *const c_char {
    border(c"".as_ptr(), || {
        // SAFETY: a zero-terminated text, as the header says.
        let (key, point) = (unsafe { text(key, "key") }?, index(point, "point")? + 1);
        if orientation == -1 {
            return Ok(thread_key(format_args!("point.{point}.{key}")));
        }
        let view = index(orientation, "orientation")? + 1;
        Ok(thread_key(format_args!("point.{point}.view.{view}.{key}")))
    })
}

/// Sets a number of a path by its name, atomically.
///
/// name  a key of .vid files, points and orientations counted from 1: "fps",
///     "point.2.zoom" (of its first orientation), "point.2.view.3.zoom",
///     "space.half_size", or a limit of v_path_check(), "check.turning". The unit at
///     its end may be missing. docs/reference/files.md lists them
/// value  of a limit, INFINITY disables the check
///
/// These functions fail with V_ERR_RANGE (no such property, or a value out of range)
/// or V_ERR_ARGUMENT (a property of another kind, another invalid value).
/// v_last_error() names the property and counts from 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_number(
    path: *mut V_PATH,
    name: *const c_char,
    value: f64,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { set(name, || Ok(Given::Number(value)), setter(path)) }
}

/// Gets a number; NaN if it is not set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_number(
    path: *const V_PATH,
    name: *const c_char,
    value: *mut f64,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { get(name, value, getter(path, number)) }
}

/// Sets several numbers: "point.2.position", "point.2.own" (tension, continuity,
/// bias), "base_speeds", "point.2.ease" (V_EASE_..., rise, fall, cruise),
/// "point.2.distance" (pairs of time and distance), "space.centre". With count 0 the
/// property is again that of a new path, or no longer set.
/// V_ERR_ARGUMENT (also a wrong count).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_numbers(
    path: *mut V_PATH,
    name: *const c_char,
    values: *const f64,
    count: usize,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { set(name, || numbers_given(values, count), setter(path)) }
}

/// Gets several numbers; none if they are not set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_numbers(
    path: *const V_PATH,
    name: *const c_char,
    values: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> c_int {
    // SAFETY: as the header says.
    unsafe {
        get_numbers(
            name,
            values,
            capacity,
            count,
            getter(path, Document::numbers_of),
        )
    }
}

/// Sets a text: "title", "point.2.name", or the name of a choice: "curve",
/// "space.up". Other properties, too, from their text in a .vid file, "[0, 1, 2]";
/// for these "" restores the value of a new path.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_text(
    path: *mut V_PATH,
    name: *const c_char,
    value: *const c_char,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { set(name, || text_given(value), setter(path)) }
}

/// Gets a text or a choice; another property as in a .vid file. "" if it is not set.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_text(
    path: *const V_PATH,
    name: *const c_char,
    value: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> c_int {
    // SAFETY: as the header says.
    unsafe {
        get_text(
            name,
            value,
            capacity,
            length,
            getter(path, Document::text_of),
        )
    }
}

/// Sets a flag, "closed": not 0 or 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_set_flag(
    path: *mut V_PATH,
    name: *const c_char,
    value: c_int,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { set(name, || Ok(Given::Flag(value != 0)), setter(path)) }
}

/// Gets a flag: 1 or 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_path_get_flag(
    path: *const V_PATH,
    name: *const c_char,
    value: *mut c_int,
) -> c_int {
    // SAFETY: as the header says.
    unsafe { get(name, value, getter(path, flag)) }
}

by_name!(V_PATH, Document, path::read, path::change);
