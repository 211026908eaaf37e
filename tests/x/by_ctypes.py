"""A host in Python, by ctypes: no macro, only the functions. Says what on_view told it."""

import ctypes
import select
import sys
import time
from ctypes import (CFUNCTYPE, POINTER, byref, c_char_p, c_double, c_int, c_size_t,
                    c_ulong, c_void_p)


OnView = CFUNCTYPE(None, c_void_p, POINTER(c_double), c_double, c_int, c_void_p)


class Options(ctypes.Structure):
    """V_EDITOR_OPTIONS."""
    _fields_ = [("size", c_size_t), ("title", c_char_p), ("file", c_char_p), ("path", c_void_p),
                ("object", c_void_p), ("frames", c_double * 4), ("display", c_char_p),
                ("language", c_char_p), ("on_poses", c_void_p), ("on_close", c_void_p),
                ("user", c_void_p), ("space_centre", c_double * 3), ("space_half_size", c_double),
                ("space_up", c_int), ("on_view", OnView), ("on_change", c_void_p),
                ("on_capture", c_void_p), ("on_pane", c_void_p), ("host_name", c_char_p),
                ("parent", c_ulong), ("transient_for", c_ulong), ("application", c_char_p),
                ("hand_over_saves", c_int), ("on_frame", c_void_p), ("view", c_void_p),
                ("on_gone", c_void_p)]


def main():
    """Opens a window, and serves it until a frame that was asked for has been told."""
    vides = ctypes.CDLL("libvides.so.1")
    vides.v_last_error.restype = c_char_p
    vides.v_editor_set_frame.argtypes = [c_void_p, c_double]
    told = []
    on_view = OnView(lambda editor, pose, frame, reason, user: told.append(frame))
    options = Options()
    ctypes.memset(byref(options), 0xff, ctypes.sizeof(options))
    vides.v_editor_options_init(byref(options))
    print("size", options.size, "of", ctypes.sizeof(options), flush=True)
    options.on_view = on_view
    editor = c_void_p()
    if vides.v_editor_open(byref(options), byref(editor)) != 0:
        sys.exit(vides.v_last_error().decode())
    vides.v_editor_set_frame(editor, 20.5)
    end = time.monotonic() + 20
    while 20.5 not in told and time.monotonic() < end:
        vides.v_dispatch()
        select.select([vides.v_fd()], [], [], 0.1)
    print("told", 20.5 in told, flush=True)
    shorter = Options.from_buffer_copy(options)
    shorter.size = Options.space_centre.offset
    again = c_void_p()
    print("shorter", vides.v_editor_open(byref(shorter), byref(again)), flush=True)
    vides.v_editor_close(editor)


main()
