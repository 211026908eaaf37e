//! What a step of the history changed, so that a window can say what it takes back.

use super::edit::Edit;
use super::info::Info;
use vides_engine::path::{CameraPath, Orientation};
use vides_engine::scene::Part;

/// What a step changed: its tool, or else what its first edit did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepName {
    /// The tool of this name.
    Tool(&'static str),
    /// Inserted a point.
    InsertPoint,
    /// Inserted several points.
    InsertPoints,
    /// Removed a point.
    RemovePoint,
    /// Renumbered points.
    MovePoint,
    /// Moved a point.
    SetPosition,
    /// Named a point.
    SetName,
    /// A point's own tangents.
    Tangents,
    /// How the curve runs at a point, or everywhere.
    Curve,
    /// The number of frames of the path or a part of it.
    FitFrames,
    /// Inserted an orientation.
    InsertOrientation,
    /// Removed an orientation.
    RemoveOrientation,
    /// Where the camera looks, or from absolute to relative.
    View,
    /// The roll.
    Roll,
    /// The zoom.
    Zoom,
    /// The ten speeds or another pace.
    Pace,
    /// A hold.
    Hold,
    /// The frames of a section.
    SectionFrames,
    /// Several values of an orientation, or another one.
    Orientation,
    /// The base speeds.
    BaseFrames,
    /// Closed or opened the path.
    Closed,
    /// How the camera turns and zooms.
    Modes,
    /// The frame rate.
    Fps,
    /// The object.
    Object,
    /// The limits of checks.
    Limits,
    /// The rest of the info.
    Info,
    /// The space.
    Space,
    /// Whose path is edited.
    EditNode,
    /// Added nodes.
    AddNodes,
    /// Removed nodes.
    RemoveNodes,
    /// Copied nodes.
    CopyNodes,
    /// A node's name.
    NodeName,
    /// What a node is in, or looks at.
    NodeLinks,
    /// What a node has at rest.
    NodeValues,
    /// What moves a node.
    Motion,
    /// Keys of a track.
    Keys,
    /// How a track goes from key to key.
    Interpolation,
    /// An object's mesh.
    Mesh,
    /// An object's shapes or their weights.
    Shapes,
    /// An object's deformations.
    Deformations,
    /// A marker.
    Marker,
    /// What is pinned to a marker.
    Pin,
    /// The shown camera.
    ShownCamera,
    /// The range of frames.
    Range,
    /// Another scene.
    ReplaceScene,
    /// A node's keys became a path.
    KeysToPath,
    /// Another path.
    ReplacePath,
    /// Moved, turned, scaled or mirrored points.
    Transform,
    /// Deformed points.
    Deform,
    /// Inserted a path.
    InsertPath,
    /// Pasted points from the clipboard.
    PastePoints,
    /// Fixed what a check has found.
    Mend,
    /// Reversed the path.
    Reverse,
    /// Repeated the path.
    Repeat,
}

impl StepName {
    /// What an edit of these would change.
    pub(super) fn of(edit: &Edit, path: &CameraPath, info: &Info) -> Self {
        match edit {
            Edit::InsertPoint { .. }
            | Edit::AppendAfterLast
            | Edit::PrependBeforeFirst
            | Edit::DivideSegment { points: 1, .. }
            | Edit::InsertOnCurve { .. } => Self::InsertPoint,
            Edit::DivideSegment { .. } => Self::InsertPoints,
            Edit::FitFrames { .. } => Self::FitFrames,
            Edit::RemovePoint { .. } => Self::RemovePoint,
            Edit::MovePoint { .. } => Self::MovePoint,
            Edit::Set { property, .. } => match *property {
                "position" => Self::SetPosition,
                "name" => Self::SetName,
                "tangents" | "keeps_motion" => Self::Tangents,
                "curve" | "preset" | "own" | "presets" => Self::Curve,
                "fps" => Self::Fps,
                "title" | "comment" | "first_frame" => Self::Info,
                "closed" => Self::Closed,
                "orientation_mode" | "zoom_mode" => Self::Modes,
                "base_speeds" => Self::BaseFrames,
                "target" | "offset" | "ahead" | "up" | "up_point" | "up_path" => Self::View,
                "roll_degrees" => Self::Roll,
                "zoom_mm" => Self::Zoom,
                "hold_frames" => Self::Hold,
                "speed_curve" | "ease" | "distance" | "pace_part" => Self::Pace,
                "frames" | "locked" => Self::SectionFrames,
                _ => Self::Orientation,
            },
            Edit::InsertOrientation { .. } => Self::InsertOrientation,
            Edit::RemoveOrientation { .. } => Self::RemoveOrientation,
            Edit::SetOrientation {
                point,
                at,
                orientation,
            } => {
                let here = path.points.get(*point);
                let old = here.and_then(|here| here.orientations.get(*at));
                old.map_or(Self::Orientation, |old| of_values(old, orientation))
            }
            Edit::SetAbsolute { .. } => Self::View,
            Edit::SetInfo(new) if new.fps != info.fps => Self::Fps,
            Edit::SetInfo(new) if new.object != info.object => Self::Object,
            Edit::SetInfo(new) if new.limits != info.limits => Self::Limits,
            Edit::SetInfo(_) => Self::Info,
            Edit::SetSpace { .. } | Edit::ChangeUp(_) => Self::Space,
            Edit::EditNode(_) => Self::EditNode,
            Edit::Part(part) => Self::of_part(part),
            Edit::AddNodes(_) => Self::AddNodes,
            Edit::CopyNodes(_) => Self::CopyNodes,
            Edit::SetParent { .. } => Self::NodeLinks,
            Edit::RenameMarker { .. } => Self::Marker,
            Edit::ReplaceScene(_) => Self::ReplaceScene,
            Edit::ReplacePath(_) => Self::ReplacePath,
            Edit::TransformPoints { .. } => Self::Transform,
            Edit::DeformPoints { .. } => Self::Deform,
            Edit::InsertPath { .. } => Self::InsertPath,
            Edit::Reverse => Self::Reverse,
            Edit::Repeat(_) => Self::Repeat,
        }
    }
}

impl StepName {
    const fn of_part(part: &Part) -> Self {
        match part {
            Part::Remove(_) => Self::RemoveNodes,
            Part::Name { .. } => Self::NodeName,
            Part::Links { .. } => Self::NodeLinks,
            Part::Path { .. } | Part::Start { .. } | Part::Track { .. } => Self::Motion,
            Part::Keys { .. } => Self::Keys,
            Part::Manner { .. } => Self::Interpolation,
            Part::Mesh { .. } => Self::Mesh,
            Part::Weights { .. } | Part::InsertShape { .. } | Part::RemoveShape { .. } => {
                Self::Shapes
            }
            Part::InsertDeformation { .. }
            | Part::RemoveDeformation { .. }
            | Part::Deformation { .. }
            | Part::MoveDeformation { .. } => Self::Deformations,
            Part::Marker { .. } => Self::Marker,
            Part::Pin { .. } => Self::Pin,
            Part::Camera(_) => Self::ShownCamera,
            Part::Range(_) => Self::Range,
            _ => Self::NodeValues,
        }
    }
}

/// The one thing in which two orientations differ.
fn of_values(old: &Orientation, new: &Orientation) -> StepName {
    let (had, has) = (&old.own, &new.own);
    let view = old.target != new.target || had.ahead != has.ahead || had.up != has.up;
    let pace = old.speeds != new.speeds || had.pace != has.pace;
    let frames = had.frames != has.frames || had.locked != has.locked;
    let differs = [
        (view, StepName::View),
        (old.roll != new.roll, StepName::Roll),
        (old.zoom != new.zoom, StepName::Zoom),
        (pace, StepName::Pace),
        (old.hold != new.hold, StepName::Hold),
        // A pace may come with frames.
        (frames && !pace, StepName::SectionFrames),
    ];
    let mut differs = differs.into_iter().filter(|(differs, _)| *differs);
    match (differs.next(), differs.next()) {
        (Some((_, name)), None) => name,
        _ => StepName::Orientation,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{At, Document};

    /// What is added to a step is taken back with it; it keeps its name.
    #[test]
    fn a_step_that_is_opened_again_takes_in_what_follows() {
        let mut document = Document::new();
        assert!(!document.reopen_step());
        let first = document.path().clone();
        document.apply(Edit::AppendAfterLast).unwrap();
        let second = document.path().clone();
        document.apply(Edit::Reverse).unwrap();
        assert!(document.reopen_step() && document.in_step());
        let last = document.path().points.len() - 1;
        let edit = Edit::FitFrames {
            first: 0,
            last,
            frames: 77,
        };
        document.apply(edit).unwrap();
        document.end_step();
        let third = document.path().clone();
        let names = [Some(StepName::Reverse), None];
        assert_eq!(document.step_names(), names);
        assert!(document.undo());
        assert_eq!(*document.path(), second);
        // Not while something is undone: that could not be done again.
        assert!(!document.reopen_step());
        assert!(document.redo());
        assert_eq!(*document.path(), third);
        assert!(document.undo() && document.undo() && !document.undo());
        assert_eq!(*document.path(), first);
    }

    /// Between a mark and its end all is one step, whatever else was taken back meanwhile.
    #[test]
    fn steps_since_a_mark_become_one() {
        let mut document = Document::new();
        document.join_steps();
        document.apply(Edit::Reverse).unwrap();
        let (before, number) = (document.path().clone(), document.state_number());
        document.mark_steps();
        document.apply(Edit::AppendAfterLast).unwrap();
        document.apply(Edit::Reverse).unwrap();
        assert!(document.undo());
        document.apply(Edit::Repeat(2)).unwrap();
        document.begin_step();
        document.apply(Edit::set(At::Path, "closed", true)).unwrap();
        let after = document.path().clone();
        document.join_steps();
        assert_eq!(document.step_names(), [Some(StepName::InsertPoint), None]);
        for _ in 0..2 {
            assert_eq!(*document.path(), after);
            assert!(document.undo());
            assert_eq!(
                (document.path(), document.state_number()),
                (&before, number)
            );
            assert_eq!(document.step_names()[0], Some(StepName::Reverse));
            assert!(document.redo() && !document.redo());
        }
        // One that was undone below its mark joins what comes after.
        document.mark_steps();
        assert!(document.undo() && document.undo());
        document.apply(Edit::AppendAfterLast).unwrap();
        document.apply(Edit::Reverse).unwrap();
        document.join_steps();
        document.apply(Edit::Reverse).unwrap();
        assert!(document.undo() && document.undo() && !document.undo());
        assert_eq!(document.path(), Document::new().path());
    }
}
