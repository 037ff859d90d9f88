# SPDX-License-Identifier: Apache-2.0
# Frames, clips, pictures, captions, the window and motion files.
auslan_test(media_digest LABEL unit LIBRARIES auslan::frame)
auslan_test(media_yuv LABEL unit LIBRARIES auslan::clip)
auslan_test(media_clip LABEL unit LIBRARIES auslan::clip auslan::picture)
auslan_test(media_picture LABEL unit LIBRARIES auslan::picture)
auslan_test(media_caption LABEL unit LIBRARIES auslan::caption)
auslan_test(media_motion LABEL unit LIBRARIES auslan::motion_file nlohmann_json::nlohmann_json)
find_package(nlohmann_json REQUIRED)
find_package(SDL2 QUIET)
if(SDL2_FOUND)
  auslan_test(media_window LABEL unit LIBRARIES auslan::window auslan::picture SDL2::SDL2)
endif()
auslan_fuzz_target(media_motion SEEDS ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/media_motion_seeds LIBRARIES auslan::motion_file)
