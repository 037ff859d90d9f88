# SPDX-License-Identifier: Apache-2.0
# What is tested of the rasteriser's lane types and of raster as a package for others.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set(_lanes unit/raster_lanes_sse2.cpp unit/raster_lanes_avx2.cpp)
  set_source_files_properties(unit/raster_lanes_avx2.cpp PROPERTIES COMPILE_OPTIONS -mavx2)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  set(_lanes unit/raster_lanes_neon.cpp)
endif()
auslan_test(raster_lanes LABEL unit SOURCES unit/raster_lanes_test.cpp ${_lanes} LIBRARIES auslan::raster)
target_include_directories(raster_lanes_test PRIVATE ${PROJECT_SOURCE_DIR}/raster/src)

# Needs the readers of glTF and of pictures, to draw by itself what the example draws with the installed library.
if(TARGET auslan::gltf AND TARGET auslan::picture)
  add_executable(raster_package_check unit/raster_package_check.cpp)
  target_link_libraries(raster_package_check PRIVATE auslan::standard auslan::gltf auslan::picture auslan::raster)
  add_dependencies(tests_unit raster_package_check auslan_raster)
  add_test(NAME raster.package COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/unit/raster_package.sh
    $<TARGET_FILE:raster_package_check> ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}
    ${CMAKE_COMMAND} ${CMAKE_CXX_COMPILER} ${CMAKE_GENERATOR}
    -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} -DAUSLANJAM_WERROR=${AUSLANJAM_WERROR})
  set_tests_properties(raster.package PROPERTIES LABELS unit SKIP_RETURN_CODE 77 TIMEOUT 600)
endif()
