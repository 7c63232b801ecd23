#!/bin/bash
# The reference text gives the GPU's bits with each compiler at each level of optimization; and the comparison turns red
# when the text, the words of glsl.h or the floating-point contract are bent.
# usage: parity_matrix.sh SOURCE_DIR PARITY_POINTS_GL WORK_DIR
set -u
source=$1 points_gl=$2 work=$3
rm -rf "$work" && mkdir -p "$work" || exit 4
"$points_gl" "$work/core" "$work/es"
status=$?
[ $status -eq 77 ] && { echo "SKIPPED: no OpenGL"; exit 77; }
[ $status -eq 0 ] || exit 1

failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# build NAME COMPILER FLAGS...: compiles parity_points_cpu.cpp; a copy of changed files under WORK_DIR/NAME wins.
build() {
  local name=$1 compiler=$2
  shift 2
  "$compiler" -std=c++20 "$@" -I"$work/$name" -I"$source" -o "$work/$name.program" \
    "$source/tests/libbake/gl/parity_points_cpu.cpp"
}

for compiler in g++ clang++; do
  command -v $compiler > /dev/null || { echo "$compiler: not installed, left out"; continue; }
  for level in "-O0" "-O2" "-O3 -march=native"; do
    name=$compiler$(echo "$level" | tr -d ' =')
    build "$name" $compiler -ffp-contract=off $level || { fail "$name does not compile"; continue; }
    for driver in core es; do
      echo "$compiler $level, $driver: $("$work/$name.program" "$work/$driver")"
      "$work/$name.program" "$work/$driver" > /dev/null || fail "$compiler $level differs from $driver"
    done
  done
done

# expect_red NAME: the comparison must see a difference.
expect_red() {
  local seen
  seen=$("$work/$1.program" "$work/core")
  if [ $? -eq 1 ]; then echo "red as it should be: $1: $seen"; else fail "$1 is not seen: $seen"; fi
}

first=$(command -v g++ || command -v clang++)
if grep -qw fma /proc/cpuinfo; then
  build fused "$first" -O3 -march=native -ffp-contract=fast && expect_red fused
else
  echo "fused multiply-add: this processor has none, left out"
fi

# bend NAME FILE PATTERN REPLACEMENT: one word changed in one file.
bend() {
  local name=$1 file=$2 pattern=$3 replacement=$4
  mkdir -p "$work/$name/$(dirname "$file")"
  sed "s/$pattern/$replacement/" "$source/$file" > "$work/$name/$file"
  cmp -s "$source/$file" "$work/$name/$file" && { fail "$name: nothing to bend in $file"; return; }
  build "$name" "$first" -O1 -ffp-contract=off && expect_red "$name" || fail "$name"
}
bend hash-multiplier shaders/hash.glsl 747796405u 747796407u
bend hash-shift shaders/hash.glsl '>> 22u' '>> 21u'
bend draw-shift shaders/content.glsl 'content_count) >> 16u' 'content_count) >> 17u'
bend owner-mask shaders/content.glsl 'bits \& 3u' 'bits \& 1u'
bend content-rounding shaders/content.glsl '+ 128) >> 8' '+ 127) >> 8'
bend normal-eighth shaders/sample.glsl 0.70710678f 0.70710671f
bend pixel-center shaders/sample.glsl '(pixel_256 >> 1u)' '(pixel_256 >> 2u)'
bend word-conversion libbake/reference/glsl.h 'x(static_cast<uint>(v.x))' 'x(static_cast<uint>(v.x < 0 ? -v.x : v.x))'
bend word-subtraction libbake/reference/glsl.h 'a.y - b.y, a.z - b.z' 'a.y - b.y, a.z + b.z'
bend word-fetch libbake/reference/glsl.h 'static_cast<size_t>(p.x)\]' 'static_cast<size_t>(p.x ^ 1)]'

rm -rf "$work"
[ $failures -eq 0 ] || { echo "$failures failed"; exit 1; }
