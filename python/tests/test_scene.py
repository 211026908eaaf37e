"""A scene: made, evaluated, sampled, saved."""

import copy
import pickle
from pathlib import Path as File

import numpy as np
import pytest

import vides


@pytest.fixture
def scene() -> vides.Scene:
    scene = vides.Scene()
    scene.fps = 50
    camera = scene.add("camera", "camera")
    camera.follow(vides.Path([[3, 0, 0], [0, 0, 3]], look_at=(0, 0, 0), frames=101), 11)
    arm = scene.add("arm")
    arm.position = (1, 0, 0)
    half = np.sqrt(0.5)
    arm.set_keys("rotation", [1, 101], [[1, 0, 0, 0], [half, 0, half, 0]], "linear")
    cube = scene.add("cube", "object", parent="arm")
    cube.position = (0, 0, 2)
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    cube.set_mesh((corners, [[0, 1, 2], [1, 3, 2]]), [[4, 5]])
    lamp = scene.add("lamp", "spot")
    lamp.colour = (1, 0.5, 0.25)
    lamp.cone = [10, 20]
    lamp.aim = "cube"
    return scene


def test_it_plays(scene: vides.Scene) -> None:
    assert list(scene) == ["camera", "arm", "cube", "lamp"] and scene.camera == "camera"
    states = scene.evaluate(101)
    # The arm has turned by 90 degrees about y: what lay along z lies along x.
    np.testing.assert_allclose(states["cube"].matrix[:3, 3], [3, 0, 0], atol=1e-12)
    assert states["lamp"].colour == (1, 0.5, 0.25) and states["lamp"].cone == (10, 20)
    toward = np.array([3.0, 0, 0]) - states["lamp"].pose[:3]
    np.testing.assert_allclose(states["lamp"].pose[3:6], toward / np.linalg.norm(toward), atol=1e-9)
    motion = scene.sample("cube", 1, 101, 0.5)
    assert motion.matrices.shape == (201, 4, 4)
    np.testing.assert_array_equal(motion.frames, np.linspace(1, 101, 201))
    np.testing.assert_allclose(motion.matrices[-1], states["cube"].matrix)
    np.testing.assert_allclose(scene["cube"].vertices(1)[7], [1, 1, 1])
    np.testing.assert_array_equal(scene["cube"].triangles, [[0, 1, 2], [1, 3, 2]])


def test_the_camera_is_that_of_its_path(scene: vides.Scene) -> None:
    poses = scene.sample(first=11, last=111).poses
    np.testing.assert_allclose(poses.array, scene.path().sample().array, atol=1e-12)
    assert poses.fps == 50


def test_nodes_change(scene: vides.Scene) -> None:
    cube = scene["cube"]
    before = scene.evaluate(1)["cube"].matrix
    cube.parent = None
    np.testing.assert_allclose(scene.evaluate(1)["cube"].matrix, before, atol=1e-12)
    cube.name = "box"
    assert "box" in scene and "cube" not in scene and scene["lamp"].aim == "box"
    cube.set_keys("visible", [1, 10], [1, 0], "step")
    assert not scene.evaluate(20)["box"].visible
    (keys,) = cube.keys
    assert keys.channel == "visible" and keys.values.tolist() == [[1], [0]]
    cube.remove_keys("visible")
    assert cube.keys == [] and scene.evaluate(20)["box"].visible
    del scene["arm"]
    assert len(scene) == 3
    with pytest.raises(KeyError):
        scene["arm"]
    with pytest.raises(vides.Error, match="taken|already"):
        scene.add("box")


def test_files(scene: vides.Scene, tmp_path: File) -> None:
    scene.save(tmp_path / "scene.vid")
    again = vides.Scene.load(tmp_path / "scene.vid")
    assert again.to_str() == scene.to_str()
    for twin in (scene.copy(), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
        assert twin == scene
        twin.fps = 10
        assert scene.fps == 50 and twin != scene
    losses = scene.save(tmp_path / "scene.glb")
    assert isinstance(losses, list)
    back = vides.Scene.load(tmp_path / "scene.glb")
    at = [s.evaluate(s.frame_range[0] + 60)["cube"].matrix[:3, 3] for s in (scene, back)]
    np.testing.assert_allclose(at[0], at[1], atol=1e-5)
    assert vides.convert(tmp_path / "scene.glb", tmp_path / "scene.usda") is not None
    with pytest.raises(vides.Error, match="would be replaced"):
        vides.convert(tmp_path / "scene.glb", tmp_path / "scene.glb")


def test_matrices_are_those_of_the_poses(scene: vides.Scene) -> None:
    motion = scene.sample("camera", 11, 60)
    np.testing.assert_allclose(motion.matrices, motion.poses.matrices("vides"), atol=1e-12)
    # What a camera sees ahead lies along its +z.
    state = scene.evaluate(20)["camera"]
    np.testing.assert_allclose(state.matrix[:3, 2], state.pose[3:6], atol=1e-12)
    for owner in (vides.State, vides.Motion, vides.Scene.sample, vides.Scene.evaluate):
        assert "forward" in (owner.__doc__ or "")


def test_what_looks_nowhere_has_no_pose(scene: vides.Scene) -> None:
    states = scene.evaluate(5)
    assert np.isnan(states["cube"].pose).all() and np.isnan(states["arm"].pose).all()
    assert np.isfinite(states["lamp"].pose).all() and np.isfinite(states["camera"].pose).all()
    assert np.isnan(scene.sample("cube", 1, 3).poses.array).all()
    assert np.isfinite(scene.sample("lamp", 1, 3).poses.array).all()


def test_nodes_are_copied_and_compared(scene: vides.Scene) -> None:
    cube = scene["cube"]
    assert cube == scene["cube"] and cube != scene["arm"] and scene == scene
    assert copy.copy(cube) == cube
    for twin in (copy.deepcopy(cube), pickle.loads(pickle.dumps(cube))):
        assert twin.name == "cube" and twin != cube
        np.testing.assert_array_equal(twin.position, cube.position)
        twin.position = (9, 9, 9)
        assert cube.position[0] == 0


def test_what_the_table_says_of_nodes_is_an_attribute_of_some_kind() -> None:
    scene = vides.Scene()
    nodes = [scene.add(kind, kind) for kind in ("object", "spot", "camera")]
    keys = [row.key for row in vides.properties() if row.owner == "node"]
    assert len(keys) == 10
    for key in keys:
        name = key.removesuffix("_mm").removesuffix("_degrees")
        assert any(hasattr(node, name) for node in nodes), key
