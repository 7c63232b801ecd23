#!/usr/bin/env bash
# Runs one line of the table of cases: run_case.sh TABLE NAME
#
# name :: exit code :: preparation :: command :: what stderr or stdout must match
#
# Law: a command that fails leaves every file as it was, and no temporary one.
. "$(dirname "$0")/scratch.sh"
line=$(grep "^$2 " "$1")
field() { echo "$line" | awk -F ' :: ' -v n="$1" '{print $n}'; }
expected=$(field 2) preparation=$(field 3) command=$(field 4) pattern=$(field 5)

[[ $command != *--max-memory* || $expected != 7 || -z $SANITIZE ]] || skip "sanitizers reserve more memory than any limit"
[ -z "${preparation// /}" ] || eval "$preparation"
listing . > ../"$2".before
code=0
(eval "$command") >../"$2".out 2>../"$2".err || code=$?
listing . > ../"$2".after

cat ../"$2".err >&2
[ "$code" -eq "$expected" ] || fail "exit code $code, expected $expected"
grep -Eq -- "$pattern" ../"$2".err ../"$2".out || fail "nothing said matches: $pattern"
[ "$(wc -l < ../"$2".err)" -le 8 ] || fail "more than a clear message"
if [ "$expected" -ge 2 ]; then
  diff ../"$2".before ../"$2".after >&2 || fail "a command that failed changed files"
  [ ! -s ../"$2".out ] || [[ $command == *--json* || $command == *verify* ]] || fail "a command that failed wrote a result to stdout"
fi
