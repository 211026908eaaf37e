//! Scenes as handles, including scenes from which nodes are being removed one by one.
//!
//! A removal only marks nodes ([`Removal`]); the next other use of the scene removes them all at
//! once. Reading nodes between two removals looks through the marks, see [`look`].

use std::cell::Cell;
use std::ffi::c_int;
use std::sync::{RwLock, RwLockReadGuard};

use super::counted::TryArc;
use super::handles::{Handles, KIND_SCENE};
use super::progress::locked;
use super::scene_types::V_SCENE;
use super::status::{Answer, Failure, V_ERR_BUSY, V_ERR_INTERNAL, V_OK};
use crate::document::SceneDocument;
use crate::inject;
use crate::scene::Scene;
use crate::scene::removal::Removal;

/// What a handle stands for.
struct Held {
    document: SceneDocument,
    removal: Option<Removal>,
}

impl Held {
    fn settle(&mut self) -> &mut SceneDocument {
        if let Some(removal) = self.removal.take() {
            self.document.scene.remove_all(removal);
        }
        &mut self.document
    }
}

/// All scenes that C holds.
static SCENES: Handles<RwLock<Held>, V_SCENE> = Handles::new(KIND_SCENE);

const SPOILED: Failure = Failure::Border(
    V_ERR_INTERNAL,
    "this scene is unusable after a fault inside the library",
);

const BUSY: Failure = Failure::Border(
    V_ERR_BUSY,
    "a scene cannot be used within a host interpolation",
);

thread_local! {
    /// How many of the host's interpolations run on this thread. Each runs while the scene is
    /// read-locked, so using a scene in it could deadlock.
    static CALLBACKS: Cell<u32> = const { Cell::new(0) };
}

/// Runs an interpolation of the host's, during which no scene may be used.
pub(super) fn within_callback<R>(run: impl FnOnce() -> R) -> R {
    struct Guard;
    impl Drop for Guard {
        fn drop(&mut self) {
            CALLBACKS.set(CALLBACKS.get() - 1);
        }
    }
    CALLBACKS.set(CALLBACKS.get() + 1);
    let _guard = Guard;
    run()
}

fn lookup(scene: *const V_SCENE) -> Answer<TryArc<RwLock<Held>>> {
    let found = SCENES.get(scene)?;
    if CALLBACKS.get() > 0 {
        return Err(BUSY);
    }
    Ok(found)
}

/// A scene without marks, to be read.
fn settled(scene: &RwLock<Held>) -> Answer<RwLockReadGuard<'_, Held>> {
    loop {
        let held = locked(|| scene.read(), || scene.try_read(), SPOILED)?;
        if held.removal.is_none() {
            return Ok(held);
        }
        drop(held);
        // Until the lock is taken again another thread may remove more.
        locked(|| scene.write(), || scene.try_write(), SPOILED)?.settle();
    }
}

pub(super) fn read<R>(
    scene: *const V_SCENE,
    look: impl FnOnce(&SceneDocument) -> Answer<R>,
) -> Answer<R> {
    let scene = lookup(scene)?;
    let held = settled(&scene)?;
    inject::point(inject::Place::Path);
    look(&held.document)
}

/// The nodes of a scene by their current numbers, which may differ from their places in
/// the scene.
pub(super) struct Nodes<'a>(&'a Held);

impl Nodes<'_> {
    pub(super) const fn scene(&self) -> &Scene {
        &self.0.document.scene
    }

    pub(super) fn count(&self) -> usize {
        let all = self.scene().nodes().len();
        self.0.removal.as_ref().map_or(all, Removal::count)
    }

    /// Where a node is in the scene.
    pub(super) fn place(&self, number: usize) -> Answer<usize> {
        match &self.0.removal {
            Some(removal) => Ok(removal.place(number)?),
            None => Ok(self.scene().node(number).map(|_| number)?),
        }
    }

    /// The number of a node at a place; `None` if it is removed.
    pub(super) fn number(&self, place: usize) -> Option<usize> {
        match &self.0.removal {
            Some(removal) => removal.number(place),
            None => Some(place),
        }
    }
}

/// Reads nodes, also between removals.
pub(super) fn look<R>(
    scene: *const V_SCENE,
    look: impl FnOnce(&Nodes<'_>) -> Answer<R>,
) -> Answer<R> {
    let scene = lookup(scene)?;
    let held = locked(|| scene.read(), || scene.try_read(), SPOILED)?;
    inject::point(inject::Place::Path);
    look(&Nodes(&held))
}

fn write<R>(scene: *mut V_SCENE, change: impl FnOnce(&mut Held) -> Answer<R>) -> Answer<R> {
    let scene = lookup(scene)?;
    let mut held = locked(|| scene.write(), || scene.try_write(), SPOILED)?;
    inject::point(inject::Place::Path);
    change(&mut held)
}

/// Removes a node and its descendants.
pub(super) fn remove_node(scene: *mut V_SCENE, node: usize) -> Answer<c_int> {
    write(scene, |held| {
        let removal = match &mut held.removal {
            Some(removal) => removal,
            none => none.insert(Removal::new(&held.document.scene)?),
        };
        removal.remove(node)?;
        Ok(V_OK)
    })
}

pub(super) fn edit<R>(
    scene: *mut V_SCENE,
    change: impl FnOnce(&mut SceneDocument) -> Answer<R>,
) -> Answer<R> {
    write(scene, |held| change(held.settle()))
}

/// Makes one change of a scene.
pub(super) fn change<R>(
    scene: *mut V_SCENE,
    change: impl FnOnce(&mut Scene) -> vides_engine::Result<R>,
) -> Answer<c_int> {
    edit(scene, |document| Ok(change(&mut document.scene)?))?;
    Ok(V_OK)
}

/// A handle for a scene.
pub(super) fn insert(document: SceneDocument) -> Answer<*mut V_SCENE> {
    SCENES.insert(RwLock::new(Held {
        document,
        removal: None,
    }))
}

/// Frees a scene.
pub(super) fn free(scene: *const V_SCENE) -> Answer<()> {
    SCENES.remove(scene).map(drop)
}
