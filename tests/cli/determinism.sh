#!/usr/bin/env bash
# The same bytes for any number of threads, twice in a row, with another compiler, and on processors without the newer
# instructions.
. "$(dirname "$0")/scratch.sh"

make() { # make NAME [COMMAND...]: a bundle and a picture with `COMMAND... texbake`
  local name=$1
  shift
  mkdir "$name"
  "$@" "${PROGRAM:-$TEXBAKE}" bake pebbles.png --map normal=pebbles_normal.png --map height=pebbles_height.png \
    -o "$name/a.texbundle" $FLAGS
  "$@" "${PROGRAM:-$TEXBAKE}" bake leaves.png -o "$name/b.texbundle" $FLAGS
  "$@" "${PROGRAM:-$TEXBAKE}" bake pebbles.png --layers structure+noise -o "$name/c.texbundle" $FLAGS
  "$@" "${PROGRAM:-$TEXBAKE}" heightmap "$name/b.texbundle" clicks.json $FLAGS
  "$@" "${PROGRAM:-$TEXBAKE}" heightmap "$name/c.texbundle" clicks.json --descriptor gradients $FLAGS
  "$@" "${PROGRAM:-$TEXBAKE}" render "$name/c.texbundle" -o "$name/c.exr" --size 200x100 --bits float --rotate 20 $FLAGS
  "$@" "${PROGRAM:-$TEXBAKE}" render "$name/a.texbundle" -o "$name/a.png" --size 300x200 --origin -70,9 --step 0.7 $FLAGS
  "$@" "${PROGRAM:-$TEXBAKE}" render "$name/b.texbundle" -o "$name/b.exr" --size 300x200 --bits float $FLAGS
}

echo '[[5, 5, 0.5], [60, 40, 0.1], [30, 20, 0.3], [17, 50, 0.9]]' > clicks.json
FLAGS="" make reference

if [ -n "$SANITIZE" ]; then
  # Sanitizers look at what the code does, which is the same on every processor; they take their time.
  FLAGS="--threads 1" make one_thread
  same reference one_thread
  echo "other threads, processors and compilers are compared by the build without sanitizers" >&2
  exit 0
fi

FLAGS="" make again
same reference again
for threads in 1 2 8; do
  FLAGS="--threads $threads" make "threads_$threads"
  same reference "threads_$threads"
done

FLAGS="" make no_avx env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX,-AVX512F,-ERMS,-SSE4_2 \
  OPENCV_CPU_DISABLE=AVX2,FMA3,AVX,SSE4_2
same reference no_avx

other=$SOURCE/build/clang/cli/texbake
if [ -x "$other" ]; then
  FLAGS="" PROGRAM=$other make other_compiler
  same reference other_compiler
else
  skip "$other is not there, so that its bytes are not compared; the rest agreed"
fi
