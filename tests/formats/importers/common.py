"""How every importer in Python gets its jobs and gives what it found."""

import json
import os
import sys


def run(work):
    """Calls `work` with each job of the file that is named; what it or its libraries print is not the result."""
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    with open(sys.argv[1]) as file:
        jobs = json.load(file)
    results = []
    for job in jobs:
        try:
            results.append(work(job))
        except Exception as error:
            results.append({"error": f"{type(error).__name__}: {error}"})
        except SystemExit as end:
            results.append({"error": f"the script ended itself: {end.code}"})
    json.dump(results, out)
    out.close()
    # Some of these libraries crash on their way out.
    os._exit(0)


def frame(matrix, looks, fov=None):
    """A pose of a camera-to-world matrix given as rows."""
    column = [[float(matrix[row][n]) for row in range(3)] for n in range(4)]
    return {
        "position": column[3],
        "view": [looks * value for value in column[2]],
        "up": [-looks * value for value in column[1]],
        "fov": None if fov is None else float(fov),
    }
