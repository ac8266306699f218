#!/usr/bin/env bash
# Builds both WebAssembly presets and puts the npm package together in dist/.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/.." && pwd)
tools=$root/tests/tools
bash "$tools/setup.sh" build wasm
# Where Debian's compiler finds its JavaScript optimiser, whichever node is first on the path.
export NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}
pch=-DLPQ_PCH=${LPQ_PCH:-OFF}
for preset in wasm wasm-plain; do bash "$tools/build.sh" "$preset" -- "$pch" | tail -n 1; done
node "$here/package.mjs"
node "$here/types.mjs" "$@"
