#!/usr/bin/env bash
# Configures and builds one preset: build.sh release|dev|fuzz [target...] [-- cmake options]
set -euo pipefail
cd "$(dirname "$0")/../.."
preset=$1; shift
targets=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do targets+=("$1"); shift; done
[ $# -gt 0 ] && shift
options=("$@")
if command -v ccache >/dev/null 2>&1; then
  options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  # What one checkout compiled serves another, precompiled headers included.
  export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$PWD} CCACHE_NOHASHDIR=${CCACHE_NOHASHDIR:-1}
  export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
fi
mkdir -p build
cmake --preset "$preset" "${options[@]}" >"build/configure-$preset.log" 2>&1 || {
  cat "build/configure-$preset.log" >&2; exit 2; }
build=(cmake --build "build/$preset")
[ ${#targets[@]} -gt 0 ] && build+=(--target "${targets[@]}")
"${build[@]}"
