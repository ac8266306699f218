#!/usr/bin/env bash
# Builds the command line and meshes a real outline.
# usage: demo.sh [DOMAIN.json [options of lpquad mesh]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
bash "$here/setup.sh" build
bash "$here/build.sh" release lpquad_command -- -DLPQ_TESTS=OFF -DLPQ_BENCH=OFF | tail -n 1

domain=${1:-$root/tests/fixtures/domains/south_africa.json}
[ $# -gt 0 ] && shift
name=$(basename "$domain" .json)
out=$root/out
"$root/build/release/bin/lpquad" mesh "$domain" -o "$out/$name.msh" --svg "$out/$name.svg" \
  --report "$out/$name.report.json" "$@"
echo
echo "mesh     out/$name.msh   (Gmsh 4.1; other endings: .obj .vtu .json)"
echo "picture  out/$name.svg"
