//! What will look wrong in the film: the findings of a check, each with its frames. A click leads
//! there; where an edit helps, a button does it.
//!
//! The path is checked again as soon as nothing is held any more. Where that would take long, it
//! waits until it is asked for, and is done beside the window. The tree over the object is kept as long as the object is the same.

use egui::{Button, Context, Label, RichText, Ui, vec2};
use glam::DVec3;
use vides_document::error::Result;
use vides_document::{Edit, Selection, StepName};
use vides_engine::tools::check::{Finding, FindingKind, OFF};

use crate::action::Action;
use crate::background::Background;
use crate::entry::Entry;
use crate::number::Number;
use crate::state::Editor;
use crate::state::windows::{CheckWindow, Windows};
use crate::texts::fill;
use crate::texts::refusals::{of_edit, reason_of};
use crate::theme;
use crate::windows::dock::docked;
use crate::windows::sub_window::SubWindow;

/// Width of the button with the frames, of that which fixes, of a limit's number.
const FRAMES: f32 = 116.0;
const MEND: f32 = 84.0;
const NUMBER: f32 = 80.0;

/// A limit's number stands below its name.
const INDENT: f32 = 20.0;

/// What a jerk is limited to when it is first looked for: gentle flights have less.
const JERK: f64 = 100.0;

/// A film with more frames, or an object with more pieces, is checked when asked.
const LONG: usize = 20_000;
const LARGE: usize = 200_000;

/// More findings are not listed.
const MOST: usize = 500;

impl SubWindow for CheckWindow {
    const ID: &'static str = "check";
    const DOCKED: bool = true;

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.check
    }

    fn new(_: &Editor) -> Self {
        Self::default()
    }

    fn show(&mut self, editor: &Editor, context: &Context, actions: &mut Vec<Action>) -> bool {
        let texts = &editor.texts().check;
        let current = self.checked == Some(editor.document.revision());
        self.take_cure(editor, (context, current), actions);
        let end = docked(editor, context, (Self::ID, texts.title), None, |ui| {
            let palette = theme::palette(ui);
            let count = match self.found.len() {
                0 => texts.nothing.to_owned(),
                1 => texts.one.to_owned(),
                many => fill(texts.many, &[&many]),
            };
            ui.horizontal_wrapped(|ui| {
                match &self.trouble {
                    Some(trouble) => ui.colored_label(palette.error, trouble),
                    None if self.checked.is_none() => ui.colored_label(palette.weak, texts.large),
                    None => ui.label(count),
                };
                if let Some(before) = self.before.filter(|_| current) {
                    ui.colored_label(palette.weak, fill(texts.before, &[&before]));
                }
                if !current && self.checking.is_none() && !is_quick(editor) {
                    if self.checked.is_some() {
                        ui.colored_label(palette.weak, texts.old);
                    }
                    let button = ui.button(texts.now).on_hover_text(texts.now_hint);
                    self.asked |= button.clicked();
                }
            });
            if progress(editor, ui, self.curing.as_ref().map(|(_, work)| work)) {
                self.curing = None;
            }
            if progress(editor, ui, self.checking.as_ref().map(|(_, work)| work)) {
                self.checking = None;
            }
            for note in &self.notes {
                let text = RichText::new(editor.language().note(note)).color(palette.weak);
                ui.add(Label::new(text).wrap());
            }
            let open = ui.selectable_label(self.limits, texts.limits);
            self.limits ^= open.on_hover_text(texts.limits_hint).clicked();
            let free = current && self.curing.is_none();
            if self.limits {
                limits(editor, ui, actions);
            }
            for (at, (finding, mend)) in self.found.iter().zip(&self.mends).enumerate() {
                ui.push_id(at, |ui| row(editor, ui, (finding, mend), free, actions));
            }
        });
        end.is_none()
    }
}

/// How far work is; whether it is cancelled.
fn progress<T: Send + 'static>(editor: &Editor, ui: &mut Ui, work: Option<&Background<T>>) -> bool {
    work.is_some_and(|work| {
        let cancelled = ui.horizontal(|ui| {
            let cancel = ui.button(editor.texts().tools.cancel);
            work.show(ui);
            cancel.clicked()
        });
        cancelled.inner
    })
}

/// The limits of this path: whether a kind is looked for, and from where on.
fn limits(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let (texts, language) = (&editor.texts().check, editor.language());
    let info = editor.document.info();
    let with = |kind: FindingKind, limit: f64| {
        let mut info = info.clone();
        let set = info.limits.set(kind, limit);
        set.map(|()| Edit::SetInfo(Box::new(info)))
            .map_err(|error| reason_of(language, &error.into()))
    };
    for kind in FindingKind::all() {
        let (known, limit) = (kind.limit(), info.limits.get(kind));
        let [name, unit] = language.limit(kind);
        let mut on = limit != OFF;
        let tick = theme::tick(ui, &mut on, name);
        if tick.on_hover_text(texts.limit_hint).clicked() {
            let usual = if known.default == OFF {
                JERK
            } else {
                known.default
            };
            let entry = Entry::Set(if on { usual } else { OFF });
            actions.push(Action::Enter(entry.try_map(|limit| with(kind, limit))));
        }
        if on && kind != FindingKind::Through {
            ui.horizontal(|ui| {
                ui.add_space(INDENT);
                let id = format!("check.limit.{}", known.name);
                let entry = Number::new(name, limit)
                    .decimals(if limit < 10.0 { 2 } else { 0 })
                    .range(0.0..=known.most)
                    .hint(kind.name())
                    .show(ui, language, &id, NUMBER);
                actions.push(Action::Enter(entry.try_map(|limit| with(kind, limit))));
                ui.label(unit);
            });
        }
    }
    ui.separator();
}

fn row(
    editor: &Editor,
    ui: &mut Ui,
    (finding, mend): (&Finding, &Option<Vec<Edit>>),
    free: bool,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().check;
    let [from, to] = [finding.first_frame, finding.last_frame].map(|frame| {
        let number = editor.document.number_of_frame(frame);
        editor.language().number(number.round(), 0)
    });
    let frames = if from == to {
        fill(texts.frame, &[&from])
    } else {
        fill(texts.frames, &[&from, &to])
    };
    let (words, remedy) = editor.language().finding(finding);
    let helps = mend.as_ref().is_none_or(|edits| !edits.is_empty());
    ui.horizontal(|ui| {
        let hint = fill(texts.go_hint, &[&(finding.point + 1)]);
        // A place to go to, not a thing to be done.
        let text = RichText::new(&frames).color(theme::palette(ui).accent);
        let button = Button::new(text).frame_when_inactive(false);
        let response = ui.add(button.min_size(vec2(FRAMES, theme::ROW)));
        let response = response.on_hover_text(hint);
        response.widget_info(|| {
            egui::WidgetInfo::labeled(egui::Role::Button, true, format!("{frames}: {words}"))
        });
        if response.clicked() {
            actions.push(Action::GoTo(*finding));
        }
        // What takes longer is computed when it is asked for.
        if helps {
            let button = Button::new(texts.mend).min_size(vec2(MEND, theme::ROW));
            let button = ui.add_enabled(free, button);
            if button.on_hover_text(remedy).clicked() {
                actions.push(match mend {
                    None => Action::Cure(*finding),
                    Some(edits) => Action::Mend(*finding, edits.clone()),
                });
            }
        }
    });
    ui.add(Label::new(words).wrap());
    if !helps {
        // Nothing does it: what helps is told.
        let text = RichText::new(remedy).color(theme::palette(ui).weak);
        ui.add(Label::new(text).wrap());
    }
    ui.add_space(theme::GAP);
}

/// Whether a check takes no noticeable time.
fn is_quick(editor: &Editor) -> bool {
    let frames = editor
        .document
        .sampler()
        .map(|sampler| sampler.frame_count());
    let mut pieces = editor.document.info().object.pieces();
    if let Some(edited) = editor.document.edited_scene() {
        for node in edited.scene().nodes() {
            if let vides_engine::scene::Kind::Object(object) = &node.kind {
                let mesh = object.mesh();
                pieces += mesh.triangles.len() + mesh.lines.len() + mesh.points.len();
            }
        }
    }
    pieces <= LARGE && frames.is_ok_and(|frames| frames <= LONG)
}

impl CheckWindow {
    /// Checks the path again, unless something is held; also behind another docked window, since
    /// the ruler shows what was found.
    pub(super) fn keep_up(&mut self, editor: &Editor, context: &Context) {
        let held = context.input(|input| input.pointer.any_down()) || editor.space.moves();
        let current = self.checked == Some(editor.document.revision());
        if !current && !held && is_quick(editor) {
            self.checking = None;
            self.check(editor);
        } else if !current && !held && self.asked {
            self.begin(editor);
        }
        let revision = editor.document.revision();
        if let Some((of, work)) = &mut self.checking {
            // What is found in another path is given up.
            if *of != revision {
                self.checking = None;
            } else if work.is_done(context) {
                let made = work.made();
                self.checking = None;
                if let Some(made) = made {
                    self.take(editor, made);
                }
            }
        }
    }

    /// Begins a check beside the window.
    fn begin(&mut self, editor: &Editor) {
        self.asked = false;
        let (copy, object) = (editor.apart(), editor.obstacles());
        let work = Background::begin(editor.start, move |progress| {
            copy?.check_against(object?.as_deref(), progress)
        });
        self.checking = Some((editor.document.revision(), work));
    }

    pub(crate) fn found(&self) -> &[Finding] {
        &self.found
    }

    /// Takes what the planner has made; what it makes of another path is given up.
    fn take_cure(
        &mut self,
        editor: &Editor,
        (context, current): (&Context, bool),
        actions: &mut Vec<Action>,
    ) {
        let Some((finding, work)) = &mut self.curing else {
            return;
        };
        if current && !work.is_done(context) {
            return;
        }
        match work.made().filter(|_| current) {
            Some(Ok(edits)) => actions.push(Action::Mend(*finding, edits)),
            Some(Err(error)) => {
                actions.push(Action::Complain(of_edit(editor.language(), &error)));
            }
            None => {}
        }
        self.curing = None;
    }

    fn check(&mut self, editor: &Editor) {
        self.asked = false;
        let found = editor.obstacles().and_then(|tree| {
            let go_on = &mut |_, _| true;
            editor.document.check_against(tree.as_deref(), go_on)
        });
        self.take(editor, found);
    }

    /// Takes what was found in the path as it is now.
    fn take(&mut self, editor: &Editor, found: Result<Vec<Finding>>) {
        let mended = self.mended == Some(editor.document.revision());
        self.before = mended.then_some(self.found.len());
        self.checked = Some(editor.document.revision());
        (self.found, self.mends, self.notes) = Default::default();
        let document = &editor.document;
        let looked = editor.obstacles().and_then(|tree| {
            self.found = found?;
            self.notes = document.notes(tree.as_deref(), true)?;
            // What spoils the film stands before what makes it less smooth.
            self.found.sort_by_key(|finding| match finding.kind {
                FindingKind::Through => 0,
                FindingKind::Clearance => 1,
                _ => 2,
            });
            let listed = self.found.iter().take(MOST);
            self.mends = listed
                .map(|finding| document.quick_remedy(finding))
                .collect::<Result<_>>()?;
            Ok(())
        });
        self.trouble = looked.err().map(|error| of_edit(editor.language(), &error));
    }
}

impl Editor {
    /// Moves the playhead to a finding, and selects the key before it.
    pub(crate) fn go_to(&mut self, finding: &Finding) {
        let frame = self.document.frame_of_scene(finding.first_frame);
        self.scrub(frame);
        let selection = Selection::at(finding.point, finding.orientation);
        if self.document.selection() != selection
            && self
                .document
                .select(finding.point, finding.orientation)
                .is_ok()
        {
            self.playing
                .put_back(self.playing.frame().or(Some(frame)), selection);
        }
    }
}

impl Editor {
    /// Leaves playhead and selection where they were before an edit, as far as they are still there.
    fn stay_at_key(&mut self, frame: Option<f64>, selection: Selection, at: Option<DVec3>) {
        let count = self.document.sampler().map(|sampler| sampler.frame_count());
        let frame = frame
            .zip(count.ok())
            .map(|(frame, count)| frame.min(count as f64));
        let points = &self.document.path().points;
        // Points may have come or gone before it.
        let same = points.iter().position(|point| Some(point.position) == at);
        let same = same.filter(|_| points.get(selection.point).map(|point| point.position) != at);
        let point = same.unwrap_or(selection.point.min(points.len() - 1));
        let last = points[point].orientations.len() - 1;
        let orientation = selection.orientation.min(last);
        if self.document.select(point, orientation).is_ok() {
            self.playing
                .put_back(frame, Selection::at(point, orientation));
        }
    }

    /// Fixes a finding with the planner, or reports why it cannot.
    pub(crate) fn cure(&mut self, finding: &Finding) {
        let copy = self.apart();
        let (object, finding) = (self.obstacles(), *finding);
        let mut work = Background::begin(self.start, move |progress| {
            copy?.remedy(&finding, object?.as_deref(), progress)
        });
        match (work.made(), &mut self.windows.check) {
            (Some(Ok(edits)), _) => self.mend(&finding, edits),
            (Some(Err(error)), _) => self.complain_of(&error),
            (None, Some(window)) => window.curing = Some((finding, work)),
            (None, None) => {}
        }
    }

    /// Applies the fix of a finding as one step and reports it. Keeps frame, point and view.
    pub(crate) fn mend(&mut self, finding: &Finding, edits: Vec<Edit>) {
        if edits.is_empty() {
            return self.complain(self.texts().check.no_fix);
        }
        let (frame, selection) = (self.playing.frame(), self.document.selection());
        let at = self.point().map(|point| point.position);
        self.document.begin_step();
        self.document.name_step(StepName::Mend);
        if self.edit_together(edits) {
            self.document.end_step();
            let revision = self.document.revision();
            if let Some(check) = &mut self.windows.check {
                check.mended = Some(revision);
            }
            self.stay_at_key(frame, selection, at);
            let mended = self.language().mended(finding.kind);
            let from = self.document.number_of_frame(finding.first_frame);
            let from = self.language().number(from.round(), 0);
            self.say(fill(mended, &[&(finding.point + 1), &from]));
        } else {
            self.document.cancel_step();
        }
    }
}

#[cfg(test)]
#[path = "check_tests.rs"]
mod tests;
