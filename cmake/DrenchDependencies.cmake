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

# The checksum of snapshots, and pictures: masks for soaking. As those for files below, these are only headers, which are
# compiled into the library under names of its own: whoever links with it need not have them, and may have others.
find_path(DRENCH_XXHASH_INCLUDE xxhash.h REQUIRED)
find_path(DRENCH_STB_INCLUDE stb_image.h PATH_SUFFIXES stb REQUIRED)

# Read and write the files of drench::files.
if(DRENCH_BUILD_FILES)
  find_package(nlohmann_json REQUIRED)
  find_path(DRENCH_TINYGLTF_INCLUDE tiny_gltf.h)
  find_path(DRENCH_TINYOBJLOADER_INCLUDE tiny_obj_loader.h)
  if(NOT DRENCH_TINYGLTF_INCLUDE OR NOT DRENCH_TINYOBJLOADER_INCLUDE)
    message(FATAL_ERROR "Drench: drench::files needs tiny_gltf.h and tiny_obj_loader.h, which are not found. Install "
                        "libtinygltf-dev and libtinyobjloader-dev, or set -DDRENCH_BUILD_FILES=OFF and "
                        "-DDRENCH_BUILD_DEMOS=OFF.")
  endif()
elseif(DRENCH_BUILD_DEMOS)
  message(FATAL_ERROR "Drench: drench-demo needs drench::files; leave DRENCH_BUILD_FILES on, or set "
                      "-DDRENCH_BUILD_DEMOS=OFF as well.")
endif()
