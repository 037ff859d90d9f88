// SPDX-License-Identifier: Apache-2.0
// A line plot, drawn twice from one description: as SVG text and as pixels.
#pragma once

#include "media/caption.h"
#include "media/picture.h"

#include <cstdint>
#include <string>
#include <vector>

namespace auslan {

struct PlotSeries {
  std::string name;
  uint32_t colour = 0;    ///< 0x00RRGGBB
  int dash = 0;           ///< length of dashes and gaps in pixels; 0: solid
  std::vector<double> y;  ///< at x = 0, 1, 2 …
};

struct LinePlot {
  std::string title, x_label, y_label;
  int width = 900, height = 520;  ///< pixels
  std::vector<PlotSeries> series;
};

std::string to_svg(const LinePlot& plot);
Picture to_picture(const LinePlot& plot, const CaptionPainter& text);

}  // namespace auslan
