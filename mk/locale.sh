#!/bin/sh
# Sees to a locale whose decimal sign is the comma: numbers in files must not
# follow it.
set -eu

locale -a 2>/dev/null | grep -qix 'de_DE\.utf-\?8' && exit 0
"$(dirname "$0")/need.sh" localedef=libc-bin /usr/share/i18n/locales/de_DE=locales
root=
[ "$(id -u)" -eq 0 ] || root=sudo
$root localedef -i de_DE -f UTF-8 de_DE.UTF-8
