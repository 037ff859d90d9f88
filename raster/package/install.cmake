# SPDX-License-Identifier: Apache-2.0
# What others get, component raster: the headers, the static library, find_package(auslan_raster) with the target
# auslan::raster, and auslan-raster.pc. All of it finds itself by its own place, so that a prefix can be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(_include ${CMAKE_INSTALL_INCLUDEDIR}/auslan)
set(_cmake ${CMAKE_INSTALL_LIBDIR}/cmake/auslan_raster)
set(_made ${CMAKE_CURRENT_BINARY_DIR}/package)

install(TARGETS auslan_raster EXPORT auslan_raster
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT raster
  FILE_SET HEADERS DESTINATION ${_include} COMPONENT raster)
install(EXPORT auslan_raster FILE auslan_raster-targets.cmake NAMESPACE auslan:: DESTINATION ${_cmake} COMPONENT raster)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/auslan_raster-config.cmake.in ${_made}/auslan_raster-config.cmake
  INSTALL_DESTINATION ${_cmake} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${_made}/auslan_raster-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${_made}/auslan_raster-config.cmake ${_made}/auslan_raster-config-version.cmake
  DESTINATION ${_cmake} COMPONENT raster)

# The way from the folder of the .pc file to the prefix; an absolute library folder has none.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(_prefix "${CMAKE_INSTALL_PREFIX}")
else()
  file(RELATIVE_PATH _prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  string(REGEX REPLACE "/+$" "" _prefix "\${pcfiledir}/${_prefix}")
endif()
cmake_path(APPEND _pc_library "\${prefix}" "${CMAKE_INSTALL_LIBDIR}")
cmake_path(APPEND _pc_include "\${prefix}" "${_include}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/auslan-raster.pc.in ${_made}/auslan-raster.pc @ONLY)
install(FILES ${_made}/auslan-raster.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT raster)

install(FILES ${CMAKE_CURRENT_LIST_DIR}/../README.md ${CMAKE_CURRENT_LIST_DIR}/../../LICENSE
  DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/auslan_raster COMPONENT raster)
