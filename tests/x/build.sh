#!/bin/bash
# Compiles and links every C host as its author would write it, against the
# archive and against the shared library, into LIBRARY_FOLDER/../x:
# build.sh LIBRARY_FOLDER
#
# As many at once as there are processors; nothing if all is as it was.
set -eu

libraries=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
root=$(realpath "$here/../..")
out=$libraries/../x
cc=${CC:-cc}
[ "$(cat "$out/built" 2>/dev/null)" = "$cc" ] && [ -z "$(find "$libraries"/libvides.* "$root/include" \
    "$root/c_examples" "$root/README.md" "$here" "$here/../calls" -type f ! -name '*.py*' \
    -newer "$out/built" -print -quit)" ] && exit
rm -f "$out/built" "$out/unbuilt"
mkdir -p "$out/archive"
ln -sf "$libraries/libvides.a" "$out/archive/"

beside() { # COMMAND...: beside what runs already
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
    { "$@" || touch "$out/unbuilt"; } &
}

build() { # NAME SOURCES -- LIBRARIES: as C89 without a warning
    beside host "$@"
}

host() {
    local name=$1 kind link source
    local objects=() sources=()
    shift
    while [ "$1" != -- ]; do
        sources+=("$1")
        shift
    done
    shift
    for source in "${sources[@]}"; do
        local object
        object=$out/$name-$(basename "$source" .c).o
        "$cc" -std=c89 -pedantic -Wall -Wextra -Werror -I"$root/include" $extra \
            -c -o "$object" "$source" || return
        objects+=("$object")
    done
    for kind in archive shared; do
        link=$libraries
        [ $kind = archive ] && link=$out/archive
        # A host's own words from here on: -lvides -lm.
        LIBRARY_PATH=$link "$cc" -o "$out/$name-$kind" "${objects[@]}" "$@" || return
    done
}

extra=
examples=$root/c_examples
build headless "$examples/headless.c" -- -lvides -lm
build pyramid_motif "$examples/pyramid_motif.c" -- -lvides -lm -lXm -lXt -lX11
build quits "$here/quits.c" -- -lvides -lm -lXm -lXt -lX11
build plain_main_loop "$examples/plain_main_loop.c" -- -lvides -lm
build two_windows "$examples/two_windows.c" -- -lvides -lm
build xlib_loop "$examples/xlib_loop.c" -- -lvides -lm -lX11
build motif_flight "$examples/motif_flight.c" -- -lvides -lm -lXm -lXt -lX11
build glut_flight "$examples/glut_flight.c" -- -lvides -lm -lglut -lGL
build glut_scene "$examples/glut_scene.c" -- -lvides -lm -lglut -lGL -lX11
build glx_pane "$examples/glx_pane.c" -- -lvides -lm -lX11 -lGL

# The README's own program: C99, as it stands there.
"$root/mk/readme.sh" "$root" "$out"
extra=-std=c99
build readme_window "$out/window.c" -- -lvides -lm

extra=-D_GNU_SOURCE
build loop_poll "$here/loop_poll.c" "$here/host.c" -- -lvides -lm
build loop_live "$here/loop_live.c" "$here/host.c" -- -lvides -lm
build stacked "$here/stacked.c" "$here/host.c" -- -lvides -lm -lX11
build loop_xt "$here/loop_xt.c" "$here/host.c" -- -lvides -lm -lXt -lX11
build loop_pending "$here/loop_pending.c" "$here/host.c" -- -lvides -lm -lXt -lX11

extra=-std=gnu99
build ending "$here/ending.c" -- -lvides -lm -lX11 -lpthread
build spaces "$here/spaces.c" -- -lvides -lm
build views "$here/views.c" -- -lvides -lm
build film "$here/film.c" "$here/../calls/hands.c" -- -lvides -lm -lX11
build standard "$here/standard.c" -- -lvides -lm
build thread_ends "$here/thread_ends.c" -- -lvides -lm
build meanwhile "$here/meanwhile.c" -- -lvides -lm
build work "$here/work.c" "$here/../calls/hands.c" -- -lvides -lm -lX11
build pane "$here/pane.c" -- -lvides -lm -lGL -lX11
build embedded "$here/embedded.c" -- -lvides -lm -lX11
extra="-std=gnu99 -g -fsanitize=address,undefined"
cp "$here/pane.c" "$out/pane_asan.c"
build pane_asan "$out/pane_asan.c" -- -fsanitize=address,undefined -lvides -lm -lGL -lX11

for kind in archive shared; do
    link=$libraries
    [ $kind = archive ] && link=$out/archive
    LIBRARY_PATH=$link beside "${CXX:-c++}" -std=c++98 -pedantic -Wall -Wextra -Werror -I"$root/include" \
        -o "$out/throws-$kind" "$here/throws.cc" -lvides -lm
done

extra=
beside "$cc" -std=gnu99 -O1 -Wall -Wextra -Werror -o "$out/first_picture" "$here/first_picture.c" -lX11
beside "$cc" -std=gnu99 -O1 -Wall -Wextra -Werror -o "$out/flood" "$here/flood.c" \
    "$here/../calls/hands.c" -lX11
beside "$cc" -std=gnu99 -O1 -Wall -Wextra -Werror -o "$out/manager" "$here/manager.c" -lX11
beside "$cc" -std=gnu99 -O1 -Wall -Wextra -Werror -o "$out/drags" "$here/drags.c" -lX11
wait
[ ! -e "$out/unbuilt" ]
echo "$cc" >"$out/built"
