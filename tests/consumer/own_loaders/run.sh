#!/usr/bin/env bash
# Runs the application of a build folder with either kind of library.
set -euo pipefail
"$1/with_files" "$1"
"$1/with_files_static" "$1"
