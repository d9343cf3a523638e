#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Unpacks the libraries of packages.txt for 64-bit ARM into build/arm64-root, from Debian 12 as this machine reaches it:
# the preset arm64 compiles against them, and runs its tests in them. Nothing of this machine is changed.
# usage: cmake/arm64_root.sh
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../build/arm64-root
list=$(sed 's/#.*//' "$here/packages.txt" | tr -s '[:space:]' '\n' | grep -E '^(lib|nlohmann|zlib).*-dev$' | paste -sd,)

if [[ -f $root/packages && $(<"$root/packages") == "$list" ]]; then
  echo "arm64 root: is there"
  exit 0
fi
rm -rf "$root"
mkdir -p "$(dirname "$root")"
mmdebstrap --quiet --variant=extract --architectures=arm64 --include="libc6-dev,libstdc++-12-dev,libgomp1,$list" bookworm "$root"
echo "$list" >"$root/packages"
echo "arm64 root: $root"
