#!/usr/bin/env bash
# Installs the Debian packages of cmake/packages.txt that are missing: install-packages.sh build [test]
set -euo pipefail
folder=$(cd "$(dirname "$0")" && pwd)

missing=()
for purpose in "$@"; do
  for package in $(sed -n "s/^$purpose //p" "$folder/packages.txt"); do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
done
if [ ${#missing[@]} -eq 0 ]; then exit 0; fi

echo "installing: ${missing[*]}" >&2
if [ "$(id -u)" -eq 0 ]; then
  as_root=(env)
elif command -v sudo >/dev/null; then
  as_root=(sudo env)
else
  echo "install-packages.sh: these packages are missing and installing them needs root or sudo: ${missing[*]}" >&2
  exit 1
fi
"${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get update -q >&2
"${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends "${missing[@]}" >&2
