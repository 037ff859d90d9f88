# SPDX-License-Identifier: Apache-2.0
# Tests that run the program as a person does: bad input, and the digests of its frames.
if(NOT TARGET auslanjam)
  return()
endif()

# auslan_cases(FILE PATTERN result): what PATTERN's group matches at the beginning of the lines of FILE.
function(auslan_cases file pattern result)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(STRINGS ${file} lines REGEX "^${pattern}")
  list(TRANSFORM lines REPLACE "^${pattern}.*" "\\1")
  set(${result} ${lines} PARENT_SCOPE)
endfunction()

set(_bad_input ${CMAKE_CURRENT_SOURCE_DIR}/unit/programs_bad_input.sh)
auslan_cases(${_bad_input} "case_([a-z0-9_]+)\\(\\)" _names)
foreach(_name ${_names})
  add_test(NAME bad_input.${_name}
    COMMAND ${_bad_input} $<TARGET_FILE:auslanjam> ${PROJECT_BINARY_DIR}/share/auslanjam ${_name})
  set_tests_properties(bad_input.${_name} PROPERTIES LABELS unit SKIP_RETURN_CODE 77 TIMEOUT 1200)
endforeach()

# Once as this processor is, and once as one without FMA and AVX2, where glibc's functions give other last bits.
set(_frames ${CMAKE_CURRENT_SOURCE_DIR}/determinism/frames.sh)
auslan_cases(${CMAKE_CURRENT_SOURCE_DIR}/determinism/frames.txt "([a-z0-9_]+) " _names)
foreach(_name ${_names})
  add_test(NAME frames.${_name} COMMAND ${_frames} $<TARGET_FILE:auslanjam> ${_name})
  add_test(NAME frames_older_processor.${_name} COMMAND ${_frames} $<TARGET_FILE:auslanjam> ${_name})
  set_tests_properties(frames_older_processor.${_name} PROPERTIES ENVIRONMENT GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2)
  set_tests_properties(frames.${_name} frames_older_processor.${_name} PROPERTIES LABELS determinism TIMEOUT 1200)
endforeach()

# All entries and phrases against the limits of quality and the list of what is known to break them.
add_test(NAME check.lexicon COMMAND auslanjam check --threads 2 --quiet)
set_tests_properties(check.lexicon PROPERTIES LABELS conformance TIMEOUT 1200)

# Every command of the README, in its order.
add_test(NAME readme.commands COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/unit/readme_commands.sh $<TARGET_FILE:auslanjam>
  ${PROJECT_SOURCE_DIR}/README.md)
set_tests_properties(readme.commands PROPERTIES LABELS unit TIMEOUT 1200)

find_package(nlohmann_json REQUIRED)
auslan_test(programs_bench LABEL unit LIBRARIES auslan::raster nlohmann_json::nlohmann_json
  DEFINITIONS AUSLANJAM_PROGRAM="$<TARGET_FILE:auslanjam>")
add_dependencies(programs_bench_test auslanjam auslan_baked_figure auslan_built_lexicon)
auslan_test(programs_avatar LABEL unit LIBRARIES auslan::gltf nlohmann_json::nlohmann_json
  DEFINITIONS AUSLANJAM_PROGRAM="$<TARGET_FILE:auslanjam>")
add_dependencies(programs_avatar_test auslanjam)
auslan_test(programs_check LABEL unit LIBRARIES auslan::kinematics nlohmann_json::nlohmann_json
  DEFINITIONS AUSLANJAM_PROGRAM="$<TARGET_FILE:auslanjam>")
auslan_test(check_avatars LABEL conformance LIBRARIES auslan::kinematics nlohmann_json::nlohmann_json
  DEFINITIONS AUSLANJAM_PROGRAM="$<TARGET_FILE:auslanjam>")
foreach(_of_check programs_check check_avatars)
  add_dependencies(${_of_check}_test auslanjam auslan_baked_figure auslan_built_lexicon auslan_copied_exceptions)
endforeach()
