#!/usr/bin/env bash
# Every test in one command on a bare Debian 12: installs what is missing, builds for release and for debugging with
# address and undefined-behavior sanitizers, runs the tests of both. The last line is the sum: N passed, M failed, K skipped.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root" || exit

cmake/install-packages.sh build test || echo "tests/run.sh: packages could not be installed; going on with what is there" >&2

cmake/install-packages.sh browser || echo "tests/run.sh: no browser could be installed; its test will be skipped" >&2
command -v npm >/dev/null || cmake/install-packages.sh node || echo "tests/run.sh: no npm could be installed" >&2

options=(-DCMAKE_UNITY_BUILD=ON)  # from nothing, a third of the time: see cmake/targets.cmake
command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1  # what another checkout compiled serves as well

passed=0 failed=0 skipped=0

# count JUNIT_FILE: adds one run of ctest to the sums.
count() {
  local tests bad skip
  attribute() { tr '\n\t' '  ' < "$1" | grep -o '<testsuite [^>]*' | grep -o " $2=\"[0-9]*\"" | head -1 | tr -cd '0-9'; }
  tests=$(attribute "$1" tests) bad=$(attribute "$1" failures) skip=$(($(attribute "$1" skipped) + $(attribute "$1" disabled)))
  passed=$((passed + tests - bad - skip)) failed=$((failed + bad)) skipped=$((skipped + skip))
}

# run PRESET: builds and tests it.
run() {
  echo "== $1" >&2
  if cmake --preset "$1" "${options[@]}" >&2 && cmake --build --preset "$1" >&2; then
    ctest --preset "$1" -j "$(nproc)" --output-junit "$root/build/$1/tests.xml" >&2
    count "$root/build/$1/tests.xml"
  else
    echo "tests/run.sh: the build of preset $1 failed" >&2
    failed=$((failed + 1))
  fi
}

# Another compiler must bake the same bytes: its program is compared by tests/cli/determinism.sh.
if command -v clang++ >/dev/null; then
  echo "== clang" >&2
  if ! cmake --preset clang -DTEXBAKE_TESTS=OFF -DTEXBAKE_BENCH=OFF "${options[@]}" >&2 ||
    ! cmake --build --preset clang --target texbake >&2; then
    echo "tests/run.sh: the build with clang++ failed" >&2
    failed=1
  fi
else
  echo "SKIPPED: no clang++ here, so that its bytes are not compared with those of g++" >&2
  skipped=1
fi

run release
run debug

echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
