#!/usr/bin/env bash
# Builds the playground from dist/ into build/web: static files for any folder of any server.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
if ! node -e 'const [a, b] = process.versions.node.split(".").map(Number); process.exit(a > 20 || (a === 20 && b >= 19) ? 0 : 1)'; then
  echo "The playground is built with Node 20.19 or newer; this is $(node --version)." >&2
  exit 2
fi
[ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --no-audit --no-fund --prefer-offline >/dev/null
node_modules/.bin/vite build -c web/vite.config.js --logLevel warn
