//! What undo takes back, and redo does again.

use std::borrow::Cow;

use vides_document::StepName;

use super::{Language, fill, texts};

texts! {
    Steps {
        undo: "Undo {0}", "{0} rückgängig";
        redo: "Redo {0}", "{0} wiederholen";

        insert_point: "new point", "Neuer Punkt";
        insert_points: "new points", "Neue Punkte";
        remove_point: "removing a point", "Löschen eines Punktes";
        move_point: "reordering the points", "Umordnen der Punkte";
        set_position: "moving a point", "Verschieben eines Punktes";
        set_name: "naming a point", "Benennen eines Punktes";
        tangents: "tangents", "Tangenten";
        curve: "shape of the curve", "Kurvenform";
        fit_frames: "length of the path", "Länge der Bahn";
        insert_orientation: "new view", "Neuer Blick";
        remove_orientation: "removing a view", "Löschen eines Blicks";
        view: "view", "Blick";
        roll: "roll", "Winkel";
        zoom: "zoom", "Zoom";
        pace: "speed curve", "Zeitkurve";
        hold: "hold", "Halt";
        section_frames: "frames of a section", "Bilder eines Abschnitts";
        orientation: "view", "Blick";
        base_frames: "base frames", "Grundbilder";
        closed: "closing or opening the path", "Schließen oder Öffnen der Bahn";
        modes: "kind of turning", "Art der Drehung";
        fps: "frame rate", "Bildrate";
        object: "object", "Objekt";
        limits: "limits of the check", "Grenzen der Prüfung";
        info: "notes on the path", "Angaben zur Bahn";
        space: "space", "Raum";
        edit_node: "choice of the node", "Wahl des Knotens";
        add_nodes: "new nodes", "Neue Knoten";
        remove_nodes: "removing nodes", "Löschen von Knoten";
        copy_nodes: "copied nodes", "Kopierte Knoten";
        node_name: "naming a node", "Benennen eines Knotens";
        node_links: "parent or aim", "Überordnung oder Ziel";
        node_values: "values of a node", "Werte eines Knotens";
        motion: "motion of a node", "Bewegung eines Knotens";
        keys: "keys", "Schlüssel";
        interpolation: "interpolation", "Interpolation";
        mesh: "mesh", "Netz";
        shapes: "shapes", "Formen";
        deformations: "deformations", "Verformungen";
        marker: "marker", "Marke";
        pin: "pin", "Anheftung";
        shown_camera: "shown camera", "Gezeigte Kamera";
        range: "range of frames", "Bildbereich";
        replace_scene: "other scene", "Andere Szene";
        keys_to_path: "keys to path", "Schlüssel zu Bahn";
        replace_path: "other path", "Andere Bahn";
        transform: "moving points", "Verschieben von Punkten";
        deform: "deformation", "Verformung";
        insert_path: "inserted path", "Eingefügte Bahn";
        paste_points: "pasted points", "Eingefügte Punkte";
        mend: "fixing a finding", "Beheben eines Funds";
        reverse: "reversed path", "Umgekehrte Bahn";
        repeat: "repeated path", "Wiederholte Bahn";
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
