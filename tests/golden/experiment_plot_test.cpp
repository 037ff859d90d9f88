// SPDX-License-Identifier: Apache-2.0
#include "experiment/line_plot.h"
#include "golden.h"

#include <gtest/gtest.h>

namespace auslan {
namespace {

LinePlot small_plot() {
  LinePlot plot;
  plot.title = "y = x and y = 8 - x";
  plot.x_label = "x";
  plot.y_label = "y";
  plot.width = 256;
  plot.height = 200;
  plot.series = {{"rising", 0xC0392B, 0, {0, 1, 2, 3, 4, 5, 6, 7, 8}},
                 {"falling", 0x2471A3, 6, {8, 7, 6, 5, 4, 3, 2, 1, 0}}};
  return plot;
}

TEST(LinePlot, LinesCrossInTheMiddleOnRoundAxes) {
  const Picture picture = to_picture(small_plot(), CaptionPainter::open().value());
  EXPECT_GOLDEN(picture.view(), "line_plot");
}

TEST(LinePlot, TheSvgHoldsEverySeriesAndEscapesItsText) {
  LinePlot plot = small_plot();
  plot.title = "a < b & c";
  const std::string svg = to_svg(plot);
  EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
  EXPECT_NE(svg.find("rising"), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray=\"6\""), std::string::npos);
  size_t lines = 0;
  for (size_t at = svg.find("<polyline"); at != std::string::npos; at = svg.find("<polyline", at + 1))
    ++lines;
  EXPECT_EQ(lines, 2U);
}

}  // namespace
}  // namespace auslan
