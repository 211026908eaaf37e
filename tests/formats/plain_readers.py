"""Formats that no kept importer reads, read by their definition alone: the poses and, where it is in the file, the rate."""

import json

import numpy as np

import turns


def poses(matrices, looks, fov):
    return turns.poses(np.array(matrices, float), looks, fov=None if fov is None else np.array(fov, float))


def transforms(path):
    document = json.loads(path.read_text())
    matrices, fov = [], []
    for frame in document["frames"]:
        both = document | frame
        matrices.append(frame["transform_matrix"])
        if "fl_y" in both:
            fov.append(np.degrees(2 * np.arctan(both["h"] / 2 / both["fl_y"])))
        else:
            across = np.tan(both["camera_angle_x"] / 2)
            fov.append(np.degrees(2 * np.arctan(across * both["h"] / both["w"])))
    return poses(matrices, -1, fov)


def cameras(path):
    matrices, fov = [], []
    for entry in json.loads(path.read_text()):
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = entry["rotation"], entry["position"]
        matrices.append(matrix)
        fov.append(np.degrees(2 * np.arctan(entry["height"] / 2 / entry["fy"])))
    return poses(matrices, 1, fov)


def matrices(path):
    return poses(np.load(path), 1, None)


def open3d(path):
    found, fov = [], []
    for entry in json.loads(path.read_text())["parameters"]:
        found.append(np.linalg.inv(np.reshape(entry["extrinsic"], (4, 4)).T))
        height, focal = entry["intrinsic"]["height"], entry["intrinsic"]["intrinsic_matrix"][4]
        fov.append(np.degrees(2 * np.arctan(height / 2 / focal)))
    return poses(found, 1, fov)


def instant_ngp(path):
    keys = json.loads(path.read_text())["path"]
    found = np.tile(np.eye(4), (len(keys), 1, 1))
    for matrix, key in zip(found, keys):
        x, y, z, w = key["R"]
        # As ngp_matrix_to_nerf() of its source does it.
        matrix[:3, :3] = turns.to_matrices(np.array([[w, x, y, z]]))[0][[2, 0, 1]] * [1, -1, -1]
        matrix[:3, 3] = ((np.array(key["T"]) - 0.5) / 0.33)[[2, 0, 1]]
    # A key is reached when the time of the one before it is over.
    times = np.array([0.0, *(key["timestamp"] for key in keys[:-1])])
    return poses(found, -1, [key["fov"] for key in keys]), times


def numbers(path, separator=None):
    return np.array(
        [line.split(separator) for line in path.read_text().splitlines() if line.strip() and line[0] not in "#f"], float
    )


def osg(path):
    rows = numbers(path)
    return turns.poses(turns.to_matrices(rows[:, [7, 4, 5, 6]]), -1, rows[:, 1:4]), rows[:, 0]


def chan(path, order="zxy"):
    rows = numbers(path)
    return turns.poses(turns.of_euler(np.radians(rows[:, 4:7]), order), -1, rows[:, 1:4], rows[:, 7])


def ten(rows):
    return turns.Poses(rows[:, :3], rows[:, 3:6], rows[:, 6:9], np.degrees(2 * np.arctan(12 / rows[:, 9])))


def csv(path):
    rows = numbers(path, ",")
    return ten(rows[:, 1:11]), rows[:, 11]


def ascii(path):
    return ten(numbers(path))


def json_(path):
    found = json.loads(path.read_text())
    if "poses" in found:
        entries = found["poses"]
    else:
        entries = found["states"]
    rows = [[*entry["vrp"], *entry["vpn"], *entry["vup"], entry["zoom"]] for entry in entries]
    return ten(np.array(rows, float))
