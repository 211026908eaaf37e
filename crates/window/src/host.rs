//! The owner of a window, and the callbacks through which a window reaches it.

use crate::error;
use vides_document::Poses;
use vides_editor::Reason;
use vides_engine::path::Pose;

/// The owner of a window. Its methods run on the window's thread. Those that call host code run
/// while nothing of this crate is borrowed.
pub trait Host {
    /// Prepares the poses for a host that takes them. Must not call host code.
    ///
    /// # Errors
    /// Shown in the window; the host's poses are unchanged.
    fn prepare(&self, window: Id, poses: &Poses<'_>) -> vides_document::Result<()> {
        let _ = (window, poses);
        Ok(())
    }

    /// Calls the host with the poses that were prepared last.
    fn hand_over(&self, window: Id) {
        let _ = window;
    }

    /// Asks the host whether the window may close.
    fn may_close(&self, window: Id) -> bool {
        let _ = window;
        true
    }

    /// Whether to call [`Host::view`], [`Host::frame`] and [`Host::changed`] at all.
    fn watches(&self) -> bool {
        false
    }

    /// Calls the host with the camera at the playhead and its frame (from 1) after a change: at
    /// most sixty times a second, even if the window is hidden.
    fn view(&self, window: Id, pose: &Pose, frame: f64, reason: Reason) {
        let _ = (window, pose, frame, reason);
    }

    /// Calls a host that draws the scene itself with the frame at the playhead, after the frame or
    /// the scene has changed: as often as [`Host::view`].
    fn frame(&self, window: Id, frame: f64, reason: Reason) {
        let _ = (window, frame, reason);
    }

    /// Calls the host after each step that changed path or scene, including undo; not during a
    /// drag.
    fn changed(&self, window: Id) {
        let _ = window;
    }

    /// Asks the host for its own camera (vectors of any length); `None` if it has none.
    fn capture(&self, window: Id) -> Option<Pose> {
        let _ = window;
        None
    }

    /// Calls the host with the X window of the camera pane when it is opened or resized (in
    /// pixels), and with 0 when it is closed.
    fn pane(&self, window: Id, pane: u32, size: [u32; 2]) {
        let _ = (window, pane, size);
    }

    /// The window is about to be lost for this reason, which is not yet reported. Calls no host
    /// code.
    fn lost(&self, why: &str) {
        error::complain(why);
    }

    /// The window is gone, and its owner did not [close](crate::close) it. Calls no host code.
    fn closed(&self, window: Id, why: Gone) {
        let _ = (window, why);
    }

    /// Calls the host after [`Host::closed`], unless the window's thread ends.
    fn gone(&self, window: Id, why: Gone) {
        let _ = (window, why);
    }
}

/// Why a window is gone although its owner did not close it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gone {
    /// The user closed it.
    ByUser,
    /// [`close_all`](crate::close_all) closed all windows without asking.
    WithAll,
    /// Its X server went away or failed.
    Screen,
    /// Another program destroyed it, or moved it out of its parent.
    FromOutside,
    /// An internal error of the library.
    Fault,
    /// The thread that opened it ended.
    Thread,
}

/// Identifies a window; never reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Id(pub(super) u64);
