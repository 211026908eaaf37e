//! How a window is opened.

/// Options for opening a window. By default it is one pixel large: set [`Options::size`].
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The display's name; `None` uses the environment variable `DISPLAY`.
    pub display: Option<String>,
    /// The title.
    pub title: String,
    /// The program's name, for WM_CLASS; "vides" if empty.
    pub application: String,
    /// Initial inner size in points (pixels at 96 dots per inch).
    pub size: [f32; 2],
    /// Minimum inner size in points.
    pub smallest: [f32; 2],
    /// The host's window to embed this one in, which it then fills; `None` for a top-level window.
    pub parent: Option<u32>,
    /// The host's window that this one is transient for.
    pub transient_for: Option<u32>,
}
