#!/usr/bin/env bash
# The verbs one by one, a recipe, and bake write the same bytes; bake again only where something has changed.
. "$(dirname "$0")/scratch.sh"
maps=(--map normal=pebbles_normal.png --map height=pebbles_height.png --map roughness=pebbles_roughness.png)

texbake convert pebbles.png "${maps[@]}" -o single.texbundle
texbake fragment single.texbundle
texbake patch single.texbundle --count 6
texbake select-contents single.texbundle
same single.texbundle good.texbundle

texbake convert pebbles.png -o layers.texbundle
texbake decompose layers.texbundle --noises 2
texbake estimate-psd layers.texbundle
texbake fragment layers.texbundle
texbake patch layers.texbundle --count 6
texbake select-contents layers.texbundle
same layers.texbundle layered.texbundle

# A decomposition that runs again arrives at the same bundle, and undoes what the first made of the palette.
texbake decompose layers.texbundle --noises 1 --local-size 2
texbake bake pebbles.png --layers structure+noise --decompose-noises 2 --patch-count 6 -o direct.texbundle
texbake decompose layers.texbundle --noises 2
texbake estimate-psd layers.texbundle
texbake fragment layers.texbundle
texbake patch layers.texbundle --count 6
texbake select-contents layers.texbundle
same layers.texbundle direct.texbundle
texbake info layered.texbundle --recipe > layered.json
texbake bake layered.json -o recipe.texbundle
same recipe.texbundle layered.texbundle

# Into other bundles instead of in place.
texbake convert pebbles.png "${maps[@]}" -o a.texbundle
texbake fragment a.texbundle -o b.texbundle
texbake patch b.texbundle -o c.texbundle --count 6
texbake select-contents c.texbundle -o d.texbundle
same d.texbundle good.texbundle

# A stage that runs again forgets what was made from it, and the chain arrives at the same bundle.
texbake fragment d.texbundle --threshold 30
[ "$(texbake info d.texbundle | grep -c '^stage')" -eq 2 ] || fail "stale stages were kept"
! texbake info d.texbundle | grep -q contents || fail "stale contents were kept"
texbake verify d.texbundle
texbake fragment d.texbundle
texbake patch d.texbundle --count 6
texbake select-contents d.texbundle
same d.texbundle good.texbundle

# A recipe holds everything that decided the bundle; flags change what it says.
texbake info good.texbundle --recipe > good.json
texbake bake good.json -o again.texbundle
same again.texbundle good.texbundle
texbake bake good.json -o other.texbundle --patch-count 5
texbake info other.texbundle | grep -q 'count = 5' || fail "the flag did not change the recipe"

# --if-changed looks at files, options and the bundle itself.
stamp() { stat -c '%y %i' "$1"/*.json | sort; }
unchanged() { before=$(stamp good.texbundle); texbake bake "$@" -o good.texbundle --if-changed; [ "$before" = "$(stamp good.texbundle)" ]; }
unchanged good.json || fail "baked again though nothing had changed"
unchanged pebbles.png "${maps[@]}" --patch-count 6 || fail "baked again though nothing had changed"
! unchanged pebbles.png "${maps[@]}" --patch-count 5 || fail "kept though an option had changed"
! unchanged pebbles.png --patch-count 5 || fail "kept though maps were gone"
cp bricks.png pebbles.png
! unchanged pebbles.png --patch-count 5 || fail "kept though the picture had changed"
truncate -s 5000 good.texbundle/*.exr
! unchanged pebbles.png --patch-count 5 || fail "kept though the bundle was damaged"
texbake verify good.texbundle

# Pictures: the same window, whole or in two halves, and another seed is another texture of the same patches.
texbake render good.texbundle -o whole.png --size 200x100 --origin -50,30
texbake render good.texbundle -o left.png --size 100x100 --origin -50,30
texbake render good.texbundle -o right.png --size 100x100 --origin 50,30
oiiotool left.png right.png --mosaic 2x1 -o halves.png
oiiotool whole.png halves.png --fail 0 --warn 0 --diff > /dev/null || fail "a window is not the sum of its halves"
texbake render good.texbundle -o seed.png --size 200x100 --origin -50,30 --seed 5
! oiiotool whole.png seed.png --diff > /dev/null || fail "another seed gave the same texture"
texbake render good.texbundle -o p0.png --size 200x100 --show patches
texbake render good.texbundle -o p5.png --size 200x100 --show patches --seed 5
cmp p0.png p5.png || fail "another seed changed the patches"
