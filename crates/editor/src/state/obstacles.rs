//! What the camera must not run into, once it is prepared.

use std::cell::RefCell;
use std::sync::Arc;

use vides_document::Object;
use vides_engine::tools::clearance::Clearance;

#[derive(Debug, Default)]
pub(crate) struct Obstacles(pub(crate) RefCell<Option<Prepared>>);

#[derive(Debug)]
pub(crate) struct Prepared {
    /// Held so that no other object gets its address.
    pub(crate) object: Object,
    /// The number of the scene around the path.
    pub(crate) scene: Option<u64>,
    pub(crate) tree: Option<Arc<Clearance>>,
}
