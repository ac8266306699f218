#!/usr/bin/env bash
# Everything that needs no data from outside: the release build's tests, and the quick ones again
# with sanitizers and internal assertions. Ends with "N passed, N failed".
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
cd "$root" || exit 2
bash "$here/setup.sh" build test || exit 2
bash "$here/setup.sh" outside || echo "Without these the tests in tests/outside are skipped."
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

bash "$here/build.sh" release -- -DLPQ_TESTS=ON -DLPQ_BENCH=ON || exit 1
run_tests release
bash "$here/build.sh" dev || exit 1
run_tests dev -L 'quick|fuzz'
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
