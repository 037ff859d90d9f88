#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Counts the instructions and last-level cache misses of a frame and compares them with instructions.txt.
#   instructions.sh PROGRAMS            exit 0 when none has grown, 1 when one has, 77 where there is no valgrind
#   instructions.sh --print PROGRAMS    prints the file with the counts that hold now
# PROGRAMS is the folder of raster_frames, which draws the scenes of the rasteriser, and stage_frames, which draws the
# figure as it signs, and synthesis_cost, which synthesises a sentence of eleven signs and letters. A frame, or a sentence, is
# a run of 11 less a run of 1, divided by 10: what the program does once drops out, and the first frame, which has to
# write every pixel, with it. The caches are those of a small processor.
set -u -o pipefail
list=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/instructions.txt
print=
[[ ${1:-} == --print ]] && print=yes && shift
programs=$(readlink -f -- "$1")

if ! command -v valgrind >/dev/null; then
  echo "skipped: valgrind is not installed"
  exit 77
fi
work=$(mktemp -d "${TMPDIR:-/tmp}/instructions.XXXXXX")
trap 'rm -rf "$work"' EXIT

# count FRAMES ARGUMENT...: "instructions misses" of a whole run.
count() {
  local frames=$1 scene=$2 width=$3 height=$4 samples=$5 kernel=$6 redraw=$7 program=$programs/raster_frames
  local arguments=("$scene" "$width" "$height" "$samples" "$kernel" 1 "$redraw" "$frames")
  [[ $scene != figure* ]] || program=$programs/stage_frames
  [[ $scene != sentence ]] || program=$programs/synthesis_cost arguments=(sentence "$frames")
  if ! valgrind --tool=cachegrind --I1=32768,8,64 --D1=24576,6,64 --LL=1048576,16,64 --cache-sim=yes \
    --cachegrind-out-file="$work/out" "$program" "${arguments[@]}" >"$work/log" 2>&1; then
    cat "$work/log" >&2
    return 1
  fi
  # summary: Ir I1mr ILmr Dr D1mr DLmr Dw D1mw DLmw
  awk '$1 == "summary:" { print $2, $4 + $7 + $10 }' "$work/out"
}

failures=0
while IFS= read -r line; do
  if [[ $line == '#'* || -z $line ]]; then
    [[ -z $print ]] || printf '%s\n' "$line"
    continue
  fi
  read -r scene width height samples kernel redraw accepted aim most_misses <<<"$line"
  arguments=("$scene" "$width" "$height" "$samples" "$kernel" "$redraw")
  read -r one one_missed < <(count 1 "${arguments[@]}")
  read -r many many_missed < <(count 11 "${arguments[@]}")
  if [[ -z ${one:-} || -z ${many:-} ]]; then
    echo "the frames of ${arguments[*]} failed under valgrind" >&2
    exit 1
  fi
  instructions=$(((many - one) / 10)) misses=$(((many_missed - one_missed) / 10))
  if [[ -n $print ]]; then
    printf '%-12s %-5s %-6s %-7s %-6s %-7s %-13s %-17s %s\n' "${arguments[@]}" "$instructions" "$aim" "$most_misses"
    continue
  fi
  printf '%s: %d instructions (accepted: %d), %d last-level misses a frame\n' "${arguments[*]}" "$instructions" "$accepted" \
    "$misses"
  if ((instructions * 100 > accepted * 102)); then
    echo "  more than 2 % more than accepted; if that is meant, run tests/bench/accept"
    failures=$((failures + 1))
  fi
  if [[ $aim != - ]] && ((instructions > aim)); then
    echo "  NOT REACHED: the aim of $aim instructions"
  fi
  if [[ $most_misses != - ]] && ((misses > most_misses)); then
    echo "  above the limit of $most_misses last-level misses"
    failures=$((failures + 1))
  fi
done <"$list"
((failures == 0))
