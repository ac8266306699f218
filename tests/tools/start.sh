#!/usr/bin/env bash
# Builds everything the playground needs, and serves it: the first thing to see after cloning.
# usage: start.sh [--port N] [--once]   (--once: ends when the page was served)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
bash "$here/setup.sh" web  # before the long build, not after it
bash "$root/wasm/build.sh"
bash "$root/web/build.sh"
exec node "$root/web/serve.mjs" "$@"
