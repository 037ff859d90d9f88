# SPDX-License-Identifier: Apache-2.0
# Figures in files: glTF and the baked form.
if(TARGET auslan::gltf)
  find_package(nlohmann_json REQUIRED)
  auslan_test(gltf_round_trip LABEL unit LIBRARIES auslan::gltf nlohmann_json::nlohmann_json)
endif()
