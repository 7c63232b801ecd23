#!/usr/bin/env bash
# Fuzzes for a long time with libFuzzer, address and undefined-behavior sanitizers, and tells how much of formats/ was
# reached. Inputs that crash, hang or take too much memory stay in build/fuzz/found.
#   tests/fuzz/run.sh [SECONDS_PER_TARGET [TARGET...]]    an hour for each of all targets
# Needs clang, its libraries (Debian: libclang-rt-14-dev) and its tools (llvm-14).
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-3600}
shift || true
targets=("$@")
[ $# -gt 0 ] || targets=(manifest bundle clicks recipe camera picture)
build=build/fuzz
version=$(clang --version | sed -nE '1s/.*version ([0-9]+).*/\1/p')

# With -fprofile-instr-generate the programs that libFuzzer runs would be slower; fuzz_smoke of another folder counts.
configure() { # configure FOLDER SANITIZERS CXX_FLAGS
  cmake -S . -B "$1" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_UNITY_BUILD=ON \
    -DCMAKE_CXX_FLAGS_DEBUG="$3" -DTEXBAKE_BENCH=OFF -DTEXBAKE_SANITIZE="$2" -DTEXBAKE_FUZZ=ON \
    ${CMAKE_CXX_COMPILER_LAUNCHER:+-DCMAKE_CXX_COMPILER_LAUNCHER="$CMAKE_CXX_COMPILER_LAUNCHER"}
}
configure $build fuzzer-no-link,address,undefined "-O1 -g1"
cmake --build $build --target fuzz_smoke $(printf 'fuzz_%s ' "${targets[@]}")
configure $build/coverage "" "-O1 -g1 -fprofile-instr-generate -fcoverage-mapping"
cmake --build $build/coverage --target fuzz_smoke

mkdir -p $build/found $build/profiles
rm -f $build/profiles/*
for name in "${targets[@]}"; do
  corpus=$build/corpus/$name
  mkdir -p "$corpus"
  [ -n "$(ls -A "$corpus")" ] || ASAN_OPTIONS=detect_leaks=0 $build/tests/fuzz/fuzz_smoke "$name" --seeds "$corpus"
  ASAN_OPTIONS=detect_leaks=0 $build/tests/fuzz/fuzz_"$name" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -max_len=4194304 -print_final_stats=1 -artifact_prefix=$build/found/"$name"- "$corpus" > $build/"$name".log 2>&1 || true
  tail -12 $build/"$name".log
done

# The corpus once more: what it reaches is the coverage.
for name in "${targets[@]}"; do
  LLVM_PROFILE_FILE=$build/profiles/$name.profraw \
    $build/coverage/tests/fuzz/fuzz_smoke "$name" --run $build/corpus/"$name"/*
done
"llvm-profdata-$version" merge -o $build/fuzz.profdata $build/profiles/*.profraw
"llvm-cov-$version" report $build/coverage/tests/fuzz/fuzz_smoke -instr-profile=$build/fuzz.profdata formats/
ls $build/found
