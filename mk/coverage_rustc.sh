#!/bin/sh
# The compiler with counters for every branch: for our own code only, as cargo's
# wrapper for the workspace, so that dependencies need not be built again. Counting
# branches is a flag that a stable compiler keeps to itself unless it is told that
# its users build compilers.
RUSTC_BOOTSTRAP=1 exec "$@" -Cinstrument-coverage -Zcoverage-options=branch
