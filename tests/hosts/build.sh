#!/bin/bash
# Compiles the hosts of other toolkits with the library in a folder:
# build.sh LIBRARY_FOLDER FOLDER [others]
#
# With `others` only what their tests need.
set -eu

libraries=$(realpath "$1")
mkdir -p "$2"
out=$(realpath "$2")
here=$(dirname "$(realpath "$0")")
root=$(realpath "$here/../..")
examples=$root/c_examples
export LIBRARY_PATH=$libraries C_INCLUDE_PATH=$root/include CPLUS_INCLUDE_PATH=$root/include

# As a host's author would: with -lvides -lm.
c() { # NAME SOURCE FLAGS
    "${CC:-cc}" -std=gnu99 -Wall -Wextra -Werror -o "$out/$1" "$2" "${@:3}" -lvides -lm
}
cxx() {
    "${CXX:-c++}" -std=c++17 -fPIC -Wall -Wextra -Werror -o "$out/$1" "$2" "${@:3}" -lvides -lm
}
flags() { # As those of system headers, that they do not warn.
    pkg-config --cflags --libs "$@" | sed 's/-I/-isystem /g'
}

c pace "$here/pace.c" -lXdamage -lX11
[ "${3:-}" != others ] || exit 0
c gtk_flight "$examples/gtk_flight.c" $(flags gtk4)
c sdl_flight "$examples/sdl_flight.c" $(flags sdl2)
cxx qt5_flight "$examples/qt_flight.cpp" $(flags Qt5Widgets)
cxx qt6_flight "$examples/qt_flight.cpp" $(flags Qt6Widgets)
c gtk3 "$here/gtk3.c" $(flags gtk+-3.0)
c gtk_embedded "$examples/gtk_embedded.c" $(flags gtk+-3.0)
c glx_pane "$examples/glx_pane.c" -lX11 -lGL
c glut "$here/glut.c" -lglut -lGL
c motif "$here/motif.c" -lXm -lXt -lX11
c xt_select "$here/xt_select.c" -lXt -lX11
cxx fltk "$here/fltk.cpp" -lfltk -lX11
cxx wx "$here/wx.cpp" $(wx-config --cxxflags --libs core,base | sed 's/-I/-isystem /g')
gfortran -std=f2008 -Wall -Wextra -Werror -Wno-unused-dummy-argument \
    -J "$out" -o "$out/fortran" "$here/fortran.f90" -lvides
