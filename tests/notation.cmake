# SPDX-License-Identifier: Apache-2.0
auslan_test(notation_symbols LABEL unit LIBRARIES auslan::notation)
auslan_test(notation_corpus LABEL unit LIBRARIES auslan::notation)
