# SPDX-License-Identifier: Apache-2.0
# Synthesis is tested on the figure and the lexicon that the build ships.
auslan_test(synthesis_mouthing LABEL unit LIBRARIES auslan::synthesis)
auslan_test(synthesis_non_manual LABEL unit LIBRARIES auslan::synthesis auslan::lexicon_text)
auslan_test(synthesis_utterance LABEL unit LIBRARIES auslan::synthesis)
auslan_test(check_exceptions LABEL unit LIBRARIES auslan::check)
if(AUSLANJAM_PROGRAMS)
  auslan_test(synthesis_motion LABEL unit LIBRARIES auslan::synthesis auslan::lexicon)
  add_dependencies(synthesis_motion_test auslan_baked_figure auslan_built_lexicon)
  auslan_test(synthesis_movement LABEL unit LIBRARIES auslan::synthesis auslan::lexicon)
  add_dependencies(synthesis_movement_test auslan_baked_figure auslan_built_lexicon)
  auslan_test(synthesis_placing LABEL unit LIBRARIES auslan::synthesis auslan::lexicon)
  add_dependencies(synthesis_placing_test auslan_baked_figure auslan_built_lexicon)
  auslan_test(synthesis_notation LABEL unit LIBRARIES auslan::synthesis auslan::notation auslan::lexicon)
  add_dependencies(synthesis_notation_test auslan_baked_figure auslan_built_lexicon)
  auslan_test(check LABEL unit LIBRARIES auslan::check auslan::lexicon)
  auslan_test(check_overlap LABEL unit LIBRARIES auslan::check auslan::lexicon)
  target_include_directories(check_overlap_test PRIVATE ${PROJECT_SOURCE_DIR}/signs/check/src)
  # Reports with tables, one process each.
  foreach(_report confusable glove reach touch)
    add_executable(${_report}_test conformance/${_report}_test.cpp)
    add_dependencies(tests_conformance ${_report}_test)
    target_link_libraries(${_report}_test PRIVATE auslan::standard
      auslan::check auslan::lexicon auslan::notation GTest::gtest GTest::gtest_main)
    target_compile_definitions(${_report}_test PRIVATE
      AUSLANJAM_BINARY_DIR="${PROJECT_BINARY_DIR}" AUSLANJAM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_include_directories(${_report}_test PRIVATE
      support ${PROJECT_SOURCE_DIR}/signs/check/src ${PROJECT_SOURCE_DIR}/signs/notation/src)
    gtest_discover_tests(${_report}_test TEST_FILTER "-*Soak.*"
      PROPERTIES LABELS conformance TIMEOUT 600 DISCOVERY_TIMEOUT 60)
  endforeach()
  target_sources(glove_test PRIVATE support/glove.cpp)
  target_link_libraries(confusable_test PRIVATE auslan::stage)
  foreach(_of_check check check_overlap confusable glove reach touch)
    add_dependencies(${_of_check}_test auslan_baked_figure auslan_built_lexicon)
  endforeach()
endif()
