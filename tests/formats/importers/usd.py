"""What OpenUSD (usd-core) makes of .usda files: the first camera, or the job's, at each time code."""

import common
from pxr import Gf, Usd, UsdGeom


def work(job):
    stage = Usd.Stage.Open(job["file"])
    cameras = [prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Camera)]
    named = [
        c for c in cameras
        if job.get("camera") in (c.GetName(), c.GetDisplayName(), c.GetParent().GetName(), c.GetParent().GetDisplayName())
    ]  # fmt: skip
    prim = (named or cameras)[0]
    camera = UsdGeom.Camera(prim)
    first, last = stage.GetStartTimeCode(), stage.GetEndTimeCode()
    frames = []
    for n in range(job["count"]):
        time = first + n
        seen = camera.GetCamera(time)
        # Row vectors: the camera's axes are the rows, after whatever scale its parents have.
        matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(time).GetOrthonormalized(False)
        rows = [[matrix[column][row] for column in range(4)] for row in range(4)]
        place = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(time).ExtractTranslation()
        for row in range(3):
            rows[row][3] = place[row]
        frames.append(common.frame(rows, -1, seen.GetFieldOfView(Gf.Camera.FOVVertical)))
    problems = [str(error) for error in getattr(stage, "GetCompositionErrors", list)()]
    return {
        "frames": frames, "fps": stage.GetTimeCodesPerSecond(), "first": first, "last": last,
        "up": UsdGeom.GetStageUpAxis(stage).lower(), "warnings": problems,
    }  # fmt: skip


common.run(work)
