# SPDX-License-Identifier: Apache-2.0
# What is tested of the rasteriser.
auslan_test(raster_fill_rule LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_multisample LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_clip LABEL unit LIBRARIES auslan::raster)
# One of its tests looks at the bits of a cut, which no picture shows.
target_include_directories(raster_clip_test PRIVATE ${PROJECT_SOURCE_DIR}/raster/src)
auslan_test(raster_validation LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_depth LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_colour LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_allocation LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_digests LABEL determinism LIBRARIES auslan::raster)
auslan_fuzz_target(raster_draw SEEDS ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/raster_seeds LIBRARIES auslan::raster)
