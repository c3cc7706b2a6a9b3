#!/usr/bin/env bash
# Layout and style of all sources by .clang-format, then clang-tidy over the sources with the list in .clang-tidy; installs both if
# they are missing. Ends with 1 if one of them finds something.
# $1...: regular expressions of paths for clang-tidy, such as src/water; all of src, demos and tests by default.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
. "$root/cmake/prepare.sh"

install_missing "${build_packages[@]}" libgtest-dev clang-format clang-tidy

# files GLOB...: those that git knows.
files() { git -C "$root" ls-files -z -- "$@"; }

cd "$root"
files '*.h' '*.cpp' | xargs -0 clang-format --dry-run --Werror
if files 'src/*.h' 'src/*.cpp' 'demos/*.h' 'demos/*.cpp' 'tests/*.h' 'tests/*.cpp' | xargs -0 grep -nE '(^|[^:"])///( |<|$)'; then
  echo "Only the public headers have comments for Doxygen (///); write // here." >&2
  exit 1
fi
# One statement has no braces around it; but GoogleTest's macros need them, so this leaves out the tests. Removing braces lays
# out lambdas in another way, hence the second pass.
without_braces=$(mktemp)
trap 'rm -f "$without_braces"' EXIT
{ echo "RemoveBracesLLVM: true"; cat .clang-format; } > "$without_braces"
braces=0
while IFS= read -r -d '' file; do
  clang-format --style=file:"$without_braces" "$file" | clang-format --assume-filename="$file" | diff -u "$file" - || braces=1
done < <(files 'include/*.h' 'src/*.h' 'src/*.cpp' 'demos/*.h' 'demos/*.cpp')
[ $braces = 0 ] || { echo "Remove the braces around single statements." >&2; exit 1; }

[ $# -gt 0 ] || set -- src demos tests
cmake -S "$root" -B "$root/build-tidy" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DDRENCH_BUILD_TESTS=ON >/dev/null
run-clang-tidy -quiet -p "$root/build-tidy" -j "$(nproc 2>/dev/null || echo 2)" "${@/#/$root/}"
