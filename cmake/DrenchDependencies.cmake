# The packages that Drench stands on. Each is a system package; nothing is downloaded.
find_package(Eigen3 3.3 REQUIRED NO_MODULE)

# Bullet's own CMake config file is broken in several distributions, and find_package's module knows the
# single-precision libraries only. pkg-config knows both.
find_package(PkgConfig REQUIRED)
if(DRENCH_DOUBLE_PRECISION)
  set(DRENCH_BULLET_PACKAGE bullet-float64)
else()
  set(DRENCH_BULLET_PACKAGE bullet)
endif()
pkg_check_modules(DRENCH_BULLET ${DRENCH_BULLET_PACKAGE})

add_library(drench_bullet INTERFACE)
if(DRENCH_BULLET_FOUND)
  target_include_directories(drench_bullet SYSTEM INTERFACE ${DRENCH_BULLET_INCLUDE_DIRS})
  target_link_libraries(drench_bullet INTERFACE ${DRENCH_BULLET_LINK_LIBRARIES})
elseif(NOT DRENCH_DOUBLE_PRECISION)
  find_package(Bullet MODULE REQUIRED)
  target_include_directories(drench_bullet SYSTEM INTERFACE ${BULLET_INCLUDE_DIRS})
  target_link_libraries(drench_bullet INTERFACE ${BULLET_LIBRARIES})
else()
  message(FATAL_ERROR "Drench: double-precision Bullet was asked for, but pkg-config does not find bullet-float64. "
                      "Install libbullet-dev, or set -DDRENCH_DOUBLE_PRECISION=OFF.")
endif()
if(DRENCH_DOUBLE_PRECISION)
  target_compile_definitions(drench_bullet INTERFACE BT_USE_DOUBLE_PRECISION)
endif()

# Reads pictures: masks for soaking.
pkg_check_modules(DRENCH_STB REQUIRED IMPORTED_TARGET stb)

# Read and write the files of drench::files.
if(DRENCH_BUILD_FILES OR DRENCH_BUILD_DEMOS OR DRENCH_BUILD_TESTS)
  find_package(nlohmann_json REQUIRED)
endif()
if(DRENCH_BUILD_FILES)
  pkg_check_modules(DRENCH_TINYGLTF IMPORTED_TARGET tinygltf)
  pkg_check_modules(DRENCH_TINYOBJLOADER IMPORTED_TARGET tinyobjloader_double)
  if(NOT DRENCH_TINYGLTF_FOUND OR NOT DRENCH_TINYOBJLOADER_FOUND)
    message(FATAL_ERROR "Drench: drench::files needs tinygltf and tinyobjloader (of doubles), which pkg-config does not "
                        "find. Install libtinygltf-dev and libtinyobjloader-dev, or set -DDRENCH_BUILD_FILES=OFF, with "
                        "the demos and tests off as well.")
  endif()
  # Its pkg-config file leaves out the definition that the header wants of whoever links the library of doubles.
  target_compile_definitions(PkgConfig::DRENCH_TINYOBJLOADER INTERFACE TINYOBJLOADER_USE_DOUBLE)
elseif(DRENCH_BUILD_DEMOS OR DRENCH_BUILD_TESTS)
  message(FATAL_ERROR "Drench: drench-demo and the tests need drench::files; leave DRENCH_BUILD_FILES on, or turn "
                      "DRENCH_BUILD_DEMOS and DRENCH_BUILD_TESTS off as well.")
endif()
