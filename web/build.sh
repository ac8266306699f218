#!/usr/bin/env bash
# Builds the playground from dist/ into build/web: static files for any folder of any server.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
bash tests/tools/setup.sh web
[ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --no-audit --no-fund --prefer-offline >/dev/null
node_modules/.bin/vite build -c web/vite.config.js --logLevel warn
