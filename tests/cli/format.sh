#!/usr/bin/env bash
# Every C++ file is as clang-format writes it.
. "$(dirname "$0")/scratch.sh"
[ -z "$SANITIZE" ] || skip "checked in the release build only"
command -v clang-format > /dev/null || skip "no clang-format here (Debian: clang-format)"
cd "$SOURCE"
find bake cli examples formats libbake pages shaders tests -name '*.cpp' -o -name '*.h' | sort | xargs clang-format --dry-run -Werror ||
  fail "clang-format -i mends these files"
