#!/usr/bin/env bash
# clang-tidy finds nothing, by .clang-tidy: tidy.sh [FILES...]. Without FILES, every source of the lowest library
# folders, without the slow analyzer: those folders' headers are in every other source. Run by hand with other FILES
# (needs SOURCE, SCRATCH, EXEMPLARS and SANITIZE set as CMakeLists.txt sets them), the analyzer runs too.
. "$(dirname "$0")/scratch.sh"
[ -z "$SANITIZE" ] || skip "checked in the release build only"
command -v clang-tidy > /dev/null || skip "no clang-tidy here (Debian: clang-tidy)"

# Each file by itself, so that what one forgets to include is found as well.
cmake -G Ninja -S "$SOURCE" -B build -DCMAKE_UNITY_BUILD=OFF -DTEXBAKE_TESTS=OFF -DTEXBAKE_BENCH=OFF > cmake.txt 2>&1 ||
  fail "$(tail -5 cmake.txt)"
cd "$SOURCE"
checks=()
files=("$@")
if [ ${#files[@]} -eq 0 ]; then
  checks=(--checks=-clang-analyzer-*)
  files=(libbake/base/*.cpp libbake/segment/*.cpp)
fi
printf '%s\n' "${files[@]}" | xargs -P 2 -n 4 clang-tidy --quiet -p "$SCRATCH/build" --warnings-as-errors='*' "${checks[@]}" \
  2> "$SCRATCH/errors.txt" || { tail -5 "$SCRATCH/errors.txt" >&2; fail "clang-tidy finds mistakes, see above"; }
