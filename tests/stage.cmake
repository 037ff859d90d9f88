# SPDX-License-Identifier: Apache-2.0
auslan_test(stage_camera LABEL unit LIBRARIES auslan::stage)
auslan_test(stage_avatar LABEL unit LIBRARIES auslan::stage)
if(AUSLANJAM_PROGRAMS)
  auslan_test(stage_shadow LABEL unit LIBRARIES auslan::stage)
  add_dependencies(stage_shadow_test auslan_baked_figure)
  auslan_test(figure_appearance LABEL unit LIBRARIES auslan::stage)
  add_dependencies(figure_appearance_test auslan_baked_figure)
  foreach(_of_signs stage_outline stage_framing)
    auslan_test(${_of_signs} LABEL unit LIBRARIES auslan::stage auslan::synthesis auslan::lexicon)
    add_dependencies(${_of_signs}_test auslan_baked_figure auslan_built_lexicon)
  endforeach()
  auslan_test(signer_pictures LABEL golden
    LIBRARIES auslan::stage auslan::synthesis auslan::lexicon auslan::caption auslan::picture auslan::golden)
  add_dependencies(signer_pictures_test auslan_baked_figure auslan_built_lexicon)

  # Contact sheets of the figure, to look at.
  set(_programs ${PROJECT_SOURCE_DIR}/signs/programs/src)
  add_executable(figure_sheets
    sheets/figure_sheets.cpp sheets/sheet.cpp ${_programs}/avatar_images.cpp ${_programs}/body.cpp)
  target_link_libraries(figure_sheets PRIVATE
    auslan::stage auslan::synthesis auslan::lexicon auslan::caption auslan::gltf auslan::picture)
  target_include_directories(figure_sheets PRIVATE sheets support ${_programs})
  target_compile_definitions(figure_sheets PRIVATE AUSLANJAM_BINARY_DIR="${PROJECT_BINARY_DIR}")
  add_dependencies(figure_sheets auslan_baked_figure auslan_built_lexicon)
endif()
