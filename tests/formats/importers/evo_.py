"""What evo makes of TUM, EuRoC and KITTI trajectories."""

import common
from evo.tools import file_interface


def work(job):
    if job["format"] == "kitti":
        path = file_interface.read_kitti_poses_file(job["file"])
        return {"frames": [common.frame(matrix, 1) for matrix in path.poses_se3]}
    euroc = job["format"] == "euroc"
    read = file_interface.read_euroc_csv_trajectory if euroc else file_interface.read_tum_trajectory_file
    path = read(job["file"])
    right, words = path.check()
    if not right:
        raise ValueError(str(words))
    return {"frames": [common.frame(m, 1) for m in path.poses_se3], "times": path.timestamps.tolist()}


common.run(work)
