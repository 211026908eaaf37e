#!/bin/sh
# Tells the desktop that types and programs below a folder for data have changed:
# desktop.sh PREFIX/share. Where no desktop looks there is nothing to tell.
set -eu

share=$1
case :${XDG_DATA_DIRS:-/usr/local/share:/usr/share}: in
*:"${share%/}":* | *:"${share%/}"/:*) ;;
*) exit 0 ;;
esac
tell() { # COMMAND FOLDER; without the desktop's tools there is no desktop that would look
    [ ! -d "$2" ] || ! command -v "$1" >/dev/null 2>&1 || "$1" "$2"
}
tell update-mime-database "$share/mime"
tell update-desktop-database "$share/applications"
# Of nothing they make databases, too, which the last one that goes takes along.
[ -n "$(ls -A "$share/mime/packages" 2>/dev/null)" ] || [ ! -d "$share/mime" ] ||
    find "$share/mime" -maxdepth 1 -type f -delete
[ -n "$(find "$share/applications" -name '*.desktop' 2>/dev/null)" ] ||
    rm -f "$share/applications/mimeinfo.cache"
# Menus look into a folder of icons again that has changed.
[ ! -e "$share/icons/hicolor/icon-theme.cache" ] || touch "$share/icons/hicolor"
