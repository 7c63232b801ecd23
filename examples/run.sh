#!/usr/bin/env bash
# Everything in one command on a bare Debian 12: installs what is missing, builds, draws exemplars, bakes them and
# renders a large window of the endless texture. The times that it tells are those of two cores.
#
#   examples/run.sh [FOLDER]     pictures go to FOLDER, build/examples when none is given
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
out=${1:-$root/build/examples}

# step TIME WHAT...: says what happens next and about how long it takes.
step() {
  local time=$1
  shift
  printf '\n== %s (about %s)\n' "$*" "$time" >&2
}

step "3 minutes, seconds when they are there" "1 of 7: installing what is needed to build"
"$root/cmake/install-packages.sh" build

step "5 minutes, seconds when it was built before" "2 of 7: building texbake"
options=(-DTEXBAKE_TESTS=OFF -DTEXBAKE_BENCH=OFF -DCMAKE_UNITY_BUILD=ON)
command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S "$root" --preset release -B "$root/build/release-tools" "${options[@]}" >&2
cmake --build "$root/build/release-tools" >&2
texbake=$root/build/release-tools/cli/texbake

mkdir -p "$out"
cd "$out"
out=$PWD
"$root/build/release-tools/examples/draw_exemplars" .

# A whole material: the maps travel with the color and share its remap.
step "10 seconds" "3 of 7: pebbles, a material of color, normals, heights and roughness"
"$texbake" bake pebbles.png --map normal=pebbles_normal.png --map height=pebbles_height.png \
  --map roughness=pebbles_roughness.png -o pebbles.texbundle
"$texbake" render pebbles.texbundle -o pebbles_4096.png --size 4096x4096
"$texbake" render pebbles.texbundle -o pebbles_normal_2048.png --size 2048x2048 --map normal
"$texbake" render pebbles.texbundle -o pebbles_patches_2048.png --size 2048x2048 --show patches
echo "The first picture of an endless texture: $out/pebbles_4096.png" >&2

# A picture that does not tile: bake closes it first.
step "10 seconds" "4 of 7: leaves, a picture that does not tile"
"$texbake" bake leaves.png -o leaves.texbundle
"$texbake" render leaves.texbundle -o leaves_4096.png --size 4096x4096

# Bricks keep their bond: contents move along the wall's own lattice.
step "10 seconds" "5 of 7: bricks, whose contents move along the lattice of the wall"
"$texbake" bake bricks.png --select-contents-lattice auto -o bricks.texbundle
"$texbake" render bricks.texbundle -o bricks_4096.png --size 4096x4096

# Two layers. As Guingo et al. 2017, Fig. 9: contents exchanged in one layer; exchanged, turned and shrunk beneath grain
# that is made anew. Fig. 10: the same deformation of one layer, whose grain it spoils, and of two.
step "1 minute" "6 of 7: lichen in one layer, and as structure and noise"
"$texbake" bake lichen.png -o lichen_1.texbundle
"$texbake" bake lichen.png --layers structure+noise --decompose-noises 2 --select-contents-scales 3 -o lichen_2.texbundle
for layers in 1 2; do
  "$texbake" render lichen_$layers.texbundle -o lichen_exchange_$layers.png --size 2048x2048
  "$texbake" render lichen_$layers.texbundle -o lichen_deformed_$layers.png --size 1024x1024 \
    --rotate 20 --stretch 3,1.5 --turbulence 16
done

step "30 seconds" "7 of 7: checking every bundle and writing a report of it"
for bundle in *.texbundle; do
  "$texbake" verify "$bundle"
  "$texbake" report "$bundle" --quick -o "${bundle%.texbundle}_report.html"
done

cat <<END

Everything is in $out:
$(ls -1)

Where to look first:
  pebbles_4096.png        an endless texture, much larger than its exemplar pebbles.png
  *_report.html           open one in a browser: what was baked, pictures of it, and a verdict

To bake a photograph of your own: $texbake bake PHOTO -o NAME.texbundle
END
