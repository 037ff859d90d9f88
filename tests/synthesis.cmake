# SPDX-License-Identifier: Apache-2.0
# Synthesis is tested on the figure and the lexicon that the build ships.
auslan_test(synthesis_mouthing LABEL unit LIBRARIES auslan::synthesis)
auslan_test(synthesis_non_manual LABEL unit LIBRARIES auslan::synthesis auslan::lexicon_text)
auslan_test(synthesis_utterance LABEL unit LIBRARIES auslan::synthesis)
if(AUSLANJAM_PROGRAMS)
  auslan_test(synthesis_motion LABEL unit LIBRARIES auslan::synthesis auslan::lexicon)
  add_dependencies(synthesis_motion_test auslan_baked_figure auslan_built_lexicon)
  auslan_test(synthesis_notation LABEL unit LIBRARIES auslan::synthesis auslan::notation auslan::lexicon)
  add_dependencies(synthesis_notation_test auslan_baked_figure auslan_built_lexicon)
  auslan_test(check LABEL unit LIBRARIES auslan::check auslan::lexicon)
  add_dependencies(check_test auslan_baked_figure auslan_built_lexicon)
endif()
