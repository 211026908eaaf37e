//! One window at work: passes input to the editor, and its picture through the raster to the
//! screen.
//!
//! [`Window::poll`] does what is due and never waits. It returns what only the host can do, one
//! [`HostRequest`] at a time, because the host may change everything before the next.

use std::rc::Rc;
use std::time::{Duration, Instant};

use egui::{ClippedPrimitive, Context, FullOutput, ViewportCommand, ViewportId, ViewportOutput};

use super::clock;
use super::host::{Host, Id};
use super::live::{FRAME, HostEvent, Live};
use super::screen::Screen;
use crate::error::Result;
use vides_editor::{Editor, Request};
use vides_engine::inject::{self, Place};
use vides_raster::{Area, Raster};
use vides_x11::{PanePlace, PaneWindow};

/// The number of passes that may follow at once without input until sizes settle. More are an
/// animation.
const SETTLING_PASSES: u32 = 3;

/// egui asks for another pass after every event. While a button is held, the next motion causes it;
/// without motion, egui runs again after this time.
pub(super) const DRAG_PAUSE: Duration = Duration::from_millis(40);

pub(super) struct Window {
    screen: Box<dyn Screen>,
    editor: Editor,
    /// Created when the window is first served, so that opening is quick.
    context: Option<Context>,
    raster: Raster,
    /// egui should run: there is input, or something changed from outside.
    fresh: bool,
    /// No button is held and nothing is animated: the next picture will last.
    resting: bool,
    /// When egui asks to run again.
    due: Option<Instant>,
    /// The number of passes since the last input.
    passes: u32,
    /// What to paint, lowest first, and its pixels per point.
    picture: Option<(Vec<ClippedPrimitive>, f32)>,
    /// When egui ran last.
    ran: Option<Instant>,
    /// A picture is on its way to the screen.
    in_flight: bool,
    title: String,
    /// A button is held.
    held: bool,
    /// The host wants to be called while the user is editing.
    tells: bool,
    live: Live,
    /// The pane that the host knows of.
    pane: Option<PaneWindow>,
}

pub(super) struct Polled {
    /// Something was done, so there may be more to do.
    pub(super) busy: bool,
    /// What the host must do.
    pub(super) request: Option<HostRequest>,
}

/// A request that only the host can fulfil.
pub(super) enum HostRequest {
    /// Take the poses that were prepared.
    HandOver,
    /// Answer whether the window may close.
    Close,
    /// Return its own view.
    Capture {
        /// Whether the view replaces the current orientation.
        replace: bool,
    },
    /// Learn what the user does.
    Live(HostEvent),
    /// Draw in this pane from now on; `None`: the pane is closed.
    Pane(Option<PaneWindow>),
}

impl Window {
    pub(super) fn new(screen: Box<dyn Screen>, editor: Editor, title: String) -> Self {
        let background = editor.background();
        let live = Live::new(&editor);
        Self {
            screen,
            editor,
            context: None,
            raster: Raster::new(background),
            fresh: true,
            resting: false,
            due: None,
            passes: 0,
            picture: None,
            ran: None,
            in_flight: false,
            title,
            held: false,
            tells: false,
            live,
            pane: None,
        }
    }

    pub(super) fn screen(&self) -> &dyn Screen {
        &*self.screen
    }

    /// Whether the host has a pane to draw in.
    pub(super) fn shows_pane(&self) -> bool {
        self.pane.is_some()
    }

    /// For a change from outside, which is shown when the window is served next.
    pub(super) fn editor_mut(&mut self) -> &mut Editor {
        self.fresh = true;
        &mut self.editor
    }

    /// When the window must be served next without input from the screen.
    pub(super) fn due(&self, now: Instant) -> Option<Instant> {
        let told = self.live.due(&self.editor, self.held);
        let due = self.next_pass(now).into_iter().chain(told);
        due.chain(self.screen.deadline()).min()
    }

    /// When egui should run. A frame in flight comes first, unless the host is called meanwhile:
    /// the frame may take long.
    fn next_pass(&self, now: Instant) -> Option<Instant> {
        let due = if self.fresh { Some(now) } else { self.due }?;
        match self.ran {
            Some(ran) if self.in_flight => self.tells.then(|| due.max(ran + FRAME)),
            _ => Some(due),
        }
    }

    /// Does what is due. After an error, the screen is gone, and the window with it.
    pub(super) fn poll(&mut self, id: Id, host: &Rc<dyn Host>) -> Result<Polled> {
        let news = self.screen.poll()?;
        inject::point(Place::Turn);
        if news.input {
            self.fresh = true;
            self.passes = 0;
        }
        if news.motion {
            self.passes = 0;
            let next = self.ran.map(|ran| ran + FRAME);
            self.due = self.due.into_iter().chain(next).min();
        }
        if news.close {
            self.editor.ask_to_close();
            self.fresh = true;
        }
        if news.new_buffer {
            self.raster.forget();
            self.fresh = true;
        }
        if news.shown {
            self.in_flight = false;
        }
        let mut polled = Polled {
            busy: news.input || news.close || news.new_buffer || news.shown || news.more,
            request: None,
        };
        if self.pane.is_some() && self.screen.pane().is_none() {
            // Report its end before another one begins.
            self.pane = None;
            polled.request = Some(HostRequest::Pane(None));
            return Ok(polled);
        }
        let now = clock::now();
        self.tells = host.watches() || self.editor.auto_hand_over();
        if self.next_pass(now).is_some_and(|due| due <= now) {
            polled.busy = true;
            self.pass(now)?;
        }
        polled.request = self.next_host_request(id, host);
        if news.close && polled.request.is_none() {
            // A question is open, and may be hidden behind other windows.
            self.screen.raise()?;
        }
        polled.busy |= self.paint()?;
        self.screen.flush()?;
        if polled.request.is_none() {
            polled.request = self.next_live_call(id, host);
        }
        Ok(polled)
    }

    fn next_live_call(&mut self, id: Id, host: &Rc<dyn Host>) -> Option<HostRequest> {
        let (watched, now) = (host.watches(), clock::now());
        let call = self.live.next(&self.editor, watched, self.held, now)?;
        let ready = !matches!(call, HostEvent::HandOver) || self.make_ready(id, host, false);
        self.called(now);
        ready.then_some(HostRequest::Live(call))
    }

    /// A call into the host has ended.
    pub(super) fn called(&mut self, began: Instant) {
        let now = clock::now();
        self.live.called(now.saturating_duration_since(began), now);
    }

    /// Lets host code change something. Changes within a call are not reported back to the host.
    pub(super) fn command<R>(
        &mut self,
        within_a_call: bool,
        change: impl FnOnce(&mut Editor) -> R,
    ) -> R {
        self.fresh = true;
        if within_a_call {
            self.live.known(&mut self.editor, change)
        } else {
            change(&mut self.editor)
        }
    }

    pub(super) fn editor(&self) -> &Editor {
        &self.editor
    }

    /// Asks the user about unsaved work, and then the host whether the window may close.
    pub(super) fn ask_to_close(&mut self) -> Result<()> {
        self.editor_mut().ask_to_close();
        // The question may be hidden behind other windows.
        self.raise()
    }

    pub(super) fn raise(&mut self) -> Result<()> {
        self.screen.raise()?;
        Ok(self.screen.flush()?)
    }

    /// Runs egui once, which makes a picture of the current state.
    fn pass(&mut self, now: Instant) -> Result<()> {
        self.fresh = false;
        self.ran = Some(now);
        let input = self.screen.take_input();
        let editor = &mut self.editor;
        editor.keep_still(self.screen.still());
        let context = self.context.get_or_insert_with(|| {
            let context = Context::default();
            editor.prepare(&context);
            context
        });
        self.picture = None;
        let output = context.run_ui(input, |ui| {
            inject::point(Place::Layout);
            editor.show(ui);
        });
        let FullOutput {
            platform_output,
            textures_delta,
            shapes,
            pixels_per_point,
            mut viewport_output,
        } = output;
        self.raster.update_textures(textures_delta);
        self.raster.set_background(editor.background());
        let primitives = vides_raster::primitives(context, shapes, pixels_per_point);
        self.picture = Some((primitives, pixels_per_point));
        self.screen.take_output(platform_output)?;
        let ours = viewport_output.remove(&ViewportId::ROOT);
        let asks = |ours: &ViewportOutput| ours.commands.contains(&ViewportCommand::RequestPaste);
        if ours.as_ref().is_some_and(asks) {
            self.screen.ask_for_clipboard()?;
        }
        let delay = ours.map_or(Duration::MAX, |ours| ours.repaint_delay);
        self.passes = self.passes.saturating_add(1);
        let (held, pressed) =
            context.input(|input| (input.pointer.any_down(), input.pointer.any_pressed()));
        self.held = held;
        self.resting = !held && delay == Duration::MAX;
        let delay = if held && !pressed {
            delay.max(DRAG_PAUSE)
        } else if self.passes <= SETTLING_PASSES {
            delay
        } else {
            delay.max(FRAME)
        };
        self.due = now.checked_add(delay);
        let title = self.editor.window_title();
        if title != self.title {
            self.screen.set_title(&title)?;
            self.title = title;
        }
        self.place_pane(pixels_per_point)
    }

    /// Places the pane in which the host draws at the position that the editor has for it.
    fn place_pane(&mut self, pixels_per_point: f32) -> Result<()> {
        let pixels = |rect: &egui::Rect| {
            let [left, top, right, bottom] = [rect.left(), rect.top(), rect.right(), rect.bottom()]
                // Negative values become 0.
                .map(|at| (at * pixels_per_point).round() as u32);
            Area {
                x: left,
                y: top,
                width: right.saturating_sub(left),
                height: bottom.saturating_sub(top),
            }
        };
        let place = self.editor.host_pane().map(|pane| PanePlace {
            area: pixels(&pane.picture),
            above: pane.above.iter().map(pixels).collect(),
        });
        let place = place.filter(|place| place.area.width > 0 && place.area.height > 0);
        if !self.screen.place_pane(place.as_ref())? {
            self.editor.draw_pane_itself();
            self.fresh = true;
        }
        Ok(())
    }

    /// Paints what is due; true if something was shown.
    fn paint(&mut self) -> Result<bool> {
        if self.in_flight || self.picture.is_none() {
            return Ok(false);
        }
        let Some(mut target) = self.screen.target() else {
            return Ok(false);
        };
        let Some((primitives, scale)) = self.picture.take() else {
            return Ok(false);
        };
        inject::point(Place::Paint);
        let areas = self.raster.paint(&primitives, scale, &mut target);
        if self.resting {
            self.raster.trim();
        }
        if areas.is_empty() {
            return Ok(false);
        }
        self.screen.present(&areas)?;
        self.in_flight = true;
        Ok(true)
    }

    /// What the editor wants from the host, prepared.
    fn next_host_request(&mut self, id: Id, host: &Rc<dyn Host>) -> Option<HostRequest> {
        let pane = self.screen.pane();
        if pane != self.pane {
            self.pane = pane;
            return Some(HostRequest::Pane(pane));
        }
        loop {
            match self.editor.next_request()? {
                Request::Close => return Some(HostRequest::Close),
                Request::Capture { replace } => return Some(HostRequest::Capture { replace }),
                Request::HandOver => {
                    self.fresh = true;
                    if self.make_ready(id, host, true) {
                        return Some(HostRequest::HandOver);
                    }
                }
            }
        }
    }

    /// Prepares the poses for the host; if that fails, the window shows why.
    fn make_ready(&mut self, id: Id, host: &Rc<dyn Host>, asked: bool) -> bool {
        inject::point(Place::HandOver);
        let count = self.editor.document().poses().and_then(|poses| {
            host.prepare(id, &poses)?;
            Ok(poses.frame_count())
        });
        inject::point(Place::Prepared);
        let ready = count.is_ok();
        self.fresh |= asked || !ready;
        self.editor.handed_over(count, asked);
        ready
    }
}
