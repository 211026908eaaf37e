//! What is done with files.

use vides_document::trusting;

use crate::action::FileAction;
use crate::state::Editor;
use crate::state::files::{AfterSave, Purpose};

impl Editor {
    pub(crate) fn file_action(&mut self, action: FileAction, context: &egui::Context) {
        match action {
            FileAction::New => self.ask_before(AfterSave::New),
            FileAction::Load => self.ask_before(AfterSave::Load),
            FileAction::Example => self.ask_before(AfterSave::Example),
            FileAction::Save => {
                self.save(None);
            }
            FileAction::SaveAs => self.choose_file(Purpose::SavePath(None)),
            FileAction::Quit => self.ask_to_close(),
            FileAction::Dropped(files) => self.dropped(&files, context),
            FileAction::LoadObject => self.choose_file(Purpose::LoadObject(None)),
            FileAction::Export => self.choose_file(Purpose::Export),
            FileAction::Import => self.choose_file(Purpose::Import),
            FileAction::ImportUpright(file, up) => {
                if let Err(text) = self.import(&file, Some(up)) {
                    self.complain(text);
                }
            }
            FileAction::WriteAs(file, format) => {
                if let Err(text) = self.write_as(&file, format) {
                    self.complain(text);
                }
            }
            FileAction::Recent(number) => self.ask_before(AfterSave::Recent(number)),
            FileAction::Restore(number) => self.ask_before(AfterSave::Restore(number)),
            FileAction::LoadSetup => self.choose_file(Purpose::LoadSetup),
            FileAction::SaveSetup => self.choose_file(Purpose::SaveSetup),
            FileAction::FileChosen(purpose, file) => self.file_chosen(purpose, &file),
            FileAction::Discard(number) => self.discard_found(number),
            FileAction::SaveBefore(then) => self.save(Some(then)),
            FileAction::GoOn(then) => self.go_on(then),
            FileAction::Reload => self.reload(),
            FileAction::ReadOutside => trusting(|| self.reload()),
            FileAction::SaveAsBefore(then) => self.choose_file(Purpose::SavePath(then)),
            FileAction::Overwrite(then) => self.overwrite(then),
        }
    }
}
