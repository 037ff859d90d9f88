#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What the program does with what it should refuse: each case_NAME is a test of its own.
#   programs_bad_input.sh PROGRAM DATA NAME      PROGRAM is auslanjam, DATA the folder with its lexicon and its figure
# A message on stderr that names what to do, the exit status of the contract, nothing on stdout, no file left behind, what
# stood there before untouched, and no crash: under sanitizers too, whose reports exit with 86 here.
set -u -o pipefail
self=$(readlink -f -- "${BASH_SOURCE[0]}")
program=$(readlink -f -- "$1") data=$(readlink -f -- "$2") name=$3
# LeakSanitizer guesses where the thread-local storage of loaded modules lies, and crashes when it guesses wrong.
export ASAN_OPTIONS=exitcode=86:intercept_tls_get_addr=0:${ASAN_OPTIONS:-} UBSAN_OPTIONS=exitcode=86:print_stacktrace=1:${UBSAN_OPTIONS:-}
export AUSLANJAM_DATA=$data
unset DISPLAY WAYLAND_DISPLAY

work=$(mktemp -d "${TMPDIR:-/tmp}/bad_input.XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir "$work/here" "$work/tmp" "$work/data"
export TMPDIR=$work/tmp
cd "$work/here" || exit 1
out=$work/out err=$work/err
failures=0 last='' status=0

wrong() {
  failures=$((failures + 1))
  printf 'WRONG: %s\n  command: %s\n  exit %s\n' "$1" "$last" "$status"
  sed 's/^/  stdout: /' "$out" | cut -c1-300 | head -n 5
  sed 's/^/  stderr: /' "$err" | cut -c1-500 | head -n 30
}

# run ARGUMENT...: starts the program; ends it after two minutes, which counts as a hang.
run() {
  last="auslanjam $(printf '%q ' "$@" | cut -c1-300)"
  timeout --kill-after=5 "${hang_seconds:-120}" "$program" "$@" >"$out" 2>"$err" </dev/null
  status=$?
  case $status in
    0 | 1 | 2) ;;
    124 | 137) wrong "hangs" ;;
    86) wrong "a sanitizer reports" ;;
    *) wrong "crashes" ;;
  esac
}
# refused STATUS PATTERN: the last run ended with STATUS, said PATTERN on stderr and nothing on stdout, and left no file.
refused() {
  [[ $status == "$1" ]] || wrong "exit $1 was due"
  grep -qiE -- "$2" "$err" || wrong "the message should say /$2/"
  [[ ! -s $out ]] || wrong "messages belong on stderr, stdout has to stay empty"
  nothing_left
}
nothing_left() {
  local left
  left=$(find "$work/here" "$work/tmp" -mindepth 1)
  [[ -z $left ]] || wrong "left behind: $left"
  rm -rf "$work/here"/* "$work/tmp"/*
}
# survived: done or refused, both are right; a refusal has to say something.
survived() {
  [[ $status == 0 || -s $err ]] || wrong "fails without a word"
  [[ $status == 0 ]] || nothing_left
  rm -rf "$work/here"/* "$work/tmp"/*
}
# The cheapest command that needs the lexicon, the figure, the rasteriser and a picture.
picture=(--at 0.3 --size 64x48 -o picture.png)

# --- the command line

case_good_input_works() { # what the other cases break has to be whole
  run render hurt "${picture[@]}"
  [[ $status == 0 && -s picture.png && ! -s $out ]] || wrong "a good command line fails"
  run translate hurt
  [[ $status == 0 ]] && grep -q HURT "$out" || wrong "a good command line fails"
}
case_unknown_option() {
  run translate --no-such-option hurt && refused 2 'no-such-option'
  run render hurt -o x.png --no-such-option && refused 2 '--help'
  run --no-such-option && refused 2 '--help'
}
case_no_arguments() { run && refused 2 'help|usage'; }
case_empty_text() {
  run translate '' && refused 2 'empty|text'
  run render '' -o x.png && refused 2 'empty|text'
  run motion '' -o x.jsonl && refused 2 'empty|text'
  run sign '' && refused 2 'empty|text'
  run '' && refused 2 'empty|text'
  run render $' \t\n ' -o x.png && refused 2 'empty|text'
}
case_missing_text_or_output() {
  run render && refused 2 'text|help'
  run render -o x.png && refused 2 'text'
  run render hurt && refused 2 '-o|--hash|output'
  run motion hurt && refused 2 '-o|output'
  run experiment && refused 2 '-o|output'
  run render hurt -o && refused 2 '-o'
  run render hurt -o x.png --size && refused 2 '--size'
}
case_bad_option_values() {
  local option
  for option in '--size 0x0' '--size 64' '--size 64x' '--size -64x48' '--size 100000x100000' '--size 64x48x2' \
    '--size 99999999999999999999x1' '--fps 0' '--fps -1' '--fps nan' '--fps 1e9' '--speed 0' '--speed -1' '--speed inf' \
    '--aa 3' '--aa 0' '--aa 1000' '--shading nosuch' '--detail nosuch' '--camera nosuch' '--at -1' '--at nan' '--at now'; do
    # shellcheck disable=SC2086
    run render hurt -o x.png $option && refused 2 "${option%% *}"
  done
}
case_unknown_appearance() {
  run render hurt -o x.png --appearance nosuch && refused 2 'nosuch.*fair-brown-petrol'
}
case_unknown_output_format() {
  run render hurt -o x.nosuch && refused 2 '\.(png|mp4|gif|y4m)'
  run render hurt -o x && refused 2 '\.(png|mp4|gif|y4m)'
  run motion hurt -o x.nosuch && refused 2 '\.(jsonl|bvh)'
}
case_notation() {
  run notation && refused 2 'FILE'
  run notation x.sigml --hamnosys hamflathand && refused 2 'one FILE'
  run notation --hamnosys hamflathand --to nosuch && refused 2 'nosuch'
  run notation --hamnosys hamflathand -o x.sigml && refused 2 '--to'
  run notation --hamnosys nothing && refused 1 'HamNoSys symbol'
  run notation nosuch.sigml && refused 1 'nosuch\.sigml'
  run notation --hamnosys hamflathand --to hns -o nowhere/x.sigml && refused 1 'nowhere'
}
case_unknown_gloss() {
  run render --gloss NO-SUCH-GLOSS "${picture[@]}" && refused 1 'NO-SUCH-GLOSS'
  run db show NO-SUCH-GLOSS && refused 1 'NO-SUCH-GLOSS'
}

# --- the text

case_invalid_utf8() {
  local text
  for text in $'hurt \xff\xfe' $'\xc0\xaf' $'\xed\xa0\x80' $'caf\xc3' $'\xf4\x90\x80\x80'; do
    run translate "$text" && refused 2 'utf-?8'
    run render "$text" -o x.png && refused 2 'utf-?8'
  done
}
case_text_of_100_kilobytes() {
  local text
  text=$(head -c 100000 < <(yes 'where does it hurt'))
  run translate "$text"
  [[ $status != 0 ]] || (($(grep -o HURT "$out" | wc -l) >= 5000)) || wrong "words were dropped"
  [[ $status == 0 ]] || refused 2 'long|limit|most'
  run render "$text" "${picture[@]}" && survived
  text=$(head -c 100000 /dev/zero | tr '\0' a)
  run translate "$text"
  [[ $status == 0 ]] || refused 2 'long|limit|most'
  run render "$text" "${picture[@]}" && survived
}
case_500_unknown_words() {
  local text i
  text=$(for ((i = 0; i < 500; ++i)); do printf 'zq%s ' "$(printf '%03d' $i | tr 0-9 a-j)"; done)
  run translate "$text"
  if [[ $status == 0 ]]; then # none is dropped: the last stands there, letter by letter or whole
    grep -qiE 'z-?q-?e-?j-?j' "$out" || wrong "the last word was dropped"
  else
    refused 2 'long|limit|most'
  fi
  run render "$text" "${picture[@]}" && survived
}
case_odd_but_valid_text() {
  local text
  for text in '?!...' $'\u4f60\u597d' $'na\u00efve caf\u00e9' $'\U1f600' '-5' '12345678901234567890' $'line\nbreak' \
    $'\u202ehurt' $'e\u0301\u0301\u0301' $'\u0001\u0007' "';DROP TABLE sign;--" '%s%n%n' '../../etc/passwd'; do
    run translate -- "$text" && survived
  done
}

# --- figures of other makers

case_foreign_figures() {
  run avatar && refused 2 'FILE'
  run avatar one.vrm two.vrm && refused 2 'two\.vrm|help'
  run avatar nowhere.vrm && refused 1 'nowhere\.vrm'
  run avatar /dev/zero && refused 1 '/dev/zero'
  run avatar "$work/here" && refused 1 'here'
  local in=$work/data
  mkfifo "$in/pipe.glb" && run avatar "$in/pipe.glb" && refused 1 'pipe\.glb'
  printf 'solid cube' >"$in/cube.glb" && run avatar "$in/cube.glb" && refused 1 'cube\.glb.*glTF'
  printf '{"asset":{"version":"2.0"}}' >"$in/empty.gltf"
  run avatar "$in/empty.gltf" && refused 1 'empty\.gltf.*no triangles'
  printf '{"asset":{"version":"2.0"},"nodes":[{"children":[0]}]}' >"$in/loop.gltf" &&
    run avatar "$in/loop.gltf" --json && refused 1 'ancestor'
  printf '{"extras":%s' "$(head -c 20000 /dev/zero | tr '\0' '[')" >"$in/deep.gltf"
  run avatar "$in/deep.gltf" && refused 1 'deep\.gltf.*nested'
  # The same with --avatar; and figures that can be read but cannot sign.
  run render --gloss HURT "${picture[@]}" --avatar nowhere.vrm && refused 1 'nowhere\.vrm'
  run render --gloss HURT "${picture[@]}" --avatar "$in/cube.glb" && refused 1 'cube\.glb.*glTF'
  run render --gloss HURT "${picture[@]}" --avatar "$in/loop.gltf" && refused 1 'ancestor'
  triangle='"asset":{"version":"2.0"},"buffers":[{"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]'
  printf '{%s,"nodes":[{"mesh":0}]}' "$triangle" >"$in/triangle.gltf"
  run render --gloss HURT "${picture[@]}" --avatar "$in/triangle.gltf" && refused 1 'triangle\.gltf.*no humanoid'
  printf '{%s,"nodes":[{"mesh":0},{"name":"Hips"},{"name":"Spine"},{"name":"Neck"},{"name":"Head"}]}' "$triangle" \
    >"$in/armless.gltf"
  run render --gloss HURT "${picture[@]}" --avatar "$in/armless.gltf" && refused 1 'lacks.*leftUpperArm'
  printf 'glTF' >"$in/huge.glb" && truncate -s 65M "$in/huge.glb" && run avatar "$in/huge.glb" && refused 1 'huge\.glb'
}

# --- the data

# broken_lexicon PATTERN / broken_figure PATTERN: with the copies in $work/data, refused with PATTERN.
copy_data() {
  rm -rf "$work/data" && mkdir "$work/data"
  cp "$data/lexicon.sqlite" "$data/signer.figure" "$work/data/"
  export AUSLANJAM_DATA=$work/data
}
case_missing_data() {
  export AUSLANJAM_DATA=$work/nowhere
  run render hurt "${picture[@]}" && refused 1 'AUSLANJAM_DATA|auslanjam|install|build'
  copy_data && rm "$work/data/lexicon.sqlite"
  run translate hurt && refused 1 'lexicon\.sqlite'
  run db list && refused 1 'lexicon\.sqlite'
  [[ ! -e $work/data/lexicon.sqlite ]] || wrong "reading made an empty database"
  copy_data && rm "$work/data/signer.figure"
  run render hurt "${picture[@]}" && refused 1 'signer\.figure'
  copy_data && rm "$work/data/signer.figure" && mkdir "$work/data/signer.figure"
  run render hurt "${picture[@]}" && refused 1 'signer\.figure'
  copy_data && rm "$work/data/lexicon.sqlite" && mkdir "$work/data/lexicon.sqlite"
  run translate hurt && refused 1 'lexicon\.sqlite'
}
# truncations FILE: lengths at and around what may be a boundary in it.
truncations() {
  local size
  size=$(stat -c %s "$data/$1")
  printf '%s\n' 0 1 7 8 15 16 31 64 99 100 101 511 512 1024 4095 4096 4097 $((size / 4)) $((size / 2)) $((size * 3 / 4)) |
    awk -v size="$size" '$1 < size' | sort -nu
}
# Bytes spread over the file with a multiplier that is prime, always the same ones.
flip_places() {
  local size i
  size=$(stat -c %s "$data/$1")
  for ((i = 1; i <= $2; ++i)); do printf '%d\n' $((i * 15485863 % size)); done
}
flip() { # FILE PLACE MASK
  local byte
  byte=$(od -An -tu1 -j "$2" -N 1 "$1")
  # shellcheck disable=SC2059
  printf "\\x$(printf %02x $((byte ^ $3)))" | dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}
case_truncated_lexicon() {
  local length
  for length in $(truncations lexicon.sqlite); do
    copy_data && truncate -s "$length" "$work/data/lexicon.sqlite"
    run render hurt "${picture[@]}" && refused 1 'lexicon\.sqlite'
  done
}
case_truncated_figure() {
  local length size
  size=$(stat -c %s "$data/signer.figure")
  for length in $(truncations signer.figure) $((size - 1)); do
    copy_data && truncate -s "$length" "$work/data/signer.figure"
    run render hurt "${picture[@]}" && refused 1 'signer\.figure'
  done
}
case_damaged_lexicon() {
  local place
  copy_data && head -c 20000 /dev/zero | tr '\0' x >"$work/data/lexicon.sqlite"
  run translate hurt && refused 1 'lexicon\.sqlite'
  for place in 0 5 15; do # the magic
    copy_data && flip "$work/data/lexicon.sqlite" $place 255
    run translate hurt && refused 1 'lexicon\.sqlite'
  done
  for place in 16 18 21 28 44 56 100 103 105 $(flip_places lexicon.sqlite 30); do
    copy_data && flip "$work/data/lexicon.sqlite" "$place" 255
    run render hurt "${picture[@]}"
    [[ $status == 0 ]] || grep -q 'lexicon\.sqlite' "$err" || wrong "byte $place: the message should name lexicon.sqlite"
    survived
  done
}
case_other_database() {
  copy_data && "$(command -v sqlite3 || echo true)" "$work/data/other" 'CREATE TABLE t(x);' && [[ -f $work/data/other ]] || {
    echo "SKIPPED: sqlite3 makes the database of this case, and is not installed"
    exit 77
  }
  mv "$work/data/other" "$work/data/lexicon.sqlite"
  run translate hurt && refused 1 'lexicon\.sqlite'
}
case_damaged_figure() {
  local place
  for place in 0 3 4 7; do # the magic and the version
    copy_data && flip "$work/data/signer.figure" $place 255
    run render hurt "${picture[@]}" && refused 1 'signer\.figure'
  done
  for place in 8 9 11 12 15 16 19 20 24 28 32 40 48 $(flip_places signer.figure 40); do # its checksum tells
    copy_data && flip "$work/data/signer.figure" "$place" 128
    run render hurt "${picture[@]}" && refused 1 'signer\.figure'
  done
}

# --- the output

case_unwritable_output() {
  run render hurt --at 0.3 --size 64x48 -o nowhere/picture.png && refused 1 'nowhere'
  run render hurt --size 64x48 -o nowhere/clip.mp4 && refused 1 'nowhere'
  run motion hurt -o nowhere/motion.jsonl && refused 1 'nowhere'
  run render hurt --at 0.3 --size 64x48 -o /proc/picture.png && refused 1 '/proc'
  run motion hurt -o /proc/motion.bvh && refused 1 '/proc'
  : >file
  run experiment -o file/inside
  [[ $status == 1 ]] || wrong "exit 1 was due"
  rm file
  mkdir picture.png
  run render hurt "${picture[@]}"
  [[ $status == 1 && -d picture.png ]] || wrong "a folder stands where the picture should go"
  rmdir picture.png
  nothing_left
}
case_full_standard_output() {
  last="auslanjam translate hurt >/dev/full"
  : >"$out"
  "$program" translate hurt >/dev/full 2>"$err" </dev/null
  status=$?
  [[ $status == 1 && -s $err ]] || wrong "output was lost without a word"
  last="auslanjam render hurt --hash >/dev/full"
  "$program" render hurt --hash --size 64x48 --fps 5 >/dev/full 2>"$err" </dev/null
  status=$?
  [[ $status == 1 && -s $err ]] || wrong "output was lost without a word"
}
# Every kind of output, larger than what is free; what stood there before stays.
outputs_that_do_not_fit() {
  local file
  for file in big.png big.gif big.mp4 big.y4m; do
    [[ $file == *.png ]] && at=(--at 0.3) || at=()
    run render hurt --size 1280x960 --fps 10 "${at[@]}" -o "$1/$file" && no_space_left "$1" "$file"
  done
  for file in big.jsonl big.bvh; do
    run motion "hurt hurt hurt hurt hurt hurt" --fps 120 -o "$1/$file" && no_space_left "$1" "$file"
  done
}
no_space_left() { # FOLDER FILE
  refused 1 "${2//./\\.}"
  [[ -z $(find "$1" -mindepth 1 ! -name before) ]] || wrong "left on the full disk: $(ls -A "$1")"
  find "$1" -mindepth 1 ! -name before -delete
}
case_full_disk() {
  disk=$work/disk
  mkdir "$disk"
  if ((EUID == 0)) && [[ -z ${BAD_INPUT_NAMESPACE:-} ]] &&
    unshare --mount --propagation private mount -t tmpfs -o size=8k tmpfs "$disk" 2>/dev/null; then
    # Mounts end with the namespace that holds them.
    BAD_INPUT_NAMESPACE=yes unshare --mount --propagation private "$self" "$program" "$data" "$name"
    exit
  fi
  if [[ -n ${BAD_INPUT_NAMESPACE:-} ]]; then
    mount -t tmpfs -o size=8k tmpfs "$disk" || exit 1
    trap 'umount "$disk"; rm -rf "$work"' EXIT
  else
    # Without root: files end at 4 kB, and writing past that fails instead of killing.
    trap '' XFSZ
    ulimit -f 4
  fi
  printf 'kept' >"$disk/before"
  outputs_that_do_not_fit "$disk"
  [[ $(<"$disk/before") == kept ]] || wrong "another file was touched"
}
case_failure_keeps_what_was_there() {
  printf 'what was there' >clip.mp4
  cp clip.mp4 picture.png
  AUSLANJAM_DATA=$work/nowhere run render hurt "${picture[@]}"
  [[ $status == 1 ]] || wrong "exit 1 was due"
  AUSLANJAM_DATA=$work/nowhere run render hurt --size 64x48 -o clip.mp4
  [[ $status == 1 ]] || wrong "exit 1 was due"
  cmp -s clip.mp4 picture.png && [[ $(<clip.mp4) == 'what was there' ]] || wrong "an older file was lost"
  [[ $(ls -A | sort | tr '\n' ' ') == 'clip.mp4 picture.png ' ]] || wrong "left behind: $(ls -A)"
}

[[ $self == /* && $(type -t "case_$name") == function ]] || {
  echo "there is no case $name" >&2
  exit 1
}
"case_$name"
((failures == 0)) || echo "$failures wrong"
exit $((failures != 0))
