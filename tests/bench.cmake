# SPDX-License-Identifier: Apache-2.0
# The benchmark (never a timed test), a short run of it that shows that it still works, and the count of instructions.
find_package(benchmark QUIET)
find_package(meshoptimizer QUIET)
if(NOT benchmark_FOUND OR NOT meshoptimizer_FOUND OR NOT AUSLANJAM_PROGRAMS)
  message(STATUS "No benchmark: it needs libbenchmark-dev, libmeshoptimizer-dev and AUSLANJAM_PROGRAMS")
  return()
endif()
find_package(nlohmann_json REQUIRED)

set(auslan_bench_scenes "${PROJECT_BINARY_DIR}/bench_scenes")
add_library(auslan_bench_scene STATIC
  bench/frame_series.cpp bench/scene.cpp bench/synthetic_scenes.cpp bench/workload.cpp)
target_link_libraries(auslan_bench_scene PUBLIC auslan::standard auslan::raster)
target_include_directories(auslan_bench_scene PUBLIC bench)
target_compile_definitions(auslan_bench_scene PRIVATE AUSLANJAM_BENCH_SCENES="${auslan_bench_scenes}")

# The signer's scenes, from the figure and the lexicon that the build ships.
add_executable(make_scenes bench/make_scenes.cpp)
target_link_libraries(make_scenes PRIVATE
  auslan_bench_scene auslan::stage auslan::synthesis auslan::lexicon meshoptimizer::meshoptimizer)
target_include_directories(make_scenes PRIVATE support)
target_compile_definitions(make_scenes PRIVATE AUSLANJAM_BINARY_DIR="${PROJECT_BINARY_DIR}")
set(_scenes)
foreach(_detail 5k 22k 90k)
  list(APPEND _scenes "${auslan_bench_scenes}/signer_${_detail}.scene")
endforeach()
add_custom_command(OUTPUT ${_scenes}
  COMMAND ${CMAKE_COMMAND} -E make_directory "${auslan_bench_scenes}"
  COMMAND make_scenes "${auslan_bench_scenes}"
  DEPENDS make_scenes auslan_baked_figure auslan_built_lexicon
  COMMENT "Posing the signer for the benchmark"
  VERBATIM)
add_custom_target(bench_scenes DEPENDS ${_scenes})

add_executable(raster_frames bench/raster_frames.cpp)
target_link_libraries(raster_frames PRIVATE auslan_bench_scene)
add_library(auslan_bench_stage STATIC bench/stage_series.cpp)
target_link_libraries(auslan_bench_stage
  PUBLIC auslan_bench_scene auslan::stage auslan::synthesis PRIVATE auslan::lexicon)
target_include_directories(auslan_bench_stage PRIVATE support)
target_compile_definitions(auslan_bench_stage PRIVATE AUSLANJAM_BINARY_DIR="${PROJECT_BINARY_DIR}")
add_executable(stage_frames bench/stage_frames.cpp)
target_link_libraries(stage_frames PRIVATE auslan_bench_stage)
add_executable(synthesis_cost bench/synthesis_cost.cpp)
target_link_libraries(synthesis_cost PRIVATE auslan::standard auslan::synthesis auslan::notation auslan::lexicon)
target_include_directories(synthesis_cost PRIVATE support)
target_compile_definitions(synthesis_cost PRIVATE
  AUSLANJAM_BINARY_DIR="${PROJECT_BINARY_DIR}" AUSLANJAM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
add_executable(lexicon_cost bench/lexicon_cost.cpp)
target_link_libraries(lexicon_cost PRIVATE auslan::standard auslan::synthesis auslan::lexicon)
target_include_directories(lexicon_cost PRIVATE support)
target_compile_definitions(lexicon_cost PRIVATE AUSLANJAM_BINARY_DIR="${PROJECT_BINARY_DIR}")
add_executable(raster_bench
  bench/measurement.cpp bench/peer_process.cpp bench/picture_difference.cpp bench/raster_bench.cpp bench/report.cpp)
target_link_libraries(raster_bench PRIVATE auslan_bench_stage benchmark::benchmark nlohmann_json::nlohmann_json)
add_dependencies(tests_bench
  lexicon_cost raster_bench raster_frames stage_frames synthesis_cost bench_scenes auslan_baked_figure auslan_built_lexicon)

# Mesa in memory, where it is installed.
find_path(OSMESA_INCLUDE_DIR GL/osmesa.h)
find_library(OSMESA_LIBRARY OSMesa)
mark_as_advanced(OSMESA_INCLUDE_DIR OSMESA_LIBRARY)
if(OSMESA_INCLUDE_DIR AND OSMESA_LIBRARY)
  add_executable(raster_gl_peer bench/gl_peer.cpp bench/gl_scene.cpp)
  target_include_directories(raster_gl_peer SYSTEM PRIVATE ${OSMESA_INCLUDE_DIR})
  target_link_libraries(raster_gl_peer PRIVATE auslan_bench_scene ${OSMESA_LIBRARY})
  add_dependencies(tests_bench raster_gl_peer)
endif()
add_custom_target(bench ALL)
add_dependencies(bench tests_bench)

auslan_test(bench_scenes LABEL unit
  SOURCES unit/bench_scenes_test.cpp bench/measurement.cpp bench/picture_difference.cpp LIBRARIES auslan_bench_scene)
add_dependencies(bench_scenes_test bench_scenes)
add_test(NAME bench.every_scene COMMAND raster_bench --benchmark_min_time=0
  --benchmark_filter=640x480/4x.*clean|fill/.*1_thread/clean|tiny/.*1x/.*2_threads/full|arm|still)
add_test(NAME bench.report COMMAND raster_bench --report --quick --json ${PROJECT_BINARY_DIR}/bench_quick.json)
set_tests_properties(bench.every_scene bench.report PROPERTIES LABELS bench TIMEOUT 600)

# Counts hold for one compiler and its optimised build.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_BUILD_TYPE STREQUAL Release AND NOT AUSLANJAM_SANITIZE
    AND CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
  add_test(NAME instructions COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/bench/instructions.sh $<TARGET_FILE_DIR:raster_frames>)
  set_tests_properties(instructions PROPERTIES LABELS conformance SKIP_RETURN_CODE 77 TIMEOUT 1200)
endif()
