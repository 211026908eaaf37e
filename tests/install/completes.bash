#!/bin/bash
# What bash completes with the file of completions that it is given: completes.bash FILE
set -u
# shellcheck source=/dev/null
source "$1"
status=0
completed() { # EXPECTED WORD...: of the last word
    local expected=$1
    shift
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
    _vides "$1" "${*: -1}" "${*: -2:1}"
    case " ${COMPREPLY[*]} " in
    *" $expected "*) ;;
    *) echo "$*: ${COMPREPLY[*]}"; status=1 ;;
    esac
}
completed convert vides conv
completed glb vides convert --to gl
completed --frames vides convert a.vid --fr
exit $status
