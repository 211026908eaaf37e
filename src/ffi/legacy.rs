//! The two functions of 1994 (thesis B.2, Anhang C).

use std::cell::{Cell, RefCell};
use std::ffi::{c_float, c_int};
use std::ptr;
use std::rc::Rc;

use super::border::border;
use super::host_loop;
use super::list;
use super::object::{object, speeds};
use super::pointers::check;
use super::status::{Answer, Failure, add_last_error, with_last_error};
use super::types::{V_KAMERAPAR, V_OBJEKT_LIST};
use crate::document::{At, Document, Edit, Object, Poses};
use crate::editor::{self, Warning, Warnings};
use crate::error::{Error, Result, TooMany, complain, try_box};
use crate::instance::{self, Gone, Host, Id};
use crate::path::BaseFrames;

type Rueck = unsafe extern "C" fn(daten: *mut V_KAMERAPAR, anzahl: c_int);
type Ende = unsafe extern "C" fn() -> c_int;

/// ==== The interface of 1994: unchanged since ====
///
/// Opens an editor window and returns at once. Each call opens another, independent
/// window, on the display that the program's Xt opened last; without Xt, on DISPLAY.
/// A program with an Xt or Motif main loop needs nothing more; others see v_fd() and
/// v_main_loop(). Unsaved work is offered at the program's next start; for your own
/// Quit see v_editors_close().
///
/// move_speed, orient_speed, zoom_speed, winkel_speed  poses at speed 50 for moving
///     by 1, turning by 180 degrees, zooming from 1 to 100, rolling by 90 degrees;
///     100 replaces one that is not finite and > 0. Those of a loaded file are
///     ignored
/// interpol_liste  first element of the list that receives the poses, see
///     V_KAMERAPAR, or NULL. It must outlive the window; several windows may share
///     it. Its number is read at each hand-over: < 0 means no data (any more)
/// anzahl_objekt, objekt  points of an object to show, at which the new path looks;
///     NULL or a number <= 0: none
/// rueck  called when the user hands over poses, with the list and its count; may be
///     NULL. The list is unchanged until the next hand-over; if interpol_liste is
///     NULL, until rueck returns
/// ende  called before the user closes the window; 0 keeps it open; may be NULL
///
/// Call it from the thread that runs the event loop; rueck and ende run there, by the
/// rules of v_editor_open(). Errors, and a window that closes because its thread
/// ends, are reported in a line on standard error that begins with "vides:", and by
/// v_last_error().
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
    let mut warnings = Warnings::default();
    border((), || {
        if !interpol_liste.is_null() {
            check(interpol_liste, "interpol_liste")?;
        }
        let given = [move_speed, orient_speed, zoom_speed, winkel_speed].map(f64::from);
        let speeds = speeds(given, &mut warnings);
        // SAFETY: the host's array, as the header says.
        let object = unsafe { object(objekt, anzahl_objekt, &mut warnings) };
        let host = Contract {
            list: interpol_liste,
            own: RefCell::default(),
            count: Cell::default(),
            rueck,
            ende,
        };
        open(speeds, object, &mut warnings, host)
    });
    report(&warnings);
}

/// Opens the window, even if the object cannot be shown.
fn open(
    speeds: BaseFrames,
    object: Answer<Object>,
    warnings: &mut Warnings,
    host: Contract,
) -> Answer<()> {
    let mut document = Document::try_new()?;
    document.apply(Edit::set(At::Path, "base_speeds", speeds))?;
    let shown = object.and_then(|object| {
        let mut info = document.info().clone();
        info.object = object;
        document.apply(Edit::SetInfo(Box::new(info)))?;
        Ok(document.look_at_object()?)
    });
    if let Err(failure) = shown {
        warnings.add(match failure {
            Failure::Library(instance::Error::Document(Error::Engine(error))) => {
                Warning::NotShown(error)
            }
            other => Warning::NotRead((&other).into()),
        });
    }
    instance::on_input(host_loop::serve);
    instance::open(instance::Options {
        editor: editor::Options {
            // The window's own history begins here.
            document: document.as_opened(),
            file: None,
            title: None,
            language: None,
            host_takes_poses: host.rueck.is_some() || !host.list.is_null(),
            fixed_speeds: true,
            folders: editor::Folders::of_environment(),
            program: instance::host_program(true),
            host_view: editor::HostView::default(),
        },
        display: None,
        application: None,
        parent: None,
        transient_for: None,
        warnings: warnings.clone(),
        host: Rc::new(host),
    })?
    .keep();
    Ok(())
}

/// The arguments of `v_haupt`.
struct Contract {
    list: *mut V_KAMERAPAR,
    /// The list used where the host gave none, and the count of either, prepared for the hand-over.
    own: RefCell<Option<OwnList>>,
    count: Cell<c_int>,
    rueck: Option<Rueck>,
    ende: Option<Ende>,
}

impl Host for Contract {
    fn prepare(&self, _: Id, poses: &Poses<'_>) -> Result<()> {
        let frames = poses.frame_count();
        let count = c_int::try_from(frames).map_err(|_| TooMany::Poses)?;
        self.count.set(count);
        if !self.list.is_null() {
            // SAFETY: the host's element, which outlives the window.
            unsafe { list::build(frames, self.list, |n, some| poses.sample(n, some)) }?;
            return Ok(());
        }
        self.own.replace(Some(OwnList::new(poses)?));
        Ok(())
    }

    fn hand_over(&self, _: Id) {
        let Some(rueck) = self.rueck else {
            return;
        };
        let mut own = self.own.take();
        let list = own.as_mut().map_or(self.list, OwnList::head);
        // SAFETY: the host's function; the list is the host's or lives until it returns.
        unsafe {
            enter!("rueck", rueck(
                list => *mut V_KAMERAPAR,
                self.count.get() => c_int,
            ) -> ());
        }
    }

    fn may_close(&self, _: Id) -> bool {
        self.ende.is_none_or(|ende| {
            // SAFETY: the host's function.
            let answer = unsafe { enter!("ende", ende() -> c_int) };
            answer != 0
        })
    }

    fn lost(&self, why: &str) {
        complain(why);
    }

    fn closed(&self, _: Id, _: Gone) {}
}

/// A list whose first element is ours, too.
struct OwnList(Box<[V_KAMERAPAR]>);

impl OwnList {
    fn new(poses: &Poses<'_>) -> Result<Self> {
        let nowhere = super::types::V_POS {
            x: 0.0,
            y: 0.0,
            z: 0.0,
        };
        let mut own = Self(try_box(V_KAMERAPAR {
            VRP: nowhere,
            VPN: nowhere,
            VUP: nowhere,
            zoom: 0,
            prev: ptr::null_mut(),
            next: ptr::null_mut(),
            number: -1,
        })?);
        let (frames, head) = (poses.frame_count(), own.head());
        // SAFETY: an element of ours without data.
        unsafe { list::build(frames, head, |n, some| poses.sample(n, some)) }?;
        Ok(own)
    }

    fn head(&mut self) -> *mut V_KAMERAPAR {
        self.0.as_mut_ptr()
    }
}

impl Drop for OwnList {
    fn drop(&mut self) {
        let head = self.head();
        // SAFETY: our element. If the host has changed the list, its other elements are the host's,
        // and only the head is forgotten.
        unsafe {
            if !list::free(head) {
                (*head).number = -1;
                list::free(head);
            }
        }
    }
}

/// Reports on standard error why there is no window and all warnings, a line each; the last error
/// has both.
fn report(warnings: &Warnings) {
    with_last_error(|message| match std::str::from_utf8(message) {
        Ok("") | Err(_) => {}
        Ok(sentence) => complain(sentence),
    });
    if !warnings.is_empty() {
        complain(warnings);
        add_last_error(format_args!("{warnings}"));
    }
}

/// Frees all elements of a list except the first, which is yours, and sets its number
/// to -1 (no data). A list that VIDES did not make, or whose links and numbers were
/// changed, stays unchanged; v_last_error() returns the reason. NULL and lists with
/// number < 0 are ignored. No other thread may use the list meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_free_liste(first: *mut V_KAMERAPAR) {
    border((), || {
        if first.is_null() {
            return Ok(());
        }
        check(first, "first")?;
        // SAFETY: not NULL, aligned; for the rest see the header.
        if unsafe { list::free(first) } {
            return Ok(());
        }
        Err(Failure::argument(
            "this list was not made by VIDES, or was changed; nothing was freed",
        ))
    });
}
