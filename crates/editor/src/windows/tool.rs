//! The window of a tool: fields for what its table asks for. The path is shown with the tool
//! applied, in a step of the document that is open as long as the window: `OK` and Enter end the
//! step, `Cancel`, the cross and Escape take it back.
//!
//! Nothing else gets into that step: a change that the user makes first takes what is shown, as `OK`
//! does; a change by the host, undo and another tool take it back, as `Cancel` does. Looking round,
//! playing, choosing a point and saving leave it alone: files, the host and recovery get
//! [`Editor::document`], which is without it.

use std::ops::Range;
use std::path::Path;

use egui::{Align, Context, Layout, Pos2, Ui, vec2};
use glam::DVec3;
use vides_document::error::{EngineError, Error, OutOfRange, Result};
use vides_document::tool::{Cage, Made, Needs, Tool, ToolInput};
use vides_document::{Document, Edit, StepName};
use vides_engine::path::Pose;
use vides_engine::tools::check::FindingKind;
use vides_engine::tools::fit::Progress;
use vides_engine::tools::{Parameter, Unit};

use crate::action::{Action, ToolAction};
use crate::background::Background;
use crate::entry::Entry;
use crate::number::{Number, decimals};
use crate::panels::parts::share;
use crate::state::Editor;
use crate::state::files::Purpose;
use crate::state::windows::{FitShown, ToolWindow};
use crate::texts::refusals::of_edit;
use crate::texts::{Language, fill};
use crate::theme;
use crate::windows::dock::docked;
use crate::windows::fit::Offer;

/// Width of a number beside its name.
const NUMBER: f32 = 84.0;

/// The choice of a move's place by which it comes after the last point.
const APPEND: f64 = 2.0;

/// Height of what is said above the fields: two lines.
const WORDS: f32 = 32.0;

impl ToolWindow {
    pub(super) const ID: &'static str = "tool";

    /// Shows it. What closes it is an action.
    pub(super) fn show(
        &mut self,
        editor: &Editor,
        context: &Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let language = editor.language();
        let texts = &editor.texts().tools;
        let ok = match self.tool.needs() {
            Needs::Output => [texts.write, texts.write_hint],
            _ => [texts.ok, texts.ok_hint],
        };
        let able = self.trouble.is_none() && self.work.is_none() && !self.lacks_stroke();
        let named = (Self::ID, language.tool(self.tool.name));
        let end = docked(editor, context, named, Some((ok, able)), |ui| {
            let palette = theme::palette(ui);
            ui.colored_label(palette.weak, language.tool_hint(&self.tool));
            // Above the fields, which may have to be scrolled, and which stay where they are when
            // the words change.
            ui.scope(|ui| {
                ui.set_min_height(WORDS);
                match (&self.work, &self.trouble) {
                    (Some(work), _) if self.unapplied.is_none() => work.show(ui),
                    (_, Some(trouble)) => ui.colored_label(palette.error, trouble),
                    _ => ui.colored_label(palette.weak, self.result(editor)),
                };
            });
            self.fields(editor, ui, actions);
            let fit = self.fit.as_ref();
            match fit.and_then(|fit| fit.show(editor, ui, actions)) {
                Some(Offer::Tolerance(tolerance)) => {
                    self.set_named("tolerance", tolerance.position);
                    self.set_named("angle", tolerance.angle);
                }
                Some(Offer::Robust) => self.set_named("robust", 1.0),
                None => {}
            }
        });
        let slow = || (self.tool).takes_long(&editor.document, &self.material, &self.numbers);
        let busy = self.work.is_some() || !self.tool.follows_drags();
        let waits = self.before.is_some() && busy && slow();
        if self.asked != self.numbers && !waits {
            // Before what ends it, which goes by these numbers.
            actions.insert(0, Action::Tool(ToolAction::Preview));
        } else if self.work.as_mut().is_some_and(|work| work.is_done(context)) {
            actions.push(Action::Tool(ToolAction::Made));
        }
        actions.extend(end.map(|keeps| Action::Tool(ToolAction::End { keeps })));
        true
    }

    /// Whether it waits for a file.
    pub(crate) fn waits(&self) -> bool {
        let material = matches!(self.tool.needs(), Needs::Block | Needs::Poses);
        material && matches!(self.material, ToolInput::None)
    }

    /// Whether the left button draws a line in space.
    pub(crate) fn draws(&self) -> bool {
        self.tool.needs() == Needs::Stroke
    }

    /// What has been drawn in the camera's picture so far.
    pub(crate) fn drawn(&self) -> &[(Pos2, DVec3)] {
        &self.drawn
    }

    fn lacks_stroke(&self) -> bool {
        self.draws() && matches!(self.material, ToolInput::None)
    }

    pub(crate) fn cage(&self) -> Option<&Cage> {
        self.cage.as_ref()
    }

    pub(crate) fn control(&self) -> usize {
        self.control
    }

    /// Brings a control point to a place; the fields then show it.
    fn move_control(&mut self, at: usize, place: DVec3) {
        let Some(cage) = &self.cage else { return };
        self.control = at;
        if cage.nodes.get(at).is_some_and(|node| *node != place)
            && let Some(numbers) = self.numbers.get_mut(3 * at..3 * at + 3)
        {
            numbers.copy_from_slice(&cage.coordinates(place).to_array());
        }
    }

    /// The frame from which a tour that has been made is played.
    pub(crate) fn plays_from(&self) -> Option<f64> {
        let made = self.tool.makes_flight() && self.unapplied.is_some();
        made.then_some(self.from.unwrap_or(1.0))
    }

    /// The text that describes the size of the result.
    fn result(&self, editor: &Editor) -> String {
        if self.lacks_stroke() {
            return editor.texts().tools.draw_now.to_owned();
        }
        let of_path = || {
            let points = editor.document.path().points.len();
            Ok([points, editor.document.sampler()?.frame_count()])
        };
        match self.written.map_or_else(of_path, Ok) {
            Ok([points, frames]) => {
                let texts = &editor.texts().tools;
                fill(texts.result, &[&points, &frames])
            }
            Err(error) => of_edit(editor.language(), &error),
        }
    }

    fn fields(&mut self, editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
        let language = editor.language();
        let mut start = 0;
        for parameter in self.tool.parameters() {
            let hint = language.parameter_hint(parameter);
            let label = language.parameter(parameter.name);
            // What takes the place of the film is nowhere beside it.
            let alone = self.tool.can_add() && self.named("put") == Some(0.0);
            if parameter.name == "fit" && alone {
                start += parameter.width;
                continue;
            }
            match parameter.unit {
                Unit::Switch => {
                    let mut on = self.numbers.get(start).is_some_and(|value| *value != 0.0);
                    let tick = theme::tick(ui, &mut on, label).on_hover_text(hint);
                    if tick.clicked() {
                        self.set(start, f64::from(u8::from(on)));
                    }
                }
                Unit::Choice(names) => {
                    ui.label(label).on_hover_text(hint);
                    let words = names.iter().map(|name| language.choice(name));
                    let words: Vec<_> = (0_u32..).map(f64::from).zip(words).collect();
                    let chosen = self.numbers.get(start).copied();
                    if let Some(chosen) = theme::choices(ui, chosen, &words, hint) {
                        self.set(start, chosen);
                    }
                }
                Unit::Lattice => {
                    ui.label(label).on_hover_text(hint);
                    ui.horizontal(|ui| {
                        let width = share(ui, 3);
                        for axis in 0..3 {
                            let what = (parameter, hint, axis);
                            self.place_in_lattice(editor, ui, what, width, actions);
                        }
                    });
                    let parts = 3 * self.control..3 * self.control + 3;
                    self.numbers(editor, ui, (parameter, start, parts), actions);
                }
                _ if parameter.width == 1 => {
                    ui.horizontal_top(|ui| {
                        let layout = Layout::left_to_right(Align::Center);
                        let name = vec2(ui.available_width() - NUMBER - theme::GAP, theme::ROW);
                        ui.allocate_ui_with_layout(name, layout, |ui| {
                            ui.set_min_size(name);
                            ui.add(egui::Label::new(label).wrap()).on_hover_text(hint);
                        });
                        let width = ui.available_width();
                        self.number(editor, ui, (parameter, start, 0), width, actions);
                    });
                }
                _ => {
                    ui.label(label).on_hover_text(hint);
                    let parts = 0..parameter.width;
                    self.numbers(editor, ui, (parameter, start, parts), actions);
                }
            }
            start += parameter.width;
        }
    }

    /// Parts of a parameter side by side, unless the digits of such a space need more room.
    fn numbers(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        (parameter, start, parts): (&'static Parameter, usize, Range<usize>),
        actions: &mut Vec<Action>,
    ) {
        let third = share(ui, 3);
        let space = editor.document.path().space;
        let beside = Number::room_in_space(ui, editor.language(), space) <= third;
        let width = if beside { third } else { ui.available_width() };
        ui.horizontal_wrapped(|ui| {
            for part in parts {
                self.number(editor, ui, (parameter, start, part), width, actions);
            }
        });
    }

    /// Chooses the control point that the fields show, from 1 along each axis.
    fn place_in_lattice(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        (parameter, hint, axis): (&'static Parameter, &'static str, usize),
        width: f32,
        actions: &mut Vec<Action>,
    ) {
        let language = editor.language();
        let letter = ["i", "j", "k"][axis];
        let place = self.control >> (2 * axis) & 3;
        let name = format!("{} {letter}", language.parameter(parameter.name));
        let number = Number::new(&name, Some(place as f64 + 1.0))
            .label(letter)
            .hint(hint)
            .whole()
            .range(1.0..=4.0)
            .steps(1.0, 0.05);
        let id = format!("tool.{}.{}.{letter}", self.tool.name, parameter.name);
        match number.show(ui, language, &id, width) {
            Entry::Drag(value) | Entry::Set(value) => {
                let chosen = (1..4).take_while(|&at| value > f64::from(at)).count();
                self.control += chosen << (2 * axis);
                self.control -= place << (2 * axis);
            }
            Entry::Wrong(text) => actions.push(Action::Complain(text)),
            Entry::Idle | Entry::Begin | Entry::End | Entry::Cancel => {}
        }
    }

    /// The poses that a path is fitted to, and the indices of those that do not count.
    pub(crate) fn recorded(&self) -> Option<(&[Pose], &[usize])> {
        match (&self.material, &self.fit) {
            (ToolInput::Poses(poses, ..), fit) => {
                let left_out = fit.as_ref().map_or(&[][..], |fit| &fit.left_out);
                Some((poses, left_out))
            }
            _ => None,
        }
    }

    fn named(&self, name: &str) -> Option<f64> {
        self.numbers.get(self.tool.place_of(name)?).copied()
    }

    fn set_named(&mut self, name: &str, value: f64) {
        if let Some(at) = self.tool.place_of(name) {
            self.set(at, value);
        }
    }

    /// What a field of a fit shows: the points follow from the tolerance, or the tolerance from the
    /// points.
    fn follows(&self, name: &str) -> Option<f64> {
        let fit = self.fit.as_ref()?;
        let by_points = *self.numbers.get(self.tool.place_of("points")?)? > 0.0;
        match (name, by_points) {
            ("points", false) => Some(fit.report.points as f64),
            ("tolerance", true) => Some(fit.tolerance.position),
            ("angle", true) => Some(fit.tolerance.angle),
            _ => None,
        }
    }

    /// What is set along with a number: a tolerance that is entered takes the place of the points.
    fn set_along(&self, name: &str) -> Vec<(usize, f64)> {
        let along = ["tolerance", "angle"].into_iter();
        let along =
            along.filter_map(|other| Some((self.tool.place_of(other)?, self.follows(other)?)));
        let along: Vec<_> = along.collect();
        match (name, self.tool.place_of("points")) {
            ("tolerance" | "angle", Some(points)) if !along.is_empty() => {
                along.into_iter().chain([(points, 0.0)]).collect()
            }
            _ => Vec::new(),
        }
    }

    fn set(&mut self, at: usize, value: f64) {
        if let Some(number) = self.numbers.get_mut(at) {
            *number = value;
        }
    }

    fn number(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        (parameter, start, part): (&'static Parameter, usize, usize),
        width: f32,
        actions: &mut Vec<Action>,
    ) {
        let language = editor.language();
        let at = start + part;
        let letter = if parameter.width >= 3 {
            ["x", "y", "z"][part % 3]
        } else {
            ""
        };
        let label = language.parameter(parameter.name);
        let name = format!("{label} {letter}");
        let value = self.follows(parameter.name);
        let value = value.or_else(|| self.numbers.get(at).copied());
        let number = Number::new(name.trim_end(), value)
            .label(letter)
            .hint(language.parameter_hint(parameter));
        let number = match parameter.unit {
            // Small against the space.
            Unit::Length if parameter.name == "tolerance" => {
                let size = editor.document.path().space.half_size;
                let number = number.decimals(decimals(size) + 2);
                number.steps(1e-3 * size, 1e-4 * size)
            }
            Unit::Length => number.in_space(editor.document.path().space),
            Unit::Degrees => number.degrees(),
            Unit::Zoom => number.unit(" mm").decimals(1).steps(1.0, 0.1),
            Unit::Seconds => number.seconds().steps(1.0, 0.05),
            Unit::Count => number.whole().steps(1.0, 0.1),
            Unit::One | Unit::Choice(_) | Unit::Switch | Unit::Lattice => number.steps(0.1, 0.01),
        };
        let number = number.range(parameter.least..=parameter.most).pending();
        let id = format!("tool.{}.{}.{part}", self.tool.name, parameter.name);
        let along = self.set_along(parameter.name);
        let set = |numbers: &mut Vec<f64>, value| {
            for (at, value) in along.into_iter().chain([(at, value)]) {
                if let Some(number) = numbers.get_mut(at) {
                    *number = value;
                }
            }
        };
        let entry = number.show(ui, language, &id, width);
        entry.apply(&mut self.before, &mut self.numbers, set, actions);
    }

    /// Points and frames that would be written to a file.
    fn to_write(&self, document: &Document) -> Result<[usize; 2]> {
        let block = self.tool.extracted(document, &self.numbers)?;
        Ok([block.path().points.len(), block.sampler()?.frame_count()])
    }

    /// Writes the points that it names to a file; returns the first and the last, from 1.
    pub(crate) fn write(&self, document: &Document, file: &Path) -> Result<[f64; 2]> {
        self.tool.extracted(document, &self.numbers)?.save(file)?;
        let of = |at: usize| self.numbers.get(at).copied().unwrap_or_default();
        Ok([of(0), of(1)])
    }
}

/// Why a tool refuses its numbers.
fn reason(language: Language, error: &Error) -> String {
    match error {
        Error::Engine(EngineError::Range(OutOfRange::NumberBetween(name, least, most))) => {
            let bound = |value: f64| {
                let decimals = usize::from(value.fract() != 0.0) * 6;
                let text = language.number(value, decimals);
                text.trim_end_matches(if decimals > 0 { '0' } else { ' ' })
                    .to_owned()
            };
            let text = language.texts().errors.out_of_range;
            let label = language.parameter(name);
            fill(text, &[&label, &bound(*least), &bound(*most)])
        }
        error => of_edit(language, error),
    }
}

/// What a tool works on beside the window.
fn copied(document: &Document) -> Result<Document> {
    Document::from_parts(document.path().try_clone()?, document.info().clone())
}

/// Whether a check finds the path outside its space, between its points, too.
fn leaves_space(document: &Document) -> Result<bool> {
    let found = document.check_against(None, &mut |_, _| true)?;
    Ok(found
        .iter()
        .any(|finding| finding.kind == FindingKind::Space))
}

impl Editor {
    /// Begins with a tool, or first asks for the file that it needs.
    pub(crate) fn open_tool(&mut self, tool: Tool) {
        if tool.makes_flight() && !self.has_object() {
            self.choose_file(Purpose::LoadObject(Some(tool)));
            return;
        }
        if !self.prepare_tool(tool) {
            return;
        }
        match tool.needs() {
            Needs::Block => self.choose_file(Purpose::LoadBlock),
            Needs::Poses => self.choose_file(Purpose::Import),
            Needs::Nothing | Needs::Output | Needs::Stroke => self.preview_tool(),
        }
    }

    /// Opens the window of a tool that does nothing yet; false, and a sentence, if it cannot.
    pub(crate) fn prepare_tool(&mut self, tool: Tool) -> bool {
        self.cancel_tool();
        self.document.end_step();
        let last = self.document.path().points.len().saturating_sub(1);
        let [first, last] = match self.several() {
            // From the first selected point to the last one.
            Some(&[first, .., last]) => [first, last],
            _ => [0, last],
        };
        let numbers = match tool.defaults_between(&self.document, first, last) {
            Ok(numbers) => numbers,
            Err(error) => {
                self.complain_of(&error);
                return false;
            }
        };
        // A film that is there stays: what is made comes after it.
        let adds = tool.can_add() && !self.document.is_new();
        let mut window = ToolWindow {
            tool,
            material: ToolInput::None,
            asked: numbers.clone(),
            numbers,
            before: None,
            trouble: None,
            unapplied: None,
            cage: None,
            control: 0,
            drawn: Vec::new(),
            written: None,
            fit: None,
            work: None,
            from: None,
            stood: (self.playing.frame(), self.document.selection()),
        };
        if adds {
            window.set_named("put", APPEND);
            window.asked.clone_from(&window.numbers);
        }
        self.windows.tool = Some(window);
        self.windows.dock(ToolWindow::ID);
        true
    }

    /// Gives the tool what it works on.
    pub(crate) fn begin_tool_with(&mut self, material: ToolInput) {
        if let Some(window) = &mut self.windows.tool {
            if let ToolInput::Poses(poses, ..) = &material
                && let Some(tolerance) = window.tool.usual_tolerance(poses)
            {
                window.set_named("tolerance", tolerance);
            }
            window.material = material;
        }
        self.preview_tool();
    }

    /// Continues the line that is drawn in the camera's picture.
    pub(crate) fn draw_on(&mut self, at: Pos2, place: DVec3) {
        if let Some(window) = &mut self.windows.tool {
            window.drawn.push((at, place));
        }
    }

    /// Takes or gives up what was drawn in the camera's picture.
    pub(crate) fn end_drawing(&mut self, keeps: bool) {
        let Some(window) = &mut self.windows.tool else {
            return;
        };
        let drawn = std::mem::take(&mut window.drawn);
        if keeps && drawn.len() > 2 {
            let places = drawn.into_iter().map(|(_, place)| place).collect();
            self.begin_tool_with(ToolInput::Stroke(places));
        }
    }

    pub(crate) fn move_control(&mut self, at: usize, place: DVec3) {
        if let Some(window) = &mut self.windows.tool {
            window.move_control(at, place);
        }
        self.preview_tool();
    }

    /// Shows the path with the tool applied, or why that is impossible.
    pub(crate) fn preview_tool(&mut self) {
        let Some(mut window) = self.windows.tool.take() else {
            return;
        };
        let tool = window.tool;
        let slow = |window: &ToolWindow, document: &Document| {
            self.start.is_some() && tool.takes_long(document, &window.material, &window.numbers)
        };
        // During a drag what is shown stays until the next is made.
        let drags = window.before.is_some() && tool.follows_drags();
        let stays = drags && slow(&window, &self.document);
        if !stays && window.unapplied.take().is_some() {
            self.document.cancel_step();
        }
        if tool.asks_object() {
            // Where it cannot be had the tool says why.
            let object = self.obstacles().ok().flatten();
            window.material = object.map_or(ToolInput::None, ToolInput::Object);
        }
        let document = &self.document;
        window.work = None;
        window.asked.clone_from(&window.numbers);
        window.cage = tool.cage(document, &window.numbers);
        if !(self.start.is_some() && tool.takes_long(document, &window.material, &window.numbers)) {
            let made = tool.edit(document, &window.material, &window.numbers, &mut |_, _| {
                true
            });
            self.show_made(window, made);
            return;
        }
        let copy = match &window.unapplied {
            Some(document) => copied(document),
            None => self.apart(),
        };
        let (material, numbers) = (window.material.clone(), window.numbers.clone());
        let make = move |progress: Progress<'_>| tool.edit(&copy?, &material, &numbers, progress);
        let mut work = match drags {
            true => Background::begin_for_later(self.start, make),
            false => Background::begin(self.start, make),
        };
        match work.made() {
            Some(made) => self.show_made(window, made),
            None => {
                (window.work, window.trouble) = (Some(work), None);
                self.windows.tool = Some(window);
            }
        }
    }

    /// Shows what the tool has made beside the window.
    pub(crate) fn tool_made(&mut self) {
        let window = self.windows.tool.as_mut();
        if let Some(made) = window.and_then(|window| window.work.take()?.made())
            && let Some(window) = self.windows.tool.take()
        {
            self.show_made(window, made);
        }
    }

    fn show_made(&mut self, mut window: ToolWindow, made: Result<Made>) {
        if window.unapplied.take().is_some() {
            self.document.cancel_step();
        }
        // The point after which it comes, if it does not take the place of all.
        let after = made.as_ref().ok().and_then(|made| match made.edit {
            Some(Edit::InsertPath { at, .. }) => Some(at),
            _ => None,
        });
        let recorded = window.tool.needs() == Needs::Poses;
        let begins = self.begins() || recorded;
        let fixed = self.times_are_fixed();
        let language = self.language();
        let document = &mut self.document;
        let shown = made.and_then(|made| {
            let unapplied = Box::new(document.try_clone()?);
            document.begin_step();
            document.name_step(StepName::Tool(window.tool.name));
            // What comes between points takes the time that it says.
            let between = |edit: &Edit| {
                let path = document.path();
                let last = path.points.len() - 1;
                matches!(edit, Edit::InsertPath { at, .. } if path.closed || *at < last)
            };
            match made.edit {
                Some(edit) if fixed && !between(&edit) => document.apply_keeping_times(edit),
                edit => document.apply_all(edit),
            }?;
            // A path that begins, and a flight that takes its place, has the room that it needs.
            let leaves = match window.tool.makes_flight() {
                true => leaves_space(document)?,
                false => begins && document.points_outside() > 0,
            };
            if leaves {
                let space = document.space_around_all()?;
                let grown = Edit::SetSpace { space, fit: false };
                match fixed {
                    true => document.apply_keeping_times(grown),
                    false => document.apply(grown),
                }?;
            }
            Ok((unapplied, made.fit))
        });
        window.from = after.and_then(|at| self.frame_of_point(at + 1));
        let document = &mut self.document;
        let from = window.from.unwrap_or(1.0);
        let fitted = |result| FitShown::new(result, from - 1.0);
        (window.unapplied, window.fit, window.trouble) = match shown {
            Ok((unapplied, fit)) => (Some(unapplied), fit.map(fitted), None),
            Err(error) => {
                document.cancel_step();
                (None, None, Some(reason(language, &error)))
            }
        };
        window.written = match window.tool.needs() {
            Needs::Output if window.unapplied.is_some() => window.to_write(document).ok(),
            _ => None,
        };
        self.windows.tool = Some(window);
    }

    /// Ends by `OK`, or by cancelling.
    pub(crate) fn end_tool(&mut self, keeps: bool) {
        let output = |window: &ToolWindow| window.tool.needs() == Needs::Output;
        if keeps && self.windows.tool.as_ref().is_some_and(output) {
            self.choose_file(Purpose::SaveBlock);
        } else if keeps {
            self.take_tool();
        } else {
            self.cancel_tool();
        }
    }

    /// Makes what the tool shows a step, and closes its window.
    pub(crate) fn take_tool(&mut self) {
        if let Some(window) = self.windows.tool.take()
            && window.unapplied.is_some()
        {
            self.document.end_step();
            self.tell_ambiguities();
        }
    }

    /// Takes back what the tool shows, and closes its window.
    pub(crate) fn cancel_tool(&mut self) {
        if let Some(window) = self.windows.tool.take() {
            if window.unapplied.is_some() {
                self.document.cancel_step();
            }
            let (frame, selection) = window.stood;
            self.playing.put_back(frame, selection);
        }
    }
}

#[cfg(test)]
#[path = "tool_tests.rs"]
mod tests;
