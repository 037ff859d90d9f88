#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs every ./auslanjam command of the README with the built program, in the order in which they stand there.
#   readme_commands.sh PROGRAM README
set -u -o pipefail
program=$(readlink -f -- "$1") readme=$(readlink -f -- "$2")
work=$(mktemp -d "${TMPDIR:-/tmp}/readme_commands.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
unset DISPLAY WAYLAND_DISPLAY

count=0
while read -r line; do
  count=$((count + 1))
  arguments=()
  eval "arguments=(${line#./auslanjam })"
  if ! "$program" "${arguments[@]}" >out 2>err </dev/null; then
    printf 'failed: %s\n' "$line"
    cat err
    exit 1
  fi
  printf 'done: %s\n' "$line"
done < <(sed -n '/^```sh$/,/^```$/p' "$readme" | grep '^\./auslanjam ')
# The README shows at least one command of each kind.
((count >= 10)) || { echo "only $count commands were found in $readme" && exit 1; }
