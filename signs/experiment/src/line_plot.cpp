// SPDX-License-Identifier: Apache-2.0
#include "experiment/line_plot.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace auslan {
namespace {

constexpr int kLeft = 80, kRight = 24, kTop = 48, kBottom = 64;
constexpr uint32_t kInk = 0x20262B, kGrid = 0xD8DEE2, kPaper = 0xFFFFFF;

struct Point {
  double x = 0, y = 0;
};

/// From data to pixels, with round numbers on the axes.
struct Axes {
  double x_most = 1, y_least = 0, y_most = 1, x_step = 1, y_step = 1;
  int width = 0, height = 0;

  Point place(double x, double y) const {
    return {kLeft + x / x_most * (width - kLeft - kRight),
            height - kBottom - (y - y_least) / (y_most - y_least) * (height - kTop - kBottom)};
  }
};

/// The smallest of 1, 2 or 5 times a power of ten that divides `range` into at most `most` parts.
double round_step(double range, int most) {
  double step = 1;
  while (range / step > most)
    step *= 10;
  while (range / (step / 10) <= most)
    step /= 10;
  for (const double part : {5.0, 2.0})
    if (range / (step / part) <= most) return step / part;
  return step;
}

Axes axes_of(const LinePlot& plot) {
  Axes axes;
  axes.width = plot.width;
  axes.height = plot.height;
  double most = 0;
  for (const PlotSeries& series : plot.series) {
    axes.x_most = std::max(axes.x_most, static_cast<double>(series.y.size()) - 1);
    for (const double y : series.y)
      most = std::max(most, y);
  }
  if (most <= 0) most = 1;
  axes.y_step = round_step(most * 1.04, 8);
  axes.y_most = axes.y_step * std::ceil(most * 1.04 / axes.y_step);
  axes.x_step = round_step(axes.x_most, 10);
  return axes;
}

std::string number(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, std::round(value * 1e6) / 1e6).ptr;
  return {text, end};
}

std::string fixed(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 2).ptr;
  return {text, end};
}

std::string hex(uint32_t colour) {
  std::string text = "#000000";
  for (size_t i = 0; i < 6; ++i)
    text[6 - i] = "0123456789abcdef"[(colour >> (4 * i)) & 15U];
  return text;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

void blend(FrameSpan frame, int x, int y, uint32_t colour, double coverage) {
  if (x < 0 || y < 0 || x >= frame.width || y >= frame.height || coverage <= 0) return;
  const auto weight = static_cast<uint32_t>(std::min(1.0, coverage) * 256.0);
  uint32_t& pixel = frame.pixels[static_cast<size_t>(y) * static_cast<size_t>(frame.width) + static_cast<size_t>(x)];
  uint32_t mixed = 0;
  for (const uint32_t shift : {0U, 8U, 16U}) {
    const uint32_t below = (pixel >> shift) & 255U, above = (colour >> shift) & 255U;
    mixed |= ((below * (256U - weight) + above * weight + 128U) >> 8U) << shift;
  }
  pixel = mixed;
}

/// A soft line: every pixel is covered as much as its centre is near the segment. `travelled` carries the dash pattern
/// on.
void draw_segment(FrameSpan frame, Point a, Point b, double half_width, uint32_t colour, int dash, double& travelled) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length = std::sqrt(dx * dx + dy * dy);
  const double reach = half_width + 1;
  const auto low = [&](double p, double q) { return static_cast<int>(std::floor(std::min(p, q) - reach)); };
  const auto high = [&](double p, double q) { return static_cast<int>(std::ceil(std::max(p, q) + reach)); };
  for (int y = low(a.y, b.y); y <= high(a.y, b.y); ++y) {
    for (int x = low(a.x, b.x); x <= high(a.x, b.x); ++x) {
      const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
      const double t = length > 0 ? std::clamp((px * dx + py * dy) / (length * length), 0.0, 1.0) : 0.0;
      if (dash > 0 && std::fmod(travelled + t * length, 2.0 * dash) > dash) continue;
      const double ex = px - t * dx, ey = py - t * dy;
      blend(frame, x, y, colour, half_width + 0.5 - std::sqrt(ex * ex + ey * ey));
    }
  }
  travelled += length;
}

/// Several series may cover each other: a segment is drawn once a pixel, at its strongest.
void draw_line(FrameSpan frame, const std::vector<Point>& points, uint32_t colour, int dash) {
  double travelled = 0;
  for (size_t i = 1; i < points.size(); ++i)
    draw_segment(frame, points[i - 1], points[i], 1.0, colour, dash, travelled);
}

std::vector<Point> points_of(const PlotSeries& series, const Axes& axes) {
  std::vector<Point> points;
  for (size_t i = 0; i < series.y.size(); ++i)
    points.push_back(axes.place(static_cast<double>(i), series.y[i]));
  return points;
}

}  // namespace

std::string to_svg(const LinePlot& plot) {
  const Axes axes = axes_of(plot);
  const std::string w = std::to_string(plot.width), h = std::to_string(plot.height);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
                    "\" viewBox=\"0 0 " + w + " " + h + "\" font-family=\"sans-serif\" font-size=\"14\" fill=\"" +
                    hex(kInk) + "\">\n" + "<rect width=\"" + w + "\" height=\"" + h + "\" fill=\"#ffffff\"/>\n";
  const auto text = [&svg](double x, double y, const std::string& anchor, const std::string& content,
                           const std::string& more) {
    svg += "<text x=\"" + fixed(x) + "\" y=\"" + fixed(y) + "\" text-anchor=\"" + anchor + "\"" + more + ">" +
           escaped(content) + "</text>\n";
  };
  const auto line = [&svg](Point a, Point b) {
    svg += "<path d=\"M" + fixed(a.x) + " " + fixed(a.y) + "L" + fixed(b.x) + " " + fixed(b.y) + "\" stroke=\"" +
           hex(kGrid) + "\"/>\n";
  };
  for (double y = 0; y <= axes.y_most + axes.y_step / 2; y += axes.y_step) {
    const Point at = axes.place(0, y);
    line(at, axes.place(axes.x_most, y));
    text(at.x - 8, at.y + 5, "end", number(y), "");
  }
  for (double x = 0; x <= axes.x_most; x += axes.x_step) {
    const Point at = axes.place(x, 0);
    line(at, axes.place(x, axes.y_most));
    text(at.x, at.y + 20, "middle", number(x), "");
  }
  for (const PlotSeries& series : plot.series) {
    svg += "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" + hex(series.colour) + "\"";
    if (series.dash > 0) svg += " stroke-dasharray=\"" + std::to_string(series.dash) + "\"";
    svg += " points=\"";
    for (const Point& point : points_of(series, axes))
      svg += fixed(point.x) + "," + fixed(point.y) + " ";
    svg += "\"/>\n";
  }
  double x = kLeft;
  for (const PlotSeries& series : plot.series) {
    svg += "<path d=\"M" + fixed(x) + " " + fixed(plot.height - 14.0) + "h26\" stroke-width=\"3\" stroke=\"" +
           hex(series.colour) + "\"" +
           (series.dash > 0 ? " stroke-dasharray=\"" + std::to_string(series.dash) + "\"" : "") + "/>\n";
    text(x + 32, plot.height - 9.0, "start", series.name, "");
    x += (plot.width - kLeft) / static_cast<double>(plot.series.size());
  }
  text(plot.width / 2.0, 28, "middle", plot.title, " font-size=\"18\"");
  text(plot.width - kRight, plot.height - 30.0, "end", plot.x_label, "");
  text(kLeft - 60, 42, "start", plot.y_label, "");
  return svg + "</svg>\n";
}

Picture to_picture(const LinePlot& plot, const CaptionPainter& text) {
  const Axes axes = axes_of(plot);
  Picture picture = make_picture(plot.width, plot.height, kPaper);
  const FrameSpan frame = picture.span();
  const auto label = [&](double x, double y, const std::string& content, int size, TextAlign align) {
    text.text(frame, static_cast<int>(x), static_cast<int>(y), content, size, kInk, align);
  };
  double unused = 0;
  for (double y = 0; y <= axes.y_most + axes.y_step / 2; y += axes.y_step) {
    const Point at = axes.place(0, y);
    draw_segment(frame, at, axes.place(axes.x_most, y), 0.2, kGrid, 0, unused);
    label(at.x - 8, at.y + 5, number(y), 13, TextAlign::kRight);
  }
  for (double x = 0; x <= axes.x_most; x += axes.x_step) {
    const Point at = axes.place(x, 0);
    draw_segment(frame, at, axes.place(x, axes.y_most), 0.2, kGrid, 0, unused);
    label(at.x, at.y + 20, number(x), 13, TextAlign::kCentre);
  }
  for (const PlotSeries& series : plot.series)
    draw_line(frame, points_of(series, axes), series.colour, series.dash);
  double x = kLeft;
  for (const PlotSeries& series : plot.series) {
    const double y = plot.height - 14.0;
    draw_line(frame, {{x, y}, {x + 26, y}}, series.colour, series.dash);
    label(x + 32, y + 5, series.name, 13, TextAlign::kLeft);
    x += (plot.width - kLeft) / static_cast<double>(plot.series.size());
  }
  label(plot.width / 2.0, 28, plot.title, 17, TextAlign::kCentre);
  label(plot.width - kRight, plot.height - 28.0, plot.x_label, 13, TextAlign::kRight);
  label(kLeft - 60, 42, plot.y_label, 13, TextAlign::kLeft);
  return picture;
}

}  // namespace auslan
