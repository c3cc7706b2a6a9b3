# What `cmake --install` leaves behind: headers, the library, and the package files by which CMake and pkg-config
# find it. Nothing in them names a place on the machine that built it, so the prefix may be moved.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# `cmake --install FOLDER --component library` leaves the demo out.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME library)
set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/${DRENCH_PACKAGE})

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/drench DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
set(libraries drench)
if(BUILD_SHARED_LIBS)
  list(APPEND libraries drench_static)
endif()
install(TARGETS ${libraries} EXPORT ${DRENCH_PACKAGE}-targets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT ${DRENCH_PACKAGE}-targets NAMESPACE drench:: DESTINATION ${package_directory})

# The library of files, apart: who does not use it needs nothing that it stands on.
if(DRENCH_BUILD_FILES)
  set(libraries drench_files)
  if(BUILD_SHARED_LIBS)
    list(APPEND libraries drench_files_static)
  endif()
  install(TARGETS ${libraries} EXPORT ${DRENCH_PACKAGE}-files-targets)
  install(EXPORT ${DRENCH_PACKAGE}-files-targets NAMESPACE drench:: DESTINATION ${package_directory})
endif()

# For CMake.
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/drench-config.cmake.in ${DRENCH_PACKAGE}-config.cmake
  INSTALL_DESTINATION ${package_directory} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# Before 1.0 each minor version may change what is there.
write_basic_package_version_file(${DRENCH_PACKAGE}-config-version.cmake COMPATIBILITY SameMinorVersion)
install(
  FILES ${CMAKE_CURRENT_BINARY_DIR}/${DRENCH_PACKAGE}-config.cmake
        ${CMAKE_CURRENT_BINARY_DIR}/${DRENCH_PACKAGE}-config-version.cmake
        ${CMAKE_CURRENT_LIST_DIR}/DrenchBullet.cmake
  DESTINATION ${package_directory})

# For pkg-config.
file(RELATIVE_PATH DRENCH_INCLUDES_FROM_PC ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR})
if(DRENCH_DOUBLE_PRECISION)
  set(DRENCH_PC_REQUIRES "bullet-float64, eigen3")
else()
  set(DRENCH_PC_REQUIRES "bullet, eigen3")
endif()
set(DRENCH_PC_DEFINITIONS "")
if(BUILD_SHARED_LIBS)
  set(DRENCH_PC_DEFINITIONS " -DDRENCH_SHARED")
endif()
set(packages ${DRENCH_PACKAGE})
configure_file(${CMAKE_CURRENT_LIST_DIR}/drench.pc.in ${DRENCH_PACKAGE}.pc @ONLY)
if(DRENCH_BUILD_FILES)
  list(APPEND packages ${DRENCH_PACKAGE}-files)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/drench-files.pc.in ${DRENCH_PACKAGE}-files.pc @ONLY)
endif()
foreach(package ${packages})
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${package}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
