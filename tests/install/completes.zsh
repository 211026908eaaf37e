#!/usr/bin/env -S zsh -f
# What zsh completes with the folder of completions that it is given: completes.zsh FOLDER
# Only a shell at a terminal completes: here is one, and Tab is pressed. What does not come is
# waited for until the caller's time is up.
zmodload zsh/zpty
zpty terminal env PS1= TERM=dumb zsh -f -i
zpty -w terminal "fpath=(${(q)1} \$fpath); autoload -Uz compinit; compinit -D -u; print READ''Y"
zpty -r -m terminal said '*READY*'
completed() { # TYPED EXPECTED
    print -r "$1 -> $2"
    zpty -n -w terminal "$1"$'\t'
    zpty -r -m terminal said "*$2*"
    zpty -n -w terminal $'\C-u'
}
completed 'vides conv' 'vides convert '
completed 'vides convert --to us' 'usda '
completed 'vides convert a.vid --fra' '--frames'
zpty -d terminal
