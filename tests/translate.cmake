# SPDX-License-Identifier: Apache-2.0
# English to signing order.
foreach(test sentences phrases input properties report word_forms)
  auslan_test(translate_${test} LABEL unit LIBRARIES auslan::translate)
endforeach()
find_package(nlohmann_json REQUIRED)
target_link_libraries(translate_report_test PRIVATE nlohmann_json::nlohmann_json)
if(TARGET auslan::lexicon_text AND EXISTS ${PROJECT_SOURCE_DIR}/assets/lexicon/phrases.toml)
  auslan_test(translate_lexicon LABEL unit LIBRARIES auslan::translate auslan::lexicon_text)
  auslan_test(translate_audience LABEL unit LIBRARIES auslan::translate auslan::lexicon_text)
endif()
auslan_fuzz_target(translate SEEDS ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/translate_seeds LIBRARIES auslan::translate)
