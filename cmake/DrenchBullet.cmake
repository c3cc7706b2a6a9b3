# Finds Bullet with soft bodies, in single or in double precision, as the target drench::bullet. Read when Drench
# is built and, installed beside its package, when an application finds it: both have the same Bullet.

# drench_find_bullet(DOUBLE_PRECISION MISSING): without Bullet, makes no target and says in MISSING what to do.
#
# Bullet's own CMake config file is broken in several distributions, and CMake's module knows the single-precision
# libraries only. pkg-config knows both.
function(drench_find_bullet double_precision missing)
  if(double_precision)
    set(package bullet-float64)
  else()
    set(package bullet)
  endif()
  find_package(PkgConfig QUIET)
  if(PKG_CONFIG_FOUND)
    pkg_check_modules(DRENCH_BULLET QUIET ${package})
  endif()

  if(DRENCH_BULLET_FOUND)
    set(include_directories ${DRENCH_BULLET_INCLUDE_DIRS})
    set(libraries ${DRENCH_BULLET_LINK_LIBRARIES})
  elseif(NOT double_precision)
    find_package(Bullet MODULE QUIET)
    set(include_directories ${BULLET_INCLUDE_DIRS})
    set(libraries ${BULLET_LIBRARIES})
  endif()

  if(libraries)
    add_library(drench::bullet INTERFACE IMPORTED)
    target_include_directories(drench::bullet SYSTEM INTERFACE ${include_directories})
    target_link_libraries(drench::bullet INTERFACE ${libraries})
    if(double_precision)
      target_compile_definitions(drench::bullet INTERFACE BT_USE_DOUBLE_PRECISION)
    endif()
  else()
    set(${missing} "Drench: pkg-config does not find ${package}; install Bullet 3.24 with soft bodies \
(on Debian and Ubuntu libbullet-dev and pkg-config)." PARENT_SCOPE)
  endif()
endfunction()
