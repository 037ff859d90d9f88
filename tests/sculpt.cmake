# SPDX-License-Identifier: Apache-2.0
if(AUSLANJAM_PROGRAMS)
  auslan_test(sculpt_figure LABEL unit LIBRARIES auslan::sculpt auslan::gltf)
  auslan_test(sculpt_table LABEL unit LIBRARIES auslan::sculpt)
  auslan_test(sculpt_bytes LABEL determinism LIBRARIES auslan::sculpt auslan::gltf)
endif()
