# The packages that Drench stands on. Each is a system package; nothing is downloaded. What the library's users
# link with, too, is global, so that a project which adds this one by add_subdirectory knows it.
if(NOT TARGET Eigen3::Eigen)
  find_package(Eigen3 3.3 REQUIRED NO_MODULE)
  set_target_properties(Eigen3::Eigen PROPERTIES IMPORTED_GLOBAL TRUE)
endif()

include(DrenchBullet)
drench_find_bullet(${DRENCH_DOUBLE_PRECISION} drench_bullet_missing)
if(NOT TARGET drench::bullet)
  message(FATAL_ERROR "${drench_bullet_missing}")
endif()
set_target_properties(drench::bullet PROPERTIES IMPORTED_GLOBAL TRUE)

# Reads pictures: masks for soaking.
find_package(PkgConfig REQUIRED)
pkg_check_modules(DRENCH_STB REQUIRED IMPORTED_TARGET GLOBAL stb)

# Read and write the files of drench::files.
if(DRENCH_BUILD_FILES)
  find_package(nlohmann_json REQUIRED)
  pkg_check_modules(DRENCH_TINYGLTF IMPORTED_TARGET GLOBAL tinygltf)
  pkg_check_modules(DRENCH_TINYOBJLOADER IMPORTED_TARGET GLOBAL tinyobjloader_double)
  if(NOT DRENCH_TINYGLTF_FOUND OR NOT DRENCH_TINYOBJLOADER_FOUND)
    message(FATAL_ERROR "Drench: drench::files needs tinygltf and tinyobjloader (of doubles), which pkg-config does not "
                        "find. Install libtinygltf-dev and libtinyobjloader-dev, or set -DDRENCH_BUILD_FILES=OFF and "
                        "-DDRENCH_BUILD_DEMOS=OFF.")
  endif()
  # Its pkg-config file leaves out the definition that the header wants of whoever links the library of doubles.
  target_compile_definitions(PkgConfig::DRENCH_TINYOBJLOADER INTERFACE TINYOBJLOADER_USE_DOUBLE)
elseif(DRENCH_BUILD_DEMOS)
  message(FATAL_ERROR "Drench: drench-demo needs drench::files; leave DRENCH_BUILD_FILES on, or set "
                      "-DDRENCH_BUILD_DEMOS=OFF as well.")
endif()
