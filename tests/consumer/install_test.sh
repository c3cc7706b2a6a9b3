#!/usr/bin/env bash
# Installs the library of a build folder ($3, of the sources in $2) with CMake ($1), moves it to a prefix ($4), and looks
# whether it knows where it was made, and shows what is not in its headers.
set -euo pipefail
cmake=$1 sources=$2 build=$3 prefix=$4
rm -rf "$prefix" "$prefix.made"
"$cmake" --install "$build" --component library --prefix "$prefix.made"
mv "$prefix.made" "$prefix"

if grep -rnF -e "$sources" -e "$build" "$prefix" --include='*.cmake' --include='*.pc' --include='*.h'; then
  echo "a file of the package names a place on the machine that built it"
  exit 1
fi

# A shared library says which versions may take its place, and shows of namespace drench what is marked in the headers.
find "$prefix" -name 'libdrench*.so' | while read -r library; do
  readelf -d "$library" | grep -q 'SONAME.*\.so\.[0-9]*\.[0-9]*\]' || { echo "$library has no SONAME"; exit 1; }
  # Of each name the first part that is no namespace.
  nm -DC --defined-only "$library" | sed -nE 's/.* [TBDR] drench::([a-z_0-9]+::)*([A-Za-z]+).*/\2/p' | sort -u |
    while read -r name; do
      grep -rqE "DRENCH_API [^;]*\b$name\b" "$prefix/include/drench" || {
        echo "$library shows drench::$name, which is no public name"
        exit 1
      }
    done
done

# An application may have its own builds of the header-only libraries that are compiled into these: neither kind of library
# defines a name of theirs that others see.
find "$prefix" -name 'libdrench*.so' -o -name 'libdrench*.a' | while read -r library; do
  visible=--extern-only
  [ "${library##*.}" = a ] || visible=--dynamic
  if nm -C --defined-only $visible "$library" |
    grep -E '(^|[^_[:alnum:]])((tinyobj|tinygltf|nlohmann|dlib)::|stbi_|XXH)'; then
    echo "$library defines a name of another library"
    exit 1
  fi
done
