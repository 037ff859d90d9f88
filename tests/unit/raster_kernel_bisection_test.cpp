// SPDX-License-Identifier: Apache-2.0
// The search that the kernels' tests rely on when they fail: fed with pictures that are wrong on purpose.
#include "raster_bisect.h"
#include "raster_soup.h"

#include <unistd.h>

namespace auslan::raster {
namespace {

namespace fs = std::filesystem;

constexpr FrameSize kSize{64, 48, 1, 0x102030U};

struct Bisection : testing::Test {
  Soup soup = make_soup(7400, kSize.width, kSize.height, 5, 100);
  size_t count = triangle_count(soup.draws);
  Renderer renderer{1, Kernel::kScalar};
  PictureSource right = source_of(renderer, soup.draws, kSize);
  fs::path folder = fs::temp_directory_path() / ("raster_bisection_" + std::to_string(::getpid()));
  ~Bisection() override {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }

  // As `right`, but one pixel is off when triangles from `from` on and before `until` have been drawn.
  PictureSource wrong(size_t from, size_t until = SIZE_MAX) {
    return [this, from, until](size_t triangles, std::vector<uint32_t>& pixels) {
      right(triangles, pixels);
      if (triangles > from && triangles <= until) pixels[5 * static_cast<size_t>(kSize.width) + 7] ^= 1U;
    };
  }
};

TEST_F(Bisection, FindsTheTriangleThatMakesTheDifference) {
  ASSERT_GT(count, 100U);
  for (const size_t bad : {size_t{0}, size_t{1}, count / 3, count - 2, count - 1}) {
    EXPECT_EQ(first_differing(count, right, wrong(bad)), bad);
  }
}

TEST_F(Bisection, SaysNothingOfEqualPictures) {
  EXPECT_EQ(first_differing(count, right, right), std::nullopt);
  EXPECT_TRUE(same_pictures(folder, "equal", soup.draws, kSize, right, right));
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(Bisection, ToldApartFromABackgroundThatIsWrong) {
  const PictureSource other = [this](size_t triangles, std::vector<uint32_t>& pixels) {
    right(triangles, pixels);
    pixels[0] ^= 1U;
  };
  EXPECT_EQ(first_differing(count, right, other), count);
  const testing::AssertionResult result = same_pictures(folder, "background", soup.draws, kSize, right, other);
  EXPECT_FALSE(result);
  EXPECT_NE(std::string(result.message()).find("the empty frame"), std::string::npos) << result.message();
}

// A difference that comes, goes and comes back: what is found is one of its beginnings.
TEST_F(Bisection, ADifferenceThatIsHiddenForAWhileIsFoundWhereOneBegins) {
  const size_t first = count / 4;
  const size_t second = count / 2;
  const PictureSource other = [&, one = wrong(first, first + 10), two = wrong(second)](size_t triangles,
                                                                                       std::vector<uint32_t>& pixels) {
    (triangles > second ? two : one)(triangles, pixels);
  };
  const std::optional<size_t> found = first_differing(count, right, other);
  EXPECT_TRUE(found == first || found == second);
}

TEST_F(Bisection, TheFailureKeepsBothPicturesAndNamesTriangleAndPixel) {
  const size_t bad = soup.draws[0].mesh.indices.size() / 3 + 2;  // number 2 of draw 1
  const testing::AssertionResult result = same_pictures(folder, "proof", soup.draws, kSize, right, wrong(bad));
  ASSERT_FALSE(result);
  const std::string message = result.message();
  EXPECT_NE(message.find("triangle " + std::to_string(bad) + " of the list, number 2 of draw 1"), std::string::npos)
      << message;
  EXPECT_NE(message.find("pixel 7, 5:"), std::string::npos) << message;
  EXPECT_NE(message.find((folder / "proof").string()), std::string::npos) << message;

  // The files hold the list up to the triangle, and differ in one byte.
  const auto bytes_of = [this](const char* name) {
    std::ifstream file(folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string expected = bytes_of("proof.expected.ppm");
  const std::string actual = bytes_of("proof.actual.ppm");
  const std::string header = "P6\n64 48\n255\n";
  ASSERT_EQ(expected.size(), header.size() + 64U * 48U * 3U);
  ASSERT_EQ(actual.size(), expected.size());
  EXPECT_EQ(expected.substr(0, header.size()), header);
  std::vector<uint32_t> pixels;
  right(bad + 1, pixels);
  size_t differing = 0;
  for (size_t i = 0; i < pixels.size(); ++i) {
    const size_t at = header.size() + 3 * i;
    const auto byte = [&](size_t k) { return static_cast<uint32_t>(static_cast<unsigned char>(expected[at + k])); };
    ASSERT_EQ(pack_pixel(byte(0), byte(1), byte(2)), pixels[i]);
    for (size_t k = 0; k < 3; ++k)
      differing += expected[at + k] != actual[at + k] ? 1U : 0U;
  }
  EXPECT_EQ(differing, 1U);
}

}  // namespace
}  // namespace auslan::raster
