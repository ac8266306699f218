#!/usr/bin/env bash
# Builds the libFuzzer targets and runs each for a while, two at a time, starting from their corpora:
# fuzz.sh [seconds]. New inputs stay in build/fuzz/found/<target>; a crash leaves crash-* there.
# Ends with "N passed, N failed" (targets).
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
cd "$root" || exit 2
seconds=${1:-60}
bash "$here/setup.sh" build fuzz || exit 2
bash "$here/build.sh" fuzz || { echo "0 passed, 1 failed"; exit 1; }

run_target() {  # name, seconds
  local found=build/fuzz/found/$1
  local corpus=()
  mkdir -p "$found"
  [ -d "tests/fuzz/corpus/$1" ] && corpus=("tests/fuzz/corpus/$1")
  build/fuzz/tests/fuzz/"$1" -max_total_time="$2" -timeout=60 -rss_limit_mb=2048 -max_len=4096 \
    -print_final_stats=1 -artifact_prefix="$found/" "$found" "${corpus[@]}" \
    >"build/fuzz/$1.log" 2>&1
}
export -f run_target

passed=0 failed=0
targets=()
for source in tests/fuzz/*_fuzz.cpp; do targets+=("$(basename "$source" .cpp)"); done
while [ ${#targets[@]} -gt 0 ]; do
  pair=("${targets[@]:0:2}")
  targets=("${targets[@]:2}")
  pids=()
  for target in "${pair[@]}"; do run_target "$target" "$seconds" & pids+=($!); done
  for i in "${!pair[@]}"; do
    if wait "${pids[$i]}"; then passed=$((passed + 1)); state=ok
    else failed=$((failed + 1)); state=FAIL; tail -n 40 "build/fuzz/${pair[$i]}.log"; fi
    runs=$(sed -nE 's/^stat::number_of_executed_units: *//p' "build/fuzz/${pair[$i]}.log")
    echo "$state ${pair[$i]}: ${runs:-?} runs"
  done
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
