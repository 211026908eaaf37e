//! What can be asked for of the path's points and views.

use glam::DVec3;
use vides_engine::path::UpVector;

use super::OwnedMotion;
use crate::state::space::Joint;

/// What adds, removes and changes points and views, and goes to them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum PathAction {
    /// `Pos.+`, as this window does it; with Shift the other way.
    AddPoint,
    /// The other way: a copy of this point, or one that leaves the flight as it is.
    AddPointOtherwise,
    /// `Pos.++`: ask how many.
    AskPoints,
    /// `Pos.++`: insert this many.
    AddPoints(usize),
    /// A key at the playhead.
    AddHere,
    /// Begin the path of the first screen with two points there, and look along it.
    Begin([DVec3; 2]),
    /// `Pos.-`.
    RemovePoint,
    /// `<< Pos.`
    PreviousPoint,
    /// `Pos. >>`
    NextPoint,
    AppendPoint,
    PrependPoint,
    SwitchClosed,
    /// Give the point own tangents as they are now, or take its own away.
    OwnTangents(bool),
    /// How own tangents are joined.
    Join(Joint),
    /// `Ori.+`.
    AddOrientation,
    /// `Ori.-`.
    RemoveOrientation,
    /// `<< Ori`
    PreviousOrientation,
    /// `Ori >>`
    NextOrientation,
    /// `Abs.` (true) or `Rel.` (false).
    SetAbsolute(bool),
    /// Take away what the current orientation owns of this.
    ClearOverride(OwnedMotion),
    /// Let the current orientation look along the way.
    LookAhead,
    /// Let the current orientation show all of the object.
    ShowObject,
    SetUp(UpVector),
    /// Change between `Abs.` and `Rel.`.
    SwitchAbsolute,
    /// Let every orientation of the path look where the current one does.
    AimAll,
    PasteOrientation,
    /// Take over the host's view as a new point, or in place of the current orientation.
    TakeOver {
        replace: bool,
    },
    /// Move the selected points before this one.
    MoveSelected(usize),
    AimAt(DVec3),
    /// Let every orientation look there.
    AimAllAt(DVec3),
}

impl PathAction {
    /// Whether it only goes to another point or view.
    pub(super) const fn selects(&self) -> bool {
        matches!(
            self,
            Self::PreviousPoint
                | Self::NextPoint
                | Self::PreviousOrientation
                | Self::NextOrientation
        )
    }
}
