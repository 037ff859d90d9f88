#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# raster as others use it: built on its own, installed, moved, then found by CMake (raster/example) and by pkg-config.
#   raster_package.sh CHECK SOURCE BUILD CMAKE COMPILER GENERATOR [CMAKE-ARGUMENT...]
# CHECK compares the example's picture with the library's own. SOURCE and BUILD are this project's; with the arguments
# raster is compiled as it was there, so that a compiler cache may know it.
set -e -u -o pipefail
check=$1 source=$(readlink -f -- "$2") build=$3 cmake=$4 compiler=$5 generator=$6
shift 6

for package in stb glm; do
  pkg-config --exists "$package" || { echo "skipped: pkg-config does not find $package (libstb-dev, libglm-dev)" && exit 77; }
done
work=$(mktemp -d "${TMPDIR:-/tmp}/raster package.XXXXXX")
trap 'rm -rf "$work"' EXIT
wrong() { echo "WRONG: $1" && exit 1; }
listing() { (cd "$1" && find . -type f | sed 's/-targets-[a-z]*\.cmake/-targets-CONFIGURATION.cmake/' | sort); }
export CMAKE_BUILD_PARALLEL_LEVEL=2
project() { "$cmake" -G "$generator" -DCMAKE_CXX_COMPILER="$compiler" "$@" >"$work/log" 2>&1 || { cat "$work/log" && exit 1; }; }

# Alone and as a part of the whole it installs the same files.
project -S "$source/raster" -B "$work/raster" "$@"
"$cmake" --build "$work/raster" >"$work/log" || { cat "$work/log" && exit 1; }
"$cmake" --install "$work/raster" --component raster --prefix "$work/first place" >/dev/null
"$cmake" --install "$build" --component raster --prefix "$work/of the whole" >/dev/null
diff <(listing "$work/first place") <(listing "$work/of the whole") || wrong "the component of the whole project differs"
mv "$work/first place" "$work/second place"
prefix="$work/second place"
! grep -rF -e "$source" -e "$work" "$prefix" --include=*.cmake --include=*.pc || wrong "a path of this machine was installed"
# Inline functions of GLM, had the library its own copies, could be replaced by a user's with other floating-point flags.
[[ $* != *CMAKE_BUILD_TYPE=Release* ]] || ! nm -C "$(find "$prefix" -name libauslan_raster.a)" | grep -E ' [WVu] ([a-z ]+ )?glm::' ||
  wrong "the library shares functions of GLM with its users"

project -S "$source/raster/example" -B "$work/example" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
# Nobody else's code is compiled by our taste.
! grep -E -e '-W|-ffp-contract|-D *GLM_' "$work/example/compile_commands.json" || wrong "flags of ours reach others"
"$cmake" --build "$work/example" >"$work/log" || { cat "$work/log" && exit 1; }
"$work/example/draw_gltf" "$source/assets/figure/signer.glb" "$work/picture.png" || wrong "the example fails"

# Another version than the one asked for is not taken.
mkdir "$work/later"
printf 'cmake_minimum_required(VERSION 3.25)\nproject(later LANGUAGES CXX)\nfind_package(auslan_raster 99 REQUIRED)\n' \
  >"$work/later/CMakeLists.txt"
! (project -S "$work/later" -B "$work/later/build" -DCMAKE_PREFIX_PATH="$prefix") >/dev/null || wrong "version 99 was found"
grep -q 'requested version "99"' "$work/log" || wrong "version 99 is refused for another reason"

cat >"$work/two lines.cpp" <<'CPP'
#include <raster/renderer.h>
int main() { return auslan::raster::Renderer().end_frame({}) == auslan::raster::Status::kNoFrame ? 0 : 1; }
CPP
export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname -- "$(find "$prefix" -name auslan-raster.pc)")
flags=$(pkg-config --cflags --libs auslan-raster)
# pkg-config escapes the blanks in the prefix for a shell.
eval "\"\$compiler\" -std=c++20 \"\$work/two lines.cpp\" $flags -o \"\$work/two lines\""
"$work/two lines" || wrong "the program built with pkg-config fails"

exec "$check" "$source/assets/figure/signer.glb" "$work/picture.png"
