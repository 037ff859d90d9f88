# SPDX-License-Identifier: Apache-2.0
foreach(test elementary rotation interpolate skeleton anatomy limits arm_ik clavicle surface solid distance_field body_model skinned_model atomic_file humanoid)
  auslan_test(kinematics_${test} LABEL unit LIBRARIES auslan::kinematics)
endforeach()
auslan_test(signing_avatar LABEL unit LIBRARIES auslan::kinematics)
auslan_test(avatar_bytes LABEL determinism LIBRARIES auslan::kinematics)
