#!/usr/bin/env bash
# A bake is the same everywhere: in another folder, language, time zone, year, home, with another umask, number of
# processors, order of files and environment. What Debian's reprotest varies, without its containers.
. "$(dirname "$0")/scratch.sh"

bake() { # bake FOLDER COMMAND...: the same two bundles and a picture in FOLDER/out
  local folder=$1
  shift
  mkdir -p "$folder/out"
  (
    cd "$folder"
    "$@" "$TEXBAKE" bake leaves.png --map normal=pebbles_normal.png -o out/a.texbundle -q
    "$@" "$TEXBAKE" bake pebbles.png --layers structure+noise -o out/b.texbundle -q
    "$@" "$TEXBAKE" render out/a.texbundle -o out/a.png --size 96 -q
  ) > /dev/null
}
sources=(leaves.png pebbles.png pebbles_normal.png)
mkdir one && cp "${sources[@]}" one
bake one env

# Another path, with spaces and letters beyond ASCII; files that were made in another order, and long ago.
other="$PWD/two/Übung mit Leerzeichen"
mkdir -p "$other"
for ((i = ${#sources[@]} - 1; i >= 0; --i)); do cp "${sources[i]}" "$other"; done
touch -d '2001-02-03 04:05:06' "$other"/*
locale=$(locale -a 2> /dev/null | grep -iE '^(tr_TR|de_DE|fr_FR)' | head -1 || true)
processor=$(taskset -cp $$ | sed -E 's/.*: ([0-9]+).*/\1/')
elsewhere=(env -i PATH="$PATH" HOME=/nonexistent TMPDIR="$PWD" LANG="${locale:-C.UTF-8}" LC_ALL="${locale:-C.UTF-8}"
  TZ=Pacific/Kiritimati SOURCE_DATE_EPOCH=1 USER=somebody COLUMNS=40 taskset -c "$processor")
if command -v faketime > /dev/null; then elsewhere+=(faketime '2037-01-01 00:00:00'); fi
umask 0077
bake "$other" "${elsewhere[@]}" 2> said || { cat said; fail "it does not bake elsewhere"; }
umask 0022
same one/out "$other/out"
