// SPDX-License-Identifier: Apache-2.0
// The window, on a real X server of this test's own (Xvfb).
#include "media/picture.h"
#include "media/picture_module.h"
#include "media/window.h"
#include "scratch_folder.h"

#include <SDL2/SDL.h>
#include <algorithm>
#include <chrono>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <optional>
#include <signal.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

// SDL opens a D-Bus connection and never gives back libdbus's own tables; that is not ours to mend.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libdbus-1.so";
}

namespace auslan {
namespace {

/// Xvfb on a display number that it chooses itself.
class Screen {
 public:
  Screen() {
    int ends[2];
    if (pipe(ends) != 0) return;
    pid_ = fork();
    if (pid_ == 0) {
      const std::string number = std::to_string(ends[1]);
      close(ends[0]);
      const int nothing = open("/dev/null", O_WRONLY);
      dup2(nothing, STDERR_FILENO);
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "640x480x24", "-nolisten", "tcp", nullptr);
      _exit(127);
    }
    close(ends[1]);
    char digit = 0;
    while (read(ends[0], &digit, 1) == 1 && digit != '\n')
      display_ += digit;
    close(ends[0]);
    if (!display_.empty()) display_ = ":" + display_;
  }
  ~Screen() {
    if (pid_ <= 0) return;
    kill(pid_, SIGTERM);
    waitpid(pid_, nullptr, 0);
  }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  const std::string& display() const { return display_; }

 private:
  pid_t pid_ = -1;
  std::string display_;
};

Picture gradient(int width, int height) {
  Picture picture = make_picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      picture.pixels[static_cast<size_t>(y * width + x)] =
          static_cast<uint32_t>(x & 255) << 16 | static_cast<uint32_t>(y & 255) << 8 | 0x55;
  return picture;
}

class OnScreen : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_program("Xvfb")) GTEST_SKIP() << "Xvfb is not installed (Debian: xvfb)";
    screen_.emplace();
    ASSERT_FALSE(screen_->display().empty()) << "Xvfb does not start";
    display_.emplace("DISPLAY", screen_->display().c_str());
  }

  /// What an independent program sees on the whole screen.
  std::optional<Picture> screenshot() {
    const std::string path = folder_ / "screen.png";
    if (!run("import -window root -depth 8 PNG24:" + path).ok) return std::nullopt;
    auto read = read_png(path);
    if (!read) return std::nullopt;
    return std::move(*read);
  }

  static bool has_eyes() { return has_program("import") && load_picture_module().has_value(); }

  /// Polls until the event is there, or gives up after five seconds.
  static bool arrives(Window& window, WindowEvent wanted) {
    for (int i = 0; i < 500; ++i) {
      const auto events = window.poll();
      if (std::ranges::find(events, wanted) != events.end()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  ScratchFolder folder_;
  std::optional<Screen> screen_;
  std::optional<ScopedVariable> display_;
};

/// The part of a picture.
Picture cut(const Picture& from, int x0, int y0, int width, int height) {
  Picture part = make_picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      part.pixels[static_cast<size_t>(y * width + x)] =
          from.pixels[static_cast<size_t>((y + y0) * from.width + x + x0)];
  return part;
}

TEST_F(OnScreen, ShowsExactlyThePixelsOfTheFrame) {
  if (!has_eyes()) GTEST_SKIP() << "ImageMagick's import or the picture module is missing";
  EXPECT_TRUE(display_available());
  auto window = Window::open("gradient", 320, 200);
  ASSERT_TRUE(window) << to_string(window.error());
  EXPECT_EQ(window->width(), 320);
  EXPECT_EQ(window->height(), 200);
  window->poll();
  const Picture picture = gradient(320, 200);
  ASSERT_TRUE(window->show(picture.view()));
  const auto seen = screenshot();
  ASSERT_TRUE(seen);
  // Centred on a screen of 640x480.
  const auto difference = compare(picture.view(), cut(*seen, 160, 140, 320, 200).view());
  EXPECT_TRUE(difference.equal()) << to_string(difference);
}

TEST_F(OnScreen, SendsNoMoreThanTheChanges) {
  if (!has_eyes()) GTEST_SKIP() << "ImageMagick's import or the picture module is missing";
  auto window = Window::open("changes", 320, 200);
  ASSERT_TRUE(window);
  window->poll();
  // The first picture is shown whole, whatever the changes are.
  const Picture first = gradient(320, 200);
  ASSERT_TRUE(window->show_changes(first.view(), {}));
  // All of the next one is new; two parts, one of which reaches beyond the picture, are said to be.
  const Picture next = make_picture(320, 200, 0x00FF00);
  const PixelRect changed[] = {{10, 20, 30, 40}, {300, 190, 50, 50}, {-5, -5, 3, 3}};
  ASSERT_TRUE(window->show_changes(next.view(), changed));
  Picture expected = first;
  for (const PixelRect& rect : {PixelRect{10, 20, 30, 40}, PixelRect{300, 190, 20, 10}})
    for (int y = rect.y; y < rect.y + rect.height; ++y)
      for (int x = rect.x; x < rect.x + rect.width; ++x)
        expected.pixels[static_cast<size_t>(y * 320 + x)] = 0x00FF00;
  const auto seen = screenshot();
  ASSERT_TRUE(seen);
  const auto difference = compare(expected.view(), cut(*seen, 160, 140, 320, 200).view());
  EXPECT_TRUE(difference.equal()) << to_string(difference);
}

TEST_F(OnScreen, ChangesAfterAResizeShowTheWholePicture) {
  if (!has_program("xdotool") || !has_eyes()) GTEST_SKIP() << "xdotool, import or the picture module is missing";
  auto window = Window::open("again", 200, 200);
  ASSERT_TRUE(window);
  const Picture picture = gradient(200, 200);
  ASSERT_TRUE(window->show_changes(picture.view(), {}));
  window->poll();
  ASSERT_TRUE(run("xdotool search --sync --name again windowsize 300 300").ok);
  ASSERT_TRUE(arrives(*window, WindowEvent::kResized));
  ASSERT_TRUE(run("xdotool search --sync --name again windowsize 200 200 windowmove 0 0").ok);
  ASSERT_TRUE(arrives(*window, WindowEvent::kResized));
  ASSERT_TRUE(window->show_changes(picture.view(), {}));
  const auto seen = screenshot();
  ASSERT_TRUE(seen);
  const auto difference = compare(picture.view(), cut(*seen, 0, 0, 200, 200).view());
  EXPECT_TRUE(difference.equal()) << to_string(difference);
}

TEST_F(OnScreen, ScalesBetweenBlackBars) {
  if (!has_eyes()) GTEST_SKIP() << "ImageMagick's import or the picture module is missing";
  auto window = Window::open("bars", 400, 200);
  ASSERT_TRUE(window);
  window->poll();
  const Picture picture = gradient(100, 100);
  ASSERT_TRUE(window->show(picture.view()));
  const auto seen = screenshot();
  ASSERT_TRUE(seen);
  const Picture shown = cut(*seen, 120, 140, 400, 200);
  // Twice as large, each pixel four times, a bar of 100 at each side.
  Picture expected = make_picture(400, 200);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      expected.pixels[static_cast<size_t>(y * 400 + 100 + x)] =
          picture.pixels[static_cast<size_t>((y / 2) * 100 + x / 2)];
  const auto difference = compare(expected.view(), shown.view());
  EXPECT_TRUE(difference.equal()) << to_string(difference);
}

TEST_F(OnScreen, ReportsKeysAndTheClosedWindow) {
  auto window = Window::open("keys", 320, 200);
  ASSERT_TRUE(window);
  window->poll();
  const std::pair<SDL_Keycode, WindowEvent> keys[] = {
      {SDLK_ESCAPE, WindowEvent::kEscape}, {SDLK_SPACE, WindowEvent::kSpace}, {SDLK_r, WindowEvent::kReplay},
      {SDLK_LEFT, WindowEvent::kLeft},     {SDLK_RIGHT, WindowEvent::kRight}, {SDLK_q, WindowEvent::kQuitKey}};
  for (const auto& [key, wanted] : keys) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym.sym = key;
    ASSERT_EQ(SDL_PushEvent(&event), 1);
    EXPECT_TRUE(arrives(*window, wanted));
  }
  SDL_Event quit{};
  quit.type = SDL_QUIT;
  ASSERT_EQ(SDL_PushEvent(&quit), 1);
  EXPECT_TRUE(arrives(*window, WindowEvent::kQuit));
  EXPECT_TRUE(window->poll().empty());
}

TEST_F(OnScreen, ARealKeyArrivesThroughTheServer) {
  if (!has_program("xdotool")) GTEST_SKIP() << "xdotool is not installed";
  auto window = Window::open("real key", 320, 200);
  ASSERT_TRUE(window);
  ASSERT_TRUE(window->show(gradient(320, 200).view()));
  window->poll();
  // There is no window manager to give the window the keyboard.
  ASSERT_TRUE(run("xdotool search --sync --name 'real key' windowfocus --sync key space").ok);
  EXPECT_TRUE(arrives(*window, WindowEvent::kSpace));
}

TEST_F(OnScreen, SurvivesBeingResized) {
  if (!has_program("xdotool") || !has_eyes()) GTEST_SKIP() << "xdotool, import or the picture module is missing";
  auto window = Window::open("resized", 200, 200);
  ASSERT_TRUE(window);
  const Picture picture = gradient(100, 100);
  ASSERT_TRUE(window->show(picture.view()));
  window->poll();
  ASSERT_TRUE(run("xdotool search --sync --name resized windowsize 300 300 windowmove 0 0").ok);
  ASSERT_TRUE(arrives(*window, WindowEvent::kResized));
  EXPECT_EQ(window->width(), 300);
  ASSERT_TRUE(window->show(picture.view()));
  window->poll();
  const auto seen = screenshot();
  ASSERT_TRUE(seen);
  const Picture shown = cut(*seen, 0, 0, 300, 300);
  EXPECT_EQ(shown.pixels[0], picture.pixels[0]);
  EXPECT_EQ(shown.pixels[300 * 300 - 1], picture.pixels[100 * 100 - 1]);
  EXPECT_EQ(shown.pixels[150 * 300 + 150], picture.pixels[50 * 100 + 50]);
}

TEST_F(OnScreen, BadSizesAreRefused) {
  EXPECT_EQ(Window::open("none", 0, 10).error().code, ErrorCode::kUsage);
  auto window = Window::open("x", 50, 50);
  ASSERT_TRUE(window);
  EXPECT_EQ(window->show({}).error().code, ErrorCode::kUsage);
  EXPECT_EQ(window->show_changes({}, {}).error().code, ErrorCode::kUsage);
}

TEST(NoScreen, IsSaidAndNotTried) {
  const ScopedVariable none("DISPLAY", nullptr);
  EXPECT_FALSE(display_available());
  const auto window = Window::open("nowhere", 320, 200);
  ASSERT_FALSE(window);
  EXPECT_EQ(window.error().code, ErrorCode::kNotFound);
  EXPECT_NE(window.error().message.find("auslanjam render"), std::string::npos) << window.error().message;
}

TEST(NoScreen, ADisplayThatDoesNotAnswerIsSaid) {
  const ScopedVariable dead("DISPLAY", ":9753");
  EXPECT_FALSE(display_available());
  const auto window = Window::open("nowhere", 320, 200);
  ASSERT_FALSE(window);
  EXPECT_NE(window.error().message.find(":9753"), std::string::npos) << window.error().message;
}

TEST(FramePacer, NeverReturnsBeforeAFrameIsDueAndCountsLateness) {
  const auto start = std::chrono::steady_clock::now();
  const FramePacer pacer(50, 1);
  pacer.wait_for(5);
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(100));
  std::this_thread::sleep_until(start + std::chrono::milliseconds(300));
  // Frame 5 was due at 100 ms; it is at least 300 ms now: ten periods of 20 ms.
  EXPECT_GE(pacer.wait_for(5), 9);
}

}  // namespace
}  // namespace auslan
