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

# The checksum of snapshots; only its header.
find_path(DRENCH_XXHASH_INCLUDE xxhash.h REQUIRED)

# Reads pictures: masks for soaking.
find_package(PkgConfig REQUIRED)
pkg_check_modules(DRENCH_STB REQUIRED IMPORTED_TARGET GLOBAL stb)
