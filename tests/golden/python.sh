#!/usr/bin/env bash
# Draws the golden frames with the reader in Python: python.sh SOURCE TEXBAKE WORK
set -euo pipefail
export PYTHONDONTWRITEBYTECODE=1
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import numpy' 2> /dev/null; then
    rm -rf "$3"
    exec "$python" "$1/examples/python/check_golden.py" "$1/tests/golden" "$2" "$3"
  fi
done
echo 'SKIPPED: the reference reader needs numpy (Debian: python3-numpy)' >&2
exit 77
