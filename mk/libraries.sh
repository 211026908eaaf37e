#!/bin/sh
# The two C libraries, from the archive that rustc makes.
#
#     libraries.sh RUST_ARCHIVE FOLDER VERSION
#
# writes FOLDER/libvides.a, libvides.so.VERSION and the two links to it.
# rustc's archive shows thousands of names and collides with any other Rust
# archive in the same program. Here it becomes one object that shows `v_*`
# only and, of the names that a host may define, calls none (system_names.c).
# Both libraries are made of that same object.
set -eu

archive=$1
folder=$2
version=$3
here=$(dirname "$0")
cc=${CC:-cc}
work=$folder/objects
mkdir -p "$work"

# Only what an exported function reaches stays. (readelf, since nm hands an
# object with LLVM's bitcode in it to a plugin, which may not know it.)
readelf -sW "$archive" |
    awk '$4 == "FUNC" && $5 == "GLOBAL" && $7 != "UND" && $8 ~ /^v_/ { print $8 }' |
    sort -u >"$work/exports"
if ! [ -s "$work/exports" ]; then
    echo "libraries.sh: $archive exports no function v_*" >&2
    exit 1
fi
# The folder's name may hold blanks; an exported name does not.
ld -r --gc-sections --force-group-allocation $(sed 's/^/-u /' "$work/exports") \
    -o "$work/rust.o" "$archive"

# ld leaves a name that nothing calls any more as a local one without a place,
# and objcopy would make a wish for it of that. (The first line is there because
# objcopy fails, without a word, on an empty list.)
{
    echo no_such_name
    readelf -sW "$work/rust.o" | awk '$5 == "LOCAL" && $7 == "UND" && $8 != "" { print $8 }'
} >"$work/uncalled"
objcopy --strip-symbols="$work/uncalled" -R .llvmbc -R .llvmcmd "$work/rust.o" "$work/reached.o"

# Names that it calls and that a host may define. A leading underscore is the
# system's by the standard, `pthread_` by every habit. A name that this
# machine's C library has not got is left alone: Rust's standard library asks
# for some newer ones and does without. `bcmp` (which the compiler calls where
# only equality counts) and the variable `environ` have a second name each,
# which no host defines.
readelf -sW "$work/reached.o" | awk '$5 != "LOCAL" && $7 == "UND" { print $8 }' |
    sort -u >"$work/called"
sed 's/#.*//' "$here/c89_names.txt" | tr -s ' ' '\n' | sort -u >"$work/reserved"
for name in libc.so.6 libm.so.6; do
    readelf --dyn-syms -W "$("$cc" -print-file-name=$name)"
done | awk '($4 == "FUNC" || $4 == "IFUNC") && $7 != "UND" { sub(/@.*/, "", $8); print $8 }' |
    sort -u >"$work/offered"
comm -23 "$work/called" "$work/reserved" | comm -12 - "$work/offered" |
    grep -Ev '^(_|pthread_|bcmp$)' >"$work/names" || true
{
    echo 'bcmp memcmp'
    echo 'environ __environ'
    sed 's/.*/& vides_&/' "$work/names"
} >"$work/renamed"
{
    printf '#define EACH_SYSTEM_NAME'
    sed 's/.*/ NAME(&)/' "$work/names" | tr -d '\n'
    echo
} >"$work/system_names.h"

objcopy --redefine-syms="$work/renamed" "$work/reached.o" "$work/renamed.o"
"$cc" -std=gnu99 -O2 -fPIC -fno-builtin -w -I"$work" \
    -DSYSTEM_NAMES='"system_names.h"' -c -o "$work/system_names.o" "$here/system_names.c"
ld -r --force-group-allocation -o "$work/joined.o" "$work/renamed.o" "$work/system_names.o"
objcopy --keep-global-symbols="$work/exports" --strip-debug \
    "$work/joined.o" "$work/libvides.o"

rm -f "$folder/libvides.a"
ar rcsD "$folder/libvides.a" "$work/libvides.o"

# Addresses to be filled in at the start take a thirtieth of the room where the
# C library knows the short form.
short=
if readelf -V "$("$cc" -print-file-name=libc.so.6)" | grep -q GLIBC_ABI_DT_RELR &&
    ld --help | grep -q pack-relative-relocs; then
    short=-Wl,-z,pack-relative-relocs
fi

# Never unloaded: Xt keeps pointers of ours. libgcc's unwinder goes inside, so
# that the C library is all it needs.
"$cc" -shared -o "$folder/libvides.so.$version" "$work/libvides.o" -static-libgcc \
    -Wl,-soname,libvides.so.1 -Wl,--version-script,"$here/libvides.map" \
    -Wl,-z,nodelete $short -Wl,-z,relro,-z,now -Wl,-z,defs -Wl,-Bsymbolic -Wl,--gc-sections -Wl,-s \
    -Wl,--as-needed -lm
ln -sf "libvides.so.$version" "$folder/libvides.so.1"
ln -sf libvides.so.1 "$folder/libvides.so"
