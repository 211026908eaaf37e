//! Work that takes long, done beside the window by a thread that its program starts.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use egui::{Context, ProgressBar, Response, Ui};
use vides_document::error::{Invalid, Result};
use vides_engine::tools::fit::Progress;

/// Starts a thread that takes no signals; whether that could be.
pub type Start = fn(Box<dyn FnOnce() + Send>) -> bool;

/// Work done within this time is never seen to be beside the window.
const AT_ONCE: Duration = Duration::from_millis(150);

/// How often it is looked at whether it is done.
const AGAIN: Duration = Duration::from_millis(50);

/// One piece of work; who drops it cancels it.
#[derive(Debug)]
pub(crate) struct Background<T> {
    how_far: Arc<HowFar>,
    answer: Receiver<std::thread::Result<Result<T>>>,
    known: Option<Result<T>>,
    /// A forked child has no thread to wait for.
    process: u32,
}

#[derive(Debug, Default)]
struct HowFar {
    done: AtomicUsize,
    all: AtomicUsize,
    cancelled: AtomicBool,
}

impl<T: Send + 'static> Background<T> {
    /// Begins it, and waits a little whether it is done at once. Without a way to start threads it
    /// is done before this returns; where none can be started it counts as cancelled.
    pub(crate) fn begin(
        start: Option<Start>,
        work: impl FnOnce(Progress<'_>) -> Result<T> + Send + 'static,
    ) -> Self {
        let mut begun = Self::begin_for_later(start, work);
        begun.known = begun.wait(AT_ONCE);
        begun
    }

    /// The same for work whose result is not awaited.
    pub(crate) fn begin_for_later(
        start: Option<Start>,
        work: impl FnOnce(Progress<'_>) -> Result<T> + Send + 'static,
    ) -> Self {
        let how_far = Arc::new(HowFar::default());
        let (sender, answer) = channel();
        let told = how_far.clone();
        let all = move || {
            let go_on = &mut |done, all| {
                told.done.store(done, Ordering::Relaxed);
                told.all.store(all, Ordering::Relaxed);
                !told.cancelled.load(Ordering::Relaxed)
            };
            let made = catch_unwind(AssertUnwindSafe(|| work(go_on)));
            // Who has given it up does not listen.
            let _ = sender.send(made);
        };
        match start {
            Some(start) => {
                start(Box::new(all));
            }
            None => all(),
        }
        Self {
            how_far,
            answer,
            known: None,
            process: std::process::id(),
        }
    }

    /// What it made; `None` as long as it is under way. Its panic is the window's.
    fn wait(&self, time: Duration) -> Option<Result<T>> {
        match self.answer.recv_timeout(time) {
            Ok(Ok(made)) => Some(made),
            Ok(Err(panic)) => resume_unwind(panic),
            Err(RecvTimeoutError::Timeout) => None,
            // It could not be started.
            Err(RecvTimeoutError::Disconnected) => Some(Err(Invalid::Cancelled.into())),
        }
    }

    /// Whether [`Background::made`] has something; else the window looks again soon.
    pub(crate) fn is_done(&mut self, context: &Context) -> bool {
        if self.known.is_none() {
            self.known = self.wait(Duration::ZERO);
        }
        if self.known.is_none() {
            context.request_repaint_after(AGAIN);
        }
        self.known.is_some()
    }

    /// What it made, if it is done: once.
    pub(crate) fn made(&mut self) -> Option<Result<T>> {
        self.known.take()
    }

    /// How far it is.
    pub(crate) fn show(&self, ui: &mut Ui) -> Response {
        let [done, all] =
            [&self.how_far.done, &self.how_far.all].map(|n| n.load(Ordering::Relaxed));
        let share = if all > 0 {
            done as f32 / all as f32
        } else {
            0.0
        };
        ui.add(ProgressBar::new(share).desired_width(ui.available_width()))
    }
}

impl<T> Drop for Background<T> {
    /// Its thread ends before the window goes on.
    fn drop(&mut self) {
        self.how_far.cancelled.store(true, Ordering::Relaxed);
        if self.known.is_none() && self.process == std::process::id() {
            let _ = self.answer.recv();
        }
    }
}

#[cfg(test)]
#[path = "background_tests.rs"]
mod tests;
