#!/usr/bin/env bash
# Everything in one command on a bare Debian 12: installs what is missing, builds, draws exemplars, bakes them and
# renders a large window of the endless texture.
#
#   examples/run.sh [FOLDER]     pictures go to FOLDER, build/examples when none is given
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
out=${1:-$root/build/examples}

"$root/cmake/install-packages.sh" build

compiler_cache=()
command -v ccache >/dev/null && compiler_cache=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S "$root" --preset release -DTEXBAKE_TESTS=OFF -DTEXBAKE_BENCH=OFF -B "$root/build/release-tools" \
  "${compiler_cache[@]}" >&2
cmake --build "$root/build/release-tools" >&2
texbake=$root/build/release-tools/cli/texbake

mkdir -p "$out"
cd "$out"
"$root/build/release-tools/examples/draw_exemplars" .

# A whole material: the maps travel with the colour and share its remap.
"$texbake" bake pebbles.png --map normal=pebbles_normal.png --map height=pebbles_height.png \
  --map roughness=pebbles_roughness.png -o pebbles.texbundle
"$texbake" render pebbles.texbundle -o pebbles_4096.png --size 4096x4096
"$texbake" render pebbles.texbundle -o pebbles_normal_2048.png --size 2048x2048 --map normal
"$texbake" render pebbles.texbundle -o pebbles_patches_2048.png --size 2048x2048 --show patches

# A picture that does not tile: bake closes it first.
"$texbake" bake leaves.png -o leaves.texbundle
"$texbake" render leaves.texbundle -o leaves_4096.png --size 4096x4096

# Bricks keep their bond: contents move along the wall's own lattice.
"$texbake" bake bricks.png --select-contents-lattice auto -o bricks.texbundle
"$texbake" render bricks.texbundle -o bricks_4096.png --size 4096x4096

# Two layers. As Guingo et al. 2017, Fig. 9: contents exchanged in one layer; exchanged, turned and shrunk beneath grain
# that is made anew. Fig. 10: the same deformation of one layer, whose grain it spoils, and of two.
"$texbake" bake lichen.png -o lichen_1.texbundle
"$texbake" bake lichen.png --layers structure+noise --decompose-noises 2 --select-contents-scales 3 -o lichen_2.texbundle
for layers in 1 2; do
  "$texbake" render lichen_$layers.texbundle -o lichen_exchange_$layers.png --size 2048x2048
  "$texbake" render lichen_$layers.texbundle -o lichen_deformed_$layers.png --size 1024x1024 \
    --rotate 20 --stretch 3,1.5 --turbulence 16
done

for bundle in *.texbundle; do
  "$texbake" verify "$bundle"
  "$texbake" report "$bundle" --quick -o "${bundle%.texbundle}_report.html"
done
echo
echo "The exemplars, the bundles, the pictures of the endless textures and the reports (.html) are in $out:"
ls -1 "$out"
