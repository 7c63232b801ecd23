#!/usr/bin/env bash
# Draws the exemplars and bakes the bundles that the other scripts copy: make_exemplars.sh FOLDER
set -euo pipefail
rm -rf "$1" && mkdir -p "$1" && cd "$1"
"$DRAW" . 128
"$TEXBAKE" bake pebbles.png --map normal=pebbles_normal.png --map height=pebbles_height.png \
  --map roughness=pebbles_roughness.png --patch-count 6 -o good.texbundle
"$TEXBAKE" bake pebbles.png --layers structure+noise --decompose-noises 2 --patch-count 6 -o layered.texbundle
