#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Renders a clip of frames.txt and compares its digest with the committed one.
#   frames.sh PROGRAM NAME            exit 0 when they are equal, 1 when not
#   frames.sh --print PROGRAM NAME    prints the digest
set -u -o pipefail
list=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/frames.txt
print=
[[ ${1:-} == --print ]] && print=yes && shift
program=$1 name=$2

line=$(grep -E "^$name " "$list") || {
  echo "there is no clip $name in $list" >&2
  exit 1
}
read -r _ wanted arguments <<<"$line"
# The arguments are quoted as a shell takes them.
eval "arguments=($arguments)"

frames=$("$program" render "${arguments[@]}" --hash --quiet) || {
  echo "$name: auslanjam render ended with status $?" >&2
  exit 1
}
count=$(grep -c . <<<"$frames")
# At least two frames that differ: a clip that stands still, or is not drawn at all, witnesses nothing.
if ((count < 2)) || (($(grep -oE '[0-9a-f]{32}' <<<"$frames" | sort -u | wc -l) < 2)); then
  echo "$name: $count frames and no two that differ" >&2
  exit 1
fi
digest=$(sha256sum <<<"$frames" | cut -c1-32)
if [[ -n $print ]]; then
  echo "$digest"
  exit
fi
if [[ $digest != "$wanted" ]]; then
  printf '%s: %s frames, digest %s, expected %s\n' "$name" "$count" "$digest" "$wanted" >&2
  printf 'The frames, to be compared with those of another build:\n%s\n' "$frames" >&2
  echo "When the pictures were changed on purpose: look at them, then run tests/determinism/accept $name" >&2
  exit 1
fi
