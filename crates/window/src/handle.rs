//! An open window as a value.

use std::marker::PhantomData;
use std::rc::Rc;

use crate::host::Id;
use crate::registry::close;

/// An open window. Dropping this closes it without asking; [`Handle::keep`] leaves it to the user.
/// It stays on its thread.
#[derive(Debug)]
#[must_use = "the window closes when this is dropped"]
pub struct Handle {
    id: Id,
    thread: PhantomData<Rc<()>>,
}

impl Handle {
    pub(crate) const fn new(id: Id) -> Self {
        let thread = PhantomData;
        Self { id, thread }
    }

    /// The id of the window, for the functions of this crate.
    #[must_use]
    pub const fn id(&self) -> Id {
        self.id
    }

    /// Leaves the window open until the user or [`close`](crate::close) closes it.
    #[allow(clippy::must_use_candidate)]
    pub fn keep(self) -> Id {
        let id = self.id;
        std::mem::forget(self);
        id
    }
}

impl Drop for Handle {
    fn drop(&mut self) {
        close(self.id);
    }
}
