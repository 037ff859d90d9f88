#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The frames of raster_digests.txt on processors that this one is not. Each way is a test of its own:
#   raster_digests.sh masked PROGRAM     the C library takes the processor for one without FMA and AVX2
#   raster_digests.sh nehalem PROGRAM    an emulated x86-64 of 2008: an instruction that is newer than SSE4.2 ends the program
#   raster_digests.sh aarch64 FOLDER BUILD-TYPE    built for AArch64 in FOLDER (kept from run to run), and emulated
# PROGRAM is raster_digests_print. Each kernel that it runs, and each that is named below, must give just the frames of the
# list. Exit status 77: what the way needs is not installed.
set -u -o pipefail
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
way=$1 place=$2 build_type=${3:-Release}

need() {
  command -v "$1" >/dev/null && return
  echo "skipped: $1 is not installed (Debian package $2)"
  exit 77
}

# built_for_aarch64 FOLDER: configures when that has not been done; says nothing unless something fails.
built_for_aarch64() {
  local folder=$1 report=$1/build.txt
  mkdir -p "$folder" || return 1
  if ! { [[ -f $folder/build.ninja ]] || cmake -S "$here/raster_aarch64" -B "$folder" -G Ninja \
    -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_BUILD_TYPE="$build_type" \
    -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -DAUSLANJAM_WERROR=ON; } >"$report" 2>&1 ||
    ! cmake --build "$folder" --target raster_digests_print >>"$report" 2>&1; then
    tail -n 60 "$report"
    return 1
  fi
}

case $way in
  masked)
    kernels='scalar sse2'
    printed=$(GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2 "$place")
    ;;
  nehalem)
    need qemu-x86_64 qemu-user
    kernels='scalar sse2'
    printed=$(qemu-x86_64 -cpu Nehalem "$place")
    ;;
  aarch64)
    need aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
    need qemu-aarch64 qemu-user
    kernels='scalar neon'
    built_for_aarch64 "$place" || exit 1
    printed=$(qemu-aarch64 "$place/bin/raster_digests_print")
    ;;
  *)
    echo "raster_digests.sh: there is no way $way" >&2
    exit 2
    ;;
esac || {
  echo "the program ended with status $?"
  exit 1
}

kernels+=" $(cut -d" " -f1 <<<"$printed" | sort -u)"
wanted=$(grep -v '^#' "$here/raster_digests.txt" | sort)
for kernel in $kernels; do
  if [[ $(sed -n "s/^$kernel //p" <<<"$printed" | sort) != "$wanted" ]]; then
    echo "$kernel: not the frames of raster_digests.txt (< as committed, > as drawn)"
    diff <(echo "$wanted") <(sed -n "s/^$kernel //p" <<<"$printed" | sort)
    exit 1
  fi
done
# A kernel that needs what the emulated processor has not would have been a trap; that it was not even offered is told here.
if [[ $way == nehalem && $printed == *avx2* ]]; then
  echo "AVX2 is offered on a processor without it"
  exit 1
fi
