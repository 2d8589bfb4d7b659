# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# What the scripts share; sourced, never run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$(basename "$0")
readonly root program

# say WORDS...: one progress line, apart from the output of the tools.
say() { printf '%s: %s\n' "$program" "$*" >&2; }

# die MESSAGE [SUGGESTED FIX]: ends the script with status 1.
die() {
  printf '%s: error: %s\n' "$program" "$1" >&2
  if [ $# -gt 1 ]; then printf '%s: hint: %s\n' "$program" "$2" >&2; fi
  exit 1
}

# print_help: the comment at the top of the script, below the licence lines.
print_help() { awk 'NR > 3 { if (!/^#/) exit; sub(/^# ?/, ""); print }' "$0"; }

# help_only ARGUMENTS...: for scripts that take no argument but --help.
help_only() {
  case ${1:-} in
    '') return ;;
    -h | --help) print_help && exit 0 ;;
    *) die "unknown argument '$1'" "$program --help" ;;
  esac
}

# as_root COMMAND...: runs COMMAND as root, by sudo where we are not.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo -- "$@"
  else
    die "this needs root, and there is no sudo: $*" "run scripts/setup once as root"
  fi
}

# configure_release: cmake's preset release in build/, which uses ccache where there is one.
configure_release() {
  say "configuring"
  cmake --preset release
}
