// SPDX-License-Identifier: Apache-2.0
#include "kinematics/figure_file.h"

#include "kinematics/little_endian.h"
#include "sample_figure.h"

#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>

namespace auslan {
namespace {

using test::difference;
using test::sample_figure;
using test::tiny_figure;

Result<Figure> parse(const std::string& bytes) {
  return parse_figure(std::as_bytes(std::span(bytes)));
}

/// The layout's checksum, written from its description alone.
uint64_t reference_checksum(const std::string& payload) {
  uint64_t hash = (14695981039346656037U ^ payload.size()) * 1099511628211U;
  for (size_t at = 0; at < payload.size(); at += 8) {
    uint64_t word = 0;
    for (size_t i = 0; i < 8 && at + i < payload.size(); ++i)
      word |= uint64_t{static_cast<uint8_t>(payload[at + i])} << (8 * i);
    hash = (hash ^ word) * 1099511628211U;
    hash ^= hash >> 32U;
  }
  return hash;
}

/// A file of this payload with a header that is right.
std::string with_header(const std::string& payload) {
  std::string bytes = "AJFIGURE";
  append_little_endian(bytes, uint32_t{2});
  append_little_endian(bytes, uint32_t{0});
  append_little_endian(bytes, uint64_t{payload.size()});
  append_little_endian(bytes, reference_checksum(payload));
  return bytes + payload;
}

void expect_malformed(const std::string& bytes, ErrorCode code = ErrorCode::kMalformed) {
  const auto read = parse(bytes);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, code) << to_string(read.error());
  EXPECT_TRUE(read.error().place.starts_with("byte ")) << to_string(read.error());
  EXPECT_NE(read.error().message.find("auslan-bake"), std::string::npos) << to_string(read.error());
}

TEST(FigureFile, GivesTheSameFigureBitForBit) {
  const ScratchFolder folder;
  const Figure figure = sample_figure();
  const auto written = write_figure(figure, folder / "signer.figure");
  ASSERT_TRUE(written) << to_string(written.error());
  const auto read = read_figure(folder / "signer.figure");
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(difference(figure, *read), "");
  EXPECT_EQ(serialise_figure(*read), serialise_figure(figure));
}

TEST(FigureFile, HeaderIsAsDescribed) {
  const std::string bytes = serialise_figure(tiny_figure());
  EXPECT_EQ(bytes.substr(0, 8), "AJFIGURE");
  EXPECT_EQ(bytes.substr(8, 8), std::string("\2\0\0\0\0\0\0\0", 8));
  EXPECT_EQ(bytes, with_header(bytes.substr(32)));
  // The name "Sample e-acute" is 9 bytes of UTF-8, then come two appearances of two pigments, the first "first
  // e-acute", and 39 nodes, the first "spine_base", without a parent.
  EXPECT_EQ(bytes.substr(32, 21), std::string("\x09\0\0\0Sample \xC3\xA9\2\0\0\0\2\0\0\0", 21));
  EXPECT_EQ(bytes.substr(53, 12), std::string("\x08\0\0\0first \xC3\xA9", 12));
  EXPECT_EQ(bytes.substr(65, 9), std::string("\1\2\3\0\0\0\xFF\x80\7", 9));
  EXPECT_EQ(bytes.substr(74, 10), std::string("\6\0\0\0second", 10));
  EXPECT_EQ(bytes.substr(93, 4), std::string("\x27\0\0\0", 4));
  EXPECT_EQ(bytes.substr(97, 18), std::string("\x0A\0\0\0spine_base\xFF\xFF\xFF\xFF", 18));
}

TEST(FigureFile, TruncatedAnywhere) {
  const std::string bytes = serialise_figure(tiny_figure());
  for (size_t part = 0; part < 37; ++part)
    expect_malformed(bytes.substr(0, bytes.size() * part / 37));
  expect_malformed(bytes.substr(0, bytes.size() - 1));
  expect_malformed(bytes + '\0');
}

TEST(FigureFile, EveryFlippedBitIsNoticed) {
  const std::string bytes = serialise_figure(tiny_figure());
  for (size_t i = 0; i < bytes.size(); ++i)
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string broken = bytes;
      broken[i] = static_cast<char>(static_cast<unsigned char>(broken[i]) ^ (1U << bit));
      ASSERT_FALSE(parse(broken)) << "bit " << bit << " of byte " << i;
    }
}

TEST(FigureFile, OtherVersionsAndForeignFiles) {
  std::string bytes = serialise_figure(tiny_figure());
  bytes[8] = 1;
  expect_malformed(bytes, ErrorCode::kUnsupported);
  expect_malformed("");
  expect_malformed("glTF and something that is long enough for a header");
  expect_malformed(std::string(4096, '\0'));
}

// Behind a right checksum every length is still checked before room is made for what it promises.
TEST(FigureFile, LengthsThatLie) {
  const std::string payload = serialise_figure(tiny_figure()).substr(32);
  ASSERT_TRUE(parse(with_header(payload)));
  for (size_t at = 0; at + 4 <= payload.size(); ++at)
    for (const uint32_t lie : {0xFFFFFFFFU, 0x80000000U, 0x10000U}) {
      std::string broken = payload;
      std::string word;
      append_little_endian(word, lie);
      const auto read = parse(with_header(broken.replace(at, 4, word)));
      if (read)
        ASSERT_TRUE(check_figure(*read)) << at;
      else
        ASSERT_TRUE(read.error().code == ErrorCode::kMalformed || read.error().code == ErrorCode::kLimit) << at;
    }
  for (size_t length = 0; length < payload.size(); ++length)
    ASSERT_FALSE(parse(with_header(payload.substr(0, length))));
  expect_malformed(with_header(payload + std::string(4, '\0')));
}

// serialise_figure writes what it is given; the reader checks every promise of figure.h again.
TEST(FigureFile, FiguresThatBreakTheirContract) {
  const auto refused_with = [](auto change) {
    Figure figure = tiny_figure();
    change(figure.segments[2]);
    const auto checked = check_figure(figure);
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().place, "head_base");
    expect_malformed(serialise_figure(figure));
    const ScratchFolder folder;
    EXPECT_FALSE(write_figure(figure, folder / "signer.figure"));
    EXPECT_FALSE(std::filesystem::exists(folder / "signer.figure"));
  };
  refused_with([](Mesh& mesh) { mesh.indices[2] = 4; });
  refused_with([](Mesh& mesh) { mesh.indices.pop_back(); });
  refused_with([](Mesh& mesh) { mesh.indices.clear(); });
  refused_with([](Mesh& mesh) { mesh.positions[1].y = std::numeric_limits<float>::quiet_NaN(); });
  refused_with([](Mesh& mesh) { mesh.normals[1].y = std::numeric_limits<float>::infinity(); });
  refused_with([](Mesh& mesh) { mesh.normals[1] = glm::vec3(0.0F); });
  refused_with([](Mesh& mesh) { mesh.colours[0].w = 254; });
  refused_with([](Mesh& mesh) { mesh.paint.pop_back(); });
  refused_with([](Mesh& mesh) { mesh.paint[1].second = 2; });
  refused_with([](Mesh& mesh) { mesh.morphs[0].vertices[1] = 4; });
  refused_with([](Mesh& mesh) { mesh.morphs[0].vertices = {1, 1}; });
  refused_with([](Mesh& mesh) { mesh.morphs[0].displacement[0].z = -std::numeric_limits<float>::infinity(); });
  refused_with([](Mesh& mesh) { mesh.morphs[0].channel = static_cast<FaceChannel>(kFaceChannelCount); });
}

TEST(FigureFile, AppearancesThatBreakTheirContract) {
  const auto refused_with = [](auto change) {
    Figure figure = tiny_figure();
    change(figure.appearances);
    EXPECT_FALSE(check_figure(figure));
    EXPECT_FALSE(parse(serialise_figure(figure)));
  };
  refused_with([](std::vector<Appearance>& list) { list.clear(); });  // the mesh is painted
  refused_with([](std::vector<Appearance>& list) { list[0].name.clear(); });
  refused_with([](std::vector<Appearance>& list) { list[1].name = list[0].name; });
  refused_with([](std::vector<Appearance>& list) { list[1].pigments.pop_back(); });
  refused_with([](std::vector<Appearance>& list) { list[0].pigments.clear(); });
  refused_with([](std::vector<Appearance>& list) {
    for (int i = 0; i < 64; ++i)
      list.push_back({"another " + std::to_string(i), glm::u8vec3(0), list[0].pigments});
  });
}

TEST(FigureFile, PaintIsAMixtureOfPigmentsTimesAShade) {
  const Appearance appearance{"", glm::u8vec3(0), {{200, 100, 0}, {0, 50, 255}}};
  EXPECT_EQ(painted({0, 1, 0, 200}, appearance), glm::u8vec4(200, 100, 0, 255));
  EXPECT_EQ(painted({0, 1, 255, 200}, appearance), glm::u8vec4(0, 50, 255, 255));
  // A third of the second: 133.3, 83.3, 85; a shade of 100 is half; one of 250 is 1.25, at most 255.
  EXPECT_EQ(painted({0, 1, 85, 200}, appearance), glm::u8vec4(133, 83, 85, 255));
  EXPECT_EQ(painted({0, 0, 0, 100}, appearance), glm::u8vec4(100, 50, 0, 255));
  EXPECT_EQ(painted({0, 1, 0, 250}, appearance), glm::u8vec4(250, 125, 0, 255));
  EXPECT_EQ(painted({1, 1, 9, 250}, appearance), glm::u8vec4(0, 63, 255, 255));
}

TEST(FigureFile, AnAppearanceColoursWhatIsPainted) {
  Figure figure = sample_figure();
  const std::vector<glm::u8vec4> unpainted = figure.segments[0].colours;
  const auto worn = put_on(figure, "second");
  ASSERT_TRUE(worn);
  EXPECT_EQ((*worn)->background, glm::u8vec3(255));
  for (size_t i = 0; i < 300; ++i)
    EXPECT_EQ(figure.segments[2].colours[i], painted(figure.segments[2].paint[i], figure.appearances[1]));
  EXPECT_EQ(figure.segments[0].colours, unpainted);
  const auto unknown = put_on(figure, "third");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::kUsage);
  EXPECT_NE(unknown.error().message.find("second"), std::string::npos);
}

TEST(FigureFile, ContractsThatOnlyMemoryCanBreak) {
  Figure figure = tiny_figure();
  figure.segments.pop_back();
  EXPECT_FALSE(check_figure(figure));
  figure = tiny_figure();
  figure.segments[2].normals.pop_back();
  EXPECT_FALSE(check_figure(figure));
  figure = tiny_figure();
  figure.segments[2].morphs[0].displacement.pop_back();
  EXPECT_FALSE(check_figure(figure));
}

TEST(FigureFile, FilesThatCannotBeRead) {
  const ScratchFolder folder;
  const auto code_of = [](const std::filesystem::path& path) { return read_figure(path).error().code; };
  EXPECT_EQ(code_of(folder / "missing.figure"), ErrorCode::kNotFound);
  EXPECT_EQ(code_of(folder.path()), ErrorCode::kUnreadable);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(code_of(folder / "pipe"), ErrorCode::kUnreadable);
  put_bytes(folder / "huge.figure", "AJFIGURE");
  std::filesystem::resize_file(folder / "huge.figure", kMaxFigureFileBytes + 1);
  EXPECT_EQ(code_of(folder / "huge.figure"), ErrorCode::kLimit);
  put_bytes(folder / "short.figure", "AJFIGURE");
  const Error error = read_figure(folder / "short.figure").error();
  EXPECT_EQ(error.place, (folder / "short.figure").string() + ": byte 8");
}

TEST(FigureFile, FailedWriteKeepsTheOldFileAndLeavesNothingElse) {
  const ScratchFolder folder;
  put_bytes(folder / "signer.figure", "old");
  // A limit on the size of files stands in for a disk that fills up halfway.
  ::rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const ::rlimit narrow{.rlim_cur = 4096, .rlim_max = before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &narrow), 0);
  const auto written = write_figure(sample_figure(), folder / "signer.figure");
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kUnwritable);
  EXPECT_EQ(bytes_of(folder / "signer.figure"), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(FigureFile, PlacesThatCannotBeWritten) {
  const ScratchFolder folder;
  for (const std::filesystem::path& path :
       {folder / "missing/signer.figure", folder.path(), std::filesystem::path("/dev/null")}) {
    const auto written = write_figure(tiny_figure(), path);
    ASSERT_FALSE(written) << path;
    EXPECT_EQ(written.error().code, ErrorCode::kUnwritable);
    EXPECT_NE(to_string(written.error()).find(path.string()), std::string::npos);
  }
}

}  // namespace
}  // namespace auslan
