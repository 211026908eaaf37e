//! Files that were read, so that no output overwrites them. Only programs that read their inputs,
//! write their outputs and end want this, such as the command: [`protect_inputs`].

use std::cell::RefCell;
use std::collections::HashMap;
use std::fs::{self, Metadata};
use std::os::unix::fs::MetadataExt;
use std::path::Path;

use crate::error::{Refused, Result};

thread_local! {
    static INPUTS: RefCell<Option<HashMap<Identity, String>>> = const { RefCell::new(None) };
}

/// Device and inode: the same through links and other names.
type Identity = (u64, u64);

fn identity(metadata: &Metadata) -> Identity {
    (metadata.dev(), metadata.ino())
}

/// From now on saving on this thread refuses to replace a file that was read on it.
pub fn protect_inputs() {
    INPUTS.set(Some(HashMap::new()));
}

/// Notes an open file as read, for instance standard input, under the name that messages call it.
pub fn note_input(metadata: &Metadata, name: &str) {
    INPUTS.with_borrow_mut(|inputs| {
        let Some(inputs) = inputs else {
            return;
        };
        if metadata.is_file() && inputs.try_reserve(1).is_ok() {
            inputs.insert(identity(metadata), name.to_owned());
        }
    });
}

/// A file may be replaced though it was read: it is edited in place.
pub fn may_replace(file: &Path) {
    INPUTS.with_borrow_mut(|inputs| {
        if let (Some(inputs), Ok(metadata)) = (inputs, fs::metadata(file)) {
            inputs.remove(&identity(&metadata));
        }
    });
}

/// Refuses to replace a file that was read.
pub(super) fn refuse(metadata: &Metadata) -> Result<()> {
    INPUTS.with_borrow(|inputs| {
        let read = inputs.as_ref().and_then(|all| all.get(&identity(metadata)));
        match read {
            Some(name) => Err(Refused::Input(name.as_str().into()).into()),
            None => Ok(()),
        }
    })
}
