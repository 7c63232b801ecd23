#!/usr/bin/env bash
# Nothing depends on messages: with stderr closed, full or without a reader, a verb does what it does otherwise. A result
# that cannot be written to stdout is exit code 4, and one without a reader 141.
. "$(dirname "$0")/scratch.sh"
texbake bake leaves.png -o expected.texbundle 2> said
grep -q 'warning:' said || fail "the bake should say something"
# baked NAME: the bake under that name is the expected one.
baked() { same "$1.texbundle" expected.texbundle; }

texbake bake leaves.png -o closed.texbundle --progress always 2>&- > /dev/null || fail "stderr closed: exit code $?"
baked closed
texbake bake leaves.png -o full.texbundle --progress json -v 2> /dev/full > /dev/null || fail "stderr full: exit code $?"
baked full
texbake bake leaves.png -o unread.texbundle --progress json -v 2> >(exec 0<&-; sleep 1) > /dev/null ||
  fail "stderr without a reader: exit code $?"
baked unread
texbake bake leaves.png -o all.texbundle 0<&- 1>&- 2>&- && fail "stdout closed: the result is lost, yet exit code 0" || code=$?
[ "$code" -eq 4 ] || fail "all streams closed: exit code $code, expected 4"
baked all
texbake render expected.texbundle -o a.png --size 64 2>&- > /dev/null
texbake render expected.texbundle -o b.png --size 64 > /dev/null
cmp a.png b.png || fail "a picture that is written while stderr is closed has messages in it"

# Mistakes and failures keep their exit codes.
for stream in '2>&-' '2>/dev/full'; do
  code=0; eval "texbake render no.texbundle $stream" || code=$?
  [ "$code" -eq 4 ] || fail "a missing bundle with $stream: exit code $code, expected 4"
  code=0; eval "texbake rendre $stream" || code=$?
  [ "$code" -eq 2 ] || fail "an unknown verb with $stream: exit code $code, expected 2"
done

# A reader that is gone before anything is written.
code=0
{ sleep 1; exec "$TEXBAKE" info expected.texbundle 2> said; } | true || code=${PIPESTATUS[0]}
[ "$code" -eq 141 ] || fail "stdout without a reader: exit code $code, expected 141"
[ ! -s said ] || fail "stdout without a reader: that needs no message"
find . -name '*texbake-tmp*' | grep . && fail "temporary files are left"
exit 0
