// SPDX-License-Identifier: Apache-2.0
// A contact sheet: small pictures of equal size with a line of text below each, in rows under headings.
#pragma once

#include "media/caption.h"
#include "media/picture.h"

#include <string>
#include <vector>

namespace auslan::sheets {

struct Cell {
  std::string label;
  Picture picture;
};

struct Row {
  std::string heading;
  std::vector<Cell> cells;
};

/// All rows below each other, `columns` cells wide; a longer row goes on in the next line. Every picture is cell_width
/// by cell_height pixels.
Picture contact_sheet(const std::vector<Row>& rows, int columns, int cell_width, int cell_height,
                      const CaptionPainter& text);

}  // namespace auslan::sheets
