#!/usr/bin/env bash
# File names are bytes. Those that are not UTF-8 are read and written, come back from a bundle and its recipe, and
# stand in JSON as text.
. "$(dirname "$0")/scratch.sh"
export LC_ALL=C
python=$(command -v python3) || skip "no python3 here, to check JSON with"
# text BYTES: as they stand in JSON.
text() { printf '%s' "$1" | "$python" -c 'import sys
print("".join(chr(0xEF00 + ord(c) - 0xDC00) if 0xDC80 <= ord(c) <= 0xDCFF else c
  for c in sys.stdin.buffer.read().decode("utf-8", "surrogateescape")))'; }
# member EXPRESSION: of the JSON at stdin, which is checked to be UTF-8.
member() { PYTHONIOENCODING=utf-8 "$python" -c 'import json, sys
print(eval("j" + sys.argv[1], {"j": json.loads(sys.stdin.buffer.read().decode("utf-8"))}))' "$1"; }

oiiotool pebbles.png --resize 64x64 -o small.png
for name in $'bl\xe4tter' $'\xed\xa0\x80 \xff' $'"\xee\xbe\x80\ttab'; do
  cp small.png "$name.png" || { echo "no such names here: $name"; continue; }
  said=$(texbake bake "$name.png" -o "$name.texbundle" --json) || fail "$name: bake ended with $?"
  [ "$(member '["exitCode"]' <<< "$said")" = 0 ] || fail "$name: no JSON: $said"
  [ "$(text "$name.texbundle")" = "$(member '["result"]["output"]' <<< "$said")" ] || [[ $name == *$'\xee'* ]] ||
    fail "$name: another output: $said"
  [[ $(texbake bake "$name.png" -o "$name.texbundle" --if-changed 2>&1) == *'is up to date'* ]] || fail "$name: baked again"
  [[ $(texbake verify "$name.texbundle") == *': valid' ]] || fail "$name: not valid"
  [[ $(texbake info "$name.texbundle") == *"source color: $name.png,"* ]] || fail "$name: another name in info"
  texbake info "$name.texbundle" --json | member '["result"]["sources"][0]["name"]' > /dev/null
  texbake info "$name.texbundle" --recipe > recipe.json
  texbake bake recipe.json -o again.texbundle > /dev/null || fail "$name: its recipe does not find it"
  same "$name.texbundle" again.texbundle
  texbake render "$name.texbundle" --size 8 --json | member '["result"]["output"]' > /dev/null
  [ -s "${name}_render.png" ] || fail "$name: no picture"
  texbake report "$name.texbundle" --quick --tiles 2 -o "$name.html" --json | member '["result"]["page"]' > /dev/null
  iconv -f utf-8 -t utf-8 "$name.html" > /dev/null || fail "$name: its report is not UTF-8"
  ! texbake render "$name.texbundle" -o "$name.png" --size 8 2> /dev/null || fail "$name: replaced the photograph"
  rm -rf again.texbundle
done

# Mistakes with such bytes are JSON too.
failure() { # failure CODE ARGUMENT...
  local expected=$1 code=0
  shift
  texbake "$@" --json > said 2> /dev/null || code=$?
  [ "$code" -eq "$expected" ] || fail "$*: exit code $code, expected $expected"
  [ "$(member '["exitCode"]' < said)" = "$expected" ] || fail "$*: no JSON"
}
failure 2 $'bak\xe4'
failure 2 bake pebbles.png $'--classe\xff'
failure 2 bake pebbles.png --classes $'\xff'
failure 4 bake $'none\xff.png'
printf '{"asset": "\xff"}' > broken.json
failure 3 bake broken.json
sed -i $'s/"color"/"col\xffor"/' good.texbundle/bundle.json
failure 3 info good.texbundle
failure 1 verify good.texbundle
printf '{"clicks": [["\xff", 1, 1]]}' > clicks.json
texbake bake pebbles.png -o a.texbundle 2> /dev/null > said
failure 3 heightmap a.texbundle clicks.json
