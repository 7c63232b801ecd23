# Sourced by the scripts: an empty folder of their own with the exemplars and bundles in it, the program as `texbake`,
# and how to fail.
set -euo pipefail
rm -rf "$SCRATCH" && mkdir -p "$SCRATCH" && cd "$SCRATCH"
cp -r "$EXEMPLARS"/. .
texbake() { "$TEXBAKE" "$@"; }
fail() { echo "FAILED: $*" >&2; exit 1; }
skip() { echo "SKIPPED: $*" >&2; exit 77; }
# The names and contents of everything below a folder.
listing() { (cd "$1" && { find . -type f -print0 | sort -z | xargs -0 sha256sum; find . -type d | sort; }); }
same() { diff <(listing "$1") <(listing "$2") >&2 || fail "$1 and $2 differ"; }
