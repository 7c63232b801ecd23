#!/usr/bin/env bash
# Includes go down, never up, sideways or in circles; each third-party library appears in few, named sources.
. "$(dirname "$0")/scratch.sh"
cd "$SOURCE"
bad=0
complain() { echo "$*" >&2; bad=1; }

# Which folders a folder may include from, besides itself: what its target links.
declare -A below=(
  [libbake/base]=""
  [libbake/color]="libbake/base"
  [libbake/tile]="libbake/base libbake/color"
  [libbake/segment]="libbake/base libbake/color"
  [libbake/content]="libbake/base libbake/color libbake/segment"
  [libbake/noise]="libbake/base libbake/color"
  [libbake/height]="libbake/base libbake/color"
  [libbake/quality]="libbake/base libbake/color"
  [libbake/reference]="libbake/base shaders"
  [libbake/planes]="libbake/base libbake/color libbake/segment libbake/content libbake/reference"
  [libbake/draw]="libbake/base libbake/color libbake/planes libbake/reference"
  [libbake/gl]="libbake/base libbake/planes libbake/reference libbake/draw shaders"
  [libbake/report]="libbake/base libbake/color libbake/tile libbake/segment libbake/content libbake/quality
    libbake/planes libbake/draw"
  [formats]="libbake/base libbake/color libbake/segment libbake/content libbake/noise libbake/height libbake/planes
    libbake/reference"
  [bake]="formats libbake"
  [pages]="formats libbake shaders"
  [cli]="bake pages formats libbake"
  [examples]="bake formats libbake"
)
while IFS=: read -r file include; do
  folder=$(dirname "$file")
  [[ $folder == examples/* ]] && folder=examples
  [[ -v below[$folder] ]] || { complain "$folder is not in the list of layers"; continue; }
  below_it=0
  for prefix in "$folder" ${below[$folder]}; do [[ $include == "$prefix"/* ]] && below_it=1; done
  [ $below_it -eq 1 ] || complain "$file includes $include, which is not below $folder"
done < <(grep -rHoE '^#include "[^"]+"' --include=*.h --include=*.cpp libbake formats bake pages cli examples |
  sed -E 's/#include "([^"]+)"/\1/')

# Inside a folder too, a pair of .h and .cpp is above or below another, never both: tsort names the pairs of a cycle.
for folder in "${!below[@]}"; do
  [ "$folder" = examples ] && folder=examples/draw
  cycle=$(cd "$folder" && grep -HoE "^#include \"$folder/[^\"]+\"" -- *.h *.cpp 2>/dev/null |
    sed -E "s|\.(h\|cpp):#include \"$folder/| |; s|\.h\"\$||" | awk '$1 != $2' | tsort 2>&1 >/dev/null) || true
  [ -z "$cycle" ] || complain "$folder: files include each other in a circle: $(sed -n 's/^tsort: //p' <<<"$cycle" | tr '\n' ' ')"
done

# only HEADER FILE...: the sources that may include it.
only() {
  local pattern=$1 file
  shift
  while read -r file; do
    [[ " $* " == *" $file "* ]] || complain "$file includes <$pattern>; allowed: $*"
  done < <(grep -rlE "#include <($pattern)" --include=*.h --include=*.cpp libbake formats bake pages cli examples)
}
only 'OpenImageIO/' formats/picture_input.h formats/image_writer.cpp formats/picture_bytes.cpp
only 'OpenEXR/' formats/exr_planes.cpp
only 'lcms2' formats/icc_profile.cpp
only 'openssl/' formats/base64.cpp formats/sha256.cpp
only 'zlib.h' formats/png_check.cpp
only 'opencv2/' libbake/base/fft.cpp libbake/report/sheet.cpp
only 'ceres/' libbake/noise/lobes.cpp
only 'flann/' libbake/height/nearest_clicks.cpp libbake/quality/structure_distance.cpp
only 'tbb/' libbake/base/parallel.h formats/exr_planes.cpp cli/resource_limits.cpp
only 'EGL/|GL/|GLES' libbake/gl/gl_functions.h libbake/gl/gl_context.cpp
only 'CLI/' cli/parser.cpp
only 'nlohmann/' formats/bundle.h formats/issues.h

# libbake never prints, never touches files, never exits.
while read -r line; do complain "$line: libbake must not"; done < <(
  grep -rnE '\b(std::cout|std::cerr|fmt::print|std::exit|std::abort|printf|fprintf)\b|#include <(fstream|iostream|cstdio|filesystem)>' \
    --include=*.h --include=*.cpp libbake)

[ $bad -eq 0 ]
