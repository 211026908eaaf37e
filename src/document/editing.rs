//! The document: a path with its edits, its history and what is computed of it.

use std::io::Read;
use std::path::Path;
use std::sync::Arc;

use super::edit::Edit;
use super::info::Info;
use crate::error::Result;
use crate::path::{CameraPath, Sampler, Timeline};

/// The current point and its current orientation, counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Selection {
    /// The current point.
    pub point: usize,
    /// The current orientation of that point.
    pub orientation: usize,
}

/// A path being edited.
#[derive(Debug)]
pub struct Document {
    path: CameraPath,
    info: Info,
}

#[allow(clippy::missing_errors_doc, missing_docs)]
impl Document {
    pub fn new() -> Self {
        unimplemented!()
    }
    pub fn without_history() -> Self {
        unimplemented!()
    }
    pub fn from_parts(_path: CameraPath, _info: Info) -> Result<Self> {
        unimplemented!()
    }
    pub fn path(&self) -> &CameraPath {
        &self.path
    }
    pub fn info(&self) -> &Info {
        &self.info
    }
    pub fn selection(&self) -> Selection {
        unimplemented!()
    }
    pub fn select(&mut self, _point: usize, _orientation: usize) -> Result<()> {
        unimplemented!()
    }
    pub fn apply(&mut self, _edit: Edit) -> Result<()> {
        unimplemented!()
    }
    pub fn undo(&mut self) -> bool {
        unimplemented!()
    }
    pub fn redo(&mut self) -> bool {
        unimplemented!()
    }
    pub fn can_undo(&self) -> bool {
        unimplemented!()
    }
    pub fn can_redo(&self) -> bool {
        unimplemented!()
    }
    pub fn begin_step(&mut self) {
        unimplemented!()
    }
    pub fn end_step(&mut self) {
        unimplemented!()
    }
    pub fn cancel_step(&mut self) {
        unimplemented!()
    }
    pub fn drop_history(&mut self) {
        unimplemented!()
    }
    pub fn is_modified(&self) -> bool {
        unimplemented!()
    }
    pub fn mark_saved(&mut self) {
        unimplemented!()
    }
    pub fn timeline<R>(&self, _f: impl FnOnce(&Timeline) -> R) -> Result<R> {
        unimplemented!()
    }
    pub fn sampler(&self) -> Result<Arc<Sampler>> {
        unimplemented!()
    }
    pub fn load(_file: &Path) -> Result<Self> {
        unimplemented!()
    }
    pub fn load_from(_reader: &mut dyn Read, _name: &str) -> Result<Self> {
        unimplemented!()
    }
    pub fn save(&self, _file: &Path) -> Result<()> {
        unimplemented!()
    }
    pub fn from_toml(_text: &str) -> Result<Self> {
        unimplemented!()
    }
    pub fn to_toml(&self) -> Result<String> {
        unimplemented!()
    }
    pub fn try_clone(&self) -> Result<Self> {
        unimplemented!()
    }
}
