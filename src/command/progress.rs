//! A progress bar: nothing in the first second, then a line drawn over itself, cleared at the end.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

const PATIENCE: Duration = Duration::from_secs(1);

/// Least time between two drawings.
const PAUSE: Duration = Duration::from_millis(100);

/// Characters of the bar itself; the whole line stays below 80.
const WIDTH: usize = 24;

/// To the start of the line, and clear it.
const CLEAR: &str = "\r\x1b[K";

/// A bar on a terminal, cleared when dropped.
pub(super) struct Bar<W: Write> {
    out: W,
    start: Instant,
    drawn: Option<Instant>,
    /// What is counted; none: a share, of a mesh.
    what: Option<&'static str>,
}

impl<W: Write> Bar<W> {
    pub(super) fn new(out: W, what: Option<&'static str>) -> Self {
        Self {
            out,
            what,
            start: Instant::now(),
            drawn: None,
        }
    }

    pub(super) fn update(&mut self, done: usize, all: usize) {
        self.update_at(Instant::now(), done, all);
    }

    fn update_at(&mut self, now: Instant, done: usize, all: usize) {
        let waited = now.saturating_duration_since(self.start);
        let due = match self.drawn {
            None => waited >= PATIENCE,
            Some(drawn) => now.saturating_duration_since(drawn) >= PAUSE,
        };
        if due && all > 0 {
            // Failing to draw must not stop the work.
            let _ = write!(
                self.out,
                "{CLEAR}{}",
                line(waited, done.min(all), all, self.what)
            );
            let _ = self.out.flush();
            self.drawn = Some(now);
        }
    }
}

/// A bar for work that reports its progress and asks whether to go on, where standard error is a
/// terminal.
pub(super) fn progress(what: &'static str) -> impl FnMut(usize, usize) -> bool {
    let shown = io::stderr().is_terminal();
    let mut bar = shown.then(|| Bar::new(io::stderr(), Some(what)));
    move |done, all| {
        if let Some(bar) = &mut bar {
            bar.update(done, all);
        }
        true
    }
}

impl<W: Write> Drop for Bar<W> {
    fn drop(&mut self) {
        if self.drawn.is_some() {
            let _ = write!(self.out, "{CLEAR}");
            let _ = self.out.flush();
        }
    }
}

/// Shows the progress of reading meshes, if standard error is a terminal.
pub(super) fn watch_meshes() {
    if !io::stderr().is_terminal() {
        return;
    }
    let mut bar = None;
    vides::document::watch_meshes(Some(Box::new(move |share| {
        let bar_of_this = bar.get_or_insert_with(|| Bar::new(io::stderr(), None));
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        bar_of_this.update((1000.0 * share) as usize, 1000);
        if share >= 1.0 {
            bar = None;
        }
        true
    })));
}

fn line(waited: Duration, done: usize, all: usize, what: Option<&str>) -> String {
    let full = WIDTH * done / all;
    let percent = 100 * done / all;
    let left = if done == 0 {
        String::new()
    } else {
        let left = waited.as_secs_f64() * (all - done) as f64 / done as f64;
        format!(", {} s left", left.ceil())
    };
    let what = what.map_or("of the mesh".to_owned(), |what| {
        format!("{done} of {all} {what}")
    });
    format!(
        "[{}{}] {percent:3} %  {what}{left}",
        "#".repeat(full),
        "-".repeat(WIDTH - full),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a bar writes at these moments.
    fn shown(moments: &[(u64, usize)], all: usize) -> String {
        let mut out = Vec::new();
        let mut bar = Bar::new(&mut out, Some("frames"));
        let start = bar.start;
        for &(milliseconds, done) in moments {
            bar.update_at(start + Duration::from_millis(milliseconds), done, all);
        }
        drop(bar);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn short_work_shows_nothing() {
        assert_eq!(shown(&[(0, 1), (500, 50), (999, 100)], 100), "");
    }

    #[test]
    fn long_work_shows_a_bar_and_wipes_it() {
        assert_eq!(
            shown(&[(900, 20), (1000, 25)], 100),
            "\r\x1b[K[######------------------]  25 %  25 of 100 frames, 3 s left\r\x1b[K"
        );
    }

    #[test]
    fn a_share_has_no_count() {
        assert_eq!(
            line(Duration::from_secs(1), 250, 1000, None),
            "[######------------------]  25 %  of the mesh, 3 s left"
        );
    }

    #[test]
    fn the_bar_is_drawn_ten_times_a_second_at_most() {
        let every_millisecond: Vec<_> = (0..3000).map(|i| (i, i as usize)).collect();
        let drawings = shown(&every_millisecond, 3000).matches('[').count();
        // Each drawing has one bracket of its own and one of the escape.
        assert_eq!(drawings, 2 * 20 + 1);
    }

    #[test]
    fn the_line_fits_a_narrow_terminal() {
        let longest = line(
            Duration::from_secs(999),
            99_999_999,
            100_000_000,
            Some("frames"),
        );
        assert!(longest.len() < 80, "{longest}");
        let begun = line(
            Duration::from_secs(9_999),
            1_000_000,
            100_000_000,
            Some("frames"),
        );
        assert!(begun.len() < 80, "{begun}");
        assert_eq!(
            line(Duration::ZERO, 0, 5, Some("frames"))
                .matches("left")
                .count(),
            0
        );
    }
}
