# SPDX-License-Identifier: Apache-2.0
# The dependencies of the house run one way, and the compiler enforces it: each of these includes must not compile.
# auslan_wrong_way(ROOM HEADER): a file that includes HEADER and knows ROOM only.
function(auslan_wrong_way room header)
  string(MAKE_C_IDENTIFIER "${room}_to_${header}" name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/wrong_way/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n")
  add_library(wrong_way_${name} OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(wrong_way_${name} PRIVATE auslan::${room})
  set_target_properties(wrong_way_${name} PROPERTIES EXPORT_COMPILE_COMMANDS OFF)
  add_test(NAME house.${name} COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target wrong_way_${name})
  set_tests_properties(house.${name} PROPERTIES LABELS unit RUN_SERIAL ON
    PASS_REGULAR_EXPRESSION "${header}: No such file|'${header}' file not found")
endfunction()

auslan_wrong_way(raster kinematics/skeleton.h)
auslan_wrong_way(raster stage/stage.h)
auslan_wrong_way(kinematics raster/renderer.h)
auslan_wrong_way(kinematics phonology/sign.h)
auslan_wrong_way(phonology lexicon/lexicon.h)
auslan_wrong_way(translate lexicon/lexicon.h)
auslan_wrong_way(translate synthesis/score.h)
auslan_wrong_way(synthesis raster/renderer.h)
auslan_wrong_way(synthesis stage/stage.h)
auslan_wrong_way(lexicon translate/translator.h)
auslan_wrong_way(stage synthesis/score.h)
