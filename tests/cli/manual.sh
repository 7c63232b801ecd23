#!/usr/bin/env bash
# Manual pages and completions tell of the options that --help tells of, and of no other: manual.sh SHARE_FOLDER
. "$(dirname "$0")/scratch.sh"
share=$1
bash_script=$share/bash-completion/completions/texbake
zsh_script=$share/zsh/site-functions/_texbake
fish_script=$share/fish/vendor_completions.d/texbake.fish
verbs=$(texbake --help | sed -n '/^Verbs:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p' | grep -vx help)
[ "$(wc -w <<< "$verbs")" -ge 14 ] || fail "the help lists too few verbs: $verbs"

missing() { echo "SKIPPED in part: $1 is not installed, so that $2" >&2; }

# Sorted options, one a line, of a verb ("" for the program): as --help, the manual page and each completion have them.
sorted() { grep -oE -- '-[a-zA-Z]$|--[a-z][a-z-]*' | sort -u; }
of_help() { texbake $1 --help | grep -E '^  -' | sed -E 's/^  (-[a-zA-Z]), (--[a-z-]+).*/\1\n\2/; s/^  (--[a-z-]+).*/\1/' | sorted; }
of_manual() { grep -A1 '^\.TP' "$share/man/man1/texbake${1:+-$1}.1" | grep '^\\fB\\-' | sed -E 's/ \\fI.*//; s/\\-/-/g; s/\\f[BR]//g; s/, /\n/' | sorted; }

# The words that bash offers: complete WORD...; the last word is the one at the cursor.
complete_in_bash() {
  bash -c 'source "$1"; shift; COMP_WORDS=(texbake "$@") COMP_CWORD=$#; _texbake; printf "%s\n" "${COMPREPLY[@]}"' bash "$bash_script" "$@"
}
of_bash() { complete_in_bash $1 - | sorted; }
# The lines of a verb: of zsh those of its case, of fish those with its condition and those without any.
of_zsh() {
  if [ "$1" ]; then sed -n "/^    $1)\$/,/^      ;;/p" "$zsh_script"; else sed -n '/^_texbake()/,/^  case/p' "$zsh_script"; fi |
    grep -E "^        '" | sed -E "s/\[.*//; s/.*\{(.*)\}.*/\1/; s/^ *'\*?//; s/,/\n/" | sorted
}
of_fish() {
  if [ "$1" ]; then grep -E "^complete -c texbake (-n '__fish_seen_subcommand_from $1' )?-[sl] " "$fish_script"
  else grep -E "^complete -c texbake (-n 'not __fish.*' )?-[sl] " "$fish_script"; fi |
    sed -E "s/ -d .*//; s/.* -s (.) -l ([a-z-]+).*/-\1\n--\2/; s/.* -l ([a-z-]+).*/--\1/" | sorted
}
for verb in "" $verbs; do
  of_help "$verb" > expected
  [ "$(wc -l < expected)" -ge 9 ] || fail "the help of $verb lists too few options"
  for source in manual bash zsh fish; do
    of_$source "$verb" | diff expected - >&2 || fail "$source: other options of texbake $verb than its --help"
  done
done

# Descriptions, defaults and examples too, in the words of the help.
plain_words() { tr -s ' \n' '\n\n' | sed -E 's/\\\[u[0-9A-F]+\]|[^ -~]//g; s/\\e/\\/g; s/\\://g; s/\\-/-/g; s/\\&//g' ; }
texbake render --help | sed -n '/^View:/,/^$/p' | sed -E '1d; s/^  (--[a-z-]+)/\1/' | plain_words > words
grep -A100 '^\.SS View' "$share/man/man1/texbake-render.1" | sed '/^\.SS Def/,$d; /^\.SS View/d; /^\.TP/d; s/\\f[BIR]//g' | plain_words > manual_words
diff words manual_words >&2 || fail "the manual page of render says something else than its help"

# bash offers verbs, options, words of a value, files and folders.
offers() { # offers EXPECTED WORD...
  local expected=$1 found
  shift
  found=$(complete_in_bash "$@" | sort | tr '\n' ' ')
  [ "${found% }" = "$expected" ] || fail "texbake $*<TAB> offers \"${found% }\", expected \"$expected\""
}
mkdir zinnia.texbundle && touch zinnia.jpg
offers "render report" re
offers "render report" --json re
offers "render report" -j 4 re
offers "heightmap help" he
offers "render report" help re
offers "--relief --relief-refinements --relief-steps" render --reli
offers "anisotropic" render zinnia.texbundle --filter an
offers "anisotropic bilinear nearest trilinear" render --filter ""
offers "anisotropic" render --filter = an
offers "auto" select-contents --search au
offers "zinnia.texbundle" render z
offers "zinnia.jpg zinnia.texbundle" bake z
offers "zinnia.texbundle" bake --output z
offers "zinnia.jpg zinnia.texbundle" render -o z
offers "" render --size 6
offers "always auto" info --progress a

# What else reads them complains of nothing.
if command -v groff > /dev/null; then
  for page in "$share"/man/man1/*.1; do
    groff -man -ww -z -Tutf8 "$page" 2>&1 | grep . && fail "groff complains about $page"
  done
else
  missing groff "the manual pages are not read"
fi
if command -v mandoc > /dev/null; then
  mandoc -Tlint -W warning "$share"/man/man1/*.1 | grep -v 'missing date' && fail "mandoc complains"
else
  missing mandoc "it did not judge the manual pages"
fi
bash -n "$bash_script"
if command -v zsh > /dev/null; then zsh -n "$zsh_script"; else missing zsh "its completions are not read"; fi
if command -v fish > /dev/null; then fish --no-execute "$fish_script"; else missing fish "its completions are not read"; fi
echo "$(wc -w <<< "$verbs") verbs"
