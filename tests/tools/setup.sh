#!/usr/bin/env bash
# Makes sure the named commands and headers are there, installing Debian packages where it may.
# usage: setup.sh build|test|outside|wasm|web|browser|clang|fuzz|referee...   (each adds its needs)
# Exit 2 with the exact packages when something is missing that it cannot install.
set -euo pipefail

missing=()
need_command() { command -v "$1" >/dev/null 2>&1 || missing+=("$2"); }
need_file() {  # package, then candidates: present if any of them exists
  local package=$1 candidate; shift
  for candidate in "$@"; do if compgen -G "$candidate" >/dev/null; then return; fi; done
  missing+=("$package")
}

for part in "$@"; do
  case $part in
    build)
      need_command g++ g++
      need_command cmake cmake
      need_command ninja ninja-build
      need_file libeigen3-dev '/usr/include/eigen3/Eigen/Core' '/usr/local/include/eigen3/Eigen/Core' \
        '/opt/homebrew/include/eigen3/Eigen/Core'
      need_file nlohmann-json3-dev '/usr/include/nlohmann/json.hpp' \
        '/usr/local/include/nlohmann/json.hpp' '/opt/homebrew/include/nlohmann/json.hpp' ;;
    test)
      need_file catch2 '/usr/include/catch2/catch*.hpp' '/usr/local/include/catch2/catch*.hpp' \
        '/opt/homebrew/include/catch2/catch*.hpp'
      need_file liblemon-dev '/usr/include/lemon/matching.h' '/usr/local/include/lemon/matching.h' ;;
    outside)  # programs that read our files back
      need_command gmsh gmsh
      need_command ccx calculix-ccx
      need_command python3 python3
      /usr/bin/python3 -c 'import meshio' 2>/dev/null || missing+=(python3-meshio) ;;
    wasm)
      need_command em++ emscripten
      need_command node nodejs
      need_command npm npm ;;
    web)  # no package: Debian 12 has Node 18
      node -e 'const [a, b] = process.versions.node.split(".").map(Number); process.exit(a > 20 || (a === 20 && b >= 19) ? 0 : 1)' 2>/dev/null || {
        echo "The playground is built with Node 20.19 or newer; this is $(node --version 2>/dev/null || echo 'a system without Node')." >&2
        exit 2; } ;;
    browser)
      need_command chromium chromium
      need_command firefox-esr firefox-esr ;;
    clang) need_command clang++ clang ;;
    fuzz)
      need_command clang++ clang
      need_file libclang-rt-14-dev '/usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.fuzzer-*.a' \
        '/usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.fuzzer_no_main-*.a' ;;
    referee)
      need_command python3 python3
      /usr/bin/python3 -c 'import numpy' 2>/dev/null || missing+=(python3-numpy) ;;
    *) echo "setup.sh: unknown part '$part'" >&2; exit 2 ;;
  esac
done
[ ${#missing[@]} -eq 0 ] && exit 0

if ! command -v apt-get >/dev/null 2>&1; then
  echo "Missing: ${missing[*]} (names of Debian packages)." >&2
  echo "Install them with your package manager, on macOS for instance:" >&2
  echo "  brew install cmake ninja eigen nlohmann-json catch2" >&2
  exit 2
fi
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null 2>&1; then
    echo "Missing packages. As root, run:  apt-get install ${missing[*]}" >&2
    exit 2
  fi
  as_root=(sudo)
fi
echo "Installing: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
install() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" >/dev/null; }
"${as_root[@]}" apt-get update -q >/dev/null || true
if ! install; then
  echo "The installation failed. As root, run:  apt-get install ${missing[*]}" >&2
  exit 2
fi
