// SPDX-License-Identifier: Apache-2.0
#include "sheet.h"

#include <algorithm>
#include <cstddef>

namespace auslan::sheets {
namespace {

constexpr int kGap = 6, kHeading = 30, kLabel = 20;
constexpr uint32_t kPaper = 0xFFFFFF, kInk = 0x202020;

void paste(const Picture& from, int x, int y, Picture& to) {
  for (int row = 0; row < from.height; ++row)
    std::copy_n(from.pixels.begin() + static_cast<std::ptrdiff_t>(row) * from.width, from.width,
                to.pixels.begin() + static_cast<std::ptrdiff_t>(y + row) * to.width + x);
}

}  // namespace

Picture contact_sheet(const std::vector<Row>& rows, int columns, int cell_width, int cell_height,
                      const CaptionPainter& text) {
  const auto lines = [columns](const Row& row) { return (static_cast<int>(row.cells.size()) + columns - 1) / columns; };
  int height = kGap;
  for (const Row& row : rows)
    height += kHeading + lines(row) * (cell_height + kLabel + kGap);
  Picture sheet = make_picture(columns * (cell_width + kGap) + kGap, height, kPaper);
  int y = kGap;
  for (const Row& row : rows) {
    text.text(sheet.span(), kGap, y + 20, row.heading, 18, kInk);
    y += kHeading;
    for (size_t i = 0; i < row.cells.size(); ++i) {
      const int column = static_cast<int>(i) % columns;
      const int line = static_cast<int>(i) / columns;
      const int x = kGap + column * (cell_width + kGap);
      const int top = y + line * (cell_height + kLabel + kGap);
      paste(row.cells[i].picture, x, top, sheet);
      text.text(sheet.span(), x + cell_width / 2, top + cell_height + 15, row.cells[i].label, 13, kInk,
                TextAlign::kCentre);
    }
    y += lines(row) * (cell_height + kLabel + kGap);
  }
  return sheet;
}

}  // namespace auslan::sheets
