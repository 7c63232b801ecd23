#!/usr/bin/env bash
# What may not be read or written is exit code 4, "permission denied": never a bundle that is said to be invalid.
# What replaces a file may be read by those who could read that file.
. "$(dirname "$0")/scratch.sh"
# unprivileged COMMAND...: as a user whom permissions bind; root without what makes it root.
unprivileged() { if [ "$(id -u)" -eq 0 ]; then setpriv --bounding-set=-all --inh-caps=-all "$@"; else "$@"; fi; }
trap 'chmod -R u+rwX "$SCRATCH"' EXIT
mkdir closed && chmod 000 closed
! unprivileged ls closed > /dev/null 2>&1 || skip "no permission binds this user"
[ -z "$SANITIZE" ] || export ASAN_OPTIONS=detect_leaks=0  # it needs what was given up

# denied COMMAND...: exit code 4 and its reason, and nothing about the bundle.
denied() {
  local code=0
  unprivileged "$TEXBAKE" "$@" > said 2>&1 || code=$?
  cat said
  [ "$code" -eq 4 ] || fail "$*: exit code $code, expected 4"
  grep -qi 'permission' said || fail "$*: it does not say why"
  ! grep -q 'invalid\|bake the bundle' said || fail "$*: it blames the bundle"
}
echo '[[5, 5, 0.5]]' > clicks.json
echo '{"window": {}}' > camera.json
texbake render good.texbundle --size 8 -o frame.png > /dev/null
texbake info good.texbundle --recipe > recipe.json
for mode in 'good.texbundle/bundle.json' 'good.texbundle/fine-*.exr' 'good.texbundle'; do
  # shellcheck disable=SC2086  # the name of the payload is not known
  chmod 000 $mode
  denied verify good.texbundle
  denied info good.texbundle
  denied render good.texbundle --size 8
  denied report good.texbundle --quick
  denied export good.texbundle --web
  denied fragment good.texbundle
  denied fragment good.texbundle -o a.texbundle
  denied stack layered.texbundle good.texbundle -o s.texbundle
  denied heightmap good.texbundle clicks.json
  # shellcheck disable=SC2086
  chmod 755 $mode
done
for input in pebbles_height.png clicks.json camera.json frame.png recipe.json; do chmod 000 "$input"; done
denied bake pebbles_height.png
denied bake pebbles.png --map height=pebbles_height.png
denied bake recipe.json
denied heightmap good.texbundle clicks.json
denied verify good.texbundle --frame frame.png --camera camera.json
chmod 644 camera.json
denied verify good.texbundle --frame frame.png --camera camera.json
for input in pebbles_height.png clicks.json frame.png recipe.json; do chmod 644 "$input"; done
for folder in closed; do
  denied bake pebbles.png -o closed/a.texbundle
  denied render good.texbundle --size 8 -o closed/a.png
  denied report good.texbundle --quick -o closed/a.html
  denied export good.texbundle --web -o closed/web
  denied bake closed/pebbles.png
  denied verify closed/good.texbundle
done
denied bake pebbles.png -o closed/a.texbundle --if-changed

# A folder that may be written to and searched, but not read.
mkdir drop && chmod 300 drop
unprivileged "$TEXBAKE" bake pebbles.png -o drop/a.texbundle > /dev/null 2>&1 || fail "into a folder without read permission: $?"
unprivileged "$TEXBAKE" render drop/a.texbundle --size 8 -o drop/a.png > /dev/null 2>&1 || fail "a picture there: $?"
[[ $(unprivileged "$TEXBAKE" verify drop/a.texbundle) == *': valid' ]] || fail "the bundle there is not valid"
chmod 300 drop/a.texbundle
unprivileged "$TEXBAKE" fragment drop/a.texbundle > /dev/null 2>&1 || fail "in a bundle without read permission: $?"
chmod 700 drop drop/a.texbundle
[[ $(texbake verify drop/a.texbundle) == *': valid' ]] || fail "the bundle there is no longer valid"

# The mode of what is replaced.
mode() { stat -c %a "$1"; }
umask 022
texbake render good.texbundle --size 8 -o a.png > /dev/null
[ "$(mode a.png)" = 644 ] || fail "a new picture has mode $(mode a.png)"
for mode in 640 600 664; do
  chmod $mode a.png
  texbake render good.texbundle --size 16 -o a.png > /dev/null
  [ "$(mode a.png)" = $mode ] || fail "a picture of mode $mode became $(mode a.png)"
  chmod $mode good.texbundle/*
  texbake fragment good.texbundle --threshold ${mode:1:1}5 -q > /dev/null
  for file in good.texbundle/*; do [ "$(mode "$file")" = $mode ] || fail "$file of mode $mode became $(mode "$file")"; done
done
