# SPDX-License-Identifier: BSD-3-Clause
# What tests/run, validation/run and .ci/run share; to be sourced by bash.
# SCARP_CMAKE_ARGS: more arguments for every configure. SCARP_JOBS: compilers, and tests, at once.
set -euo pipefail
scarp_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

scarp_say() { printf '== %s\n' "$*"; }

scarp_jobs() { echo "${SCARP_JOBS:-$(nproc)}"; }

# scarp_configure PRESET [cmake arguments]
scarp_configure() {
  local preset=$1 words
  shift
  read -ra words <<<"${SCARP_CMAKE_ARGS:-}"
  scarp_say "configuring the preset $preset in build/$preset"
  (cd "$scarp_root" && cmake --preset "$preset" "${words[@]}" "$@")
}

# scarp_build PRESET [targets]: all of them if none is named.
scarp_build() {
  local preset=$1 targets=()
  shift
  if (($#)); then targets=(--target "$@"); fi
  scarp_say "building ${*:-everything} with $(scarp_jobs) compilers"
  (cd "$scarp_root" && cmake --build --preset "$preset" --parallel "$(scarp_jobs)" "${targets[@]}")
}

# scarp_test PRESET [ctest arguments]
scarp_test() {
  local preset=$1
  shift
  scarp_say "running the tests of the preset $preset"
  (cd "$scarp_root" && ctest --preset "$preset" --parallel "$(scarp_jobs)" "$@")
}
