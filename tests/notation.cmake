# SPDX-License-Identifier: Apache-2.0
auslan_test(notation_symbols LABEL unit LIBRARIES auslan::notation)
auslan_test(notation_meaning LABEL unit LIBRARIES auslan::notation)
auslan_test(notation_diagnostics LABEL unit LIBRARIES auslan::notation)
auslan_test(notation_corpus LABEL unit LIBRARIES auslan::notation)
auslan_test(notation_coverage LABEL unit LIBRARIES auslan::notation)
auslan_test(notation_writer LABEL unit LIBRARIES auslan::notation auslan::lexicon)
auslan_fuzz_target(notation SEEDS ${PROJECT_SOURCE_DIR}/tests/fuzz/notation_seeds LIBRARIES auslan::notation)
