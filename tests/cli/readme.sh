#!/usr/bin/env bash
# The commands of the README, in a folder with the files that they name: they succeed, and the files that a person owns
# stay as they are.
. "$(dirname "$0")/scratch.sh"
[ -z "$SANITIZE" ] || skip "run in the release build only: the cases run the same code with sanitizers"
mkdir own && cd own
# What the commands name, photographs under every name that a bundle's picture might be given.
for name in leaves rock moss wall bricks; do
  cp ../pebbles.png $name.png
  oiiotool $name.png -o $name.jpg
done
for map in normal height roughness; do cp ../pebbles_$map.png rock_$map.png; done
for name in bricks cliff wood cracks far mid near; do cp -r ../good.texbundle $name.texbundle; done
for name in cliff wood far; do texbake bake ../bricks.png -q -o $name.texbundle > /dev/null; done
echo '[[5, 5, 0.5], [60, 40, 0.1], [30, 20, 0.3]]' > clicks.json
oiiotool --create 128x128 1 --box:color=0.25:fill=1 10,10,12,12 -d uint16 -o strokes.png
echo '{"window": {}}' > capture.json
texbake render bricks.texbundle --size 64 -o capture.png -q > /dev/null
sha256sum ./*.png ./*.jpg ./*.json > ../own.sums

# run_all: each line of stdin.
run_all() {
  local line code
  while read -r line; do
    code=0
    eval "$line" > ../said 2>&1 || code=$?
    # A verdict on what these pictures are worth, or on a frame, is an answer; OpenGL need not be here.
    case "$code $line" in
      0\ *) ;;
      1\ "texbake report "* | 1\ "texbake verify "*) ;;
      5\ *"--backend gl"*) ;;
      *) cat ../said; fail "exit code $code: $line" ;;
    esac
    sha256sum --check --quiet ../own.sums || fail "a file that a person owns is no longer as it was after: $line"
  done
}
sed -n '/^```/,/^```/p' "$SOURCE/README.md" | grep '^texbake ' > ../readme
[ "$(wc -l < ../readme)" -ge 15 ] || fail "the README has lost its commands"
run_all < ../readme
echo "$(wc -l < ../readme) commands of the README"
sha256sum ./*.png ./*.jpg ./*.json | grep -vF -f <(cut -d' ' -f3 ../own.sums) > ../made || fail "the README makes no pictures"
