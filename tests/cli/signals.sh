#!/usr/bin/env bash
# SIGINT ends with 130 and SIGTERM with 143, and nothing temporary stays behind.
. "$(dirname "$0")/scratch.sh"
listing . > ../signals.before
interrupted() { # interrupted SIGNAL CODE COMMAND...
  local signal=$1 expected=$2 code=0
  shift 2
  timeout -s "$signal" --preserve-status 0.7 "$@" > /dev/null 2>&1 || code=$?
  [ "$code" -eq "$expected" ] || fail "$* ended with $code after SIG$signal, expected $expected"
  listing . > ../signals.after
  diff ../signals.before ../signals.after >&2 || fail "$* left files behind"
}
# A picture that takes many seconds.
interrupted INT 130 "$TEXBAKE" render good.texbundle -o window.png --size 30000x30000
interrupted TERM 143 "$TEXBAKE" render good.texbundle -o window.png --size 30000x30000
interrupted TERM 143 "$TEXBAKE" render good.texbundle -o window.exr --size 30000x30000
