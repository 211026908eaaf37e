"""What the scripts for ParaView show: pvpython runs each, plays its animation frame by frame and asks the view's camera."""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import common  # noqa: E402
from paraview import simple  # noqa: E402


def work(job):
    simple.ResetSession()
    simple._DisableFirstRenderCameraReset()
    with open(job["file"], encoding="utf-8") as file:
        program = compile(file.read(), job["file"], "exec")
    # The script's functions stay in what cues of Python evaluate: the main module.
    space = {"__name__": "__main__", "__file__": job["file"]}
    exec(program, space)
    scene, view = simple.GetAnimationScene(), simple.GetActiveViewOrCreate("RenderView")
    width, height = view.ViewSize
    if not job.get("picture"):
        # Each step draws; the shape is what counts.
        view.ViewSize = [max(1, width // 10), max(1, height // 10)]
    frames = []
    scene.GoToFirst()
    count = scene.NumberOfFrames
    for n in job.get("frames", range(count)):
        if "frames" in job:
            scene.AnimationTime = scene.StartTime + n * (scene.EndTime - scene.StartTime) / (count - 1)
        elif n:
            scene.GoToNext()
        camera = view.GetActiveCamera()
        matrix = camera.GetModelViewTransformMatrix()
        turn = [[matrix.GetElement(column, row) for column in range(3)] for row in range(3)]
        place = camera.GetPosition()
        frame = common.frame([[*turn[row], place[row]] for row in range(3)], -1, camera.GetViewAngle())
        if job.get("points"):
            whole = camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
            frame["pixels"] = []
            for point in job["points"]:
                x, y, _, w = whole.MultiplyPoint([*point, 1])
                frame["pixels"].append([(x / w + 1) / 2 * width, (1 - y / w) / 2 * height])
        frames.append(frame)
    if job.get("picture"):
        simple.SaveScreenshot(job["picture"], view)
    return {"frames": frames, "size": [width, height], "play_mode": str(scene.PlayMode)}


common.run(work)
