#!/usr/bin/env bash
# Every verb that writes, killed at any moment: its target is the old one, the new one, or, where there was none, none;
# the next run is not hindered and removes what the killed one left. ROUNDS=300 for a long run, SEED for other moments.
. "$(dirname "$0")/writing_verbs.sh"
. "$(dirname "$0")/scratch.sh"

is_temporary() { [[ $1 == */.*.texbake-tmp-* ]]; }

# Each file is the old or the new one; a bundle is so as a whole, for verify looks at it; a folder of exports, too.
judge() { # judge VERB MOMENT
  local file old new
  while IFS= read -r file; do
    is_temporary "$file" && continue
    old="old.$1/${file#target/}" new="new.$1/${file#target/}"
    cmp -s "$file" "$old" || cmp -s "$file" "$new" || fail "$1 killed after $2 ms: $file is neither old nor new"
  done < <(find target -type f)
  for file in target/*.texbundle; do
    [ ! -d "$file" ] || texbake verify "$file" > verdict || { cat verdict; fail "$1 killed after $2 ms: $file is broken"; }
  done
  [ ! -d target/export ] || same target/export new.export/export
}

declare -A took seen
for verb in "${verbs[@]}"; do
  remember "$verb"
  took[$verb]=$took_ms
done
rounds=${ROUNDS:-10}
RANDOM=${SEED:-1}
for ((i = 0; i < rounds; ++i)); do
  verb=${verbs[i % ${#verbs[@]}]}
  # The writing is at the end of a run.
  delay_ms=$((took[$verb] * (400 + RANDOM % 700) / 1000))
  prepare "$verb"
  write "$verb" timeout -s KILL "$(printf '%d.%03d' $((delay_ms / 1000)) $((delay_ms % 1000)))" || true
  state=between
  ! is_like "old.$verb" || state=old
  ! is_like "new.$verb" || state=new
  seen[$state]=$((${seen[$state]:-0} + 1))
  judge "$verb" $delay_ms
  write "$verb" || { cat said; fail "$verb does not work after a run that was killed after $delay_ms ms"; }
  same target "new.$verb"
done
echo "$rounds kills: as before ${seen[old]:-0}, as after ${seen[new]:-0}, with temporary files ${seen[between]:-0}"
