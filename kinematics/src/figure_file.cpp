// SPDX-License-Identifier: Apache-2.0
#include "kinematics/figure_file.h"

#include "kinematics/little_endian.h"
#include "kinematics/whole_file.h"

#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

namespace auslan {
namespace {

constexpr std::string_view kMagic = "AJFIGURE";
constexpr size_t kHeaderBytes = 32;
constexpr size_t kFloatBytes = sizeof(float);
constexpr std::string_view kRebuild = "; rebuild it with: auslan-bake FIGURE.glb -o signer.figure";

// The arrays of a Mesh are copied as they lie in memory.
static_assert(sizeof(glm::vec3) == 3 * kFloatBytes && sizeof(glm::u8vec4) == 4 && sizeof(glm::u8vec3) == 3 &&
              sizeof(Paint) == 4 && sizeof(Vec3) == 3 * sizeof(double));

void append_text(std::string& bytes, std::string_view text) {
  append_little_endian(bytes, static_cast<uint32_t>(text.size()));
  bytes += text;
}

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Result<void> check_morph(const Morph& morph, size_t vertices, const std::string& place) {
  const auto channel = static_cast<int>(morph.channel);
  if (channel < 0 || channel >= kFaceChannelCount)
    return fail(ErrorCode::kMalformed, "a morph has no face channel of the list in pose.h", place);
  const std::string name(kFaceChannelNames[static_cast<size_t>(channel)]);
  if (morph.vertices.size() != morph.displacement.size())
    return fail(ErrorCode::kMalformed, "the morph " + name + " needs one displacement a vertex", place);
  for (size_t i = 0; i < morph.vertices.size(); ++i) {
    if (morph.vertices[i] >= vertices || (i > 0 && morph.vertices[i] <= morph.vertices[i - 1]))
      return fail(ErrorCode::kMalformed, "the vertices of the morph " + name + " must ascend and exist in the mesh",
                  place);
    if (!is_finite(morph.displacement[i]))
      return fail(ErrorCode::kMalformed, "the morph " + name + " has a displacement that is not a finite number",
                  place);
  }
  return {};
}

Result<void> check_appearances(const std::vector<Appearance>& appearances, const std::string& place) {
  if (appearances.size() > kMaxFigureAppearances)
    return fail(ErrorCode::kLimit, "the figure has more than " + std::to_string(kMaxFigureAppearances) + " appearances",
                place);
  for (size_t i = 0; i < appearances.size(); ++i) {
    const Appearance& appearance = appearances[i];
    if (appearance.name.empty()) return fail(ErrorCode::kMalformed, "an appearance needs a name", place);
    for (size_t k = 0; k < i; ++k)
      if (appearances[k].name == appearance.name)
        return fail(ErrorCode::kMalformed, "two appearances are called " + appearance.name, place);
    if (appearance.pigments.empty() || appearance.pigments.size() > kMaxFigurePigments ||
        appearance.pigments.size() != appearances.front().pigments.size())
      return fail(ErrorCode::kMalformed, "every appearance needs as many pigments as the first, 1 to 256", place);
  }
  return {};
}

Result<void> check_mesh(const Mesh& mesh, size_t pigments, const std::string& place) {
  const size_t vertices = mesh.positions.size();
  if (!mesh.paint.empty() && mesh.paint.size() != vertices)
    return fail(ErrorCode::kMalformed, "a painted mesh needs one paint for each of its positions", place);
  for (size_t i = 0; i < mesh.paint.size(); ++i)
    if (mesh.paint[i].first >= pigments || mesh.paint[i].second >= pigments)
      return fail(ErrorCode::kMalformed,
                  "vertex " + std::to_string(i) + " is painted with a pigment that the figure does not have", place);
  if (mesh.normals.size() != vertices || mesh.colours.size() != vertices)
    return fail(ErrorCode::kMalformed, "a mesh needs one normal and one colour for each of its positions", place);
  if (vertices > 0 && mesh.indices.empty())
    return fail(ErrorCode::kMalformed, "the mesh has vertices but no triangles", place);
  if (mesh.indices.size() % 3 != 0)
    return fail(ErrorCode::kMalformed, "the number of indices must be a multiple of three", place);
  for (const uint32_t index : mesh.indices)
    if (index >= vertices)
      return fail(ErrorCode::kMalformed,
                  "a triangle names vertex " + std::to_string(index) + " of " + std::to_string(vertices), place);
  for (size_t i = 0; i < vertices; ++i) {
    const std::string_view fault = [&]() -> std::string_view {
      if (!is_finite(mesh.positions[i])) return "its position is not a finite number";
      const glm::vec3& n = mesh.normals[i];
      const float squared = n.x * n.x + n.y * n.y + n.z * n.z;
      if (!(squared > 0.998F && squared < 1.002F)) return "its normal is not a unit vector";
      if (mesh.colours[i].w != 255) return "its colour is not opaque";
      return {};
    }();
    if (!fault.empty())
      return fail(ErrorCode::kMalformed, "vertex " + std::to_string(i) + ": " + std::string(fault), place);
  }
  if (mesh.morphs.size() > kMaxFigureMorphs)
    return fail(ErrorCode::kLimit, "the mesh has more than " + std::to_string(kMaxFigureMorphs) + " morphs", place);
  for (const Morph& morph : mesh.morphs)
    if (auto checked = check_morph(morph, vertices, place); !checked) return checked;
  return {};
}

size_t pigment_count(const Figure& figure) {
  return figure.appearances.empty() ? 0 : figure.appearances.front().pigments.size();
}

/// Reads fields one after another; the first that does not fit makes every later one empty.
class Cursor {
 public:
  explicit Cursor(std::span<const std::byte> bytes) : bytes_(bytes) {}

  size_t offset() const { return offset_; }
  bool failed() const { return failed_; }
  bool at_end() const { return offset_ == bytes_.size(); }

  template <typename T>
  T number() {
    T value{};
    if (claim(1, sizeof(T))) load_little_endian(take(sizeof(T)), &value, 1);
    return value;
  }

  std::string text() {
    const auto length = number<uint32_t>();
    if (!claim(length, 1)) return {};
    std::string text(length, '\0');
    load_little_endian(take(length), text.data(), length);
    return text;
  }

  template <typename T>
  void array(std::vector<T>& values, uint32_t count, size_t width) {
    if (!claim(count, sizeof(T))) return;
    values.resize(count);
    load_little_endian(take(count * sizeof(T)), values.data(), count, width);
  }

  /// Whether `count` things of at least `each` bytes can still follow: asked before room is made for them.
  bool claim(uint64_t count, uint64_t each) {
    failed_ = failed_ || count * each > bytes_.size() - offset_;
    return !failed_;
  }

 private:
  const std::byte* take(size_t size) {
    const std::byte* at = bytes_.data() + offset_;
    offset_ += size;
    return at;
  }

  std::span<const std::byte> bytes_;
  size_t offset_ = 0;
  bool failed_ = false;
};

tl::unexpected<Error> refuse(ErrorCode code, std::string message, size_t offset) {
  message += kRebuild;
  return fail(code, std::move(message), "byte " + std::to_string(offset));
}

tl::unexpected<Error> too_short(size_t offset) {
  return refuse(ErrorCode::kMalformed, "the figure file is damaged: a length in it exceeds what follows", offset);
}

Result<std::vector<Node>> parse_nodes(Cursor& cursor) {
  constexpr uint64_t kLeastNodeBytes = 4 + 4 + 3 * sizeof(double);
  const auto count = cursor.number<uint32_t>();
  if (!cursor.claim(count, kLeastNodeBytes)) return too_short(cursor.offset());
  if (count > kMaxFigureNodes) return refuse(ErrorCode::kLimit, "the figure has too many nodes", cursor.offset());
  std::vector<Node> nodes(count);
  for (Node& node : nodes) {
    node.name = cursor.text();
    node.parent = cursor.number<int32_t>();
    node.offset.x = cursor.number<double>();
    node.offset.y = cursor.number<double>();
    node.offset.z = cursor.number<double>();
    if (cursor.failed()) return too_short(cursor.offset());
  }
  return nodes;
}

Result<std::vector<Appearance>> parse_appearances(Cursor& cursor) {
  const auto count = cursor.number<uint32_t>();
  const auto pigments = cursor.number<uint32_t>();
  if (count > kMaxFigureAppearances || pigments > kMaxFigurePigments)
    return refuse(ErrorCode::kLimit, "the figure has too many appearances or pigments", cursor.offset());
  if (count == 0 && pigments != 0)
    return refuse(ErrorCode::kMalformed, "the figure has pigments but no appearance", cursor.offset());
  if (!cursor.claim(count, 4 + 3 + uint64_t{3} * pigments)) return too_short(cursor.offset());
  std::vector<Appearance> appearances(count);
  for (Appearance& appearance : appearances) {
    appearance.name = cursor.text();
    for (int channel = 0; channel < 3; ++channel)
      appearance.background[channel] = cursor.number<uint8_t>();
    cursor.array(appearance.pigments, pigments, 1);
    if (cursor.failed()) return too_short(cursor.offset());
  }
  return appearances;
}

Result<void> parse_mesh(Cursor& cursor, Mesh& mesh) {
  constexpr uint64_t kLeastMorphBytes = 8;
  const auto vertices = cursor.number<uint32_t>();
  const auto painted = cursor.number<uint32_t>();
  const auto indices = cursor.number<uint32_t>();
  const auto morphs = cursor.number<uint32_t>();
  cursor.array(mesh.positions, vertices, kFloatBytes);
  cursor.array(mesh.normals, vertices, kFloatBytes);
  cursor.array(mesh.colours, vertices, 1);
  cursor.array(mesh.paint, painted, 1);
  cursor.array(mesh.indices, indices, sizeof(uint32_t));
  if (!cursor.claim(morphs, kLeastMorphBytes)) return too_short(cursor.offset());
  if (morphs > kMaxFigureMorphs) return refuse(ErrorCode::kLimit, "a mesh has too many morphs", cursor.offset());
  mesh.morphs.resize(morphs);
  for (Morph& morph : mesh.morphs) {
    const auto channel = cursor.number<uint32_t>();
    const auto count = cursor.number<uint32_t>();
    if (channel >= static_cast<uint32_t>(kFaceChannelCount))
      return refuse(ErrorCode::kMalformed, "the figure file names an unknown face channel", cursor.offset());
    morph.channel = static_cast<FaceChannel>(channel);
    cursor.array(morph.vertices, count, sizeof(uint32_t));
    cursor.array(morph.displacement, count, kFloatBytes);
    if (cursor.failed()) return too_short(cursor.offset());
  }
  return {};
}

/// The length of the payload, after everything the header says was compared with the bytes.
Result<void> check_header(std::span<const std::byte> bytes) {
  if (bytes.size() < kMagic.size() || std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0)
    return refuse(ErrorCode::kMalformed, "this is not a baked figure (it does not begin with AJFIGURE)", 0);
  if (bytes.size() < kHeaderBytes) return refuse(ErrorCode::kMalformed, "the figure file is cut short", bytes.size());
  if (bytes.size() > kMaxFigureFileBytes)
    return refuse(ErrorCode::kLimit, "the figure file is longer than 64 MiB", kMaxFigureFileBytes);
  const auto version = load_little_endian<uint32_t>(bytes.data() + 8);
  if (version != kFigureFileVersion)
    return refuse(ErrorCode::kUnsupported,
                  "the figure file has version " + std::to_string(version) + ", this program reads version " +
                      std::to_string(kFigureFileVersion),
                  8);
  if (load_little_endian<uint32_t>(bytes.data() + 12) != 0)
    return refuse(ErrorCode::kMalformed, "the figure file is damaged: a field that must be zero is not", 12);
  const auto length = load_little_endian<uint64_t>(bytes.data() + 16);
  if (length != bytes.size() - kHeaderBytes)
    return refuse(ErrorCode::kMalformed,
                  length > bytes.size() - kHeaderBytes ? "the figure file is cut short"
                                                       : "something follows the end of the figure file",
                  bytes.size());
  if (figure_checksum(bytes.subspan(kHeaderBytes)) != load_little_endian<uint64_t>(bytes.data() + 24))
    return refuse(ErrorCode::kMalformed, "the figure file is damaged: its checksum does not match", 24);
  return {};
}

}  // namespace

// Words, because they cost a kiosk eight times fewer dependent multiplications at start than bytes; the shift carries
// the high bits down, where the multiplications would never bring them.
uint64_t figure_checksum(std::span<const std::byte> payload) {
  constexpr uint64_t kOffsetBasis = 0xcbf29ce484222325U;
  constexpr uint64_t kPrime = 0x00000100000001b3U;
  uint64_t hash = (kOffsetBasis ^ payload.size()) * kPrime;
  for (size_t at = 0; at < payload.size(); at += 8) {
    std::array<std::byte, 8> word{};
    std::memcpy(word.data(), payload.data() + at, payload.size() - at < 8 ? payload.size() - at : 8);
    hash = (hash ^ load_little_endian<uint64_t>(word.data())) * kPrime;
    hash ^= hash >> 32U;
  }
  return hash;
}

Result<void> check_figure(const Figure& figure) {
  if (figure.segments.size() != figure.skeleton.nodes().size())
    return fail(ErrorCode::kMalformed, "a figure needs one segment, which may be empty, for each node", figure.name);
  if (figure.segments.size() > kMaxFigureNodes)
    return fail(ErrorCode::kLimit, "the figure has more than " + std::to_string(kMaxFigureNodes) + " nodes",
                figure.name);
  if (auto checked = check_appearances(figure.appearances, figure.name); !checked) return checked;
  const size_t pigments = pigment_count(figure);
  for (size_t i = 0; i < figure.segments.size(); ++i)
    if (auto checked = check_mesh(figure.segments[i], pigments, figure.skeleton.nodes()[i].name); !checked)
      return checked;
  return {};
}

std::string serialise_figure(const Figure& figure) {
  std::string bytes(kMagic);
  append_little_endian(bytes, kFigureFileVersion);
  append_little_endian(bytes, uint32_t{0});
  bytes.resize(kHeaderBytes);  // length and checksum follow when they are known
  append_text(bytes, figure.name);
  append_little_endian(bytes, static_cast<uint32_t>(figure.appearances.size()));
  append_little_endian(bytes, static_cast<uint32_t>(pigment_count(figure)));
  for (const Appearance& appearance : figure.appearances) {
    append_text(bytes, appearance.name);
    append_little_endian(bytes, &appearance.background, 1, 1);
    append_little_endian(bytes, appearance.pigments.data(), appearance.pigments.size(), 1);
  }
  append_little_endian(bytes, static_cast<uint32_t>(figure.skeleton.size()));
  for (const Node& node : figure.skeleton.nodes()) {
    append_text(bytes, node.name);
    append_little_endian(bytes, static_cast<int32_t>(node.parent));
    append_little_endian(bytes, &node.offset, 1, sizeof(double));
  }
  for (const Mesh& mesh : figure.segments) {
    append_little_endian(bytes, static_cast<uint32_t>(mesh.positions.size()));
    append_little_endian(bytes, static_cast<uint32_t>(mesh.paint.size()));
    append_little_endian(bytes, static_cast<uint32_t>(mesh.indices.size()));
    append_little_endian(bytes, static_cast<uint32_t>(mesh.morphs.size()));
    append_little_endian(bytes, mesh.positions.data(), mesh.positions.size(), kFloatBytes);
    append_little_endian(bytes, mesh.normals.data(), mesh.normals.size(), kFloatBytes);
    append_little_endian(bytes, mesh.colours.data(), mesh.colours.size(), 1);
    append_little_endian(bytes, mesh.paint.data(), mesh.paint.size(), 1);
    append_little_endian(bytes, mesh.indices.data(), mesh.indices.size());
    for (const Morph& morph : mesh.morphs) {
      append_little_endian(bytes, static_cast<uint32_t>(morph.channel));
      append_little_endian(bytes, static_cast<uint32_t>(morph.vertices.size()));
      append_little_endian(bytes, morph.vertices.data(), morph.vertices.size());
      append_little_endian(bytes, morph.displacement.data(), morph.displacement.size(), kFloatBytes);
    }
  }
  const std::span<const std::byte> payload = std::as_bytes(std::span(bytes)).subspan(kHeaderBytes);
  std::string rest;
  append_little_endian(rest, static_cast<uint64_t>(payload.size()));
  append_little_endian(rest, figure_checksum(payload));
  bytes.replace(16, rest.size(), rest);
  return bytes;
}

Result<Figure> parse_figure(std::span<const std::byte> bytes) {
  if (auto header = check_header(bytes); !header) return tl::unexpected<Error>(std::move(header.error()));
  Cursor cursor(bytes);
  cursor.claim(1, kHeaderBytes);
  for (size_t i = 0; i < kHeaderBytes; i += 8)
    cursor.number<uint64_t>();

  Figure figure;
  figure.name = cursor.text();
  const size_t appearances_start = cursor.offset();
  auto appearances = parse_appearances(cursor);
  if (!appearances) return tl::unexpected<Error>(std::move(appearances.error()));
  figure.appearances = *std::move(appearances);
  if (auto checked = check_appearances(figure.appearances, figure.name); !checked)
    return refuse(ErrorCode::kMalformed, to_string(checked.error()), appearances_start);
  auto nodes = parse_nodes(cursor);
  if (!nodes) return tl::unexpected<Error>(std::move(nodes.error()));
  const size_t nodes_end = cursor.offset();
  auto skeleton = Skeleton::build(*std::move(nodes));
  if (!skeleton) return refuse(ErrorCode::kMalformed, to_string(skeleton.error()), nodes_end);
  figure.skeleton = *std::move(skeleton);
  figure.segments.resize(figure.skeleton.nodes().size());
  for (size_t i = 0; i < figure.segments.size(); ++i) {
    const size_t start = cursor.offset();
    if (auto parsed = parse_mesh(cursor, figure.segments[i]); !parsed)
      return tl::unexpected<Error>(std::move(parsed.error()));
    if (auto checked = check_mesh(figure.segments[i], pigment_count(figure), figure.skeleton.nodes()[i].name); !checked)
      return refuse(ErrorCode::kMalformed, to_string(checked.error()), start);
  }
  if (!cursor.at_end())
    return refuse(ErrorCode::kMalformed, "something follows the last segment of the figure", cursor.offset());
  return figure;
}

Result<void> write_figure(const Figure& figure, const std::filesystem::path& path) {
  if (auto checked = check_figure(figure); !checked) return checked;
  const std::string bytes = serialise_figure(figure);
  if (bytes.size() > kMaxFigureFileBytes)
    return fail(ErrorCode::kLimit, "the figure is larger than 64 MiB; use meshes with fewer triangles", path.string());
  return write_whole_file(path, bytes);
}

Result<Figure> read_figure(const std::filesystem::path& path) {
  auto bytes = read_whole_file(path, kMaxFigureFileBytes);
  if (!bytes) return tl::unexpected<Error>(std::move(bytes.error()));
  auto figure = parse_figure(std::as_bytes(std::span(*bytes)));
  if (!figure) figure.error().place = path.string() + ": " + figure.error().place;
  return figure;
}

}  // namespace auslan
