// SPDX-License-Identifier: Apache-2.0
#include "sculpt/measurements.h"

#include "kinematics/figure_file.h"

#include <fstream>
#include <set>
#include <sstream>
#include <string_view>
#include <toml++/toml.h>

namespace auslan {

namespace {

/// Reads one table key by key; keeps the first error, and what was asked for, so that unknown keys are found.
class Reader {
 public:
  Reader(const toml::table& table, std::string section, std::string file)
      : table_(table), section_(std::move(section)), file_(std::move(file)) {}

  double number(std::string_view key, double low, double high) {
    const toml::node* node = find(key);
    if (node == nullptr) return low;
    const std::optional<double> value = node->value<double>();
    if (!node->is_number() || !value) {
      refuse(*node, label(key) + " must be a number");
      return low;
    }
    return bounded(*node, key, *value, low, high);
  }

  /// `count` numbers into `out`.
  void numbers(std::string_view key, double* out, size_t count, double low, double high) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    if (list == nullptr || list->size() != count) {
      refuse(*node, label(key) + " must be a list of " + std::to_string(count) + " numbers");
      return;
    }
    for (size_t i = 0; i < count; ++i) {
      const toml::node& item = *list->get(i);
      const std::optional<double> value = item.value<double>();
      if (!item.is_number() || !value) {
        refuse(item, label(key) + " must hold numbers only");
        return;
      }
      out[i] = bounded(item, key, *value, low, high);
    }
  }

  std::string text(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) return {};
    const std::optional<std::string> value = node->value<std::string>();
    if (!value || value->empty()) refuse(*node, label(key) + " must be a text that is not empty");
    return value.value_or("");
  }

  /// A sub-table; an empty one, and an error, where there is none.
  const toml::table& section(std::string_view key) {
    static const toml::table kEmpty;
    const toml::node* node = find(key);
    if (node == nullptr) return kEmpty;
    if (!node->is_table()) refuse(*node, label(key) + " must be a section, written [" + std::string(key) + "]");
    return node->is_table() ? *node->as_table() : kEmpty;
  }

  /// The tables of a list, written [[key]]: 1 to `most`, else an error.
  std::vector<const toml::table*> sections(std::string_view key, size_t most) {
    std::vector<const toml::table*> found;
    const toml::node* node = find(key);
    if (node == nullptr) return found;
    const toml::array* list = node->as_array();
    if (list == nullptr || list->empty() || list->size() > most || !list->is_homogeneous(toml::node_type::table)) {
      refuse(*node, label(key) + " must be 1 to " + std::to_string(most) + " sections, each written [[" +
                        std::string(key) + "]]");
      return found;
    }
    for (const toml::node& section : *list)
      found.push_back(section.as_table());
    return found;
  }

  /// An error of the section as a whole.
  void refuse_all(std::string message) { refuse(table_, std::move(message)); }

  /// The first error of this section: what went wrong above, else a key nobody asked for.
  std::optional<Error> error() {
    if (!error_) {
      for (const auto& [key, value] : table_) {
        if (known_.count(std::string(key.str())) != 0) continue;
        refuse(value, label(key.str()) + " is not a measurement this program knows; remove it or correct its spelling");
        break;
      }
    }
    return error_;
  }

 private:
  const toml::node* find(std::string_view key) {
    known_.insert(std::string(key));
    const toml::node* node = table_.get(key);
    if (node == nullptr) refuse(table_, label(key) + " is missing; add it");
    return node;
  }

  double bounded(const toml::node& node, std::string_view key, double value, double low, double high) {
    if (value >= low && value <= high) return value;
    std::ostringstream range;
    range << label(key) << " must lie between " << low << " and " << high;
    refuse(node, range.str());
    return low;
  }

  void refuse(const toml::node& node, std::string message) {
    if (error_) return;
    const auto line = node.source().begin.line;
    error_ = Error{ErrorCode::kMalformed, std::move(message), file_ + ":" + std::to_string(line == 0 ? 1 : line)};
  }

  std::string label(std::string_view key) const {
    return section_.empty() ? std::string(key) : section_ + "." + std::string(key);
  }

  const toml::table& table_;
  std::string section_;
  std::string file_;
  std::set<std::string> known_;
  std::optional<Error> error_;
};

struct Length {
  std::string_view key;
  double Measurements::*value;
  double low, high;
};

// The ranges are what a grown or growing person can have, widened; outside them the shapes no longer hold together.
constexpr Length kBody[] = {{"stature", &Measurements::stature, 1000, 2300},
                            {"hip_height", &Measurements::hip_height, 500, 1300},
                            {"acromial_height", &Measurements::acromial_height, 800, 1900},
                            {"acromion_to_shoulder_joint", &Measurements::acromion_to_shoulder_joint, 15, 60},
                            {"shoulder_joint_breadth", &Measurements::shoulder_joint_breadth, 200, 460},
                            {"neck_base_height", &Measurements::neck_base_height, 850, 2000},
                            {"neck_base_depth", &Measurements::neck_base_depth, 0, 60},
                            {"chest_breadth", &Measurements::chest_breadth, 200, 420},
                            {"chest_depth", &Measurements::chest_depth, 180, 360},
                            {"waist_breadth", &Measurements::waist_breadth, 200, 480},
                            {"waist_depth", &Measurements::waist_depth, 160, 400},
                            {"hip_breadth", &Measurements::hip_breadth, 240, 500},
                            {"neck_circumference", &Measurements::neck_circumference, 260, 480}};
constexpr Length kArm[] = {{"upper_arm", &Measurements::upper_arm, 220, 420},
                           {"forearm", &Measurements::forearm, 170, 340},
                           {"wrist_circumference", &Measurements::wrist_circumference, 120, 220},
                           {"upper_arm_circumference", &Measurements::upper_arm_circumference, 220, 420},
                           {"forearm_circumference", &Measurements::forearm_circumference, 200, 360}};
constexpr Length kHead[] = {{"head_length", &Measurements::head_length, 160, 230},
                            {"head_breadth", &Measurements::head_breadth, 125, 180},
                            {"eye_to_vertex", &Measurements::eye_to_vertex, 90, 135},
                            {"face_height", &Measurements::face_height, 95, 145},
                            {"interpupillary", &Measurements::interpupillary, 52, 74}};
constexpr Length kHand[] = {{"hand_length", &Measurements::hand_length, 140, 230},
                            {"hand_breadth", &Measurements::hand_breadth, 65, 105},
                            {"palm_thickness", &Measurements::palm_thickness, 20, 38},
                            {"thumb_angle_deg", &Measurements::thumb_angle_deg, 20, 60},
                            {"thumb_drop_deg", &Measurements::thumb_drop_deg, 0, 40}};
struct ColourKey {
  std::string_view key;
  TableColour TableAppearance::*value;
};
constexpr ColourKey kColours[] = {
    {"skin", &TableAppearance::skin},         {"palm", &TableAppearance::palm},
    {"hair", &TableAppearance::hair},         {"shirt", &TableAppearance::shirt},
    {"trousers", &TableAppearance::trousers}, {"iris", &TableAppearance::iris},
    {"lips", &TableAppearance::lips},         {"background", &TableAppearance::background}};
constexpr const char* kDigitNames[] = {"thumb", "index", "middle", "ring", "little"};

TableColour colour(Reader& reader, std::string_view key) {
  double channels[3] = {0.0, 0.0, 0.0};
  reader.numbers(key, channels, 3, 0.0, 255.0);
  return {channels[0], channels[1], channels[2]};
}

Result<Measurements> read(const toml::table& root, const std::string& file) {
  Measurements out;
  Reader top(root, "", file);
  out.name = top.text("name");
  std::optional<Error> error;
  const auto keep = [&error](Reader& reader) {
    if (!error) error = reader.error();
  };
  const auto lengths = [&](std::string_view section, const auto& list) {
    Reader reader(top.section(section), std::string(section), file);
    for (const Length& length : list)
      out.*length.value = reader.number(length.key, length.low, length.high);
    return reader;
  };
  Reader body = lengths("body", kBody);
  Reader arm = lengths("arm", kArm);
  Reader head = lengths("head", kHead);
  Reader hand = lengths("hand", kHand);
  for (size_t digit = 0; digit < 5; ++digit) {
    Reader reader(hand.section(kDigitNames[digit]), std::string("hand.") + kDigitNames[digit], file);
    DigitMeasurements& m = out.digits[digit];
    double root_place[3] = {0.0, 0.0, 0.0};
    reader.numbers("root", root_place, 3, -60.0, 150.0);
    m.root = Vec3(root_place[0], root_place[1], root_place[2]);
    reader.numbers("bones", m.bones.data(), 3, 8.0, 80.0);
    m.tip = reader.number("tip", 1.0, 12.0);
    reader.numbers("breadths", m.breadths.data(), 3, 9.0, 36.0);
    keep(reader);
  }
  for (const toml::table* section : top.sections("appearance", kMaxFigureAppearances)) {
    Reader reader(*section, "appearance", file);
    TableAppearance look;
    look.name = reader.text("name");
    for (const auto& [key, value] : kColours)
      look.*value = colour(reader, key);
    for (const TableAppearance& other : out.appearances)
      if (other.name == look.name)
        reader.refuse_all("appearance.name must differ from the others; \"" + look.name + "\" is taken");
    out.appearances.push_back(std::move(look));
    keep(reader);
  }
  for (Reader* reader : {&top, &body, &arm, &head, &hand})
    keep(*reader);
  if (error) return tl::unexpected<Error>(*error);
  return out;
}

}  // namespace

Result<Measurements> read_measurements(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf()) || stream.bad()) {
    return fail(ErrorCode::kUnreadable, "cannot read the table of measurements; check that the file exists",
                path.string());
  }
  try {
    const toml::table root = toml::parse(text.str(), path.string());
    return read(root, path.string());
  } catch (const toml::parse_error& error) {
    return fail(ErrorCode::kMalformed, std::string(error.description()),
                path.string() + ":" + std::to_string(error.source().begin.line));
  }
}

}  // namespace auslan
