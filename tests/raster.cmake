# SPDX-License-Identifier: Apache-2.0
# What is tested of the rasteriser. Tests that depend on a kernel run with each one that this processor has.
auslan_test(raster_fill_rule LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_multisample LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_clip LABEL unit LIBRARIES auslan::raster)
# One of its tests looks at the bits of a cut, which no picture shows.
target_include_directories(raster_clip_test PRIVATE ${PROJECT_SOURCE_DIR}/raster/src)
auslan_test(raster_validation LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_depth LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_colour LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_allocation LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_damage LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_texture LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_kernel_bisection LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_kernel_equality LABEL unit LIBRARIES auslan::raster)
if(AUSLANJAM_PROGRAMS)
  auslan_test(raster_kernel_figure LABEL unit LIBRARIES auslan::raster auslan::kinematics)
  add_dependencies(raster_kernel_figure_test auslan_baked_figure)
  auslan_test(figure_holes LABEL conformance LIBRARIES auslan::raster auslan::kinematics auslan::sculpt)
  add_dependencies(figure_holes_test auslan_baked_figure)
endif()

# Exact arithmetic against the renderer, two million triangles and more.
auslan_test(raster_coverage LABEL conformance LIBRARIES auslan::raster)
auslan_test(raster_picture LABEL conformance LIBRARIES auslan::raster)
auslan_test(raster_near_plane LABEL conformance LIBRARIES auslan::raster)
auslan_test(raster_shared_edges LABEL conformance LIBRARIES auslan::raster)

# The committed digests: on this processor, and on those that it can pass for.
auslan_test(raster_digests LABEL determinism LIBRARIES auslan::raster)
set(_ways)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)  # the same for clang's build, which needs no second one
  list(APPEND _ways aarch64)
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  list(APPEND _ways masked nehalem)
endif()
add_executable(raster_digests_print determinism/raster_digests_print.cpp)
target_include_directories(raster_digests_print PRIVATE support)
target_link_libraries(raster_digests_print PRIVATE auslan::raster)
add_dependencies(tests_determinism raster_digests_print)
foreach(_way ${_ways})
  set(_subject $<TARGET_FILE:raster_digests_print>)
  if(_way STREQUAL aarch64)
    set(_subject ${PROJECT_BINARY_DIR}/raster_aarch64 ${CMAKE_BUILD_TYPE})
  endif()
  add_test(NAME raster_digests.${_way}
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/determinism/raster_digests.sh ${_way} ${_subject})
  set_tests_properties(raster_digests.${_way} PROPERTIES LABELS determinism SKIP_RETURN_CODE 77 TIMEOUT 900)
endforeach()

auslan_fuzz_target(raster_draw SEEDS ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/raster_seeds LIBRARIES auslan::raster)
