# SPDX-License-Identifier: Apache-2.0
# Parts of the programs that are tested from inside.
if(NOT TARGET auslanjam)
  return()
endif()
auslan_test(programs_frame_maker LABEL unit
  SOURCES unit/programs_frame_maker_test.cpp ${PROJECT_SOURCE_DIR}/signs/programs/src/frame_maker.cpp
    ${PROJECT_SOURCE_DIR}/signs/programs/src/body.cpp
  LIBRARIES auslan::caption auslan::lexicon auslan::picture auslan::stage auslan::synthesis auslan::translate)
target_include_directories(programs_frame_maker_test PRIVATE ${PROJECT_SOURCE_DIR}/signs/programs/src)
add_dependencies(programs_frame_maker_test auslan_baked_figure auslan_built_lexicon)
