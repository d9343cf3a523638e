#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the Debian packages scarp needs and this machine lacks; on a set-up machine it does nothing
# and needs no network. usage: cmake/setup.sh [lammps] [--with-ci]; `lammps`: for scarp-lammps too
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

say() { printf 'setup: %s\n' "$*"; }
fail() { printf 'setup: %s\n' "$@" >&2; exit 1; }

lists=("$here/packages.txt")
for argument in "$@"; do
  case $argument in
    lammps) lists+=("$here/packages_lammps.txt") ;;
    --with-ci) lists+=("$here/packages_ci.txt") ;;
    -h | --help) echo "usage: cmake/setup.sh [lammps] [--with-ci]   installs the missing Debian packages"; exit 0 ;;
    *) fail "unknown argument '$argument'; the only ones are lammps, --with-ci and --help" ;;
  esac
done

if [[ ${SCARP_SKIP_SETUP:-} == 1 ]]; then
  say "skipped, as SCARP_SKIP_SETUP=1 asks"
  exit 0
fi

mapfile -t wanted < <(sed 's/#.*//' "${lists[@]}" | tr -s '[:space:]' '\n' | sed '/^$/d')

command -v dpkg-query >/dev/null && command -v apt-get >/dev/null || fail \
  "this is not a Debian machine; install the like of: ${wanted[*]}" \
  "then set SCARP_SKIP_SETUP=1"

# dpkg-query fails as soon as one name is unknown to it: the output counts, not the exit code.
installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null |
  awk '$2 == "installed" { print $1 }') || true
missing=()
for package in "${wanted[@]}"; do
  # Packages of nodejs that are not Debian's hold npm, and Debian's npm does not go with them.
  if [[ $package == npm ]] && command -v npm >/dev/null; then continue; fi
  grep -qxF -- "$package" <<<"$installed" || missing+=("$package")
done

if ((${#missing[@]} == 0)); then
  say "all ${#wanted[@]} packages are installed"
  exit 0
fi
say "missing: ${missing[*]}"

as_root=()
if ((EUID != 0)); then
  if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
    as_root=(sudo -n)
  else
    fail "no right to install them; have an administrator run this line, then start again:" \
      "  apt-get update && apt-get install --yes --no-install-recommends ${missing[*]}"
  fi
fi

apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 \
    -o Acquire::Retries=3 -o Dpkg::Use-Pty=0 "$@" </dev/null
}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
say "updating the package lists"
apt update >"$log" 2>&1 || {
  tail -n 15 "$log" >&2
  fail "apt-get update failed (above); is there a network?"
}
say "installing ${#missing[@]} packages and what they depend on"
apt install --yes --no-install-recommends "${missing[@]}" >"$log" 2>&1 || {
  tail -n 15 "$log" >&2
  fail "apt-get install failed (above); the package names are those of Debian 12"
}
say "done"
