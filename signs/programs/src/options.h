// SPDX-License-Identifier: Apache-2.0
// What a command line asks for, as plain data.
#pragma once

#include "stage/stage.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

enum class Command {
  kSign,
  kRender,
  kMotion,
  kTranslate,
  kDbList,
  kDbShow,
  kDbSearch,
  kDbCheck,
  kDbStats,
  kDbBuild,
  kDbExport,
  kDbImport,
  kDbReview,
  kDbDiff,
  kDbMigrate,
  kExperiment,
  kBench,
  kAvatar,
  kCheck,
  kNotation
};

/// What is to be signed: exactly one of these.
struct Source {
  std::optional<std::string> text;
  std::vector<std::string> glosses;
  std::optional<std::string> motion_file;
  std::optional<std::string> sigml_file;
  std::optional<std::string> hamnosys;
};

/// As the appearance: print the names there are.
inline constexpr std::string_view kListAppearances = "list";

struct Options {
  Command command = Command::kSign;
  Source source;
  std::string output;        ///< -o
  std::optional<double> at;  ///< seconds, for a single frame or pose
  bool hash = false;
  StageOptions stage;
  int fps = 25;
  double speed = 1.0;
  std::string detail = "normal";  ///< of the built-in figure: low, normal or high
  std::string appearance;         ///< of the figure, by name; empty: its first
  std::string avatar;    ///< a figure in place of the built-in one; empty: built in; for the command avatar: its FILE
  std::string dialect;   ///< of the signing: north, south; empty: the lexicon's first choice
  bool strict = false;   ///< doubtful safety-critical signs are spelled, and captioned
  std::string database;  ///< a database in place of the built-in one; empty: built in
  bool left_handed = false;
  bool caption = false;
  bool idle = true;
  int threads = 1;  ///< frames drawn at once; how many share a frame is stage.threads
  int frames = 0;   ///< for bench; 0: those of the show
  uint64_t seed = 1;
  bool quiet = false;
  bool json = false;
  // check
  std::string exceptions;        ///< a list in place of the built-in one; empty: that, for the built-in figure
  std::string write_exceptions;  ///< where to write what breaks a limit; empty: nowhere
  std::string notation;  ///< for the command notation: hns, gestural, hamnosys, text; empty: only what was found
  // db
  std::vector<std::string> words;  ///< the glosses to show, the words to search, the files to work on
  std::string kind, category, region, handshape, place, hands, movement, review;  ///< empty: any
  std::string conflicts;                               ///< of an import: "ours", "theirs"; empty: none are allowed
  std::string reviewer, verdict, remark, reviewed_on;  ///< of a review; reviewed_on empty: today
};

}  // namespace auslan
