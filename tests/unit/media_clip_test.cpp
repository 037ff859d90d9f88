// SPDX-License-Identifier: Apache-2.0
#include "media/clip.h"
#include "media/picture.h"
#include "media/picture_module.h"
#include "scratch_folder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <vector>

namespace auslan {
namespace {

using Names = std::vector<std::string>;

/// Noise, which no encoder makes small; the same for the same number.
Picture noise(int width, int height, uint32_t seed) {
  Picture picture = make_picture(width, height);
  uint32_t state = seed * 2654435761U + 1;
  for (uint32_t& pixel : picture.pixels) {
    state = state * 1664525U + 1013904223U;
    pixel = state >> 8;
  }
  return picture;
}

/// Four colours in bands that move.
Picture bands(int width, int height, int shift) {
  constexpr uint32_t kColours[] = {0x102030, 0xFF8000, 0x00FF40, 0xFFFFFF};
  Picture picture = make_picture(width, height);
  for (size_t i = 0; i < picture.pixels.size(); ++i) {
    const int x = static_cast<int>(i) % width;
    picture.pixels[i] = kColours[(x / 4 + shift) % 4];
  }
  return picture;
}

Result<void> write_clip(const std::string& path, const ClipFormat& format, int frames, bool noisy = false) {
  auto sink = open_clip(path, format);
  if (!sink) return tl::unexpected(sink.error());
  for (int i = 0; i < frames; ++i) {
    const Picture picture =
        noisy ? noise(format.width, format.height, static_cast<uint32_t>(i)) : bands(format.width, format.height, i);
    if (auto written = (*sink)->write(picture.view()); !written) return written;
  }
  return (*sink)->finish();
}

bool has_pictures() {
  return load_picture_module().has_value();
}

TEST(Y4m, TwoByTwoIsTheseBytes) {
  const ScratchFolder folder;
  auto sink = open_clip(folder / "a.y4m", {2, 2, 30000, 1001});
  ASSERT_TRUE(sink);
  const std::vector<uint32_t> pixels = {0xFF0000, 0x00FF00, 0x0000FF, 0xFFFFFF};
  ASSERT_TRUE((*sink)->write({pixels, 2, 2}));
  ASSERT_TRUE((*sink)->finish());
  // BT.601: red (81.48, 90.20, 240), green (144.55, 53.80, 34.21), blue (40.97, 240, 109.79), white (235, 128, 128).
  EXPECT_EQ(bytes_of(folder / "a.y4m"),
            "YUV4MPEG2 W2 H2 F30000:1001 Ip A1:1 C444 XCOLORRANGE=LIMITED\nFRAME\n"
            "\x51\x91\x29\xEB"
            "\x5A\x36\xF0\x80"
            "\xF0\x22\x6E\x80");
}

struct Encoded {
  const char* name;
  const char* codec;
};

class FfmpegClip : public testing::TestWithParam<Encoded> {
 protected:
  void SetUp() override {
    if (!has_program("ffmpeg") || !has_program("ffprobe")) GTEST_SKIP() << "ffmpeg is not installed";
  }
};

TEST_P(FfmpegClip, HasTheSizeTheFramesAndTheRate) {
  const ScratchFolder folder;
  const std::string path = folder / (std::string("a") + GetParam().name);
  const auto done = write_clip(path, {63, 47, 30, 1}, 11);
  ASSERT_TRUE(done) << to_string(done.error());
  EXPECT_EQ(folder.contents().size(), 1U);
  const Ran probe =
      run("ffprobe -v error -count_frames -show_entries "
          "stream=codec_name,width,height,avg_frame_rate,nb_read_frames -of csv=p=0 " +
          path);
  EXPECT_EQ(probe.output, std::string(GetParam().codec) + ",64,48,30/1,11\n");
}

TEST_P(FfmpegClip, ShowsTheColoursThatWereWritten) {
  const ScratchFolder folder;
  const std::string path = folder / (std::string("a") + GetParam().name);
  auto sink = open_clip(path, {32, 32, 25, 1});
  ASSERT_TRUE(sink);
  const Picture orange = make_picture(32, 32, 0xE08020);
  for (int i = 0; i < 3; ++i)
    ASSERT_TRUE((*sink)->write(orange.view()));
  ASSERT_TRUE((*sink)->finish());
  const Ran raw = run("ffmpeg -v error -nostdin -i " + path + " -frames:v 1 -f rawvideo -pix_fmt rgb24 -");
  ASSERT_EQ(raw.output.size(), 32U * 32U * 3U);
  // The middle pixel; a wrong matrix or range is off by far more than the codec.
  const size_t middle = 3 * (16 * 32 + 16);
  EXPECT_NEAR(static_cast<unsigned char>(raw.output[middle]), 0xE0, 5);
  EXPECT_NEAR(static_cast<unsigned char>(raw.output[middle + 1]), 0x80, 5);
  EXPECT_NEAR(static_cast<unsigned char>(raw.output[middle + 2]), 0x20, 5);
}

INSTANTIATE_TEST_SUITE_P(Suffixes, FfmpegClip, testing::Values(Encoded{".mp4", "h264"}, Encoded{".webm", "vp9"}),
                         [](const auto& made) { return std::string(made.param.name + 1); });

TEST(WebpClip, IsAnAnimationOfAsManyFrames) {
  if (!has_program("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  const ScratchFolder folder;
  const auto done = write_clip(folder / "a.webp", {40, 30, 25, 1}, 5);
  ASSERT_TRUE(done) << to_string(done.error());
  // RIFF container: chunks of name, little-endian size, content padded to even length; one ANMF for each frame.
  const std::string bytes = bytes_of(folder / "a.webp");
  ASSERT_EQ(bytes.substr(0, 4) + bytes.substr(8, 4), "RIFFWEBP");
  int frames = 0;
  for (size_t at = 12; at + 8 <= bytes.size();) {
    uint32_t size = 0;
    for (size_t i = 0; i < 4; ++i)
      size |= uint32_t{static_cast<unsigned char>(bytes[at + 4 + i])} << (8 * i);
    frames += bytes.compare(at, 4, "ANMF") == 0 ? 1 : 0;
    at += 8 + size + (size & 1);
  }
  EXPECT_EQ(frames, 5);
}

TEST(GifClip, FramesOfFewColoursReadBackExactly) {
  if (!has_pictures()) GTEST_SKIP() << "no picture module";
  const ScratchFolder folder;
  const auto done = write_clip(folder / "a.gif", {32, 8, 25, 1}, 6);
  ASSERT_TRUE(done) << to_string(done.error());
  EXPECT_EQ(folder.contents(), Names{"a.gif"});
  const std::string bytes = bytes_of(folder / "a.gif");
  const std::span<const uint8_t> view(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
  for (int i = 0; i < 6; ++i) {
    const auto frame = decode_picture(view, PictureFormat::kGif, i, "a.gif");
    ASSERT_TRUE(frame) << i << " " << to_string(frame.error());
    const auto difference = compare(bands(32, 8, i).view(), frame->view());
    EXPECT_TRUE(difference.equal()) << i << ": " << to_string(difference);
  }
  EXPECT_FALSE(decode_picture(view, PictureFormat::kGif, 6, "a.gif"));
}

TEST(PngClip, IsANumberedSequenceThatReadsBackExactly) {
  if (!has_pictures()) GTEST_SKIP() << "no picture module";
  const ScratchFolder folder;
  ASSERT_TRUE(write_clip(folder / "out.png", {20, 10, 25, 1}, 3, true));
  EXPECT_EQ(folder.contents(), (Names{"out-0001.png", "out-0002.png", "out-0003.png"}));
  const auto second = read_png(folder / "out-0002.png");
  ASSERT_TRUE(second);
  EXPECT_TRUE(compare(noise(20, 10, 1).view(), second->view()).equal());
}

TEST(PngClip, ASinglePictureHasThePathsOwnNameAndTakesOneFrame) {
  if (!has_pictures()) GTEST_SKIP() << "no picture module";
  const ScratchFolder folder;
  ClipFormat format{20, 10, 25, 1};
  format.single_picture = true;
  ASSERT_TRUE(write_clip(folder / "out.png", format, 1));
  EXPECT_EQ(folder.contents(), Names{"out.png"});
  EXPECT_FALSE(write_clip(folder / "two.png", format, 2));
  EXPECT_EQ(folder.contents(), Names{"out.png"});
}

TEST(OpenClip, RefusesWhatItCannotWrite) {
  const ScratchFolder folder;
  const auto code = [&](const std::string& name, const ClipFormat& format) {
    const auto sink = open_clip(folder / name, format);
    return sink ? std::string("opened") : std::to_string(static_cast<int>(sink.error().code));
  };
  const std::string usage = std::to_string(static_cast<int>(ErrorCode::kUsage));
  EXPECT_EQ(code("a.avi", {8, 8, 25, 1}), usage);
  EXPECT_EQ(code("mp4", {8, 8, 25, 1}), usage);
  EXPECT_EQ(code(".mp4", {8, 8, 25, 1}), usage);
  EXPECT_EQ(code("a.y4m", {0, 8, 25, 1}), usage);
  EXPECT_EQ(code("a.y4m", {8, 20000, 25, 1}), usage);
  EXPECT_EQ(code("a.y4m", {8, 8, 0, 1}), usage);
  EXPECT_EQ(code("a.y4m", {8, 8, 25, 0}), usage);
  EXPECT_EQ(code("a.y4m", {8, 8, 2000000, 1}), usage);
  EXPECT_EQ(folder.contents(), Names{});
  EXPECT_TRUE(is_clip_path("x/Y.MP4"));
  EXPECT_FALSE(is_clip_path("x.mp4/y"));
}

// From here on: every way to fail leaves the folder as it was, an older file of the name included.
class FailingClip : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const std::string& suffix = GetParam();
    if ((suffix == ".gif" || suffix == ".png") && !has_pictures()) GTEST_SKIP() << "no picture module";
    if ((suffix == ".mp4" || suffix == ".webm" || suffix == ".webp") && !has_program("ffmpeg"))
      GTEST_SKIP() << "ffmpeg is not installed";
    put_bytes(path(), "old");
  }
  std::string path() const { return folder_ / ("a" + GetParam()); }
  void expect_untouched() const {
    EXPECT_EQ(folder_.contents(), Names{"a" + GetParam()});
    EXPECT_EQ(bytes_of(path()), "old");
  }

  ScratchFolder folder_;
};

TEST_P(FailingClip, MissingFolder) {
  const auto sink = open_clip(folder_ / ("none/a" + GetParam()), {16, 16, 25, 1});
  ASSERT_FALSE(sink);
  EXPECT_EQ(sink.error().code, ErrorCode::kUnwritable);
  EXPECT_NE(sink.error().message.find("make the folder first"), std::string::npos) << sink.error().message;
  expect_untouched();
}

TEST_P(FailingClip, AFrameOfAnotherSize) {
  auto sink = open_clip(path(), {16, 16, 25, 1});
  ASSERT_TRUE(sink) << to_string(sink.error());
  ASSERT_TRUE((*sink)->write(bands(16, 16, 0).view()));
  EXPECT_FALSE((*sink)->write(bands(16, 18, 0).view()));
  EXPECT_FALSE((*sink)->finish());
  expect_untouched();
}

TEST_P(FailingClip, NoFrame) {
  auto sink = open_clip(path(), {16, 16, 25, 1});
  ASSERT_TRUE(sink) << to_string(sink.error());
  const auto done = (*sink)->finish();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kUsage);
  expect_untouched();
}

TEST_P(FailingClip, Abandoned) {
  {
    auto sink = open_clip(path(), {16, 16, 25, 1});
    ASSERT_TRUE(sink) << to_string(sink.error());
    for (int i = 0; i < 3; ++i)
      ASSERT_TRUE((*sink)->write(bands(16, 16, i).view()));
  }
  expect_untouched();
}

/// The system's limit on the size of files stands in for a disk that fills: writes fail half-way in the same calls.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    previous_ = signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    signal(SIGXFSZ, previous_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  sighandler_t previous_ = SIG_DFL;
};

TEST_P(FailingClip, TheDiskFills) {
  Result<void> done;
  {
    const FileSizeLimit limit(8000);
    done = write_clip(path(), {128, 128, 25, 1}, 12, true);
  }
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kUnwritable);
  EXPECT_NE(done.error().message.find(';'), std::string::npos) << "says what to do: " << done.error().message;
  expect_untouched();
}

INSTANTIATE_TEST_SUITE_P(Suffixes, FailingClip, testing::Values(".y4m", ".mp4", ".webm", ".webp", ".gif", ".png"),
                         [](const auto& made) { return made.param.substr(1); });

TEST(Ffmpeg, MissingIsSaidWithThePackage) {
  const ScratchFolder folder;
  const ScopedVariable program("AUSLANJAM_FFMPEG", "/nonexistent/ffmpeg");
  const auto sink = open_clip(folder / "a.mp4", {16, 16, 25, 1});
  ASSERT_FALSE(sink);
  EXPECT_EQ(sink.error().code, ErrorCode::kNotFound);
  EXPECT_NE(sink.error().message.find("apt install ffmpeg"), std::string::npos) << sink.error().message;
  EXPECT_EQ(folder.contents(), Names{});
}

TEST(Ffmpeg, ThatDiesIsQuotedAndDoesNotTakeUsWithIt) {
  const ScratchFolder folder;
  put_bytes(folder / "broken", "#!/bin/sh\nhead -c 100 >/dev/null\necho 'the encoder is on fire' >&2\nexit 3\n");
  chmod((folder / "broken").c_str(), 0755);
  const ScopedVariable program("AUSLANJAM_FFMPEG", (folder / "broken").c_str());
  const auto done = write_clip(folder / "a.mp4", {640, 360, 25, 1}, 50);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kUnwritable);
  EXPECT_NE(done.error().message.find("the encoder is on fire"), std::string::npos) << done.error().message;
  EXPECT_NE(done.error().message.find("exit status 3"), std::string::npos) << done.error().message;
  EXPECT_EQ(folder.contents(), Names{"broken"});
}

TEST(Ffmpeg, APathIsNeverAnOptionOrAProtocol) {
  if (!has_program("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  const ScratchFolder folder;
  for (const std::string name : {"-y.mp4", "a b;$(x)%d.mp4", "pipe:1.mp4"}) {
    const auto done = write_clip(folder / name, {16, 16, 25, 1}, 2);
    ASSERT_TRUE(done) << name << ": " << to_string(done.error());
    EXPECT_FALSE(bytes_of(folder / name).empty()) << name;
  }
  EXPECT_EQ(folder.contents().size(), 3U);
}

}  // namespace
}  // namespace auslan
