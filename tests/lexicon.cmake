# SPDX-License-Identifier: Apache-2.0
# Breaking a database on purpose takes SQLite itself.
find_package(SQLite3 REQUIRED)
auslan_test(lexicon_shipped LABEL unit LIBRARIES auslan::lexicon)
auslan_test(lexicon_text LABEL unit LIBRARIES auslan::lexicon_text)
auslan_test(lexicon_database LABEL unit LIBRARIES auslan::lexicon)
auslan_test(lexicon_damage LABEL unit LIBRARIES auslan::lexicon SQLite::SQLite3)
auslan_test(lexicon_edit LABEL unit LIBRARIES auslan::lexicon SQLite::SQLite3)
auslan_test(lexicon_power_cut LABEL unit LIBRARIES auslan::lexicon)
auslan_fuzz_target(lexicon_text SEEDS ${PROJECT_SOURCE_DIR}/tests/fuzz/lexicon_text_seeds LIBRARIES auslan::lexicon_text)
