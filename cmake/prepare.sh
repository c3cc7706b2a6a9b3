# Sourced by demos/run.sh and tests/run.sh: installs what is missing, configures and builds.
# Knows Debian and Ubuntu; elsewhere the README's plain CMake lines do the same.

# install_missing PACKAGE...: through apt-get, as root or with sudo; else says what to run and stops.
install_missing() {
  command -v dpkg-query >/dev/null 2>&1 || return 0
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null 2>&1 && { sudo -n true 2>/dev/null || [ -t 0 ]; }; then
      as_root=(sudo)
    else
      echo "Some packages are missing. As root, run" >&2
      echo "  apt-get update && apt-get install -y --no-install-recommends ${missing[*]}" >&2
      echo "and then this script again." >&2
      exit 3
    fi
  fi
  echo "installing ${missing[*]}" >&2
  "${as_root[@]}" apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# build_in FOLDER TARGET [CMAKE-OPTION...]: configures once and whenever options change, then builds several sources at a
# time, and through ccache where it is installed.
build_in() {
  local folder=$1 target=$2
  shift 2
  local options=(-DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON)
  # A build folder keeps the generator that it was made with.
  if [ ! -e "$folder/CMakeCache.txt" ] && command -v ninja >/dev/null 2>&1; then options+=(-G Ninja); fi
  if command -v ccache >/dev/null 2>&1; then options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  local log="$folder/configure.log"
  mkdir -p "$folder"
  if ! cmake -S "$root" -B "$folder" "${options[@]}" "$@" >"$log" 2>&1; then
    cat "$log" >&2
    exit 4
  fi
  cmake --build "$folder" --target "$target" --parallel "$(nproc 2>/dev/null || echo 2)" >&2 || exit 4
}

build_packages=(g++ make cmake ninja-build pkg-config libbullet-dev libeigen3-dev libglfw3-dev libepoxy-dev
  libegl-dev libgl-dev libimgui-dev libstb-dev libxxhash-dev libtinygltf-dev libtinyobjloader-dev libcli11-dev
  nlohmann-json3-dev)
# What a picture needs at run time: Mesa's drivers for windows and for no window, and a font for captions.
picture_packages=(libegl1 libgl1 libegl-mesa0 libgl1-mesa-dri fonts-dejavu-core)
