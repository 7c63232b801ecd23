# Sourced by scripts that disturb a verb while it writes, before scratch.sh: what each verb writes to the folder `target`,
# what was there before, and what may be there afterwards.
verbs=(bake fragment render report export)

# write VERB [WRAPPER...]: runs the verb, by a wrapper such as `timeout 3`; `said` has its words.
write() {
  local verb=$1
  shift
  case $verb in
    bake) set -- "$@" "$TEXBAKE" convert leaves.png -o target/bake.texbundle ;;
    fragment) set -- "$@" "$TEXBAKE" fragment target/fragment.texbundle --threshold 30 ;;
    render) set -- "$@" "$TEXBAKE" render good.texbundle -o target/render.png --size 256 ;;
    report) set -- "$@" "$TEXBAKE" report good.texbundle -o target/report.html --quick --tiles 2 ;;
    export) set -- "$@" "$TEXBAKE" export good.texbundle --web -o target/export ;;
  esac
  "$@" -q > said 2>&1
}

# prepare VERB: the target as it is before.
prepare() {
  mkdir -p target
  find target/ -mindepth 1 -delete
  case $1 in
    fragment) cp -r good.texbundle target/fragment.texbundle ;;
    render) cp leaves.png target/render.png ;;
    report) echo old > target/report.html ;;
  esac
}

# remember VERB: the folders old.VERB and new.VERB, the target before and after; `took_ms` is how long it took.
remember() {
  local start
  prepare "$1"
  cp -r target/ "old.$1"
  start=$(date +%s%N)
  write "$1" || { cat said; fail "$1 does not even work undisturbed"; }
  took_ms=$((($(date +%s%N) - start) / 1000000))
  cp -r target/ "new.$1"
}

# is_like FOLDER: does the target look so?
is_like() { diff <(listing target) <(listing "$1") > /dev/null; }
