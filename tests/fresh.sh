#!/usr/bin/env bash
# Before a release: does all work where nothing is installed? Makes a bare Debian 12 (debootstrap, minbase), copies the
# tracked files into it and runs there examples/run.sh and tests/run.sh; makes the package and installs it on a second
# bare Debian 12, where it bakes and draws. Needs root, debootstrap and 20 GB; takes an hour or two on two cores.
#
#   tests/fresh.sh [FOLDER [WHAT...]]   FOLDER holds both systems and is kept (a temporary one is removed); WHAT is of
#                                       examples, tests and package, all three when none is given
# Packages come from where apt gets those of this machine. Exit code 77: skipped.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)

skip() { echo "SKIPPED: tests/fresh.sh $*" >&2; exit 77; }
[ "$(id -u)" -eq 0 ] || skip "needs root"
command -v debootstrap >/dev/null || skip "needs debootstrap (Debian: debootstrap)"

folder=${1:-$(mktemp -d /var/tmp/texbake-fresh.XXXXXX)}
what=("${@:2}")
[ ${#what[@]} -gt 0 ] || what=(examples tests package)
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
builder=$folder/builder user=$folder/user

# Whatever happens, nothing stays mounted, and a folder that nobody named goes.
unmount() {
  local system
  for system in "$builder" "$user"; do
    umount "$system/dev/shm" "$system/dev" "$system/proc" 2>/dev/null || true
  done
}
trap 'unmount; [ $# -gt 0 ] || { mountpoint -q "$builder/proc" || rm -rf "$folder"; }' EXIT

# bare SYSTEM: makes it, with the sources of packages that this machine has.
bare() {
  if [ ! -e "$1/made" ]; then
    echo "== making a bare Debian 12 in $1" >&2
    local mirror
    mirror=$(apt-get indextargets --format '$(SITE) $(RELEASE)' 'Created-By: Packages' | sed -n 's/ bookworm$//p' | head -1)
    debootstrap --variant=minbase bookworm "$1" ${mirror:+"$mirror"} >&2
    rm -f "$1/etc/apt/sources.list"
    cp -r /etc/apt/sources.list* /etc/apt/trusted.gpg.d "$1/etc/apt/" 2>/dev/null || true
    apt-config dump | grep -E '^Acquire::(https?::|Check-)' > "$1/etc/apt/apt.conf.d/host" || true
    mkdir -p "$1/usr/share/keyrings"
    cp -r /usr/share/keyrings/. "$1/usr/share/keyrings/"
    touch "$1/made"
  fi
  cp -L /etc/resolv.conf /etc/hosts "$1/etc/"
  mountpoint -q "$1/proc" || mount -t proc proc "$1/proc"
  mountpoint -q "$1/dev" || mount --bind /dev "$1/dev"
  mountpoint -q "$1/dev/shm" || mount -t tmpfs tmpfs "$1/dev/shm"
}

# inside SYSTEM COMMAND: runs it in /texbake of the system; tells the processor time that it took.
inside() {
  local TIMEFORMAT="$2: %0R s, of the processors %0U s + %0S s"
  time chroot "$1" env HOME=/root LC_ALL=C.UTF-8 bash -euc "cd /texbake && $2"
}

bare "$builder"
rm -rf "$builder/texbake.new" && mkdir "$builder/texbake.new"
git -C "$root" ls-files -z | tar -C "$root" --null -T - -c | tar -C "$builder/texbake.new" -x
[ ! -d "$builder/texbake/build" ] || mv "$builder/texbake/build" "$builder/texbake.new/build"
rm -rf "$builder/texbake" && mv "$builder/texbake.new" "$builder/texbake"

for step in "${what[@]}"; do
  echo "== $step" >&2
  case $step in
    examples) inside "$builder" "examples/run.sh" ;;
    tests) inside "$builder" "tests/run.sh" ;;
    package)
      inside "$builder" "examples/run.sh && cmake/install-packages.sh test && cpack -G DEB \
        --config build/release-tools/CPackConfig.cmake -B build/package"
      bare "$user"
      mkdir -p "$user/texbake"
      cp "$builder"/texbake/build/package/*.deb "$builder/texbake/build/examples/leaves.png" "$user/texbake/"
      inside "$user" "apt-get update -q && apt-get install -qy --no-install-recommends ./*.deb"
      inside "$user" "texbake --version"
      inside "$user" "texbake bake leaves.png -o leaves.texbundle && texbake verify leaves.texbundle &&
        texbake render leaves.texbundle -o leaves_1024.png --size 1024x1024"
      cmp <(cd "$user/texbake/leaves.texbundle" && sha256sum -- *) \
        <(cd "$builder/texbake/build/examples/leaves.texbundle" && sha256sum -- *) ||
        { echo "FAILED: the package bakes other bytes than the build does" >&2; exit 1; }
      ;;
    *) echo "tests/fresh.sh: \"$step\" is none of examples, tests and package" >&2; exit 2 ;;
  esac
done
echo "passed on a bare Debian 12: ${what[*]}"
