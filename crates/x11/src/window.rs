//! Creating the window on the server, and describing it to window managers.

use x11rb::connection::Connection as _;
use x11rb::properties::{WmHints, WmHintsState, WmSizeHints, WmSizeHintsSpecification};
use x11rb::protocol::xproto::{
    Atom, AtomEnum, ChangeWindowAttributesAux, ClientMessageEvent, ColormapAlloc,
    ConfigureWindowAux, ConnectionExt as _, CreateGCAux, CreateWindowAux, EventMask, Gravity,
    InputFocus, PropMode, StackMode, WindowClass,
};
use x11rb::wrapper::ConnectionExt as _;

use super::connection::Connection;
use super::options::Options;
use super::visual::Visual;
use super::{connect, drops, icon, scale};
use crate::error::{Error, Result};

/// The events selected on our window.
pub(super) fn events() -> EventMask {
    EventMask::KEY_PRESS
        | EventMask::KEY_RELEASE
        | EventMask::BUTTON_PRESS
        | EventMask::BUTTON_RELEASE
        | EventMask::ENTER_WINDOW
        | EventMask::LEAVE_WINDOW
        | EventMask::POINTER_MOTION
        | EventMask::EXPOSURE
        | EventMask::VISIBILITY_CHANGE
        | EventMask::STRUCTURE_NOTIFY
        | EventMask::FOCUS_CHANGE
        | EventMask::PROPERTY_CHANGE
}

/// In characters.
const LONGEST_TITLE: usize = 1000;

/// The window's identifiers on the server.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub(super) window: u32,
    /// The graphics context for images.
    pub(super) context: u32,
    /// The inner size in pixels.
    pub(super) size: (u32, u32),
}

/// Selects changes of the X resources and the start of a settings manager; call before reading
/// either, so that no change is missed.
pub(super) fn watch_desktop(connection: &Connection) -> Result<()> {
    let mask = EventMask::PROPERTY_CHANGE | EventMask::STRUCTURE_NOTIFY;
    let watch = ChangeWindowAttributesAux::new().event_mask(mask);
    let asked = connection.change_window_attributes(scale::root(connection), &watch);
    connection.sent(asked).map(drop)
}

pub(super) fn create(
    connection: &Connection,
    visual: &Visual,
    options: &Options,
    scale: f32,
    home: Option<(u32, (u32, u32))>,
) -> Result<Frame> {
    let group = match options.transient_for {
        None => None,
        Some(window) => Some(group_of(connection, window)?),
    };
    let frame = make(connection, visual, options, scale, home)?;
    describe(connection, frame, options, scale, group)?;
    set_title(connection, frame.window, &options.title)?;
    connection.sent(connection.map_window(frame.window))?;
    Ok(frame)
}

/// The window group of a host's window, which may be its own leader.
fn group_of(connection: &Connection, window: u32) -> Result<u32> {
    let exists = connection.answer(connection.get_window_attributes(window))?;
    if exists.is_none() {
        return Err(Error::NoOwner {
            window,
            display: connection.display().into(),
        });
    }
    let hints = connection.sent(WmHints::get(&**connection, window))?;
    let hints = connection.excuse(hints.reply().map_err(Into::into))?;
    let group = hints.flatten().and_then(|hints| hints.window_group);
    Ok(group.unwrap_or(window))
}

fn make(
    connection: &Connection,
    visual: &Visual,
    options: &Options,
    scale: f32,
    home: Option<(u32, (u32, u32))>,
) -> Result<Frame> {
    let id = || connection.sent(connection.generate_id());
    let screen = connection.screen();
    let most = (screen.width_in_pixels, screen.height_in_pixels);
    let (parent, (width, height)) = match home {
        None => (screen.root, in_pixels(options.size, scale, most)),
        Some((parent, size)) => {
            let side = |pixels: u32| u16::try_from(pixels).unwrap_or(u16::MAX);
            (parent, (side(size.0), side(size.1)))
        }
    };
    let colormap = if visual.foreign {
        let colormap = id()?;
        let none = ColormapAlloc::NONE;
        connection.sent(connection.create_colormap(none, colormap, screen.root, visual.id))?;
        colormap
    } else {
        screen.default_colormap
    };
    // No background, to avoid flicker; a border pixel is needed if the depth is not the parent's.
    let attributes = CreateWindowAux::new()
        .border_pixel(0)
        .bit_gravity(Gravity::NORTH_WEST)
        .colormap(colormap)
        .event_mask(events());
    let window = id()?;
    let made = connection.sent(connection.create_window(
        visual.depth,
        window,
        parent,
        0,
        0,
        width,
        height,
        0,
        WindowClass::INPUT_OUTPUT,
        visual.id,
        &attributes,
    ))?;
    let context = id()?;
    let values = CreateGCAux::new().graphics_exposures(0);
    connection.sent(connection.create_gc(context, window, &values))?;
    if !connection.done(Ok(made))? {
        return Err(Error::NoWindow);
    }
    Ok(Frame {
        window,
        context,
        size: (width.into(), height.into()),
    })
}

fn in_pixels(size: [f32; 2], scale: f32, most: (u16, u16)) -> (u16, u16) {
    let pixels = |points: f32, most: u16| (points * scale).round().clamp(1.0, most.max(1).into());
    // NaN becomes 0 here, which X does not allow as a size.
    let whole = |pixels: f32| (pixels as u16).max(1);
    (
        whole(pixels(size[0], most.0)),
        whole(pixels(size[1], most.1)),
    )
}

fn describe(
    connection: &Connection,
    frame: Frame,
    options: &Options,
    scale: f32,
    group: Option<u32>,
) -> Result<()> {
    let (atoms, window) = (connection.atoms(), frame.window);
    let text =
        |name: Atom, text: &[u8]| set_text(connection, window, name, AtomEnum::STRING.into(), text);
    let set = |name: Atom, kind: AtomEnum, values: &[u32]| {
        let replace = PropMode::REPLACE;
        let asked = connection.change_property32(replace, window, name, kind, values);
        connection.sent(asked).map(drop)
    };
    text(AtomEnum::WM_CLASS.into(), &class(&options.application))?;
    let protocols = [atoms.WM_DELETE_WINDOW, atoms._NET_WM_PING];
    set(atoms.WM_PROTOCOLS, AtomEnum::ATOM, &protocols)?;
    text(AtomEnum::WM_CLIENT_MACHINE.into(), &connect::host_name())?;
    set(atoms._NET_WM_PID, AtomEnum::CARDINAL, &[std::process::id()])?;
    text(atoms.WM_LOCALE_NAME, locale().as_bytes())?;
    let kind = [atoms._NET_WM_WINDOW_TYPE_NORMAL];
    set(atoms.XdndAware, AtomEnum::ATOM, &[drops::VERSION])?;
    set(atoms._NET_WM_WINDOW_TYPE, AtomEnum::ATOM, &kind)?;
    set(atoms._NET_WM_ICON, AtomEnum::CARDINAL, &icon::icon())?;
    if let Some(owner) = options.transient_for {
        set(
            AtomEnum::WM_TRANSIENT_FOR.into(),
            AtomEnum::WINDOW,
            &[owner],
        )?;
    }
    // Without a host's window, it leads its own group.
    set(atoms.WM_CLIENT_LEADER, AtomEnum::WINDOW, &[window])?;
    let hints = WmHints {
        input: Some(true),
        initial_state: Some(WmHintsState::Normal),
        window_group: group.or(Some(window)),
        ..WmHints::new()
    };
    connection.sent(hints.set(&**connection, window))?;
    set_sizes(connection, window, options.smallest, scale, frame.size)
}

fn set_text(
    connection: &Connection,
    window: u32,
    name: Atom,
    kind: Atom,
    text: &[u8],
) -> Result<()> {
    let asked = connection.change_property8(PropMode::REPLACE, window, name, kind, text);
    connection.sent(asked).map(drop)
}

pub(super) fn set_sizes(
    connection: &Connection,
    window: u32,
    smallest: [f32; 2],
    scale: f32,
    size: (u32, u32),
) -> Result<()> {
    let screen = connection.screen();
    let most = (screen.width_in_pixels, screen.height_in_pixels);
    let (width, height) = in_pixels(smallest, scale, most);
    let whole = |pixels: u32| i32::try_from(pixels).unwrap_or(i32::MAX);
    let wanted = WmSizeHintsSpecification::ProgramSpecified;
    let sizes = WmSizeHints {
        size: Some((wanted, whole(size.0), whole(size.1))),
        min_size: Some((width.into(), height.into())),
        ..WmSizeHints::new()
    };
    connection
        .sent(sizes.set_normal_hints(&**connection, window))
        .map(drop)
}

pub(super) fn set_title(connection: &Connection, window: u32, title: &str) -> Result<()> {
    let title = title.chars().filter(|c| !c.is_control());
    let title: String = title.take(LONGEST_TITLE).collect();
    let (old, atoms) = (latin1(&title), connection.atoms());
    for name in [AtomEnum::WM_NAME, AtomEnum::WM_ICON_NAME] {
        set_text(
            connection,
            window,
            name.into(),
            AtomEnum::STRING.into(),
            &old,
        )?;
    }
    for name in [atoms._NET_WM_NAME, atoms._NET_WM_ICON_NAME] {
        set_text(
            connection,
            window,
            name,
            atoms.UTF8_STRING,
            title.as_bytes(),
        )?;
    }
    Ok(())
}

/// WM_CLASS: the instance is the program, so that a desktop shows whose window it is; the class is
/// always "Vides" (ICCCM 4.1.2.5).
fn class(application: &str) -> Vec<u8> {
    let mut class = latin1(application);
    class.retain(|letter| *letter != 0);
    if class.is_empty() {
        class.extend_from_slice(b"vides");
    }
    class.extend_from_slice(b"\0Vides\0");
    class
}

fn latin1(text: &str) -> Vec<u8> {
    let letter = |c: char| match c {
        '\u{2010}'..='\u{2015}' => b'-',
        '\u{2018}' | '\u{2019}' => b'\'',
        '\u{201c}'..='\u{201e}' => b'"',
        c => u8::try_from(u32::from(c)).unwrap_or(b'?'),
    };
    text.chars().map(letter).collect()
}

/// The locale, determined as in C programs.
fn locale() -> String {
    let set = |name| std::env::var(name).ok().filter(|value| !value.is_empty());
    let found = ["LC_ALL", "LC_CTYPE", "LANG"].into_iter().find_map(set);
    found
        .filter(|name| name.is_ascii())
        .unwrap_or_else(|| "C".to_owned())
}

/// Raises the window and asks for the focus. `top` is the top-level window around it, `time` that
/// of the last user action.
pub(super) fn raise(connection: &Connection, window: u32, top: u32, time: u32) -> Result<()> {
    connection.sent(connection.map_window(window))?;
    let above = ConfigureWindowAux::new().stack_mode(StackMode::ABOVE);
    connection.sent(connection.configure_window(window, &above))?;
    // Window managers act on the message; without one, the focus is set here. A window not yet
    // viewable cannot have it; the server's error about that is ignored.
    let data = [1, time, 0, 0, 0];
    let kind = connection.atoms()._NET_ACTIVE_WINDOW;
    tell_manager(connection, ClientMessageEvent::new(32, top, kind, data))?;
    let focus = connection.set_input_focus(InputFocus::PARENT, window, time);
    connection.sent(focus).map(drop)
}

pub(super) fn answer_ping(connection: &Connection, question: &ClientMessageEvent) -> Result<()> {
    let answer = ClientMessageEvent {
        window: connection.screen().root,
        ..*question
    };
    tell_manager(connection, answer)
}

/// Sends a message to the window manager.
fn tell_manager(connection: &Connection, message: ClientMessageEvent) -> Result<()> {
    let root = connection.screen().root;
    let mask = EventMask::SUBSTRUCTURE_NOTIFY | EventMask::SUBSTRUCTURE_REDIRECT;
    connection
        .sent(connection.send_event(false, root, mask, message))
        .map(drop)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_fit_the_screen() {
        assert_eq!(in_pixels([1200.0, 800.0], 1.0, (1920, 1080)), (1200, 800));
        assert_eq!(in_pixels([1200.0, 800.0], 2.0, (1920, 1080)), (1920, 1080));
        assert_eq!(in_pixels([100.3, 99.9], 1.25, (1920, 1080)), (125, 125));
        for odd in [0.0, -7.0, f32::NAN, f32::NEG_INFINITY] {
            assert_eq!(in_pixels([odd, odd], 1.0, (1920, 1080)), (1, 1));
        }
        assert_eq!(in_pixels([f32::INFINITY, 5.0], 1.0, (1920, 0)), (1920, 1));
    }

    #[test]
    fn the_class_names_the_program() {
        assert_eq!(class("nedit"), b"nedit\0Vides\0");
        assert_eq!(class("Köln\0 2"), b"K\xf6ln 2\0Vides\0");
        assert_eq!(class("\0"), b"vides\0Vides\0");
    }

    #[test]
    fn old_window_managers_get_their_letters() {
        assert_eq!(
            latin1("VIDES – *Flug über Köln"),
            b"VIDES - *Flug \xfcber K\xf6ln"
        );
        assert_eq!(latin1("„a“ ’b’ 点 ÿ"), b"\"a\" 'b' ? \xff");
    }
}
