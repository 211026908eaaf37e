"""What a message names: every parameter of every function, as the header names them, is given what will not do, all
others what will: names.py LIBRARY HEADER FOLDER

    NULL, an address that is not aligned, a handle that is none, a struct of another size, a
    number that is none of the known ones

and v_last_error() must name that parameter, the numbers given and those that are right. The calls
are made of the header's own declarations, so that a new function is tried, too.
"""

import ctypes
import re
import struct
import sys

library, header, folder = sys.argv[1:4]
text = open(header).read()
vides = ctypes.CDLL(library)
vides.v_last_error.restype = ctypes.c_char_p
OK, NULL, HANDLE, ARGUMENT, RANGE, SIZE = range(6)
WRONG = [-7, 54321]

# Without answer, or without a parameter of their own to be wrong.
LEFT_OUT = {"v_haupt", "v_free_liste", "v_editor_open", "v_last_error", "v_set_progress", "v_strerror", "v_version"}
FUNCTION = re.compile(r"^(int|void) (v_\w+)\(([^;]*?)\);", re.M | re.S)

VID = """version = 1
[[point]]
position = [0.0, 0.0, 0.0]
[[point.orientation]]
offset = [0.0, 0.0, -1.0]
[[point]]
position = [1.0, 0.0, 0.0]
[[point.orientation]]
offset = [0.0, 0.0, -1.0]
"""
CSV = "0 0 0 0 0 1 0 1 0 24\n1 0 0 0 0 1 0 1 0 24\n2 0 0 0 0 1 0 1 0 24\n"
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n"

faults = 0
kept = []  # what pointers point to


def fault(text):
    global faults
    faults += 1
    print("FAULT:", text, file=sys.stderr)


def block(data, room=0):
    data = ctypes.create_string_buffer(data, max(len(data) + 1, room))  # a text ends by zero
    kept.append(data)
    return ctypes.addressof(data)


def doubles(*numbers):
    return block(struct.pack("%dd" % len(numbers), *numbers))


def made(function, *more):
    handle = ctypes.c_void_p()
    status = getattr(vides, function)(ctypes.byref(handle), *more)
    assert status == OK, (function, vides.v_last_error())
    return handle.value


def a_path():
    path = made("v_path_new")
    vides.v_path_insert_point(ctypes.c_void_p(path), 1, ctypes.c_void_p(doubles(0.1, 0.5, 0.2)))
    vides.v_path_insert_orientation(ctypes.c_void_p(path), 0, 1, None)
    return path


def a_mesh():
    xyz = doubles(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1)
    corners = block(struct.pack("3I", 0, 1, 2))
    return block(struct.pack("QQQQQQQQ", 64, xyz, 4, 0, 0, 0, corners, 3))


def a_node(kind=1):
    node = block(b"", 1000)
    vides.v_node_init(ctypes.c_void_p(node), kind)
    return node


def a_scene():
    scene, pointer = made("v_scene_new"), ctypes.c_void_p
    for name, more in [
        ("v_scene_add_node", [pointer(block(b"sheet")), pointer(a_node()), None]),
        ("v_scene_set_geometry", [1, pointer(a_mesh())]),
        ("v_scene_add_deformation", [1, pointer(block(b"twist")), pointer(doubles(2, 30)),
                                     ctypes.c_size_t(2), pointer(doubles(-1, -1, -1, 1, 1, 1)), None]),
        ("v_scene_set_marker", [pointer(block(b"meet")), ctypes.c_double(20)]),
        ("v_scene_pin", [0, 1, pointer(block(b"meet"))]),
        ("v_scene_add_shape", [1, pointer(block(b"flat")), pointer(doubles(*range(12))), None, ctypes.c_size_t(4)]),
        ("v_scene_set_track", [1, pointer(block(b"position")), pointer(block(b"linear")), pointer(doubles(1, 11)),
                               pointer(doubles(*range(6))), None, ctypes.c_size_t(2), 0]),
    ]:
        status = getattr(vides, name)(pointer(scene), *more)
        assert status == OK, (name, vides.v_last_error())
    return scene


def with_size(kind):
    init = {"V_ORIENTATION": "v_orientation_init", "V_EDITOR_OPTIONS": "v_editor_options_init"}
    if kind == "V_MESH":
        return a_mesh()
    if kind == "V_NODE":
        return a_node()
    if kind == "V_MOTION":
        return block(struct.pack("Q4d", 40, 0, 0, 0, 0))
    if kind == "V_VIEW":
        numbers = [0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 2, -1, 1, -1, 1, 1, -1, 0]
        return block(struct.pack("Q19dii", 168, *numbers, 0, 0))
    if kind == "V_PROPERTY":
        return block(struct.pack("Q8Q", 72, *[0] * 8))
    room = block(b"", 2000)
    getattr(vides, init[kind])(ctypes.c_void_p(room))
    return room


SIZED = ("V_ORIENTATION", "V_MESH", "V_NODE", "V_VIEW", "V_MOTION", "V_EDITOR_OPTIONS", "V_PROPERTY")
window = []


def fit(function, kind, name):
    """What will do, for a parameter of this kind and name."""
    if "(*" in kind or kind in ("V_INTERPOLATE", "void *") and name != "app_context":
        return ctypes.c_void_p(None)
    if kind in ("int", "float"):
        return ctypes.c_int(INTS.get((function, name), INTS.get(name, 0)))
    if kind == "size_t":
        return ctypes.c_size_t(SIZES.get((function, name), SIZES.get(name, 0)))
    if kind == "double":
        return ctypes.c_double(DOUBLES.get(name, 0.5))
    base, stars = kind.replace("const", "").replace("*", "").strip(), kind.count("*")
    if base in SIZED and stars == 1:
        return ctypes.c_void_p(with_size(base))
    if stars == 1 and base in ("V_PATH", "V_SCENE", "V_EDITOR"):
        handle = {"V_PATH": a_path, "V_SCENE": a_scene, "V_EDITOR": lambda: window[0]}[base]()
        return ctypes.c_void_p(handle)
    if name == "paths":
        return ctypes.c_void_p(block(struct.pack("QQ", a_path(), a_path())))
    if kind == "const char *":
        return ctypes.c_void_p(block(TEXTS.get((function, name), TEXTS.get(name, "x")).encode()))
    if kind.startswith("const double"):
        given = ARRAYS.get((function, name), ARRAYS.get(name, [0.25 * k for k in range(64)]))
        return ctypes.c_void_p(doubles(*given))
    if kind == "const V_POSE *":
        poses = [[0.1 * k, 0.01 * k * k, 0, 0, 0, 1, 0, 1, 0, 24] for k in range(12)]
        return ctypes.c_void_p(doubles(*sum(poses, [])))
    if base == "V_KAMERAPAR":
        return ctypes.c_void_p(block(bytes(56) + struct.pack("i", -1), 64))
    return ctypes.c_void_p(block(b"", 100000))


INTS = {"last_point": 1, "up": 1, "count": 2, "points": 1, "node": 1, ("v_path_extract", "last_point"): 2,
        ("v_path_remove_orientation", "at"): 1, ("v_scene_set_path", "node"): 0,
        ("v_scene_get_path", "node"): 0, ("v_scene_pin", "node"): 0, ("v_scene_set_camera", "node"): 0, ("v_scene_tool", "node"): 0}
SIZES = {"capacity": 50000, "count": 2, "keys": 2, "points": 4, "size": len(VID), "first": 1,
         "frames": 500, ("v_path_fit_poses", "count"): 12,
         ("v_path_set_numbers", "count"): 6, ("v_scene_set_numbers", "count"): 3,
         ("v_editor_options_init_sized", "size"): 1000}
DOUBLES = {"fps": 25.0, "value": 25.0, "frame": 2.5, "back": 10.0, "rise": 0.2, "fall": 0.2, "s": 0.1,
           "tolerance": 0.01, "half_size": 1.0, "far_plane": 10.0}
TEXTS = {"format": "csv", "options": "as=keys", ("v_scene_import", "file"): folder + "/a.csv", ("v_scene_export", "file"): folder + "/written.csv", "channel": "position", "interpolation": "hermite", "kind": "twist", "tool": "repeat", ("v_path_tool", "options"): "times=2", ("v_scene_tool", "options"): "times=2", ("v_path_fit_poses", "options"): "robust=yes", "what": "tracks", ("v_last_number", "name"): "seconds", "up": "point",
         "marker": "meet", "text": VID, "name": "wheel", ("v_scene_find_node", "name"): "sheet",
         ("v_scene_remove_marker", "name"): "meet", "file": folder + "/written",
         **{("v_%s_%s_%s" % key, "name"): name for key, name in {
             ("path", "set", "number"): "fps", ("path", "get", "number"): "fps",
             ("path", "set", "numbers"): "point.2.tangents", ("path", "get", "numbers"): "base_speeds",
             ("path", "set", "text"): "title", ("path", "get", "text"): "title",
             ("path", "set", "flag"): "closed", ("path", "get", "flag"): "closed",
             ("scene", "set", "number"): "fps", ("scene", "get", "number"): "fps",
             ("scene", "set", "numbers"): "node.2.position", ("scene", "get", "numbers"): "node.2.position",
             ("scene", "set", "text"): "title", ("scene", "get", "text"): "title",
             ("scene", "set", "flag"): "node.2.visible", ("scene", "get", "flag"): "node.2.visible"}.items()},
         ("v_path_load", "file"): folder + "/a.vid", ("v_scene_load", "file"): folder + "/a.vid",
         ("v_scene_load_geometry", "file"): folder + "/a.obj"}
ARRAYS = {"keys": [1, 0, 0, 0, 0, 1, 0, 0], "key_times": [0, 1], "tcb": [0] * 6, "weights": [0.5, 0.5],
          "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0, 0, 1],
          "box": [-2, -2, -2, 2, 2, 2], "speed": [50] * 10, "before": [50] * 3, "after": [50] * 3,
          "vpn": [0, 0, 1], "vup": [0, 1, 0], "parameters": [0, 30], "up_point": [2, 3, 2],
          "frames": [1, 11], "m": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0, 0, 1]}

# Numbers of things, and those that choose one of a few.
NUMBERS = ("at", "point", "node", "segment", "section", "orientation", "first_point", "last_point", "preset",
           "from", "to", "parent")
CHOICES = ("up", "kind", "fit", "after", "convention", "order", "keep")


def parameters(text):
    for part in re.split(r",(?![^()]*\))", re.sub(r"\s+", " ", text).strip()):
        inner = re.search(r"\(\*(\w+)\)", part)
        plain = re.fullmatch(r"(.*?)(\w+)(\[\d+\])?", part)
        if inner:
            yield "(*)", inner[1]
        elif part != "void":
            kind = plain[1].strip() + (" *" if plain[3] else "")
            yield kind, plain[2]


def call(function, all_of, changed=None, value=None):
    arguments = [fit(function, kind, name) for kind, name in all_of]
    for (kind, name), argument in zip(all_of, arguments):
        if name != changed:
            continue
        argument.value = value(argument.value) if callable(value) else value
    status = getattr(vides, function)(*arguments)
    return status, vides.v_last_error().decode()


def wrong_size(address):
    """The struct with size 3."""
    size = ctypes.c_size_t.from_address(address)
    size.value = 3
    return address


def must(function, got, status, pattern, may_do=False):
    answer, said = got
    if may_do and answer != status:
        return False
    if answer != status or not re.match(pattern, said):
        fault("%s answers %d and \"%s\" instead of %d and %s" % (function, answer, said, status, pattern))
    return answer == status


def try_function(answers, function, all_of):
    if answers == "void":
        status = lambda got: (NULL if got[1] else OK, got[1])
    else:
        status = lambda got: got
        usual = call(function, all_of)
        if usual[0] not in (OK, ARGUMENT, RANGE):
            fault("%s answers %d to what will do: %s" % (function, *usual))
    refused = 0
    unneeded = function == "v_path_set_up"  # what its up does not need is not looked at
    for kind, name in all_of:
        there = re.escape(name)
        base, pointer = kind.replace("const", "").replace("*", "").strip(), "*" in kind and kind != "(*)"
        if pointer and kind != "void *" or name == "app_context":
            got = status(call(function, all_of, name, None))
            refused += must(function, got, NULL, there + " is NULL$", True)
            if got[0] not in (OK, NULL) and answers != "void" and usual[0] == OK:
                fault("%s without %s answers %d: %s" % (function, name, *got))
        if pointer and answers == "int" and "char *" not in kind and kind.count("*") == 1:
            if base in ("V_PATH", "V_SCENE", "V_EDITOR"):
                must(function, call(function, all_of, name, 7), HANDLE, there + " is not a valid handle", unneeded)
            elif base != "void":
                odd = call(function, all_of, name, lambda address: address + 1)
                must(function, odd, ARGUMENT, there + " is not aligned", unneeded)
            if base in SIZED:
                told = call(function, all_of, name, wrong_size)
                must(function, told, SIZE, there + r"->size is 3, but sizeof \(%s\) is \d+$" % base)
        for given in WRONG if kind == "int" and answers == "int" else []:
            if name in NUMBERS:
                got = call(function, all_of, name, given)
                must(function, got, RANGE, ".*(?<![-0-9])%d(?![0-9])" % given)
            elif name in CHOICES:
                got = call(function, all_of, name, given)
                must(function, got, RANGE, there + " is %d; known: V_" % given)
                for constant, number in re.findall(r"(V_\w+) \((\d+)\)", got[1]):
                    if "#define %s %s\n" % (constant, number) not in text:
                        fault("%s says %s is %s" % (function, constant, number))
    return refused


def main():
    for name, contents in (("a.vid", VID), ("a.obj", OBJ), ("a.csv", CSV)):
        open("%s/%s" % (folder, name), "w").write(contents)
    editor = ctypes.c_void_p()
    status = vides.v_editor_open(None, ctypes.byref(editor))
    assert status == OK, vides.v_last_error()
    window.append(editor.value)
    functions = refused = 0
    plain = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    for answers, function, given in FUNCTION.findall(plain):
        all_of = list(parameters(given))
        if function in LEFT_OUT or not all_of or function in ("v_editor_close", "v_editors_close"):
            continue
        functions += 1
        before = refused
        refused += try_function(answers, function, all_of)
        told = re.search(r"/\*\*((?:(?!\*/).)*)\*/\s*int %s\(" % function, text, re.S)
        if told and "V_ERR_NULL" in told[1] and refused == before:
            fault("%s refuses no NULL" % function)
        kept.clear()
    TEXTS["up"] = "path"
    declared = re.search(r"int v_path_set_up\(([^;]*?)\);", plain, re.S)[1]
    try_function("int", "v_path_set_up", list(parameters(declared)))
    print("%d functions, %d parameters that must not be NULL, %d faults" % (functions, refused, faults))
    return faults != 0


sys.exit(main())
