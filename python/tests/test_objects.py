"""Objects as other libraries have them, wherever one is taken."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import vides

VERTICES = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=float)
FACES = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]


def as_trimesh() -> Any:
    return SimpleNamespace(vertices=VERTICES, faces=np.array(FACES))


def as_pyvista() -> Any:
    return SimpleNamespace(points=VERTICES.astype(np.float32), faces=np.array([[3, *face] for face in FACES]).ravel())


def as_file() -> str:
    with open("ball.obj", "w") as out:
        out.writelines(f"v {x} {y} {z}\n" for x, y, z in VERTICES)
        out.writelines("f " + " ".join(str(corner + 1) for corner in face) + "\n" for face in FACES)
    return "ball.obj"


FORMS: dict[str, Callable[[], Any]] = {"trimesh": as_trimesh, "pyvista": as_pyvista, "arrays": lambda: (VERTICES, FACES), "file": as_file}


def path() -> vides.Path:
    return vides.Path([[-3.0, 0.1, 0.0], [3.0, 0.0, 0.0]], frames=101)


@pytest.mark.parametrize("form", FORMS)
def test_an_object_is_taken_everywhere(form: str) -> None:
    mesh = FORMS[form]()
    a, b = path(), path()
    assert a.avoid(0.5, object=mesh) == b.avoid(0.5, object=(VERTICES, FACES)) != ()
    own = path()
    own.set_object(mesh)
    assert sorted(map(tuple, own.object_points)) and own.avoid(0.5) and own == own.copy()
    seen = vides.Path([[-3, 0, 4], [3, 0, 5]], look_at=(0, 0, 0), frames=101)
    assert 0 < seen.keep_in_picture(object=mesh).tightest <= 1
    assert vides.tour(mesh, seconds=10).coverage >= 0.95
    around = vides.Path.orbit(object=mesh).sample().positions
    np.testing.assert_allclose(around, vides.Path.orbit(object=(VERTICES, FACES)).sample().positions, atol=1e-6)
    node = vides.Scene().add("ball", "object")
    node.set_mesh(mesh)
    np.testing.assert_array_equal(node.vertices(1), VERTICES)
    assert sorted(map(tuple, node.triangles)) == sorted(map(tuple, FACES))


def test_faces_with_more_corners_become_triangles() -> None:
    quad = SimpleNamespace(points=np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]), faces=np.array([4, 0, 1, 2, 3]))
    node = vides.Scene().add("quad", "object")
    node.set_mesh(quad)
    assert node.triangles.tolist() == [[0, 1, 2], [0, 2, 3]]
    for faces in ([4, 0, 1], [2, 0, 1], [0]):
        with pytest.raises(ValueError, match="number of corners"):
            node.set_mesh(SimpleNamespace(points=quad.points, faces=np.array(faces)))
    for wrong in (3, None, object(), {"vertices": []}):
        with pytest.raises(TypeError, match="an object is a file, a mesh of trimesh or pyvista"):
            node.set_mesh(wrong)  # type: ignore[arg-type]


@pytest.mark.large
def test_meshes_of_the_libraries_themselves() -> None:
    import pyvista
    import trimesh

    for mesh in (trimesh.creation.icosphere(radius=2), pyvista.Icosphere(radius=2), pyvista.Cube().triangulate()):
        assert vides.Path.orbit(object=mesh).frame_count == 250
        node = vides.Scene().add("ball", "object")
        node.set_mesh(mesh)
        assert len(node.triangles) >= 12


def test_nodes_are_given_where_names_are() -> None:
    scene = vides.Scene()
    arm = scene.add("arm")
    ball = scene.add("ball", "object", parent=arm)
    lamp = scene.add("lamp", "spot")
    camera = scene.add("camera", "camera")
    lamp.aim = ball
    assert (ball.parent, lamp.aim) == ("arm", "ball")
    ball.parent = None
    ball.parent = "arm"
    scene.camera = camera
    assert scene.camera == "camera"
    np.testing.assert_array_equal(scene.sample(ball, 1, 3).matrices, scene.sample("ball", 1, 3).matrices)
    with pytest.raises(ValueError, match="node 'a' is of another scene"):
        lamp.aim = vides.Scene().add("a")
    del scene[lamp], scene["camera"]
    assert list(scene) == ["arm", "ball"]


def test_keys_have_an_interpolation_that_fits() -> None:
    scene = vides.Scene()
    node = scene.add("lamp", "spot")
    chosen = {"position": "cubic", "rotation": "catmull-rom", "visible": "step", "intensity": "cubic", "scale": "cubic"}
    values: dict[str, Any] = {"position": np.eye(3), "rotation": np.eye(4)[:3], "visible": [1, 0, 1], "intensity": [1, 2, 3], "scale": np.ones((3, 3))}
    for channel in chosen:
        node.set_keys(channel, [1, 5, 9], values[channel])
    assert {keys.channel: keys.interpolation for keys in node.keys} == chosen


class Plotter:
    """Notes what pyvista would show."""

    def __init__(self) -> None:
        self.camera = SimpleNamespace()
        self.seen: list[tuple[Any, ...]] = []

    def reset_camera_clipping_range(self) -> None:
        pass

    def render(self) -> None:
        camera = self.camera
        self.seen.append((camera.position, camera.focal_point - camera.position, camera.up, camera.view_angle))

    def screenshot(self, filename: Any) -> None:
        filename.write_text("picture")


def test_frames_are_rendered(capsys: pytest.CaptureFixture[str]) -> None:
    plotter, flight = Plotter(), path()
    files = flight.render(plotter, "frames")
    assert [file.name for file in files[:2]] == ["00001.png", "00002.png"] and len(files) == 101
    assert all(file.read_text() == "picture" for file in files)
    samples = flight.sample()
    for at, (position, view, up, angle) in enumerate(plotter.seen):
        np.testing.assert_allclose(np.r_[position, view, up], samples.array[at, :9], atol=1e-12)
        assert angle == samples.fov[at]
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\r") == 101 and "101/101 frames, 0 s left" in said.err
    flight.render(plotter, "again", progress=False)
    assert capsys.readouterr().err == ""
