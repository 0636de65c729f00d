#!/usr/bin/env bash
# Sets up, then runs every test.
set -euo pipefail
cd "$(dirname "$0")"
./setup.sh all
export VANTAGE_DATASETS="${VANTAGE_DATASETS:-$PWD/../shared/datasets}"
ctest --test-dir build -j "$(nproc)" --output-on-failure "$@"
