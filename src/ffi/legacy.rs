//! The two functions of 1994 (thesis B.2, Anhang C).

use std::ffi::{c_float, c_int};
use std::io::Write as _;

use super::border::border;
use super::list;
use super::pointers::check;
use super::status::{Failure, V_ERR_ARGUMENT, V_ERR_DISPLAY, with_last_error};
use super::types::{V_KAMERAPAR, V_OBJEKT_LIST};

/// ==== The interface of 1994 ====
///
/// Opens an editor window for a camera path and returns at once; the window
/// then works side by side with the host, in the host's own event loop. Every
/// call opens another window.
///
/// This version of the library has no window yet. The call says so in one line
/// on standard error, which begins "vides:", and by v_last_error().
///
/// move_speed, orient_speed, zoom_speed, winkel_speed  poses at speed 50 for a
///     way of length 1, for turning by 180 degrees, for the zoom from 1 to
///     100, for rolling by 90 degrees; finite and > 0
/// interpol_liste  first element of the list that takes the poses, see
///     V_KAMERAPAR; the host's, must outlive the window; may be NULL
/// anzahl_objekt, objekt  points of an object to be shown; copied during the
///     call; NULL or a number <= 0 for none
/// rueck  called when the user hands over poses, with the list and its count;
///     may be NULL
/// ende   called before the window closes; 0 keeps it open; may be NULL
///
/// rueck and ende run on the thread that called v_haupt(), inside the host's
/// event loop, and may call any function of the library.
/// From the thread that runs the event loop; from callbacks too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_haupt(
    move_speed: c_float,
    orient_speed: c_float,
    zoom_speed: c_float,
    winkel_speed: c_float,
    interpol_liste: *mut V_KAMERAPAR,
    anzahl_objekt: c_int,
    objekt: *mut V_OBJEKT_LIST,
    rueck: Option<unsafe extern "C" fn(daten: *mut V_KAMERAPAR, anzahl: c_int)>,
    ende: Option<unsafe extern "C" fn() -> c_int>,
) {
    // What a window would be made of.
    let _ = (move_speed, orient_speed, zoom_speed, winkel_speed);
    let _ = (interpol_liste, anzahl_objekt, objekt, rueck, ende);
    border((), || {
        Err(Failure::Border(
            V_ERR_DISPLAY,
            "this version of the library opens no window",
        ))
    });
    report();
}

/// Room for the longest message with what stands around it.
const LINE_BYTES: usize = 2048;

/// Says the last error on standard error, in one line and one piece.
fn report() {
    with_last_error(|message| {
        // One write, so that nobody else's text comes between; no allocation.
        let mut line = [0; LINE_BYTES];
        let length = {
            let mut rest = &mut line[..];
            let parts: [&[u8]; 3] = [b"vides: ", message, b"\n"];
            // The longest message fits.
            let _ = parts.iter().try_for_each(|part| rest.write_all(part));
            LINE_BYTES - rest.len()
        };
        // Nothing is left to be done where standard error is closed.
        let _ = std::io::stderr().write_all(&line[..length]);
    });
}

/// Frees all elements of a list but the first, which is the host's, and sets
/// the first one's number to -1 (no data). Only a list that VIDES made and that
/// is still linked and numbered as it was made is freed: otherwise nothing is
/// changed, and v_last_error() tells. A list without data (number < 0) and NULL
/// are no error; nothing happens.
/// Any thread, if no other uses the list meanwhile; from callbacks too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_free_liste(first: *mut V_KAMERAPAR) {
    border((), || {
        if first.is_null() {
            return Ok(());
        }
        check(first)?;
        // SAFETY: not NULL, aligned; the header tells what the host must
        // hold to.
        if unsafe { list::free(first) } {
            return Ok(());
        }
        Err(Failure::Border(
            V_ERR_ARGUMENT,
            "this list was not made by VIDES, or was changed; nothing was freed",
        ))
    });
}
