/* Calls VTK's own compiled functions in a C loop, so that no time of the
   Python interpreter is charged to VTK. peers.py finds the two functions in
   the libraries of the VTK wheel, and the objects behind the Python ones. */
#include <stddef.h>

typedef double (*evaluate)(void *spline, double t);
typedef void (*interpolate)(void *interpolator, double t, double q[4]);

/* poses: count rows of vrp, vpn, vup, zoom, as v_path_sample gives them. */
void vtk_poses(evaluate spline, interpolate turning, void *x, void *y, void *z, void *zoom,
               void *quaternions, double last, size_t count, double *poses)
{
    size_t i;
    double step = last / (double)(count - 1);
    for (i = 0; i < count; i++, poses += 10) {
        double t = step * (double)i, q[4];
        poses[0] = spline(x, t);
        poses[1] = spline(y, t);
        poses[2] = spline(z, t);
        poses[9] = spline(zoom, t);
        turning(quaternions, t, q);
        poses[3] = 2 * (q[1] * q[3] + q[0] * q[2]);
        poses[4] = 2 * (q[2] * q[3] - q[0] * q[1]);
        poses[5] = q[0] * q[0] - q[1] * q[1] - q[2] * q[2] + q[3] * q[3];
        poses[6] = 2 * (q[1] * q[2] - q[0] * q[3]);
        poses[7] = q[0] * q[0] - q[1] * q[1] + q[2] * q[2] - q[3] * q[3];
        poses[8] = 2 * (q[2] * q[3] + q[0] * q[1]);
    }
}
