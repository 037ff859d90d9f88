# SPDX-License-Identifier: Apache-2.0
# The harness for golden pictures and the tests of the harness. A golden test: LABEL golden, LIBRARIES ... auslan::golden.
add_library(auslan_golden STATIC support/golden.cpp)
add_library(auslan::golden ALIAS auslan_golden)
target_include_directories(auslan_golden PUBLIC support)
target_link_libraries(auslan_golden PUBLIC auslan::standard auslan::frame GTest::gtest PRIVATE auslan::picture)
target_compile_definitions(auslan_golden PRIVATE
  AUSLANJAM_SOURCE_DIR="${PROJECT_SOURCE_DIR}" AUSLANJAM_BINARY_DIR="${PROJECT_BINARY_DIR}")

auslan_test(golden_harness LABEL unit LIBRARIES auslan::golden auslan::picture)
