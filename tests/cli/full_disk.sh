#!/usr/bin/env bash
# A disk that is full, has no more files to give, or gives this user no more: what was there stays, nothing is left
# behind, and the message says why. The disk is made for the test, which takes the rights of root.
if [ "${1:-}" != in_its_own_namespace ]; then
  if ! unshare --mount true 2> /dev/null; then
    echo "SKIPPED: no disk can be mounted here, so that none is filled" >&2
    exit 77
  fi
  exec unshare --mount "$0" in_its_own_namespace  # which takes the disk with it
fi
. "$(dirname "$0")/writing_verbs.sh"
. "$(dirname "$0")/scratch.sh"
mkdir disk
# mount_disk OPTIONS: an empty disk; `target` lies on it.
mount_disk() {
  ! mountpoint -q disk || umount disk
  mount -t tmpfs -o "$1" none disk 2> /dev/null && mkdir disk/target
}
mount_disk size=64m || skip "no disk can be mounted here, so that none is filled"
ln -s disk/target target

failed=0 written=0
# judge VERB DISK: runs the verb on a disk that is described so.
judge() {
  local verb=$1 disk=$2 code=0
  write "$verb" || code=$?
  if [ $code -eq 0 ]; then
    is_like "new.$verb" || fail "$verb, $disk: exit code 0, but the target is not the new one"
    written=$((written + 1))
    return
  fi
  [ $code -eq 4 ] || { cat said; fail "$verb, $disk: exit code $code, expected 4"; }
  grep -qi 'no space left' said || { cat said; fail "$verb, $disk: it does not say why"; }
  is_like "old.$verb" || { find target/ -ls; fail "$verb, $disk: the target is not as it was"; }
  failed=$((failed + 1))
}

used() { df -k --output="$1" disk | tail -1; }
for verb in "${verbs[@]}"; do
  mount_disk size=64m
  remember "$verb"
  for left_kib in 4 40; do
    mount_disk size=64m
    prepare "$verb"
    mount -o remount,size=$(($(used used) + left_kib))k disk
    judge "$verb" "$left_kib KiB left"
  done
  for left in 1 9; do
    mount_disk size=64m
    prepare "$verb"
    mount -o remount,nr_inodes=$(($(used iused) + left)) disk
    judge "$verb" "$left files left"
  done
done
[ $failed -gt 0 ] || fail "no disk was full"
[ $written -gt 0 ] || fail "no disk was large enough"
echo "$failed times the disk was full, $written times there was room"
