#!/usr/bin/env bash
# usage: viewer.sh WRITE_GOLDEN_PAGE GOLDEN_FOLDER WORK_FOLDER: exports golden tiles and opens them in headless Chromium.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
write=$1 golden=$2 work=$3

skip() { echo "SKIPPED: the viewer is not tested: $*" >&2; exit 77; }
mkdir -p "$work"
for tile in plain moved turned levels noise_levels stack stack_turned stack_three stack_soft stack_relief stack_noise; do
  rm -rf "${work:?}/$tile"
  "$write" "$tile" "$work/$tile"
done

[ -z "${SANITIZE:-}" ] || skip "the pages were written; the browser draws those of the release build"
command -v node >/dev/null && command -v npm >/dev/null || skip "no node and npm here"
chromium=$(command -v chromium || command -v chromium-browser || true)
[ -n "$chromium" ] || skip "no chromium here"
if [ ! -d "$work/node_modules/playwright-core" ]; then
  npm install --silent --no-audit --no-fund --no-save --prefix "$work" playwright-core@1 >&2 || skip "playwright-core could not be installed"
fi
NODE_PATH="$work/node_modules" node "$here/viewer_test.cjs" "$chromium" "$golden" "$work"
