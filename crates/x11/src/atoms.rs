//! Atoms, interned once when the connection opens.

use x11rb::atom_manager;

atom_manager! {
    /// All atoms in use.
    pub Atoms:
    /// The pending requests for them.
    AtomsCookie {
        // Window manager.
        WM_PROTOCOLS,
        WM_DELETE_WINDOW,
        WM_CLIENT_LEADER,
        WM_LOCALE_NAME,
        WM_STATE,
        _NET_ACTIVE_WINDOW,
        _NET_WM_ICON,
        _NET_WM_ICON_NAME,
        _NET_WM_NAME,
        _NET_WM_PID,
        _NET_WM_PING,
        _NET_WM_USER_TIME,
        _NET_WM_WINDOW_TYPE,
        _NET_WM_WINDOW_TYPE_NORMAL,
        // Text and selections.
        UTF8_STRING,
        TEXT,
        CLIPBOARD,
        CLIPBOARD_MANAGER,
        SAVE_TARGETS,
        TARGETS,
        MULTIPLE,
        TIMESTAMP,
        ATOM_PAIR,
        INCR,
        NULL,
        TEXT_PLAIN: b"text/plain",
        TEXT_PLAIN_UTF8: b"text/plain;charset=utf-8",
        // Dragging and dropping.
        XdndAware,
        XdndEnter,
        XdndPosition,
        XdndStatus,
        XdndLeave,
        XdndDrop,
        XdndFinished,
        XdndSelection,
        XdndTypeList,
        XdndActionCopy,
        TEXT_URI_LIST: b"text/uri-list",
        // The desktop's settings.
        MANAGER,
        _XSETTINGS_S0,
        _XSETTINGS_SETTINGS,
        // Our own.
        _VIDES_SELECTION,
        _VIDES_SHOWN,
    }
}
