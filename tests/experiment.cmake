# SPDX-License-Identifier: Apache-2.0
auslan_test(experiment_study LABEL unit LIBRARIES auslan::experiment)
auslan_test(experiment_plot LABEL golden LIBRARIES auslan::experiment auslan::golden)
