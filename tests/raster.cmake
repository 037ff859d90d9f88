# SPDX-License-Identifier: Apache-2.0
# What is tested of the rasteriser.
auslan_test(raster_fill_rule LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_multisample LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_clip LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_validation LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_depth LABEL unit LIBRARIES auslan::raster)
auslan_test(raster_colour LABEL unit LIBRARIES auslan::raster)
