//! Files of other programs: poses and scenes written and taken over.

use std::path::Path;

use vides_document::tool::{Needs, ToolInput, tools};
use vides_document::{Edit, SceneDocument, mesh};
use vides_engine::path::Up;
use vides_formats::{Content, Flight, Format, Loss, Options, Recording, Report, Source};

use crate::files::short;
use crate::state::Editor;
use crate::state::files::Question;
use crate::texts::fill;
use crate::texts::formats::{losses_of, reason_of};

/// The format of a file whose name tells none: the thesis's (B.2.3).
pub(super) const DEFAULT: &str = "ascii";

/// Whether a file is a mesh, by its ending, without a camera: an object rather than a scene.
pub(crate) fn is_object(file: &Path) -> bool {
    let has_camera = || {
        let options = Options::default();
        let read = Source::open(file).and_then(|source| {
            vides_formats::read(&source, None, &options, &mut Report::default())
        });
        // What cannot be read is refused when it is loaded.
        matches!(read, Ok((_, Content::Scene(document))) if document.scene.shown_camera().is_some())
    };
    mesh::Format::of(file).is_some() && !has_camera()
}

impl Editor {
    /// Writes into a file of the chosen format, or of the one its name tells; asks first if
    /// something would be lost.
    pub(crate) fn export(&mut self, file: &Path, chosen: Option<&str>) -> Result<(), String> {
        let written = |error| self.not_written(file, &error);
        let format = self.format_of(file, chosen).map_err(written)?;
        let document = self
            .document()
            .scene_document()
            .map_err(|error| self.not_written(file, &error.into()))?;
        let report = vides_formats::losses(&document, format, &Options::default());
        let report = report.map_err(|error| self.not_written(file, &error))?;
        let lost = losses_of(self.language(), &report);
        if lost.is_empty() {
            return self.write_as(file, format.name);
        }
        self.windows.question = Some(Question::losses(file, format.name, lost));
        Ok(())
    }

    fn format_of(
        &self,
        file: &Path,
        chosen: Option<&str>,
    ) -> vides_formats::Result<&'static Format> {
        let chosen = vides_formats::by_name(chosen.unwrap_or(DEFAULT))?;
        if chosen.is_named(file) {
            return Ok(chosen);
        }
        match vides_formats::by_target(file) {
            Err(error @ vides_formats::Error::SharedEnding { .. }) => Err(error),
            told => Ok(told.unwrap_or(chosen)),
        }
    }

    /// The same, whatever is lost.
    pub(crate) fn write_as(&mut self, file: &Path, format: &str) -> Result<(), String> {
        let mut count = 0;
        let mut written = || -> vides_formats::Result<()> {
            let document = self.document().scene_document()?;
            let (format, options) = (vides_formats::by_name(format)?, Options::default());
            let mut ignored = |_, _| {};
            count = Flight::new(&document, &options, format, &mut ignored)?.count();
            vides_formats::export(&document, file, format, &options, &mut |_, _| {}).map(drop)
        };
        written().map_err(|error| self.not_written(file, &error))?;
        let text = self.texts().output.written;
        self.say(fill(text, &[&count, &short(file)]));
        Ok(())
    }

    fn not_written(&self, file: &Path, error: &vides_formats::Error) -> String {
        let text = self.texts().errors.cannot_write;
        fill(text, &[&short(file), &reason_of(self, error)])
    }

    /// Takes over a file of another program: a scene in place of the document, in one step; of
    /// poses a path, by the tool that fits it. Asks which axis is up in poses whose file
    /// does not say, unless `up` does.
    pub(super) fn import(&mut self, file: &Path, up: Option<Up>) -> Result<(), String> {
        let mut report = Report::default();
        let read = |report: &mut Report| {
            let source = Source::open(file)?;
            vides_formats::read(&source, None, &Options::default(), report)
        };
        let (_, content) = read(&mut report).map_err(|error| self.not_loaded(file, &error))?;
        match content {
            Content::Poses(recording) => {
                let Some(up) = recording.up.or(up) else {
                    self.windows.question = Some(Question::upright(file));
                    return Ok(());
                };
                // The path alone is turned upright, not the scene around it.
                let scene = self.document.edited_scene();
                if scene.is_some_and(|edited| edited.scene().space().up != up) {
                    report.add(Loss::Upright(up.name()));
                }
                let taken = self.take_recording(recording, up, &mut report);
                if !taken.map_err(|error| self.not_loaded(file, &error))? {
                    return Ok(());
                }
            }
            Content::Scene(document) => {
                let SceneDocument { scene, info, .. } = *document;
                let edits = [
                    Edit::SetInfo(Box::new(info)),
                    Edit::ReplaceScene(Box::new(scene)),
                ];
                self.cancel_tool();
                let done = self.document.apply_all(edits);
                done.map_err(|error| self.refusal(self.texts().errors.cannot_load, file, &error))?;
                self.show_anew();
                // Saving does not put another program's scene over the file that was open. A host's
                // file is the host's.
                if self.program.offers_all {
                    (self.file, self.known) = (None, None);
                }
            }
        }
        self.tell_loaded(file, &report);
        Ok(())
    }

    /// Takes over poses: keyframes as the path, in one step, unless a tool waits for poses; all
    /// others by the tool that fits them; false, and a sentence, if that cannot begin.
    fn take_recording(
        &mut self,
        recording: Recording,
        up: Up,
        report: &mut Report,
    ) -> vides_formats::Result<bool> {
        let tool = self.windows.tool.as_ref();
        let waits = tool.is_some_and(|window| window.waits());
        let document_fps = self.document.info().fps;
        let space = self.document.path().space;
        if !waits && let Some(path) = recording.path(Some(space), up, document_fps)? {
            self.cancel_tool();
            self.change(|document| document.apply(Edit::ReplacePath(Box::new(path))))?;
            return Ok(true);
        }
        recording.tell_keyframes(report);
        let fps = recording.rate().unwrap_or(document_fps);
        let seconds = recording.seconds_at(fps);
        let fit = tools().find(|tool| tool.needs() == Needs::Poses);
        let ready = waits || fit.is_some_and(|fit| self.prepare_tool(fit));
        if ready {
            self.begin_tool_with(ToolInput::Poses(recording.poses, seconds, up));
        }
        Ok(ready)
    }

    fn not_loaded(&self, file: &Path, error: &vides_formats::Error) -> String {
        let text = self.texts().errors.cannot_load;
        fill(text, &[&short(file), &reason_of(self, error)])
    }

    /// That a file was taken over, and what of it was not.
    fn tell_loaded(&mut self, file: &Path, report: &Report) {
        let mut text = fill(self.texts().output.loaded, &[&short(file)]);
        let fps = self.document.info().fps;
        let decimals = if fps.fract() == 0.0 { 0 } else { 3 };
        let rate = self.language().number(fps, decimals);
        text += &format!(" · {}", fill(self.texts().output.at_rate, &[&rate]));
        for loss in losses_of(self.language(), report) {
            text += &format!(" · {loss}");
        }
        self.say(text);
    }
}
