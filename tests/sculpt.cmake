# SPDX-License-Identifier: Apache-2.0
if(AUSLANJAM_PROGRAMS)
  # Not among the unit tests, which the sanitizers run too: each of its tests sculpts a figure, under them for 40 seconds.
  auslan_test(sculpt_figure LABEL conformance LIBRARIES auslan::sculpt auslan::gltf)
  auslan_test(sculpt_table LABEL unit LIBRARIES auslan::sculpt)
  auslan_test(sculpt_bytes LABEL determinism LIBRARIES auslan::sculpt auslan::gltf)
endif()
