//! The menu bar (thesis A.5): opened by the pointer, by Alt and a letter, or by F10. The arrow keys
//! walk through it; in an open menu an entry's letter picks it. Letters are of the words that are
//! shown, underlined: each language has its own.

mod entry;
mod letters;

use std::borrow::Cow;

use egui::{
    Align2, Button, Color32, Context, CornerRadius, FocusDirection, Id, Key, Modifiers, Popup,
    Response, Role, Sense, SetOpenCommand, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use letters::{GERMAN, lettered, pick_by_letter, underlined};
use vides_document::StepName;
use vides_document::tool;
use vides_document::tool::Needs;
use vides_engine::limits::MIN_POINTS;

use self::entry::{Entry, Menu};
use crate::action::{Action, FileAction, PathAction, ToolAction};
use crate::setup::Theme;
use crate::state::Editor;
use crate::state::scene_view::{NewNode, NodeCommand};
use crate::state::selected::SelectionChange;
use crate::texts::{Language, fill};
use crate::windows::sub_window::{below_bar, is_cramped};
use crate::{keys, theme};
pub(super) use letters::letters;

/// Room for a mark before an entry's text.
const MARK: f32 = 28.0;
/// Room for a line between entries.
const LINE: f32 = 9.0;
/// Height of a group's heading.
const HEADING: f32 = 22.0;
/// Beside a menu's title.
const TITLE_MARGIN: f32 = 6.0;
/// The same in a narrow window.
const NARROW_MARGIN: f32 = 3.0;
/// Between the texts and their keys.
const APART: f32 = 32.0;

fn menus(editor: &Editor) -> [Menu; 6] {
    let entries = [file, edit, output, tools, settings, help];
    let mut entries = entries.into_iter().map(|entries| entries(editor));
    let none = editor
        .is_first_screen()
        .then_some(editor.texts().space.no_path);
    let possible = |entry: Entry| match none.filter(|_| entry.action.needs_path()) {
        Some(why_not) => entry.only_if(false, why_not),
        None => entry,
    };
    letters(editor.language(), editor.fixed_speeds).map(|(letter, title)| {
        let entries = entries.next().unwrap_or_default().into_iter();
        Menu {
            title,
            letter,
            entries: lettered(entries.map(possible).collect()),
        }
    })
}

/// The actions of a menu and the words of their entries.
#[cfg(test)]
pub(super) fn names(editor: &Editor, menu: usize) -> Vec<(Action, Cow<'static, str>)> {
    let entries = menus(editor).into_iter().nth(menu);
    let entries = entries.map(|menu| menu.entries).unwrap_or_default();
    let named = entries.into_iter().map(|entry| (entry.action, entry.text));
    named.collect()
}

fn file(editor: &Editor) -> Vec<Entry> {
    let (texts, hints) = (&editor.texts().menu, &editor.texts().menu_hints);
    let mut file = vec![
        Entry::new(texts.new, hints.new, FileAction::New),
        Entry::new(texts.load, hints.load, FileAction::Load),
        Entry::new(texts.load_object, hints.load_object, FileAction::LoadObject),
        Entry::new(texts.save, hints.save, FileAction::Save).apart(),
        Entry::new(texts.save_as, hints.save_as, FileAction::SaveAs),
        Entry::new(texts.import, hints.import, FileAction::Import).apart(),
        Entry::new(texts.export, hints.export, FileAction::Export),
    ];
    let recent = editor.recent.iter().zip(editor.recent_names());
    file.extend(recent.enumerate().map(|(number, (path, name))| Entry {
        text: name.into(),
        hint: fill(hints.recent, &[&path.display()]).into(),
        apart: number == 0,
        ..Entry::new("", "", FileAction::Recent(number))
    }));
    file.push(Entry::new(texts.quit, hints.quit, FileAction::Quit).apart());
    file
}

fn edit(editor: &Editor) -> Vec<Entry> {
    let (texts, hints) = (&editor.texts().menu, &editor.texts().menu_hints);
    let (position, output) = (&editor.texts().position, &editor.texts().output);
    let orientation = &editor.texts().orientation;
    let orientations = editor.point().map_or(1, |point| point.orientations.len());
    let path = editor.document.path();
    let closed = path.closed;
    let [back, forth] = editor.document.step_names();
    let several = editor.several().is_some();
    let (copy, copy_hint) = match several {
        true => (texts.copy_points, hints.copy_points),
        false => (texts.copy_orientation, hints.copy_orientation),
    };
    let close_hint = if closed { hints.open } else { hints.close };
    let travels = [
        travel(editor, false, back).only_if(editor.document.can_undo(), output.nothing_to_undo),
        travel(editor, true, forth).only_if(editor.document.can_redo(), output.nothing_to_redo),
    ];
    let [add_hint, add_many_hint] = editor.add_hints();
    let (otherwise, otherwise_hint) = match editor.adds_copies() {
        true => (texts.add_keeping, position.only_keep_hint),
        false => (texts.add_copy, position.only_copy_hint),
    };
    let of_path = [
        Entry::new(texts.add_point, add_hint, PathAction::AddPoint)
            .only_if(editor.has_segment(), position.last_point)
            .apart(),
        Entry::new(otherwise, otherwise_hint, PathAction::AddPointOtherwise)
            .only_if(editor.has_segment(), position.last_point),
        Entry::new(texts.add_points, add_many_hint, PathAction::AskPoints)
            .only_if(editor.has_segment(), position.last_point),
        Entry {
            text: editor.removal(),
            ..Entry::new("", position.remove_hint, PathAction::RemovePoint)
        }
        .only_if(path.points.len() > MIN_POINTS, position.two_remain),
        Entry::new(texts.append, hints.append, PathAction::AppendPoint)
            .only_if(!closed, position.closed_has_no_ends),
        Entry::new(texts.prepend, hints.prepend, PathAction::PrependPoint)
            .only_if(!closed, position.closed_has_no_ends),
        Entry::new(texts.close, close_hint, PathAction::SwitchClosed)
            .letter(Key::G)
            .on(closed),
        Entry::new(
            editor.texts().space.all_points,
            hints.select_all,
            Action::Choose(SelectionChange::All),
        ),
        Entry::new(
            texts.add_orientation,
            orientation.add_hint,
            PathAction::AddOrientation,
        )
        .apart(),
        Entry::new(
            texts.remove_orientation,
            orientation.remove_hint,
            PathAction::RemoveOrientation,
        )
        .only_if(orientations > 1, orientation.one_remains),
        Entry::new(copy, copy_hint, Action::Copy).apart(),
        Entry::new(texts.cut, hints.cut, Action::Cut).only_if(several, output.nothing_to_cut),
        Entry::new(texts.paste, hints.paste, Action::Paste),
        Entry::new(
            texts.paste_orientation,
            hints.paste_orientation,
            PathAction::PasteOrientation,
        )
        .only_if(editor.copied.is_some(), output.nothing_copied),
        Entry::new(texts.aim_all, hints.aim_all, PathAction::AimAll),
        Entry::new(texts.speeds, hints.speeds, Action::SpeedCurve).apart(),
        Entry::new(texts.space, hints.space, Action::Space),
    ];
    let of_path = match editor.document.edits_path() {
        true => of_path,
        false => of_path.map(|entry| without_path(editor, entry)),
    };
    travels
        .into_iter()
        .chain(of_path)
        .chain(nodes(editor))
        .collect()
}

/// An entry where no path is edited: what is done to points is done to nodes.
fn without_path(editor: &Editor, entry: Entry) -> Entry {
    let (texts, hints) = (&editor.texts().menu, &editor.texts().menu_hints);
    let (text, hint) = match entry.action {
        Action::Path(PathAction::RemovePoint) => (texts.remove_nodes, hints.remove_nodes),
        Action::Choose(SelectionChange::All) => (texts.all_nodes, hints.all_nodes),
        Action::Copy => (texts.copy_nodes, hints.copy_nodes),
        Action::Cut => (texts.cut_nodes, hints.cut_nodes),
        Action::Paste => (texts.paste, hints.paste_nodes),
        _ => return entry.only_if(false, editor.texts().tools.only_path),
    };
    let selects = matches!(entry.action, Action::Choose(_) | Action::Paste);
    let possible = selects || editor.current_node().is_some();
    Entry {
        text: text.into(),
        hint: hint.into(),
        enabled: true,
        ..entry
    }
    .only_if(possible, editor.texts().scene.nothing_copied)
}

/// What adds a node to the scene, or makes one of a path.
fn nodes(editor: &Editor) -> [Entry; 4] {
    let (texts, hints) = (&editor.texts().menu, &editor.texts().menu_hints);
    let add = |text, hint, command| Entry::new(text, hint, Action::Nodes(command));
    let new = NodeCommand::Add;
    [
        add(texts.add_object, hints.add_object, NodeCommand::AddObject).apart(),
        add(texts.add_light, hints.add_light, new(NewNode::Light)),
        add(texts.add_camera, hints.add_camera, new(NewNode::Camera)),
        add(texts.add_group, hints.add_group, new(NewNode::Group)),
    ]
}

/// An entry for undo or redo that says what it takes back or does again.
fn travel(editor: &Editor, redo: bool, step: Option<StepName>) -> Entry {
    let hints = &editor.texts().menu_hints;
    let (hint, action) = if redo {
        (hints.redo, Action::Redo)
    } else {
        (hints.undo, Action::Undo)
    };
    let text = editor.language().travel(redo, step);
    let hint = match step {
        Some(_) => format!("{text}. {hint}").into(),
        None => Cow::Borrowed(hint),
    };
    // Whatever its words are.
    let letter = match (editor.language(), redo) {
        (Language::English, false) => Key::U,
        (_, false) => Key::R,
        (Language::English, true) => Key::R,
        (_, true) => Key::W,
    };
    Entry {
        text,
        hint,
        ..Entry::new("", "", action).letter(letter)
    }
}

fn output(editor: &Editor) -> Vec<Entry> {
    let (texts, hints) = (&editor.texts().menu, &editor.texts().menu_hints);
    vec![
        Entry::new(texts.export, hints.export, FileAction::Export).letter(Key::D),
        Entry::new(texts.hand_over, hints.hand_over, Action::HandOver)
            .letter(Key::U)
            .only_if(editor.host_takes_poses, texts.nobody_takes),
        Entry::new(texts.hands_over, hints.hands_over, Action::SwitchHandsOver)
            .letter(Key::L)
            .on(editor.auto_hand_over)
            .only_if(editor.host_takes_poses, texts.nobody_takes),
    ]
}

/// The tools in four groups and two columns, each in the order of the table.
fn tools(editor: &Editor) -> Vec<Entry> {
    let (language, texts) = (editor.language(), &editor.texts().tools);
    let group_of = |tool: &tool::Tool| match tool.name {
        _ if tool.is_move() || tool.needs() == Needs::Stroke => 0,
        "steady" | "avoid" | "picture" | "tour" | "fit" => 1,
        "reverse" | "repeat" | "frames" | "retime" => 3,
        _ => 2,
    };
    let entry = |tool: tool::Tool| {
        let more = if tool.needs() == Needs::Nothing && !tool.has_numbers() {
            ""
        } else {
            " …"
        };
        Entry {
            text: format!("{}{more}", language.tool(tool.name)).into(),
            ..Entry::new("", language.tool_hint(&tool), ToolAction::Open(tool))
        }
    };
    let headings = [texts.moves, texts.planning, texts.shape, texts.timing];
    let mut entries = Vec::new();
    for (group, heading) in headings.into_iter().enumerate() {
        let first = entries.len();
        let of_group = tool::tools().filter(|tool| group_of(tool) == group);
        entries.extend(of_group.map(entry));
        if group == 1 {
            let check = &editor.texts().check;
            entries.push(Entry::new(check.menu, check.menu_hint, Action::Check));
        }
        if let Some(entry) = entries.get_mut(first) {
            (entry.heading, entry.beside) = (heading, group == 2);
        }
    }
    let possible = editor.document.edits_path();
    let entries = entries.into_iter();
    entries
        .map(|entry| entry.only_if(possible, texts.only_path))
        .collect()
}

fn settings(editor: &Editor) -> Vec<Entry> {
    let (texts, hints) = (&editor.texts().menu, &editor.texts().menu_hints);
    let display = &editor.texts().display;
    let speaks = |text, hint, language| {
        Entry::new(text, hint, Action::Language(language)).on(editor.setup.language == language)
    };
    let look = |text, hint, theme| {
        Entry::new(text, hint, Action::Theme(theme)).on(editor.setup.theme == theme)
    };
    vec![
        Entry::new(texts.colours, hints.colours, Action::Colours).letter(match editor.language() {
            Language::German => Key::F,
            Language::English => Key::C,
        }),
        Entry::new(texts.display, hints.display, Action::Display).letter(Key::Z),
        Entry::new(
            editor.texts().space.sliders,
            editor.texts().space.sliders_tip,
            Action::SwitchSliders,
        )
        .on(editor.shows_sliders()),
        Entry::new(
            editor.texts().space.wireframe,
            editor.texts().space.wireframe_tip,
            Action::SwitchWireframe,
        )
        .on(editor.setup.wireframe),
        look(texts.as_system, hints.as_system, None).apart(),
        look(texts.dark, hints.dark, Some(Theme::Dark)),
        look(texts.light, hints.light, Some(Theme::Light)),
        // Each language by its own name, for those who speak it.
        speaks(display.automatic, display.language_hint, None).apart(),
        speaks(display.german, display.german_hint, Some(Language::German)),
        speaks(
            display.english,
            display.english_hint,
            Some(Language::English),
        ),
        Entry::new(texts.load_setup, hints.load_setup, FileAction::LoadSetup)
            .letter(Key::T)
            .apart(),
        Entry::new(texts.save_setup, hints.save_setup, FileAction::SaveSetup).letter(Key::P),
    ]
}

fn help(editor: &Editor) -> Vec<Entry> {
    let (texts, hints) = (&editor.texts().menu, &editor.texts().menu_hints);
    vec![Entry::new(texts.keys, hints.keys, Action::Keys)]
}

#[derive(Clone, Debug, Default)]
struct Bar {
    popups: Vec<Id>,
    /// The entries of the open menu that can be picked.
    entries: Vec<Id>,
    /// The keyboard goes to the first entry as soon as it is there.
    wants_first: bool,
}

impl Bar {
    fn open(&self, context: &Context) -> Option<usize> {
        let is_open = |&popup: &Id| Popup::is_id_open(context, popup);
        self.popups.iter().position(is_open)
    }
}

/// Shows the menus; returns the action that was picked.
pub(super) fn show(editor: &Editor, ui: &mut Ui) -> Option<Action> {
    let memory = Id::unique("menu bar");
    let mut bar: Bar = ui.data(|data| data.get_temp(memory)).unwrap_or_default();
    let menus = menus(editor);
    // A question has the keyboard.
    let mut picked = (!editor.windows.has_modal())
        .then(|| walk(ui.ctx(), &mut bar, &menus))
        .flatten();
    let open = bar.open(ui.ctx());
    bar.popups.clear();
    bar.entries.clear();
    let margin = if is_cramped(ui.ctx()) {
        NARROW_MARGIN
    } else {
        TITLE_MARGIN
    };
    ui.spacing_mut().button_padding = vec2(margin, 0.0);
    ui.spacing_mut().item_spacing.x = 0.0;
    for (index, menu) in menus.iter().enumerate() {
        let words = underlined(menu.title, Some(menu.letter), theme::palette(ui).text);
        let mut title = Button::new(words).frame_when_inactive(false);
        if open == Some(index) {
            let fill = theme::palette(ui).hovered;
            title = title.frame_when_inactive(true).fill(fill);
        } else if open.is_some() {
            // The pointer may rest on another one.
            title = title.fill(Color32::TRANSPARENT).stroke(Stroke::NONE);
        }
        let response = ui.add(title);
        let mut popup = Popup::menu(&response);
        bar.popups.push(popup.get_id());
        // An open menu gives way to the one that the pointer moves onto; a resting pointer leaves
        // the choice to the keyboard.
        let came = response.hovered() && ui.input(|input| input.pointer.delta() != Vec2::ZERO);
        if came && open.is_some_and(|open| open != index) {
            popup = popup.open_memory(Some(SetOpenCommand::Bool(true)));
        }
        let inner = popup.show(|ui| show_entries(editor, ui, menu, &mut bar));
        picked = picked.or(inner.and_then(|inner| inner.inner));
    }
    ui.data_mut(|data| data.insert_temp(memory, bar));
    picked
}

fn show_entries(editor: &Editor, ui: &mut Ui, menu: &Menu, bar: &mut Bar) -> Option<Action> {
    let mut picked = None;
    ui.spacing_mut().item_spacing.y = 0.0;
    let keys = |entry: &Entry| {
        let keys = keys::words(editor.language(), &entry.action);
        keys.unwrap_or_default()
    };
    let width = |text: &str| {
        let galley = ui
            .painter()
            .layout_no_wrap(text.to_owned(), theme::text(), Color32::WHITE);
        galley.size().x
    };
    let widest = |of: &dyn Fn(&Entry) -> f32| menu.entries.iter().map(of).fold(0.0, f32::max);
    let all =
        MARK + widest(&|entry| width(&entry.text)) + APART + widest(&|entry| width(&keys(entry)));
    let columns = || menu.entries.chunk_by(|_, next| !next.beside);
    let row = columns()
        .map(|entries| row_height(ui, entries))
        .fold(theme::ROW, f32::min);
    let size = vec2((all + 8.0).ceil(), row);
    let mut column = |ui: &mut Ui, picked: &mut Option<Action>, entries: &[Entry]| {
        for entry in entries {
            if !entry.heading.is_empty() {
                let size = vec2(size.x, HEADING);
                let (place, _) = ui.allocate_exact_size(size, Sense::hover());
                let at = pos2(place.left() + 8.0, place.bottom() - 4.0);
                let colour = theme::palette(ui).weak;
                let words = ui.painter();
                words.text(
                    at,
                    Align2::LEFT_BOTTOM,
                    entry.heading,
                    theme::small(),
                    colour,
                );
            }
            if entry.apart {
                let (line, _) = ui.allocate_exact_size(vec2(size.x, LINE), Sense::hover());
                let stroke = Stroke::new(1.0, theme::palette(ui).line);
                ui.painter().hline(line.x_range(), line.center().y, stroke);
            }
            let response = ui
                .add_enabled_ui(entry.enabled, |ui| {
                    show_entry(ui, entry, &keys(entry), size)
                })
                .inner;
            if entry.enabled {
                bar.entries.push(response.id);
                if bar.wants_first {
                    bar.wants_first = false;
                    response.request_focus();
                }
            }
            if response.clicked() {
                *picked = Some(entry.action.clone());
                ui.close();
            }
            response
                .on_hover_text(&*entry.hint)
                .on_disabled_hover_text(&*entry.hint);
        }
    };
    ui.horizontal_top(|ui| {
        for entries in columns() {
            ui.vertical(|ui| column(ui, &mut picked, entries));
        }
    });
    picked
}

/// How high a row may be for a column of entries to fit into the window.
fn row_height(ui: &Ui, entries: &[Entry]) -> f32 {
    let lines = entries.iter().filter(|entry| entry.apart).count() as f32;
    let headed = |entry: &&Entry| !entry.heading.is_empty();
    let headings = entries.iter().filter(headed).count() as f32;
    let frame = ui.spacing().menu_margin.sum().y + 2.0;
    let room = below_bar(ui.ctx()).height() - frame - LINE * lines - HEADING * headings;
    (room / entries.len() as f32).floor().max(theme::ROW / 2.0)
}

fn show_entry(ui: &mut Ui, entry: &Entry, keys: &str, size: Vec2) -> Response {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let palette = theme::palette(ui);
    let painter = ui.painter();
    if entry.enabled && (response.hovered() || response.has_focus()) {
        painter.rect_filled(rect, CornerRadius::same(4), palette.hovered);
    }
    let middle = rect.center().y;
    if entry.on == Some(true) {
        let at = |x: f32, y: f32| pos2(rect.left() + 8.0 + x, middle + y);
        let tick = vec![at(0.0, 0.0), at(3.0, 3.5), at(9.0, -4.0)];
        painter.add(Shape::line(tick, Stroke::new(1.5, palette.accent)));
    }
    let left = pos2(rect.left() + MARK, middle);
    let words = painter.layout_job(underlined(&entry.text, entry.letter, palette.text));
    let place = Align2::LEFT_CENTER.anchor_size(left, words.size());
    painter.galley(place.min, words, palette.text);
    let right = pos2(rect.right() - 8.0, middle);
    painter.text(
        right,
        Align2::RIGHT_CENTER,
        keys,
        theme::text(),
        palette.weak,
    );
    response.widget_info(|| match entry.on {
        Some(on) => WidgetInfo::selected(Role::MenuItemCheckBox, entry.enabled, on, &*entry.text),
        None => WidgetInfo::labeled(Role::MenuItem, entry.enabled, &*entry.text),
    });
    response
}

fn walk(context: &Context, bar: &mut Bar, menus: &[Menu]) -> Option<Action> {
    let open = bar.open(context);
    if let Some(open) = open
        && let Some(action) = pick_by_letter(context, &menus[open])
    {
        Popup::close_all(context);
        return Some(action);
    }
    // F10 opens the first one, as in many programs.
    let letters = menus.iter().map(|menu| menu.letter).chain(GERMAN);
    let keys = letters.map(|letter| (Modifiers::ALT, letter));
    let keys = keys.chain([(Modifiers::NONE, Key::F10)]);
    for (index, (modifiers, key)) in keys.enumerate() {
        if let Some(&popup) = bar.popups.get(index % menus.len())
            && context.input_mut(|input| {
                // Shift+F10 is another key.
                !input.modifiers.shift && input.consume_key(modifiers, key)
            })
        {
            keys::release(context);
            Popup::open_id(context, popup);
            bar.wants_first = true;
            return None;
        }
    }
    let open = open?;
    let count = bar.popups.len();
    let step = |forth: Key, back: Key| {
        context.input_mut(|input| {
            let forth = input.consume_key(Modifiers::NONE, forth);
            let back = input.consume_key(Modifiers::NONE, back);
            isize::from(forth) - isize::from(back)
        })
    };
    let across = step(Key::ArrowRight, Key::ArrowLeft);
    if across != 0 {
        let next = (open + if across > 0 { 1 } else { count - 1 }) % count;
        if let Some(&popup) = bar.popups.get(next) {
            Popup::open_id(context, popup);
            bar.wants_first = true;
        }
    }
    let down = step(Key::ArrowDown, Key::ArrowUp);
    let entries = bar.entries.len();
    if down != 0 && entries > 0 {
        let focused = context.memory(|memory| memory.focused());
        let at = focused.and_then(|id| bar.entries.iter().position(|&entry| entry == id));
        let next = match (at, down > 0) {
            (Some(at), true) => (at + 1) % entries,
            (Some(at), false) => (at + entries - 1) % entries,
            (None, true) => 0,
            (None, false) => entries - 1,
        };
        if let Some(&entry) = bar.entries.get(next) {
            context.memory_mut(|memory| memory.request_focus(entry));
        }
    }
    if across != 0 || down != 0 {
        // egui would go on to whatever lies in that direction.
        context.memory_mut(|memory| memory.move_focus(FocusDirection::None));
    }
    None
}

#[cfg(test)]
mod keyboard_tests;
#[cfg(test)]
mod tests;
