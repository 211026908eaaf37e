// A small host in C++: the version that runs, and how many poses its path has.
#include <libvides.h>

#include <iostream>
#include <vector>

int main() {
    const double summit[3] = {0.0, 0.6, -0.2};
    V_PATH *path = nullptr;
    std::size_t count = 0;
    std::vector<V_POSE> poses(10000);
    if (v_path_new(&path) != V_OK || v_path_insert_point(path, 1, summit) != V_OK
        || v_path_sample(path, poses.data(), poses.size(), &count) != V_OK) {
        std::cerr << v_last_error() << '\n';
        return 1;
    }
    v_path_free(path);
    std::cout << v_version() << ": " << count << " poses\n";
}
