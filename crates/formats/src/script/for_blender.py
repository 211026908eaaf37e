"""A camera flight for Blender 3.6 and later, written by VIDES.

Open it in Blender's text editor and press Run Script, or start `blender --python FILE`; where bpy
is a module of Python, run it there. It adds a camera and the objects of the flight, and sets the
scene's camera, frames, rate and resolution. Nothing is removed.
"""

import json

import bpy

# A frame: position, rotation (w, x, y, z), focal length in mm of a picture 24 mm high.
# ---- data, JSON: nothing of it is run ----
DATA = r'''
{}
'''
# ---- end of data ----

# Blender has no other frame numbers.
LAST_FRAME = 1048574


def curves_of(owner, name):
    """The curves of a new action: in a channel bag where there are slots, and Blender 5 has no others."""
    action = bpy.data.actions.new(name)
    animation = owner.animation_data_create()
    animation.action = action
    if not hasattr(action, "slots"):
        return action.fcurves
    slot = action.slots.new(owner.id_type, name)
    animation.action_slot = slot
    strip = action.layers.new(name).strips.new(type="KEYFRAME")
    return strip.channelbag(slot, ensure=True).fcurves


def animate(owner, name, first, channels):
    """Sets a key a frame; a channel is a property's path and a list of values for each component."""
    curves = curves_of(owner, name)
    linear = bpy.types.Keyframe.bl_rna.properties["interpolation"].enum_items["LINEAR"].value
    for path, columns in channels:
        for index, column in enumerate(columns):
            curve = curves.new(path, index=index)
            points = curve.keyframe_points
            points.add(len(column))
            places = [0.0] * (2 * len(column))
            places[::2] = range(first, first + len(column))
            places[1::2] = column
            points.foreach_set("co", places)
            points.foreach_set("interpolation", [linear] * len(column))
            curve.update()


def add_object(scene, name, shape):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(shape["points"], shape["lines"], shape["triangles"])
    mesh.validate()
    thing = bpy.data.objects.new(name, mesh)
    scene.collection.objects.link(thing)
    return thing


def add_objects(scene, flight):
    """Adds the objects of a scene: a place is a position, a rotation, a scale, and 1 if hidden."""
    for shape in flight.get("objects", []):
        thing = add_object(scene, shape["name"], shape)
        thing.rotation_mode = "QUATERNION"
        first = shape["places"][0]
        thing.location, thing.rotation_quaternion, thing.scale = first[:3], first[3:7], first[7:10]
        thing.hide_render = thing.hide_viewport = bool(first[10])
        if len(shape["places"]) == 1:
            continue
        columns = list(zip(*shape["places"]))
        hidden = [(name, columns[10:]) for name in ("hide_render", "hide_viewport")]
        channels = [("location", columns[:3]), ("rotation_quaternion", columns[3:7]), ("scale", columns[7:10])]
        if any(columns[10]):
            channels += hidden
        animate(thing, shape["name"], flight["first_frame"], channels)


def add_camera(scene, flight):
    lens = bpy.data.cameras.new(flight["camera"])
    lens.sensor_fit = "VERTICAL"
    lens.sensor_height = 24
    lens.clip_start, lens.clip_end = flight["clip"]
    camera = bpy.data.objects.new(flight["camera"], lens)
    camera.rotation_mode = "QUATERNION"
    scene.collection.objects.link(camera)
    columns = list(zip(*flight["frames"]))
    first = flight["first_frame"]
    channels = [("location", columns[:3]), ("rotation_quaternion", columns[3:7])]
    animate(camera, flight["camera"], first, channels)
    animate(lens, flight["camera"], first, [("lens", columns[7:])])
    return camera


def set_frames(scene, flight):
    first = flight["first_frame"]
    scene.frame_start = first
    scene.frame_end = min(first + len(flight["frames"]) - 1, LAST_FRAME)
    render = scene.render
    # Its rate is a whole number through a base.
    render.fps = min(max(round(flight["fps"]), 1), 32767)
    render.fps_base = render.fps / flight["fps"]
    render.resolution_x, render.resolution_y = flight["size"]
    render.resolution_percentage = 100
    render.pixel_aspect_x = render.pixel_aspect_y = 1


def main():
    flight = json.loads(DATA)
    scene = bpy.context.scene
    set_frames(scene, flight)
    if "object" in flight:
        add_object(scene, flight["title"] or "object", flight["object"])
    add_objects(scene, flight)
    scene.camera = add_camera(scene, flight)
    scene.frame_set(flight["first_frame"])


main()
