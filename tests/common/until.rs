//! How tests wait: for what is to be seen, never for a time. Whoever needs it takes this file
//! in by its path.

use std::time::{Duration, Instant};

/// How long a test waits for what must happen. Long, since machines may be busy.
pub(crate) const PATIENCE: Duration = Duration::from_secs(60);

/// Asks again and again, with a short rest, until there is an answer.
pub(crate) fn until<T>(what: &str, mut ask: impl FnMut() -> Option<T>) -> T {
    let end = Instant::now() + PATIENCE;
    loop {
        if let Some(answer) = ask() {
            return answer;
        }
        assert!(Instant::now() < end, "waited too long for {what}");
        std::thread::sleep(Duration::from_millis(2));
    }
}
