//! What a window knows of its owner, and what it is called.

use crate::error;
use vides_document::Poses;
use vides_editor::Reason;
use vides_engine::path::Pose;

/// The owner of a window. Its methods run on the window's thread; those that call host code run
/// while nothing of ours is borrowed.
pub trait Host {
    /// Makes the poses ready for a host that takes them. Must not call host code.
    ///
    /// # Errors
    /// Shown in the window; what the host has stays as it was.
    fn prepare(&self, window: Id, poses: &Poses<'_>) -> vides_document::Result<()> {
        let _ = (window, poses);
        Ok(())
    }

    /// Calls the host with the poses that were made ready last.
    fn hand_over(&self, window: Id) {
        let _ = window;
    }

    /// Asks the host whether the window may close.
    fn may_close(&self, window: Id) -> bool {
        let _ = window;
        true
    }

    /// Whether [`Host::view`], [`Host::frame`] and [`Host::changed`] are to be called at all.
    fn watches(&self) -> bool {
        false
    }

    /// Calls the host with the camera at the playhead and its frame (from 1) after a change: at
    /// most sixty times a second, whether or not the window is seen.
    fn view(&self, window: Id, pose: &Pose, frame: f64, reason: Reason) {
        let _ = (window, pose, frame, reason);
    }

    /// Calls a host that draws the scene itself with the frame at the playhead, after that or the
    /// scene has changed: as often as [`Host::view`].
    fn frame(&self, window: Id, frame: f64, reason: Reason) {
        let _ = (window, frame, reason);
    }

    /// Calls the host after each step that changed path or scene, undone ones too; not in a drag.
    fn changed(&self, window: Id) {
        let _ = window;
    }

    /// Asks the host for its own camera (vectors of any length); `None` if it has none.
    fn capture(&self, window: Id) -> Option<Pose> {
        let _ = window;
        None
    }

    /// Calls the host with the X window of the camera pane, opened or resized (pixels); 0: closed.
    fn pane(&self, window: Id, pane: u32, size: [u32; 2]) {
        let _ = (window, pane, size);
    }

    /// A window is being lost for this reason, which was not reported yet. Calls no host code.
    fn lost(&self, why: &str) {
        error::complain(why);
    }

    /// The window is gone, but its owner did not close it. Calls no host code.
    fn closed(&self, window: Id, why: Gone) {
        let _ = (window, why);
    }
}

/// Why a window is gone that its owner did not close.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gone {
    /// The user closed it.
    ByUser,
    /// Its X server went away or refused to go on.
    Screen,
    /// It was destroyed, or put out of its parent.
    FromOutside,
    /// A fault of the library's own.
    Fault,
    /// The thread that opened it ended.
    Thread,
}

/// Identifies a window; never used again for another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Id(pub(super) u64);
