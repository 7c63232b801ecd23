#!/usr/bin/env bash
# A bundle killed at any moment while it is written is the old one or the new one, and the next writer cleans up.
. "$(dirname "$0")/scratch.sh"
texbake patch good.texbundle --count 7 -o old.texbundle
texbake fragment good.texbundle -o new.texbundle --threshold 30
old=$(sha256sum < old.texbundle/bundle.json)
new=$(sha256sum < new.texbundle/bundle.json)

# The whole run takes some hundred milliseconds; the writing is at its end.
start=$(date +%s%N)
texbake fragment old.texbundle -o timed.texbundle --threshold 30
took_ms=$((($(date +%s%N) - start) / 1000000))
rounds=${ROUNDS:-25}
seen_old=0 seen_new=0
for ((i = 0; i < rounds; ++i)); do
  rm -rf target.texbundle
  cp -r old.texbundle target.texbundle
  delay_ms=$((took_ms * 3 / 10 + took_ms * 9 * i / (10 * rounds)))
  timeout -s KILL "$(printf '%d.%03d' $((delay_ms / 1000)) $((delay_ms % 1000)))" \
    "$TEXBAKE" fragment target.texbundle --threshold 30 > /dev/null 2>&1 || true
  texbake verify target.texbundle > verdict || { cat verdict; fail "killed after $delay_ms ms: the bundle is broken"; }
  case $(sha256sum < target.texbundle/bundle.json) in
    "$old") seen_old=$((seen_old + 1)) ;;
    "$new") seen_new=$((seen_new + 1)) ;;
    *) fail "killed after $delay_ms ms: neither the old nor the new bundle" ;;
  esac
  texbake fragment target.texbundle --threshold 30 -q > /dev/null
  same target.texbundle new.texbundle
done
echo "old $seen_old times, new $seen_new times"
