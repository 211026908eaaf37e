# VIDES: builds the C libraries and the command, tests and installs them.
#
#   make             the libraries and the command, in target/
#   make demo        a Motif program that opens the editor, on your display or by itself
#   make test        every check there is
#   make check       format, lints and Rust tests: what one runs while working
#   make check-hosts the window beside hosts of many toolkits; large packages
#   make check-formats what VIDES writes, read by Blender, ParaView and others; large packages
#   make wheel       the Python package, in target/wheels
#   make check-packages the Python package with several Pythons and much beside it; large packages
#   make check-planning what is planned, beside other libraries
#   make bench       speed, beside other libraries
#   make soak        the random checks again, with many more cases, and fuzz
#   make coverage    which share of the branches the tests take, by folder
#   make fuzz        tries broken files for FUZZ_SECONDS for each reader
#   make miri        runs the unsafe code in an interpreter that sees what it may not
#   make threads     looks for races between threads
#   make install     PREFIX=/usr/local DESTDIR=
#   make uninstall   the same
#   make deb         Debian packages, in target/deb
#   make header      rewrites include/libvides.h
#   make reference   pages of the C interface, target/reference: HTML and section 3
#   make gallery     eight flights with pictures and pages that play them, target/gallery
#   make site        the documents as pages, with gallery and C reference, target/site
#   make completions rewrites completions/, docs/reference/command.md and the commands in man/vides.1
#   make clean
#
# Each target installs by itself what it misses (mk/need.sh).

SHELL = /bin/sh
.SUFFIXES:
.DELETE_ON_ERROR:
# The steps of a target run in the order written; cargo itself works in parallel.
# Only the checks of `make test` run side by side, as many as JOBS.
ifeq ($(filter side-by-side,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif
JOBS ?= 2

PREFIX ?= /usr/local
DESTDIR ?=
bindir = $(PREFIX)/bin
libdir = $(PREFIX)/lib
includedir = $(PREFIX)/include
datadir = $(PREFIX)/share
mandir = $(datadir)/man
# What lies below the share of a desktop and of the shells, as FILE:WHERE.
SHARED = desktop/vides.desktop:applications desktop/vides.xml:mime/packages \
    desktop/vides.svg:icons/hicolor/scalable/apps \
    completions/vides:bash-completion/completions completions/_vides:zsh/site-functions \
    completions/vides.fish:fish/vendor_completions.d

CARGO ?= cargo
CC ?= cc
CARGO_TARGET_DIR ?= target
export CARGO_TARGET_DIR CC AGAIN

VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
RELEASE = $(CARGO_TARGET_DIR)/release
# The C libraries as they are installed.
LIB = $(CARGO_TARGET_DIR)/c
DEMO = $(CARGO_TARGET_DIR)/demo
# Not empty: what is played anew in folders of its own is left out.
SHORT =
# A mesh without a flight.
SPIDER = /usr/share/assimp/models/OBJ/spider.obj
TOOLS = $(CARGO_TARGET_DIR)/tools

# Not run again where it has passed with the same files: $(ONCE)NAME ITS_FILES -- COMMAND.
WITH = $(LIB) $(RELEASE)/vides include c_examples examples mk README.md
ONCE = mk/once.sh $(CARGO_TARGET_DIR)/passed/

SOAK_CASES ?= 20000
FUZZ_SECONDS ?= 1800
# What drives a window under an X server without a screen.
X_TOOLS = python3=python3 Xvfb=xvfb xauth=xauth xdotool=xdotool xprop=x11-utils \
    xwd=x11-apps /usr/include/Xm/Xm.h=libmotif-dev
LINT = -D warnings

.PHONY: all libs demo test check bench soak soak-calls soak-x fuzz coverage miri threads install uninstall deb check-deb header completions reference gallery site clean side-by-side FORCE \
	toolchain check-format check-lints check-rust check-c check-linking \
	check-calls check-x check-demo check-install check-docs check-dependencies \
	check-hosts soak-hosts check-planning check-formats check-formats-small wheel check-python check-packages

all: libs $(RELEASE)/vides

# ---- The libraries and the command -------------------------------------------

toolchain:
	@command -v $(CARGO) >/dev/null || { \
	    echo 'No Rust toolchain here: see https://rustup.rs' >&2; exit 1; }
	@mk/need.sh $(firstword $(CC))=gcc ld=binutils /usr/include/stdio.h=libc6-dev

libs: toolchain $(LIB)/libvides.a

# cargo knows best whether something changed; if not, it leaves the files alone.
# One call for both: their link-time optimisations take a processor each.
$(RELEASE)/libvides_archive.a $(RELEASE)/vides &: FORCE
	$(CARGO) build --release --locked -p vides-archive -p vides --features vides/cli --lib --bin vides

$(LIB)/libvides.a: $(RELEASE)/libvides_archive.a $(wildcard mk/*)
	mk/libraries.sh $(RELEASE)/libvides_archive.a $(LIB) $(VERSION)

# For CPython 3.10 and later.
WHEELS = $(CARGO_TARGET_DIR)/wheels
wheel: toolchain
	@mk/need.sh python3=python3 python3:ensurepip=python3-venv
	mk/wheel.sh $(TOOLS) $(WHEELS)

header: toolchain
	UPDATE_HEADER=1 $(CARGO) test --locked --all-features --test header

reference:
	@mk/need.sh python3=python3
	python3 mk/reference.py include/libvides.h $(CARGO_TARGET_DIR)/reference $(VERSION)

gallery: all
	@mk/need.sh python3=python3
	python3 mk/gallery.py $(RELEASE)/vides $(CARGO_TARGET_DIR)/gallery

# Pages that lead nowhere are an error.
site: reference gallery
	@mk/need.sh cmark-gfm=cmark-gfm
	python3 mk/site.py $(CARGO_TARGET_DIR)/site c=$(CARGO_TARGET_DIR)/reference/html gallery=$(CARGO_TARGET_DIR)/gallery

completions: toolchain
	UPDATE_COMPLETIONS=1 $(CARGO) test --locked --all-features --bin vides completions

# ---- Seeing it ------------------------------------------------------------------

# The Motif host on the user's display; without one it is played by mouse and
# keyboard on an X server without a screen.
demo: all
	@mk/need.sh /usr/include/Xm/Xm.h=libmotif-dev /usr/include/GL/freeglut.h=freeglut3-dev \
	    $(SPIDER)=assimp-testmodels
	@mkdir -p $(DEMO)
	$(RELEASE)/vides info examples/pyramid.vid
	$(RELEASE)/vides sample examples/pyramid.vid -o $(DEMO)/pyramid.txt
	$(CC) -std=c89 -pedantic -Wall -Wextra -Iinclude -o $(DEMO)/headless \
	    c_examples/headless.c -L$(LIB) -lvides -lm
	LD_LIBRARY_PATH=$(abspath $(LIB)) $(DEMO)/headless examples/pyramid.vid >$(DEMO)/list.txt
	$(RELEASE)/vides plot examples/pyramid.vid -o $(DEMO)/pyramid.svg
	$(RELEASE)/vides convert examples/pyramid.vid $(DEMO)/pyramid.html
	$(RELEASE)/vides tour $(SPIDER) -o $(DEMO)/spider.vid
	$(RELEASE)/vides --trust plot $(DEMO)/spider.vid -o $(DEMO)/spider.svg
	$(RELEASE)/vides --trust check $(DEMO)/spider.vid
	$(CC) -Iinclude -o $(DEMO)/pyramid_motif c_examples/pyramid_motif.c \
	    -L$(LIB) -lvides -lm -lXm -lXt -lX11
	for program in glut_flight glut_scene; do \
	    $(CC) -Iinclude -o $(DEMO)/$$program c_examples/$$program.c \
	        -L$(LIB) -lvides -lm -lglut -lGL -lX11 || exit; \
	done
	@echo
	@echo 'A flight around a pyramid, in $(DEMO):'
	@echo '  pyramid.svg   the path in space, its views, speed and turning: open it in a browser'
	@echo '  pyramid.html  the flight itself: open it in a browser, Space plays it'
	@echo '  spider.svg    a tour of a mesh that nobody planned; vides check has found nothing in it'
	@echo '  pyramid.txt   every camera pose, one a line, as vides sample writes them'
	@echo '  list.txt      the same as a C program meets them in its list, forwards and back'
	@if [ -n "$$DISPLAY" ]; then \
	    echo 'A Motif program of 1994: press "Edit Kurve", plan a flight, hand it over with Alt-U.'; \
	    LD_LIBRARY_PATH=$(abspath $(LIB)) $(DEMO)/pyramid_motif; \
	    echo 'A program of today flies along: drag, scrub and play in the editor beside it.'; \
	    LD_LIBRARY_PATH=$(abspath $(LIB)) $(DEMO)/glut_flight examples/pyramid.vid; \
	    echo 'A scene of moving things, drawn by a program at the frame of the editor.'; \
	    LD_LIBRARY_PATH=$(abspath $(LIB)) $(DEMO)/glut_scene; \
	else \
	    mk/need.sh $(X_TOOLS) && \
	    echo 'No display: mouse and keyboard play it by themselves. Screens and poses:' && \
	    LD_LIBRARY_PATH=$(abspath $(LIB)) PYTHONDONTWRITEBYTECODE=1 \
	        python3 tests/x/demo.py $(DEMO)/pyramid_motif $(DEMO)/glut_flight \
	        $(DEMO)/glut_scene examples/pyramid.vid $(DEMO) $(SHORT) && \
	    [ -n '$(SHORT)' ] || { echo 'What a new user does, by mouse and keyboard in vides edit:' && \
	    PYTHONDONTWRITEBYTECODE=1 python3 tests/x/tasks.py $(RELEASE)/vides $(DEMO)/tasks $(SPIDER); }; \
	fi

# ---- Checks, the cheap ones first -----------------------------------------------

# Side by side, since much of it is waiting or has one thread; each check's words
# come when it is done. `make test AGAIN=1` runs what has passed with the same files, too.
test: toolchain check-format
	@$(MAKE) -j$(JOBS) --output-sync=target side-by-side
	@$(MAKE) check-x
	@echo 'make test: every check passed'

# While working: minutes after a change of one file.
check: toolchain check-format check-lints check-rust

# Beside what compiles runs what waits. The window from outside comes last and alone:
# some of its checks look at the clock.
side-by-side: check-lints all check-calls check-rust check-c \
	check-linking check-demo check-install check-formats-small check-python check-docs check-dependencies

check-format:
	@command -v cargo-fmt >/dev/null || mk/component.sh rustfmt
	$(CARGO) fmt --all --check
	$(CARGO) fmt --check --manifest-path fuzz/Cargo.toml
	$(CARGO) fmt --check --manifest-path python/Cargo.toml

check-lints:
	@command -v cargo-clippy >/dev/null || mk/component.sh clippy
	@mk/need.sh python3=python3
	python3 mk/imports.py --check --plain >/dev/null && python3 mk/imports.py --check >/dev/null
	python3 mk/count_lines.py --check
	$(CARGO) clippy --locked --workspace --all-features --all-targets -- $(LINT)

check-rust:
	@mk/need.sh python3=python3 Xvfb=xvfb xdotool=xdotool xclip=xclip \
	    setxkbmap=x11-xkb-utils /usr/share/X11/locale/compose.dir=libx11-data
	@mk/locale.sh
	env -u MAKEFLAGS $(CARGO) test --locked --workspace --all-features --no-fail-fast -- --skip timed_

check-c: libs
	@mk/need.sh c++=g++ valgrind=valgrind
	$(ONCE)c $(WITH) tests/c tests/corpus -- tests/c/run.sh $(LIB)

check-linking: libs
	@mk/need.sh c++=g++ tcc=tcc /usr/include/Xm/Xm.h=libmotif-dev
	$(ONCE)linking $(WITH) tests/linking -- tests/linking/run.sh $(LIB) include

# Calls as no host should make them; and a library that panics when it is told
# to, and says where it is. That one is built with what the Rust tests are built
# with, and it is not installed.
check-calls: libs
	@mk/need.sh Xvfb=xvfb python3=python3 /usr/include/X11/Xlib.h=libx11-dev
	$(ONCE)calls $(WITH) tests/calls -- tests/calls/run.sh $(LIB)
	$(CARGO) build --locked --workspace --all-features --lib --tests
	mk/libraries.sh $(CARGO_TARGET_DIR)/debug/libvides_archive.a $(CARGO_TARGET_DIR)/inject $(VERSION)
	$(ONCE)inject $(CARGO_TARGET_DIR)/inject include tests/calls -- \
	    tests/calls/run.sh $(CARGO_TARGET_DIR)/inject inject hand_over

# Planned flights, beside other libraries and against their distances and rays; not in `make test`.
check-planning: all
	@mk/need.sh python3=python3 node=nodejs npm=npm
	[ -x $(CARGO_TARGET_DIR)/planning/bin/python ] || { \
	    python3 -m venv $(CARGO_TARGET_DIR)/planning && \
	    $(CARGO_TARGET_DIR)/planning/bin/pip -q install -r tests/planning/requirements; }
	$(CARGO_TARGET_DIR)/planning/bin/python tests/planning/retime.py $(RELEASE)/vides $(CARGO_TARGET_DIR)/planning/paths
	$(CARGO_TARGET_DIR)/planning/bin/python tests/planning/picture.py $(LIB)/libvides.so.1 $(CARGO_TARGET_DIR)/planning/meshes
	$(CARGO_TARGET_DIR)/planning/bin/python tests/planning/steady.py $(RELEASE)/vides $(CARGO_TARGET_DIR)/planning/paths
	cd $(CARGO_TARGET_DIR)/planning && { [ -d data/meshes ] || { apt-get -q download libcgal-demo && \
	    dpkg -x libcgal-demo_*.deb cgal && tar xzf cgal/usr/share/doc/libcgal-dev/data.tar.gz; }; }
	$(CARGO_TARGET_DIR)/planning/bin/python tests/planning/tour.py $(RELEASE)/vides $(CARGO_TARGET_DIR)/planning/tours \
	    $(patsubst %,$(CARGO_TARGET_DIR)/planning/data/meshes/%.off,refined_elephant bunny00 armadillo \
	    camel bull lion-head cow) nut.ply airplane.ply ant.ply
	$(CARGO_TARGET_DIR)/planning/bin/python tests/planning/avoid.py $(RELEASE)/vides $(CARGO_TARGET_DIR)/planning/avoid

# The window, from outside.
check-x: all
	@mk/need.sh $(X_TOOLS) xclip=xclip openbox=openbox valgrind=valgrind \
	    setxkbmap=x11-xkb-utils xdpyinfo=x11-utils \
	    xrdb=x11-xserver-utils /usr/include/GL/freeglut.h=freeglut3-dev
	$(ONCE)x $(WITH) tests/x tests/calls -- tests/x/run.sh $(LIB)

# What a new user types first, where there is no display; and once more, over what the first
# time left, without what is made in folders of its own.
check-demo: all
	$(ONCE)demo $(WITH) tests/x -- \
	    sh -c 'env -u DISPLAY $(MAKE) demo && env -u DISPLAY $(MAKE) demo SHORT=short'

check-install: all
	@mk/need.sh python3=python3 pkg-config=pkg-config groff=groff-base c++=g++ cmake=cmake xmllint=libxml2-utils \
	    desktop-file-validate=desktop-file-utils update-mime-database=shared-mime-info \
	    gio=libglib2.0-bin zsh=zsh fish=fish
	tests/install/run.sh

check-docs:
	RUSTDOCFLAGS='$(LINT)' $(CARGO) doc --locked --workspace --all-features --no-deps --document-private-items

# Licences, sources and duplicates; that the fuzzer's own lock file fits. Known
# weaknesses of dependencies are asked for apart (`cargo deny check advisories`):
# they come from the network and change without a change here.
check-dependencies:
	mk/deny.sh $(TOOLS) --locked check bans licenses sources
	$(CARGO) metadata --locked --format-version 1 --manifest-path fuzz/Cargo.toml >/dev/null
	mk/deny.sh $(TOOLS) --locked --manifest-path python/Cargo.toml --config deny.toml check bans licenses sources

# Hosts of other toolkits. Their packages are large: not in `make test`.
check-hosts: all
	@mk/need.sh $(X_TOOLS) openbox=openbox xwininfo=x11-utils \
	    c++=g++ pkg-config=pkg-config gfortran=gfortran \
	    /usr/include/X11/extensions/Xdamage.h=libxdamage-dev \
	    /usr/include/gtk-4.0/gtk/gtk.h=libgtk-4-dev /usr/include/gtk-3.0/gtk/gtk.h=libgtk-3-dev \
	    /usr/include/SDL2/SDL.h=libsdl2-dev /usr/include/FL/Fl.H=libfltk1.3-dev \
	    /usr/include/GL/freeglut.h=freeglut3-dev wx-config=libwxgtk3.2-dev \
	    /usr/bin/python3:tkinter=python3-tk /usr/bin/python3:vtkmodules=python3-vtk9
	@pkg-config --exists Qt5Widgets || mk/need.sh /no/Qt5=qtbase5-dev
	@pkg-config --exists Qt6Widgets || mk/need.sh /no/Qt6=qt6-base-dev
	tests/hosts/run.sh $(LIB)

# What VIDES writes, read by the programs of others; those that are small, and all.
FORMATS = $(CARGO_TARGET_DIR)/formats
check-formats-small: all
	tests/formats/install.sh $(FORMATS)
	$(ONCE)formats $(RELEASE)/vides tests/formats examples -- tests/formats/run.sh $(FORMATS) $(RELEASE)/vides

check-formats: all
	@mk/need.sh chromium=chromium chromedriver=chromium-driver
	tests/formats/install.sh $(FORMATS) large
	tests/formats/run.sh $(FORMATS) $(RELEASE)/vides --large

# The Python package: what is quick, and all.
check-python: libs wheel
	@mk/need.sh Xvfb=xvfb xdotool=xdotool
	python/tests/run.sh $(WHEELS) $(CARGO_TARGET_DIR)/python $(LIB)/libvides.so.1

check-packages: libs wheel
	@mk/need.sh Xvfb=xvfb xdotool=xdotool
	tests/formats/install.sh $(FORMATS) large
	VIDES_FORMATS=$(abspath $(FORMATS)) \
	    python/tests/run.sh $(WHEELS) $(CARGO_TARGET_DIR)/python $(LIB)/libvides.so.1 large

bench: libs wheel
	@mk/need.sh python3=python3 python3:ensurepip=python3-venv
	python3 benches/table.py
	python3 benches/python.py $(WHEELS)/vides-*.whl
	python3 benches/scene.py
	$(CARGO) test --locked --workspace --all-features --lib --tests timed_ -- \
	    --test-threads=1 --nocapture

soak: toolchain libs fuzz
	@mk/need.sh python3=python3 Xvfb=xvfb xdotool=xdotool xclip=xclip setxkbmap=x11-xkb-utils \
	    /usr/share/X11/locale/compose.dir=libx11-data c++=g++ valgrind=valgrind
	@mk/locale.sh
	VIDES_LIMITS=1 VIDES_KILLS=200 VIDES_DRAGS=10000 VIDES_PATHS=200 PROPTEST_CASES=$(SOAK_CASES) $(CARGO) test --locked --workspace --all-features
	EACH=1 tests/c/run.sh $(LIB)
	VIDES_SAVE_KILLS=1000 tests/c/run.sh $(LIB) saving
	mk/arm.sh
	$(MAKE) soak-calls soak-x soak-hosts

# Other calls each time; the seeds are said.
soak-calls: libs
	@mk/need.sh Xvfb=xvfb /usr/include/X11/Xlib.h=libx11-dev
	EACH=1 tests/calls/run.sh $(LIB)
	SEEDS="$$(seq $$(date +%s) $$(($$(date +%s) + 19)))" CALLS=3000 tests/calls/run.sh $(LIB) hostile

# Events for a minute, 1,000 panes of each kind, and 10,000 windows.
soak-x: all
	@mk/need.sh $(X_TOOLS) valgrind=valgrind
	EACH=1 tests/x/run.sh $(LIB)
	VIDES_FLOOD=60 tests/x/run.sh $(LIB) events
	VIDES_PANES=1000 tests/x/run.sh $(LIB) a_host_that_draws
	LD_LIBRARY_PATH=$(abspath $(LIB)) python3 tests/x/measure.py $(CARGO_TARGET_DIR)/x soak

# Programs of other people's making, from Debian's sources.
soak-hosts: libs
	@mk/need.sh $(X_TOOLS) dpkg-source=dpkg-dev patch=patch pkg-config=pkg-config \
	    /usr/include/gtk-3.0/gtk/gtk.h=libgtk-3-dev /usr/include/X11/Xaw/XawInit.h=libxaw7-dev \
	    /usr/include/X11/extensions/Xdamage.h=libxdamage-dev \
	    /usr/include/curses.h=libncurses-dev
	tests/hosts/run.sh $(LIB) others

coverage: toolchain
	@mk/need.sh python3=python3 Xvfb=xvfb /usr/include/X11/Xlib.h=libx11-dev
	@mk/locale.sh
	mk/coverage.sh

miri:
	mk/miri.sh

threads: toolchain
	mk/threads.sh

fuzz: toolchain
	@mk/need.sh c++=g++
	@command -v cargo-fuzz >/dev/null || [ -x $(TOOLS)/bin/cargo-fuzz ] || \
	    $(CARGO) install --locked --root $(TOOLS) --target-dir $(TOOLS)/build cargo-fuzz
	PATH="$$PATH:$(abspath $(TOOLS))/bin" mk/fuzz.sh $(FUZZ_SECONDS)

# ---- Laying it down -------------------------------------------------------------

# So that the loader finds the library at once, and the desktop the type of .vid files;
# in a package's folder that is the package's business.
TELL = [ -n '$(DESTDIR)' ] || { [ "$$(id -u)" -ne 0 ] || ldconfig; mk/desktop.sh '$(datadir)'; }

install: all
	install -d '$(DESTDIR)$(libdir)/pkgconfig' '$(DESTDIR)$(libdir)/cmake/vides' \
	    '$(DESTDIR)$(includedir)' '$(DESTDIR)$(bindir)' '$(DESTDIR)$(mandir)/man1' '$(DESTDIR)$(mandir)/man3'
	install -m 644 $(LIB)/libvides.a '$(DESTDIR)$(libdir)'
	install -m 644 $(LIB)/libvides.so.$(VERSION) '$(DESTDIR)$(libdir)'
	ln -sf libvides.so.$(VERSION) '$(DESTDIR)$(libdir)/libvides.so.1'
	ln -sf libvides.so.1 '$(DESTDIR)$(libdir)/libvides.so'
	install -m 644 include/libvides.h '$(DESTDIR)$(includedir)'
	install -m 755 $(RELEASE)/vides '$(DESTDIR)$(bindir)'
	for file in pkgconfig/vides.pc cmake/vides/videsConfig.cmake \
	        cmake/vides/videsConfigVersion.cmake; do \
	    sed -e 's|@prefix@|$(PREFIX)|' -e 's|@libdir@|$(libdir)|' -e 's|@includedir@|$(includedir)|' \
	        -e 's|=$(PREFIX)/|=$${prefix}/|' -e 's|@version@|$(VERSION)|' \
	        -e "s|@include@|$$(realpath -ms --relative-to='$(libdir)' '$(includedir)')|" \
	        "mk/$${file##*/}.in" >'$(DESTDIR)$(libdir)/'"$$file" && \
	    chmod 644 '$(DESTDIR)$(libdir)/'"$$file" || exit; \
	done
	install -m 644 man/vides.1 '$(DESTDIR)$(mandir)/man1'
	install -m 644 man/libvides.3 '$(DESTDIR)$(mandir)/man3'
	for shared in $(SHARED); do \
	    install -D -m 644 -t '$(DESTDIR)$(datadir)/'"$${shared#*:}" "$${shared%:*}" || exit; \
	done
	@$(TELL)

uninstall:
	rm -f '$(DESTDIR)$(libdir)/libvides.a' \
	    '$(DESTDIR)$(libdir)/libvides.so' \
	    '$(DESTDIR)$(libdir)/libvides.so.1' \
	    '$(DESTDIR)$(libdir)/libvides.so.$(VERSION)' \
	    '$(DESTDIR)$(includedir)/libvides.h' \
	    '$(DESTDIR)$(bindir)/vides' \
	    '$(DESTDIR)$(libdir)/pkgconfig/vides.pc' \
	    '$(DESTDIR)$(mandir)/man1/vides.1' \
	    '$(DESTDIR)$(mandir)/man3/libvides.3' \
	    '$(DESTDIR)$(libdir)/cmake/vides/videsConfig.cmake' \
	    '$(DESTDIR)$(libdir)/cmake/vides/videsConfigVersion.cmake'
	rmdir '$(DESTDIR)$(libdir)/cmake/vides' 2>/dev/null || true
	for shared in $(SHARED); do \
	    file=$${shared%:*}; rm -f '$(DESTDIR)$(datadir)/'"$${shared#*:}/$${file##*/}"; \
	done
	@$(TELL)

# ---- Packages -------------------------------------------------------------------

DEB = $(CARGO_TARGET_DIR)/deb
deb: toolchain
	@mk/need.sh dh=debhelper dh_python3=dh-python python3:ensurepip=python3-venv
	rm -rf $(DEB)
	mkdir -p $(DEB)
	CARGO_TARGET_DIR='$(abspath $(CARGO_TARGET_DIR))' DEBS='$(abspath $(DEB))' debian/rules binary
	CARGO_TARGET_DIR='$(abspath $(CARGO_TARGET_DIR))' debian/rules clean

# Installs them on this machine, and purges them again.
check-deb: deb
	@mk/need.sh lintian=lintian pkg-config=pkg-config cmake=cmake
	tests/install/deb.sh $(DEB)

clean:
	$(CARGO) clean
	rm -f libvides.a
