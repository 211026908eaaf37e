//! The host's callbacks, as an editor window calls them.

use std::cell::{Cell, RefCell};
use std::ffi::{c_int, c_ulong, c_void};
use std::ptr;

use super::editor;
use super::types::{
    V_EDITOR, V_EDITOR_OPTIONS, V_GONE_BY_USER, V_GONE_DESTROYED, V_GONE_DISPLAY, V_GONE_FAULT,
    V_GONE_WITH_ALL, V_POSE, V_VIEW_EDITED, V_VIEW_PLAYED, V_VIEW_RESTED, V_VIEW_SCRUBBED,
    V_VIEW_SELECTED,
};
use crate::document::Poses;
use crate::error::{Result, complain, vec_with_room};
use crate::instance::{Gone, Host, Id, Reason};
use crate::path::Pose;

/// The host's callbacks.
pub(super) struct Callbacks {
    pub(super) handle: Cell<*mut V_EDITOR>,
    /// The poses prepared for the hand-over.
    poses: RefCell<Vec<Pose>>,
    /// Only its callbacks and their `user` are used.
    on: V_EDITOR_OPTIONS,
}

impl Callbacks {
    pub(super) fn new(on: V_EDITOR_OPTIONS) -> Self {
        Self {
            handle: Cell::new(ptr::null_mut()),
            poses: RefCell::default(),
            on,
        }
    }
}

impl Host for Callbacks {
    fn prepare(&self, _: Id, poses: &Poses<'_>) -> Result<()> {
        let mut all = vec_with_room(poses.frame_count())?;
        all.resize(poses.frame_count(), Pose::default());
        poses.sample(1, &mut all)?;
        self.poses.replace(all);
        Ok(())
    }

    fn hand_over(&self, _: Id) {
        if let Some(on_poses) = self.on.on_poses {
            let (handle, poses) = (self.handle.get(), self.poses.take());
            // SAFETY: the host's function; the poses live until it returns, and both pose types
            // have one layout.
            unsafe {
                enter!("on_poses", on_poses(
                    handle => *mut V_EDITOR,
                    poses.as_ptr().cast() => *const V_POSE,
                    poses.len() => usize,
                    self.on.user => *mut c_void,
                ) -> ());
            }
        }
    }

    fn watches(&self) -> bool {
        let on = &self.on;
        on.on_view.is_some() || on.on_frame.is_some() || on.on_change.is_some()
    }

    fn view(&self, _: Id, pose: &Pose, frame: f64, reason: Reason) {
        let Some(on_view) = self.on.on_view else {
            return;
        };
        // SAFETY: as for `on_poses`.
        unsafe {
            enter!("on_view", on_view(
                self.handle.get() => *mut V_EDITOR,
                ptr::from_ref(pose).cast() => *const V_POSE,
                frame => f64,
                reason_for_c(reason) => c_int,
                self.on.user => *mut c_void,
            ) -> ());
        }
    }

    fn frame(&self, _: Id, frame: f64, reason: Reason) {
        if let Some(on_frame) = self.on.on_frame {
            // SAFETY: the host's function.
            unsafe {
                enter!("on_frame", on_frame(
                    self.handle.get() => *mut V_EDITOR,
                    frame => f64,
                    reason_for_c(reason) => c_int,
                    self.on.user => *mut c_void,
                ) -> ());
            }
        }
    }

    fn changed(&self, _: Id) {
        if let Some(on_change) = self.on.on_change {
            // SAFETY: the host's function.
            unsafe {
                enter!("on_change", on_change(
                    self.handle.get() => *mut V_EDITOR,
                    self.on.user => *mut c_void,
                ) -> ());
            }
        }
    }

    fn capture(&self, _: Id) -> Option<Pose> {
        let on_capture = self.on.on_capture?;
        let mut pose = Pose::default();
        // SAFETY: the host's function may write the pose until it returns; any bits are valid, and
        // both pose types have one layout.
        let given = unsafe {
            enter!("on_capture", on_capture(
                self.handle.get() => *mut V_EDITOR,
                ptr::from_mut(&mut pose).cast() => *mut V_POSE,
                self.on.user => *mut c_void,
            ) -> c_int)
        };
        (given != 0).then_some(pose)
    }

    fn may_close(&self, _: Id) -> bool {
        let (handle, user) = (self.handle.get(), self.on.user);
        self.on.on_close.is_none_or(|on_close| {
            // SAFETY: the host's function.
            let answer = unsafe {
                enter!("on_close", on_close(
                    handle => *mut V_EDITOR,
                    user => *mut c_void,
                ) -> c_int)
            };
            answer != 0
        })
    }

    fn pane(&self, _: Id, pane: u32, size: [u32; 2]) {
        let Some(on_pane) = self.on.on_pane else {
            return;
        };
        let (handle, user) = (self.handle.get(), self.on.user);
        let [width, height] = size.map(|side| c_int::try_from(side).unwrap_or(c_int::MAX));
        // SAFETY: the host's function.
        unsafe {
            enter!("on_pane", on_pane(
                handle => *mut V_EDITOR,
                c_ulong::from(pane) => c_ulong,
                width => c_int,
                height => c_int,
                user => *mut c_void,
            ) -> ());
        }
    }

    fn lost(&self, why: &str) {
        complain(why);
    }

    fn closed(&self, _: Id, why: Gone) {
        editor::closed(self.handle.get(), why);
    }

    fn gone(&self, _: Id, why: Gone) {
        let (Some(on_gone), Some(reason)) = (self.on.on_gone, gone_for_c(why)) else {
            return;
        };
        let (handle, user) = (self.handle.get(), self.on.user);
        // SAFETY: the host's function.
        unsafe {
            enter!("on_gone", on_gone(
                handle => *mut V_EDITOR,
                reason => c_int,
                user => *mut c_void,
            ) -> ());
        }
    }
}

/// The reason for C; `None` if no callback may run.
fn gone_for_c(why: Gone) -> Option<c_int> {
    match why {
        Gone::ByUser => Some(V_GONE_BY_USER),
        Gone::WithAll => Some(V_GONE_WITH_ALL),
        Gone::FromOutside => Some(V_GONE_DESTROYED),
        Gone::Screen => Some(V_GONE_DISPLAY),
        Gone::Fault => Some(V_GONE_FAULT),
        Gone::Thread => None,
    }
}

fn reason_for_c(reason: Reason) -> c_int {
    match reason {
        Reason::Selected => V_VIEW_SELECTED,
        Reason::Edited => V_VIEW_EDITED,
        Reason::Scrubbed => V_VIEW_SCRUBBED,
        Reason::Played => V_VIEW_PLAYED,
        Reason::Rested => V_VIEW_RESTED,
    }
}
