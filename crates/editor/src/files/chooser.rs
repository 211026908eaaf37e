//! The file window: a directory, a filter, a name (thesis A.5, fig. A.8).
//!
//! By mouse: a click chooses, a double click takes, a name is proposed for saving. By keyboard: the
//! name has the focus, the up and down arrows go through the list, Enter takes, Alt and the up arrow
//! go to the directory above.

use std::cmp::Reverse;
use std::path::{Path, PathBuf};

use egui::{
    Align, Button, Context, Key, Label, Layout, Modifiers, RichText, ScrollArea, Sense, Ui, vec2,
};
use vides_formats::{Format, formats};

use super::listing::{MAX_ENTRIES, fits, is_hidden};
use super::naming::{described, filter_of, is_export, tidy, with_ending};
use crate::action::{Action, FileAction};
use crate::files::exchange::DEFAULT;
use crate::files::recovery_window::date_in_words;
use crate::files::{folders, picture, readable, short};
use crate::state::Editor;
use crate::state::files::{FileWindow, Folder, Item, Order, Picture, Purpose};
use crate::texts::fill;
use crate::texts::formats::title_of;
use crate::texts::refusals::of_system;
use crate::theme;
use crate::windows::sub_window::{modal, takes_keyboard};

const WIDTH: f32 = 520.0;
/// Rows seen at once, in a window that is high enough.
const ROWS: f32 = 12.0;
/// Width of the labels before the fields.
const LABELS: f32 = 88.0;
/// Size of the picture of a path.
const PICTURE: egui::Vec2 = vec2(148.0, 112.0);

/// Files that become the object, and all that a path is begun with.
const OBJECTS: &str = "*.obj *.ply *.stl *.gltf *.glb";
const OPENED: &str = "*.vid *.obj *.ply *.stl *.gltf *.glb";

#[derive(Default)]
struct Done {
    go: Option<PathBuf>,
    take: bool,
    cancel: bool,
}

impl FileWindow {
    pub(crate) fn open(editor: &Editor, purpose: Purpose) -> Self {
        let texts = &editor.texts().files;
        let importable = filter_of(Format::reads);
        let exported = filter_of(is_export);
        let (name, filter) = match purpose {
            Purpose::LoadPath => (String::new(), OPENED),
            Purpose::LoadBlock => (String::new(), "*.vid"),
            Purpose::SaveBlock => (format!("{}.vid", texts.block), "*.vid"),
            Purpose::Import => (String::new(), importable.as_str()),
            Purpose::SavePath(_) => (editor.proposal(texts.proposal, "vid"), "*.vid"),
            Purpose::LoadObject(_)
            | Purpose::AddObject
            | Purpose::LoadMesh(_)
            | Purpose::LoadShape(_) => (String::new(), OBJECTS),
            Purpose::Export => (editor.proposal(texts.poses, "txt"), exported.as_str()),
            Purpose::LoadSetup => (String::new(), "*.toml"),
            Purpose::SaveSetup => (folders::SETUP_NAME.to_owned(), "*.toml"),
        };
        let mut window = Self {
            purpose,
            folder: Folder::empty(PathBuf::new()),
            place: String::new(),
            name,
            chosen: None,
            filter: filter.to_owned(),
            own_filter: filter.to_owned(),
            order: editor.file_order,
            format: (purpose == Purpose::Export).then_some(DEFAULT),
            hidden: false,
            trouble: None,
            overwrite: None,
            fresh: true,
            scroll: false,
            picture: None,
        };
        window.go(editor, editor.folder_for(purpose));
        window
    }

    /// Shows it; false: it closes. A chosen file is an action, which closes it.
    pub(crate) fn show(
        &mut self,
        editor: &Editor,
        context: &Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        self.folder.read_on();
        if self.folder.is_reading() {
            context.request_repaint();
        }
        let texts = &editor.texts().files;
        let title = match self.purpose {
            Purpose::LoadPath => texts.load_path,
            Purpose::SavePath(_) => texts.save_path,
            Purpose::LoadObject(_) => texts.load_object,
            Purpose::AddObject => texts.add_object,
            Purpose::Export => texts.export,
            Purpose::LoadSetup => texts.load_setup,
            Purpose::SaveSetup => texts.save_setup,
            Purpose::LoadBlock => texts.load_block,
            Purpose::SaveBlock => texts.save_block,
            Purpose::Import => texts.import,
            Purpose::LoadMesh(_) => editor.texts().node.mesh_title,
            Purpose::LoadShape(_) => editor.texts().node.shape_title,
        };
        let mut done = Done::default();
        let asks = self.overwrite.is_some();
        if !asks {
            self.keys(context, &mut done);
        }
        let escape = context.input(|input| input.key_pressed(Key::Escape));
        modal(context, "files", title, WIDTH, |ui| {
            if asks {
                self.show_question(editor, ui, &mut done);
            } else {
                self.show_choice(editor, ui, &mut done);
            }
        });
        if done.cancel || escape {
            self.overwrite = None;
            self.fresh = true;
            return asks;
        }
        if let Some(place) = done.go {
            self.go(editor, place);
        } else if done.take {
            let file = self.take(editor);
            actions.extend(
                file.map(|file| Action::File(FileAction::FileChosen(self.purpose, tidy(&file)))),
            );
        }
        true
    }

    /// Shows why the chosen file was refused.
    pub(crate) fn refused(mut self, trouble: String) -> Self {
        self.trouble = Some(trouble);
        self.fresh = true;
        self
    }

    /// Goes to a directory, unless it cannot be read.
    fn go(&mut self, editor: &Editor, place: PathBuf) {
        let place = tidy(&place);
        self.trouble = None;
        match Folder::open(place.clone()) {
            Ok(folder) => self.folder = folder,
            Err(error) => {
                let why = of_system(editor.language(), &error);
                let text = editor.texts().errors.cannot_list;
                self.trouble = Some(fill(text, &[&readable(place.as_os_str()), &why]));
                if self.folder.path.as_os_str().is_empty() {
                    self.folder = Folder::empty(place);
                }
            }
        }
        self.place = readable(self.folder.path.as_os_str());
        self.chosen = None;
        if self.loads() {
            self.name.clear();
        }
        self.folder.read_on();
    }

    fn loads(&self) -> bool {
        matches!(
            self.purpose,
            Purpose::LoadPath
                | Purpose::LoadObject(_)
                | Purpose::LoadMesh(_)
                | Purpose::LoadShape(_)
                | Purpose::AddObject
                | Purpose::LoadSetup
                | Purpose::LoadBlock
                | Purpose::Import
        )
    }

    /// The indices of the items that are shown.
    fn rows(&self) -> Vec<usize> {
        let items = self.folder.items.iter().enumerate();
        let shown = items
            .filter(|(_, item)| self.hidden || !is_hidden(&item.name))
            .filter(|(_, item)| item.is_folder || fits(&item.shown, &self.filter));
        let mut rows: Vec<usize> = shown.map(|(index, _)| index).collect();
        let item = |at: &usize| &self.folder.items[*at];
        // Directories come first, and what is equal keeps the order of names.
        match self.order {
            Order::Name => {}
            Order::Date => {
                rows.sort_by_key(|at| (!item(at).is_folder, Reverse(item(at).written)));
            }
            Order::Size => rows.sort_by_key(|at| (!item(at).is_folder, Reverse(item(at).size))),
        }
        rows
    }

    fn current(&self) -> Option<usize> {
        let chosen = self.chosen.as_ref()?;
        self.folder
            .items
            .iter()
            .position(|item| item.name == *chosen)
    }

    fn choose(&mut self, index: usize) {
        if let Some(item) = self.folder.items.get(index) {
            self.chosen = Some(item.name.clone());
            if !item.is_folder {
                self.name.clone_from(&item.shown);
            }
            self.trouble = None;
        }
    }

    /// Keys that work wherever the keyboard is.
    fn keys(&mut self, context: &Context, done: &mut Done) {
        let pressed = |modifiers, key| context.input_mut(|input| input.consume_key(modifiers, key));
        if pressed(Modifiers::ALT, Key::ArrowUp) {
            done.go = self.folder.above().map(Path::to_owned);
        }
        let by = isize::from(pressed(Modifiers::NONE, Key::ArrowDown))
            - isize::from(pressed(Modifiers::NONE, Key::ArrowUp));
        if by != 0 {
            let rows = self.rows();
            let at = self
                .current()
                .and_then(|index| rows.iter().position(|&row| row == index));
            let next = match at {
                Some(at) => at
                    .saturating_add_signed(by)
                    .min(rows.len().saturating_sub(1)),
                None => 0,
            };
            if let Some(&index) = rows.get(next) {
                self.choose(index);
                self.scroll = true;
            }
            context.memory_mut(|memory| memory.move_focus(egui::FocusDirection::None));
        }
    }

    fn show_choice(&mut self, editor: &Editor, ui: &mut Ui, done: &mut Done) {
        let texts = &editor.texts().files;
        let field = |ui: &mut Ui, label: &str| {
            let (rect, _) = ui.allocate_exact_size(vec2(LABELS, theme::ROW), Sense::hover());
            let color = theme::palette(ui).weak;
            let place = rect.left_center();
            ui.painter().text(
                place,
                egui::Align2::LEFT_CENTER,
                label,
                theme::text(),
                color,
            );
        };
        ui.horizontal(|ui| {
            field(ui, texts.folder);
            let buttons = 2.0 * (88.0 + ui.spacing().item_spacing.x);
            let (width, words) = (
                ui.available_width() - buttons,
                (texts.folder, texts.folder_hint),
            );
            let response = theme::line_edit(ui, &mut self.place, "files.place", width, words);
            let known = self.place == readable(self.folder.path.as_os_str());
            if entered(ui, &response) && !known {
                done.go = Some(self.resolved(&self.place));
            }
            let above = self.folder.above().map(Path::to_owned);
            let size = vec2(88.0, theme::ROW);
            let up = ui.add_enabled(above.is_some(), Button::new(texts.up).min_size(size));
            if up.on_hover_text(texts.up_hint).clicked() {
                done.go = above;
            }
            let home = folders::home();
            let button = ui.add_enabled(home.is_some(), Button::new(texts.home).min_size(size));
            if button.on_hover_text(texts.home_hint).clicked() {
                done.go = home;
            }
        });
        ui.horizontal(|ui| {
            field(ui, texts.order);
            ui.spacing_mut().item_spacing.x = 3.0 * theme::GAP;
            for (order, name) in [
                (Order::Name, texts.by_name),
                (Order::Date, texts.by_date),
                (Order::Size, texts.by_size),
            ] {
                if theme::choice(ui, self.order == order, name).clicked() {
                    self.order = order;
                    self.scroll = true;
                }
            }
        });
        self.show_list_and_picture(editor, ui, done);
        ui.horizontal(|ui| {
            field(ui, texts.name);
            let (width, words) = (ui.available_width(), (texts.name, texts.name_hint));
            let response = theme::line_edit(ui, &mut self.name, "files.name", width, words);
            if takes_keyboard(ui, &response, &mut self.fresh) {
                // Without the ending, so that typing replaces the rest of a proposed name.
                let end = self.name.rfind('.').unwrap_or(self.name.len());
                theme::select(ui, response.id, &self.name[..end]);
            }
            if response.changed() {
                self.chosen = None;
            }
            if entered(ui, &response) {
                done.take = true;
            }
        });
        ui.horizontal(|ui| {
            field(ui, texts.filter);
            let layout = Layout::right_to_left(Align::Center);
            ui.with_layout(layout, |ui| {
                theme::tick(ui, &mut self.hidden, texts.hidden).on_hover_text(texts.hidden_hint);
                self.show_filter(editor, ui);
            });
        });
        if self.purpose == Purpose::Export {
            ui.horizontal(|ui| {
                field(ui, texts.format);
                self.show_formats(editor, ui);
            });
        }
        let palette = theme::palette(ui);
        let trouble = self.trouble.as_deref().unwrap_or_default();
        ui.add_sized(
            vec2(ui.available_width(), 20.0),
            Label::new(RichText::new(trouble).color(palette.error)).halign(egui::Align::Min),
        );
        let take = match self.purpose {
            Purpose::Export => texts.write,
            _ if self.loads() => texts.load,
            _ => texts.save,
        };
        let [cancel, taken] = buttons(ui, [texts.cancel, take]);
        done.cancel |= cancel.on_hover_text(texts.cancel_hint).clicked();
        done.take |= taken.on_hover_text(texts.take_hint).clicked();
    }

    /// Which files are shown, by name; patterns of one's own can be typed.
    fn show_filter(&mut self, editor: &Editor, ui: &mut Ui) {
        let texts = &editor.texts().files;
        let own = match self.purpose {
            Purpose::LoadPath => texts.kind_opened,
            Purpose::SavePath(_) | Purpose::LoadBlock | Purpose::SaveBlock => texts.kind_paths,
            Purpose::Import | Purpose::Export => texts.kind_formats,
            Purpose::LoadSetup | Purpose::SaveSetup => texts.kind_setups,
            _ => texts.kind_objects,
        };
        let words = match self.filter.as_str() {
            filter if filter == self.own_filter => own,
            "" => texts.all_files,
            other => other,
        };
        let size = vec2(ui.available_width(), theme::ROW);
        let open = ui.add(Button::new(words).truncate().min_size(size));
        open.widget_info(|| egui::WidgetInfo {
            current_text_value: Some(words.to_owned()),
            ..egui::WidgetInfo::labeled(egui::Role::ComboBox, true, texts.filter)
        });
        let stays = egui::PopupCloseBehavior::CloseOnClickOutside;
        let menu = egui::Popup::menu(&open).close_behavior(stays);
        menu.show(|ui| {
            for (name, filter) in [
                (own, self.own_filter.clone()),
                (texts.all_files, String::new()),
            ] {
                let chosen = self.filter == filter;
                if ui.add(Button::selectable(chosen, name)).clicked() {
                    self.filter = filter;
                    ui.close();
                }
            }
            let words = (texts.patterns, texts.filter_hint);
            theme::line_edit(ui, &mut self.filter, "files.filter", 280.0, words);
        });
        open.on_hover_text(texts.filter_hint);
    }

    /// The name of the chosen format.
    pub(crate) fn format(&self) -> Option<&'static str> {
        self.format
    }

    /// The formats that are written; choosing one changes the name's ending.
    fn show_formats(&mut self, editor: &Editor, ui: &mut Ui) {
        let (texts, language) = (&editor.texts().files, editor.language());
        let typed = Path::new(self.name.trim());
        // A name that is typed may tell another one.
        let fits = |name| vides_formats::by_name(name).is_ok_and(|format| format.is_named(typed));
        if !self.format.is_some_and(fits)
            && let Ok(told) = vides_formats::by_target(typed)
        {
            self.format = Some(told.name);
        }
        let Ok(current) = vides_formats::by_name(self.format.unwrap_or(DEFAULT)) else {
            return;
        };
        let open = Button::new(described(language, current))
            .min_size(vec2(ui.available_width(), theme::ROW));
        let open = ui.add(open);
        open.widget_info(|| egui::WidgetInfo {
            current_text_value: Some(title_of(language, current).to_owned()),
            ..egui::WidgetInfo::labeled(egui::Role::ComboBox, true, texts.format)
        });
        egui::Popup::menu(&open).width(320.0).show(|ui| {
            // All of them, where the window is high enough.
            let room = ui.ctx().content_rect().height() - 40.0;
            ScrollArea::vertical().max_height(room).show(ui, |ui| {
                for format in formats().iter().filter(|format| is_export(format)) {
                    let chosen = format.name == current.name;
                    if ui
                        .add(Button::selectable(chosen, described(language, format)))
                        .clicked()
                        && !chosen
                    {
                        self.choose_format(current, format);
                    }
                }
            });
        });
        open.on_hover_text(texts.format_hint);
    }

    fn choose_format(&mut self, old: &Format, new: &Format) {
        self.format = Some(new.name);
        self.chosen = None;
        let name = self.name.trim();
        let ending = Path::new(name)
            .extension()
            .and_then(|ending| ending.to_str());
        let known =
            ending.filter(|ending| old.all_endings().any(|of| ending.eq_ignore_ascii_case(of)));
        let cut = known.map_or(0, |ending| ending.len() + 1);
        let stem = &name[..name.len() - cut];
        self.name = match (new.endings, new.file_names) {
            ([ending, ..], _) => format!("{stem}.{ending}"),
            ([], [name, ..]) => (*name).to_owned(),
            // A folder.
            ([], []) => stem.to_owned(),
        };
    }

    /// The list, and a picture of the path chosen in it.
    fn show_list_and_picture(&mut self, editor: &Editor, ui: &mut Ui, done: &mut Done) {
        if !matches!(self.purpose, Purpose::LoadPath | Purpose::LoadBlock) {
            return self.show_list(editor, ui, done);
        }
        ui.horizontal_top(|ui| {
            let width = ui.available_width() - PICTURE.x - ui.spacing().item_spacing.x;
            ui.vertical(|ui| {
                ui.set_max_width(width);
                self.show_list(editor, ui, done);
            });
            let item = self.current().and_then(|at| self.folder.items.get(at));
            let file = item.filter(|item| !item.is_folder);
            let file = file.map(|item| self.folder.path.join(&item.name));
            if self.picture.as_ref().map(|of| &of.0) != file.as_ref() {
                self.picture = file.map(|file| {
                    let picture = Picture::of_file(&file, PICTURE);
                    (file, picture)
                });
            }
            if let Some((_, picture)) = &self.picture {
                picture::show(editor, ui, PICTURE, picture.as_ref());
            }
        });
    }

    fn show_list(&mut self, editor: &Editor, ui: &mut Ui, done: &mut Done) {
        let texts = &editor.texts().files;
        let palette = theme::palette(ui);
        let rows = self.rows();
        let formats = if self.purpose == Purpose::Export {
            theme::ROW + ui.spacing().item_spacing.y
        } else {
            0.0
        };
        let room = ui.ctx().content_rect().height() - 348.0 - formats;
        let height = (ROWS * theme::ROW).min(room).max(4.0 * theme::ROW);
        let current = self.current();
        let frame = egui::Frame::new()
            .fill(palette.field)
            .corner_radius(4)
            .inner_margin(4);
        frame.show(ui, |ui| {
            ui.set_min_size(vec2(ui.available_width(), height));
            ui.spacing_mut().item_spacing.y = 0.0;
            let mut area = ScrollArea::vertical().max_height(height).auto_shrink(false);
            if self.scroll
                && let Some(at) =
                    current.and_then(|index| rows.iter().position(|&row| row == index))
            {
                let middle = at as f32 * theme::ROW - height / 2.0;
                area = area.vertical_scroll_offset(middle.max(0.0));
                self.scroll = false;
            }
            let shown = area.show_rows(ui, theme::ROW, rows.len(), |ui, range| {
                for &index in rows.get(range).unwrap_or_default() {
                    self.show_row(editor, ui, (index, current == Some(index)), done);
                }
            });
            ui.ctx()
                .accesskit_node_builder(shown.id, |node| node.set_label(texts.contents));
            if rows.is_empty() {
                let words = if self.folder.is_reading() {
                    texts.reading
                } else {
                    texts.empty
                };
                let place = ui.max_rect().left_top() + vec2(8.0, theme::ROW / 2.0);
                let align = egui::Align2::LEFT_CENTER;
                ui.painter()
                    .text(place, align, words, theme::text(), palette.weak);
            }
        });
        if self.folder.more {
            ui.colored_label(palette.weak, fill(texts.more, &[&MAX_ENTRIES]));
        }
    }

    fn show_row(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        (index, chosen): (usize, bool),
        done: &mut Done,
    ) {
        let Some(item) = self.folder.items.get(index) else {
            return;
        };
        let palette = theme::palette(ui);
        let color = match (chosen, item.is_folder) {
            (true, _) => palette.on_accent,
            (false, true) => palette.accent,
            (false, false) => palette.text,
        };
        let slash = if item.is_folder { "/" } else { "" };
        let facts = facts(editor, item);
        let text = RichText::new(format!("{}{slash}", item.shown)).color(color);
        let mut button = Button::new(text)
            .truncate()
            .frame_when_inactive(chosen)
            .min_size(vec2(ui.available_width(), theme::ROW));
        if chosen {
            button = button.fill(palette.accent);
        }
        let (is_folder, path) = (item.is_folder, self.folder.path.join(&item.name));
        let response = ui
            .with_layout(egui::Layout::top_down_justified(egui::Align::Min), |ui| {
                ui.add(button)
            })
            .inner;
        let weak = if chosen {
            palette.on_accent
        } else {
            palette.weak
        };
        let right = response.rect.right_center() - vec2(8.0, 0.0);
        let words = ui.painter().layout_no_wrap(facts, theme::small(), weak);
        // Not over a long name.
        if words.size().x < 0.5 * response.rect.width() {
            let place = egui::Align2::RIGHT_CENTER.anchor_size(right, words.size());
            let ground = if chosen {
                palette.accent
            } else {
                palette.field
            };
            ui.painter()
                .rect_filled(place.expand2(vec2(6.0, 2.0)), 0.0, ground);
            ui.painter().galley(place.min, words, weak);
        }
        // The third click in a row, too, where the first one opened this window.
        if response.double_clicked() || response.triple_clicked() {
            if is_folder {
                done.go = Some(path);
            } else {
                self.choose(index);
                done.take = true;
            }
        } else if response.clicked() {
            self.choose(index);
        }
    }

    fn show_question(&mut self, editor: &Editor, ui: &mut Ui, done: &mut Done) {
        let texts = &editor.texts().files;
        let name = self.overwrite.as_deref().map_or_else(String::new, short);
        ui.label(fill(texts.exists, &[&name]));
        ui.add_space(8.0);
        let [cancel, overwrite] = buttons(ui, [texts.cancel, texts.overwrite]);
        takes_keyboard(ui, &cancel, &mut self.fresh);
        done.cancel = cancel.on_hover_text(texts.cancel_hint).clicked();
        done.take = overwrite.on_hover_text(texts.overwrite_hint).clicked();
    }

    /// A typed path: `~` is the home directory, relative ones begin at the shown directory.
    fn resolved(&self, typed: &str) -> PathBuf {
        let home = folders::home();
        match (typed.strip_prefix('~'), home) {
            (Some(""), Some(home)) => home,
            (Some(rest), Some(home)) if rest.starts_with('/') => {
                home.join(rest.trim_start_matches('/'))
            }
            _ => self.folder.path.join(typed),
        }
    }

    /// The file taken by Enter, a double click or the button; `None` if something else comes first.
    fn take(&mut self, editor: &Editor) -> Option<PathBuf> {
        if let Some(file) = self.overwrite.take() {
            return Some(file);
        }
        let typed = self.name.trim().to_owned();
        // An item of the list counts by its true name, which may be impossible to type.
        let item = self
            .current()
            .and_then(|index| self.folder.items.get(index));
        let path = match item {
            Some(item) if item.is_folder && (self.loads() || typed.is_empty()) => {
                self.folder.path.join(&item.name)
            }
            Some(item) if !item.is_folder && item.shown == self.name => {
                self.folder.path.join(&item.name)
            }
            _ if typed.is_empty() => {
                self.trouble = Some(editor.texts().files.no_name.to_owned());
                self.fresh = true;
                return None;
            }
            _ => self.resolved(&typed),
        };
        if path.is_dir() {
            self.go(editor, path);
            self.fresh = true;
            return None;
        }
        if self.loads() {
            return Some(path);
        }
        let path = with_ending(path, self.purpose, self.format);
        if path.symlink_metadata().is_ok() {
            self.overwrite = Some(path);
            self.fresh = true;
            return None;
        }
        Some(path)
    }
}

/// When a file was written, and how long it is.
fn facts(editor: &Editor, item: &Item) -> String {
    let date = item.written.and_then(editor.program.local_time);
    let date = date.map_or_else(String::new, |date| date_in_words(editor.language(), date));
    if item.is_folder {
        return date;
    }
    let (mut size, mut units) = (
        item.size as f64,
        ["B", "kB", "MB", "GB"].into_iter().peekable(),
    );
    while size >= 1000.0 && units.len() > 1 {
        (size, _) = (size / 1000.0, units.next());
    }
    let decimals = usize::from(size < 10.0 && units.len() < 4);
    let size = editor.language().number(size, decimals);
    format!("{date}   {size} {}", units.peek().unwrap_or(&"GB"))
}

fn entered(ui: &Ui, response: &egui::Response) -> bool {
    response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter))
}

fn buttons(ui: &mut Ui, texts: [&str; 2]) -> [egui::Response; 2] {
    let size = vec2(112.0, 28.0);
    ui.horizontal(|ui| {
        let used = 2.0 * size.x + ui.spacing().item_spacing.x;
        ui.add_space(ui.available_width() - used);
        texts.map(|text| ui.add(Button::new(text).min_size(size)))
    })
    .inner
}
