//! What undo takes back, and redo does again.

use std::borrow::Cow;

use vides_document::StepName;

use super::{Language, fill, texts};

texts! {
    Steps {
        undo, redo, insert_point, insert_points, remove_point, move_point, set_position, set_name,
        tangents, curve, fit_frames, insert_orientation, remove_orientation, view, roll, zoom, pace,
        hold, section_frames, orientation, base_frames, closed, modes, fps, object, limits, info,
        space, edit_node, add_nodes, remove_nodes, copy_nodes, node_name, node_links, node_values,
        motion, keys, interpolation, mesh, shapes, deformations, marker, pin, shown_camera, range,
        replace_scene, keys_to_path, replace_path, transform, deform, insert_path, paste_points,
        mend, reverse, repeat,
    }
}

impl Language {
    /// What a step changed.
    pub(crate) fn step(self, name: StepName) -> Cow<'static, str> {
        let texts = &self.texts().steps;
        let name = match name {
            StepName::Tool(tool) => return self.tool_in_sentence(tool),
            StepName::InsertPoint => texts.insert_point,
            StepName::InsertPoints => texts.insert_points,
            StepName::RemovePoint => texts.remove_point,
            StepName::MovePoint => texts.move_point,
            StepName::SetPosition => texts.set_position,
            StepName::SetName => texts.set_name,
            StepName::Tangents => texts.tangents,
            StepName::Curve => texts.curve,
            StepName::FitFrames => texts.fit_frames,
            StepName::InsertOrientation => texts.insert_orientation,
            StepName::RemoveOrientation => texts.remove_orientation,
            StepName::View => texts.view,
            StepName::Roll => texts.roll,
            StepName::Zoom => texts.zoom,
            StepName::Pace => texts.pace,
            StepName::Hold => texts.hold,
            StepName::SectionFrames => texts.section_frames,
            StepName::Orientation => texts.orientation,
            StepName::BaseFrames => texts.base_frames,
            StepName::Closed => texts.closed,
            StepName::Modes => texts.modes,
            StepName::Fps => texts.fps,
            StepName::Object => texts.object,
            StepName::Limits => texts.limits,
            StepName::Info => texts.info,
            StepName::Space => texts.space,
            StepName::EditNode => texts.edit_node,
            StepName::AddNodes => texts.add_nodes,
            StepName::RemoveNodes => texts.remove_nodes,
            StepName::CopyNodes => texts.copy_nodes,
            StepName::NodeName => texts.node_name,
            StepName::NodeLinks => texts.node_links,
            StepName::NodeValues => texts.node_values,
            StepName::Motion => texts.motion,
            StepName::Keys => texts.keys,
            StepName::Interpolation => texts.interpolation,
            StepName::Mesh => texts.mesh,
            StepName::Shapes => texts.shapes,
            StepName::Deformations => texts.deformations,
            StepName::Marker => texts.marker,
            StepName::Pin => texts.pin,
            StepName::ShownCamera => texts.shown_camera,
            StepName::Range => texts.range,
            StepName::ReplaceScene => texts.replace_scene,
            StepName::KeysToPath => texts.keys_to_path,
            StepName::ReplacePath => texts.replace_path,
            StepName::Transform => texts.transform,
            StepName::Deform => texts.deform,
            StepName::InsertPath => texts.insert_path,
            StepName::PastePoints => texts.paste_points,
            StepName::Mend => texts.mend,
            StepName::Reverse => texts.reverse,
            StepName::Repeat => texts.repeat,
        };
        Cow::Borrowed(name)
    }

    /// "Undo orbit": what [`crate::action::Action::Undo`] would do, or redo; without a step the
    /// plain word.
    pub(crate) fn travel(self, redo: bool, step: Option<StepName>) -> Cow<'static, str> {
        let (steps, menu) = (&self.texts().steps, &self.texts().menu);
        let (text, plain) = if redo {
            (steps.redo, menu.redo)
        } else {
            (steps.undo, menu.undo)
        };
        let named = step.map(|step| fill(text, &[&self.step(step)]).into());
        named.unwrap_or(Cow::Borrowed(plain))
    }

    /// A tool's name within an English sentence.
    fn tool_in_sentence(self, tool: &'static str) -> Cow<'static, str> {
        let name = self.tool(tool);
        let mut letters = name.chars();
        match (self, letters.next()) {
            (Self::English, Some(first)) => {
                format!("{}{}", first.to_lowercase(), letters.as_str()).into()
            }
            _ => Cow::Borrowed(name),
        }
    }
}
