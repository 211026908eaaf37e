"""Jupyter, Blender's Python, ParaView's Python."""

import os
import shutil
import subprocess
import sys
from pathlib import Path as File

import pytest

import vides

pytestmark = pytest.mark.large

PACKAGE = str(File(vides.__file__).parent.parent)

# For interpreters that have a numpy of their own.
PROGRAM = """
import sys
sys.path.append(sys.argv[-1])
import numpy as np
import vides
path = vides.Path(np.random.default_rng(3).uniform(-1, 1, (20, 3)), look_at=(0, 0, 0), frames=500)
samples = path.sample()
matrices = samples.matrices("opengl")
assert matrices.shape == (500, 4, 4)
path.points[1].zoom = 40
assert len(path.plot()) > 1000
try:
    path.points[0].zoom = -1
except vides.Error as error:
    assert error.place == "zoom"
"""


def test_a_notebook_shows_it() -> None:
    import nbformat
    from nbclient import NotebookClient

    cells = [
        "import vides\npath = vides.Path()\npath",
        "path.plot()",
        "path.sample()",
        "path.points[0].zoom = 5000",
    ]
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    notebook.cells[3].metadata["tags"] = ["raises-exception"]
    NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    shown = [cell.outputs for cell in notebook.cells]
    page = shown[0][0].data
    assert page["text/html"].startswith("<iframe srcdoc=") and "<svg" in page["image/svg+xml"]
    assert shown[1][0].data["image/svg+xml"].startswith("<svg")
    assert "121 poses" in shown[2][0].data["text/plain"]
    assert shown[3][0].output_type == "error" and shown[3][0].ename == "Error"
    assert "zoom must lie between 1 and 2000" in shown[3][0].evalue


@pytest.mark.parametrize("name", ["bpy-new", "bpy-old"])
def test_blenders_python(name: str, tmp_path: File) -> None:
    python = File(os.environ["VIDES_FORMATS"], name, "bin", "python")
    program = PROGRAM + """
import bpy
from mathutils import Matrix
camera = bpy.context.scene.camera or bpy.data.objects["Camera"]
for frame, matrix in zip(samples.frames[:10], matrices):
    camera.matrix_world = Matrix(matrix.tolist())
    camera.keyframe_insert("location", frame=int(frame))
bpy.context.scene.frame_set(7)
assert np.allclose(camera.location, samples.positions[6], atol=1e-6)
# Blender's cameras look along their own -z.
assert np.allclose(-np.array(camera.matrix_world)[:3, 2], samples.view[9], atol=1e-5)
print("flown")
"""
    done = subprocess.run([python, "-c", program, PACKAGE], capture_output=True, text=True, timeout=300)
    assert "flown" in done.stdout, done


def test_paraviews_python(tmp_path: File) -> None:
    program = tmp_path / "flight.py"
    program.write_text(PROGRAM + """
from paraview import simple
view = simple.CreateRenderView()
pose = samples[99]
view.CameraPosition = pose[0:3].tolist()
view.CameraFocalPoint = (pose[0:3] + pose[3:6]).tolist()
view.CameraViewUp = pose[6:9].tolist()
view.CameraViewAngle = float(samples.fov[99])
seen = view.GetActiveCamera()
assert np.allclose(seen.GetDirectionOfProjection(), samples.view[99])
print("flown")
""")
    pvpython = shutil.which("pvpython")
    assert pvpython is not None
    done = subprocess.run(
        [pvpython, "--force-offscreen-rendering", program, PACKAGE], capture_output=True, text=True, timeout=300
    )
    assert "flown" in done.stdout, done


def test_it_is_not_this_interpreters_folder() -> None:
    # The wheel is what is tested, not the sources.
    assert PACKAGE.startswith(sys.prefix)
