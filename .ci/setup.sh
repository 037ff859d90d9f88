# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Installs the missing packages and builds what has changed. Sourced by ./auslanjam and tests/run, which set `root`, the
# top of the checkout, and run under `set -u -o pipefail`. Says everything on stderr; what tools print goes to `log`.

log=${root:?the script that sources this sets it}/.build/setup.log

say() { printf 'auslanjam: %s\n' "$*" >&2; }
die() {
  say "$@"
  exit 1
}

# One set-up at a time in a checkout: a second start waits for the first and then finds its work done.
lock_setup() {
  if ! mkdir -p "$root/.build" 2>/dev/null || ! [[ -w $root/.build ]]; then
    die "cannot write to $root/.build: make the checkout writable, or start from a copy of your own"
  fi
  exec {setup_lock}>"$root/.build/setup.lock"
  if ! flock --nonblock "$setup_lock"; then
    say "waiting for another start that is setting up this checkout"
    flock "$setup_lock"
  fi
  : >"$log"
}
unlock_setup() { exec {setup_lock}>&-; }

# Keeps the last line of a long command in view on a terminal.
show_progress() {
  local line
  while IFS= read -r line; do printf '\r\033[K  %.100s' "$line" >&2; done
  printf '\r\033[K' >&2
}

# run_logged COMMAND...: with the output in the log; the file descriptor of the lock stays with us, so that a program
# left running in the background by a tool cannot hold it.
run_logged() {
  printf '\n$ %s\n' "$*" >>"$log"
  if [[ -t 2 && ${TERM:-dumb} != dumb ]]; then
    "$@" </dev/null 2>&1 {setup_lock}>&- | tee -a "$log" {setup_lock}>&- | show_progress
  else
    "$@" </dev/null >>"$log" 2>&1 {setup_lock}>&-
  fi
}

# fail_with_log MESSAGE: the end of the log, then what to do.
fail_with_log() {
  tail -n "${AUSLANJAM_LOG_LINES:-25}" "$log" >&2
  say "$@"
  die "the whole log: $log"
}

# packages_of GROUP...: the names listed under these groups of .ci/packages.
packages_of() {
  local name rest group=
  while read -r name rest; do
    case $name in
      '' | '#'*) ;;
      '['*) group=${name//[\[\]]/} ;;
      *) [[ " $* " == *" $group "* ]] && printf '%s\n' "$name" ;;
    esac
  done <"$root/.ci/packages"
}

missing_of() {
  local -A installed=()
  local status name wanted
  mapfile -t wanted < <(packages_of "$@")
  while read -r status name; do
    [[ $status == ?i ]] && installed[$name]=yes
  done < <(dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' "${wanted[@]}" 2>/dev/null)
  for name in "${wanted[@]}"; do [[ -n ${installed[$name]:-} ]] || printf '%s\n' "$name"; done
}

# ensure_packages GROUP...: installs what is missing; asks apt for new lists only when it cannot do with the old ones.
ensure_packages() {
  local missing as_root=() install
  mapfile -t missing < <(missing_of "$@")
  ((${#missing[@]})) || return 0
  install="apt-get install --yes --no-install-recommends ${missing[*]}"

  if [[ -n ${AUSLANJAM_NO_INSTALL:-} ]]; then
    say "AUSLANJAM_NO_INSTALL is set, so these packages stay missing: ${missing[*]}"
    return 0
  fi
  if ! command -v apt-get >/dev/null; then
    die "this system has no apt-get. Install what these Debian packages hold: ${missing[*]};" \
      "then set AUSLANJAM_NO_INSTALL=1 and start again"
  fi
  if ((EUID != 0)); then
    if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
      as_root=(sudo -n)
    elif command -v sudo >/dev/null && { : </dev/tty; } 2>/dev/null; then
      say "sudo may ask for your password: packages are to be installed"
      sudo -v || die "sudo refused. As root run: apt-get update && $install"
      as_root=(sudo)
    else
      die "packages are missing, and neither root nor sudo is at hand. As root run: apt-get update && $install"
    fi
  fi

  say "installing ${#missing[@]} packages and what they need (only once)"
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600)
  run_logged "${apt[@]}" install --yes --no-install-recommends "${missing[@]}" && return 0
  run_logged "${apt[@]}" update
  run_logged "${apt[@]}" install --yes --no-install-recommends "${missing[@]}" && return 0
  fail_with_log "installing packages failed. Check the network and the disk, then start again, or as root run:" \
    "apt-get update && $install"
}

# configure PRESET [FOLDER [cmake argument...]]: in .build/FOLDER, when it has not been done or its settings changed.
# A build folder that was moved here holds the paths of another place and is made anew.
configure() {
  local folder=$root/.build/${2:-$1} settings="$*"
  if [[ -f $folder/CMakeCache.txt ]] &&
    ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    rm -rf "$folder"
  fi
  if [[ -f $folder/build.ninja && -f $folder/configured && $(<"$folder/configured") == "$settings" &&
    ! $root/CMakePresets.json -nt $folder/configured && ! $root/.ci/packages -nt $folder/configured ]]; then
    return 0
  fi
  (cd "$root" && run_logged cmake --preset "$1" -B "$folder" "${@:3}") || return 1
  printf '%s\n' "$settings" >"$folder/configured"
}

# build FOLDER [TARGET...]: in .build/FOLDER; ninja decides what has changed.
build() {
  run_logged cmake --build "$root/.build/$1" ${2:+--target "${@:2}"}
}
