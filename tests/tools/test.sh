#!/usr/bin/env bash
# Everything that needs no data from outside: the release build's tests, the quick ones again with
# sanitizers and internal assertions, the npm package, and the playground. Ends with "N passed, N failed".
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
cd "$root" || exit 2
bash "$here/setup.sh" build test || exit 2
bash "$here/setup.sh" outside || echo "Without these the tests in tests/outside are skipped."
wasm=yes
bash "$here/setup.sh" wasm || { wasm=no; echo "SKIPPED: the npm package, for want of these."; }
web=$wasm
bash "$here/setup.sh" web || { web=no; echo "SKIPPED: the playground, for want of this."; }
bash "$here/setup.sh" browser || echo "Without these the package is not tried in browsers."
jobs=$(nproc 2>/dev/null || echo 2)
passed=0 failed=0

# Runs ctest in a build folder and adds its counts.
run_tests() {  # preset, ctest options
  local preset=$1 log=build/$1/ctest.log; shift
  ctest --test-dir "build/$preset" -j "$jobs" --output-on-failure --timeout 600 "$@" >"$log" 2>&1
  local status=$?
  local summary bad total
  summary=$(grep -E '^[0-9]+% tests passed' "$log" | tail -n 1)
  bad=$(sed -nE 's/.* ([0-9]+) tests? failed out of ([0-9]+).*/\1/p' <<<"$summary")
  total=$(sed -nE 's/.* ([0-9]+) tests? failed out of ([0-9]+).*/\2/p' <<<"$summary")
  if [ -z "$total" ]; then
    cat "$log"; failed=$((failed + 1)); return 1
  fi
  passed=$((passed + total - bad)) failed=$((failed + bad))
  echo "$preset: $((total - bad)) passed, $bad failed"
  [ "$bad" -eq 0 ] || sed -n '/The following tests FAILED/,$p;/\*\*\*/p' "$log"
  [ "$bad" -eq 0 ] || grep -B2 -A25 'FAILED:' "$log" | head -n 200
  return $status
}

# Installs what a lock file names, unless that was done.
install_tools() {  # folder
  [ "$1/node_modules/.package-lock.json" -nt "$1/package-lock.json" ] ||
    (cd "$1" && npm ci --no-audit --no-fund --prefer-offline >/dev/null)
}

# Adds the counts of a log's last "N passed, N failed"; a missing line is a failure.
add_counts() {  # what, log
  local line
  line=$(grep -oE '[0-9]+ passed, [0-9]+ failed' "$2" | tail -n 1)
  line=${line:-0 passed, 1 failed}
  echo "$1: $line"
  grep -A 30 -E '^(FAIL|not ok|SKIPPED:)|# SKIP' "$2" | head -n 200
  passed=$((passed + ${line%% passed*}))
  line=${line#*, }
  failed=$((failed + ${line%% failed*}))
}

# "N passed, N failed" from the end of a log of Node's test runner; what it cancelled has failed.
count_node_tests() {  # log
  awk '/^# pass / { passed = $3; ended = 1 } /^# (fail|cancelled) / { failed += $3 }
       END { if (ended) print passed " passed, " failed " failed" }' "$1"
}

test_package() {
  local log=build/wasm.log
  bash wasm/build.sh >"$log" 2>&1 && install_tools . && install_tools tests/package || {
    cat "$log"; failed=$((failed + 1)); return; }
  node --test --test-reporter=tap tests/wasm/*.test.mjs >"$log" 2>&1
  count_node_tests "$log" >>"$log"
  add_counts "tests/wasm" "$log"
  node tests/package/matrix.mjs >build/matrix.log 2>&1
  add_counts "tests/package" build/matrix.log
}

# The playground: its types, its build, and the page in real browsers, two files at a time.
test_web() {
  local log=build/web.log
  { node_modules/.bin/tsc -p web/tsconfig.json && bash web/build.sh; } >"$log" 2>&1 || {
    cat "$log"; failed=$((failed + 1)); return; }
  node --test --test-concurrency=2 --test-reporter=tap tests/web/*.test.mjs >"$log" 2>&1
  count_node_tests "$log" >>"$log"
  add_counts "tests/web" "$log"
}

pch=-DLPQ_PCH=${LPQ_PCH:-OFF}
bash "$here/build.sh" release -- -DLPQ_TESTS=ON -DLPQ_BENCH=ON "$pch" || exit 1
run_tests release
# LPQ_SANITIZED=fuzz: with clang, in the tree that fuzzing needs anyway.
sanitized=${LPQ_SANITIZED:-dev}
bash "$here/build.sh" "$sanitized" -- -DLPQ_TESTS=ON "$pch" || exit 1
run_tests "$sanitized" -L 'quick|fuzz'
[ $wasm = no ] || test_package
[ $web = no ] || test_web
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
