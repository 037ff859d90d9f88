# SPDX-License-Identifier: Apache-2.0
# Figures in files: glTF and the baked form.
auslan_test(figure_file LABEL unit LIBRARIES auslan::kinematics)

if(TARGET auslan::gltf)
  find_package(nlohmann_json REQUIRED)
  foreach(test gltf_round_trip gltf_reader gltf_hostile avatar_reader avatar_hostile avatar_samples)
    auslan_test(${test} LABEL unit LIBRARIES auslan::gltf nlohmann_json::nlohmann_json)
  endforeach()
  auslan_test(gltf_bake LABEL unit LIBRARIES auslan::gltf nlohmann_json::nlohmann_json
    DEFINITIONS AUSLANJAM_BAKE="$<TARGET_FILE:auslan-bake>")
  add_dependencies(gltf_bake_test auslan-bake)

  auslan_fuzz_target(figure_file SEEDS ${PROJECT_BINARY_DIR}/seeds/figure_file LIBRARIES auslan::kinematics)
  auslan_fuzz_target(gltf SEEDS ${PROJECT_BINARY_DIR}/seeds/gltf LIBRARIES auslan::gltf)
  auslan_fuzz_target(avatar SEEDS ${PROJECT_BINARY_DIR}/seeds/avatar LIBRARIES auslan::gltf)
  if(AUSLANJAM_FUZZ)
    target_include_directories(avatar_fuzz PRIVATE support)
    add_executable(figure_seeds fuzz/figure_seeds.cpp)
    add_dependencies(tests_fuzz figure_seeds)
    target_include_directories(figure_seeds PRIVATE support)
    target_link_libraries(figure_seeds PRIVATE auslan::gltf nlohmann_json::nlohmann_json)
    foreach(fuzzer gltf figure_file avatar)
      add_test(NAME seeds_${fuzzer} COMMAND figure_seeds ${fuzzer} ${PROJECT_BINARY_DIR}/seeds/${fuzzer})
      set_tests_properties(seeds_${fuzzer} PROPERTIES LABELS fuzz FIXTURES_SETUP seeds_${fuzzer})
      set_tests_properties(fuzz_${fuzzer} PROPERTIES FIXTURES_REQUIRED seeds_${fuzzer})
    endforeach()
  endif()
endif()
