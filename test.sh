#!/usr/bin/env bash
# Runs setup.sh, then the default tests, or all tests with --full. Other arguments are passed to ctest.
set -euo pipefail
cd "$(dirname "$0")"
targets=(suite) some=(-LE full)
if [ "${1:-}" = --full ]; then
  targets=(all) some=()
  shift
fi
./setup.sh "${targets[@]}"
export VANTAGE_DATASETS="${VANTAGE_DATASETS:-$PWD/../shared/datasets}"
ctest --test-dir build -j "$(nproc)" --output-on-failure "${some[@]}" "$@"
