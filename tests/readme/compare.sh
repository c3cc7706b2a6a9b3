#!/usr/bin/env bash
# Whether the C++ block of a README ($1) is, line for line, a source file ($2).
diff <(sed -n '/^```cpp$/,/^```$/p' "$1" | sed '1d;$d') "$2"
