//! Every `v_*` of [`vides`], to be linked from C.
//!
//! A package of its own, so that one call of cargo builds the archive and the
//! command: what they share is compiled once, and their link-time
//! optimisations, which take a processor each, run side by side.

extern crate vides as _;
