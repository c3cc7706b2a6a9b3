
# A static library leaves it to its users to link what it calls.
find_dependency(PkgConfig)
pkg_check_modules(DRENCH_STB QUIET IMPORTED_TARGET stb)
if(NOT DRENCH_STB_FOUND)
  set(${CMAKE_FIND_PACKAGE_NAME}_FOUND FALSE)
  set(${CMAKE_FIND_PACKAGE_NAME}_NOT_FOUND_MESSAGE
    "Drench: pkg-config does not find stb; install it (on Debian and Ubuntu libstb-dev).")
  return()
endif()
