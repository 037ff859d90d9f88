// SPDX-License-Identifier: Apache-2.0
// A window on the screen, without graphics acceleration: the pixels go into the surface that SDL shares with the X
// server.
#pragma once

#include "kinematics/result.h"
#include "media/frame.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace auslan {

/// Whether a window can be opened here: DISPLAY is set and SDL's X11 driver answers. (SDL's Wayland driver offers no
/// surface without graphics acceleration; a Wayland session with Xwayland sets DISPLAY.)
bool display_available();

enum class WindowEvent {
  kQuit,  ///< the window was closed
  kEscape,
  kSpace,
  kReplay,  ///< the key r
  kLeft,
  kRight,
  kQuitKey,  ///< the key q
  kResized,  ///< the picture is gone: show it again. A mere exposure is repaired by poll() itself
};

/// One window. Use from the thread that opened it.
class Window {
 public:
  /// kNotFound: no display. kUnsupported: SDL says why. Sizes in pixels; the user may resize the window.
  static Result<Window> open(const std::string& title, int width, int height);

  Window(Window&&) noexcept;
  Window& operator=(Window&&) noexcept;
  ~Window();

  /// Shows a frame: copied as it is where the sizes agree, else scaled to the largest size of the same shape (nearest
  /// pixel, integer steps) between black bars. kUnwritable when the display is gone.
  Result<void> show(FrameView frame);
  /// The same for a frame that differs from the one shown last within `changed` only, which is the caller's word: no
  /// more than that is copied and sent, where the sizes agree and the window still holds its picture.
  Result<void> show_changes(FrameView frame, std::span<const PixelRect> changed);
  /// Events since the last call; the span holds until the next call.
  std::span<const WindowEvent> poll();

  int width() const;
  int height() const;

 private:
  struct State;
  explicit Window(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Keeps frames in step with the monotonic clock, which enters the program only here. Frame n is due n periods after
/// the start, so that errors do not add up.
class FramePacer {
 public:
  /// Starts now. Both at least 1.
  FramePacer(int fps_numerator, int fps_denominator);
  /// Starts again now, at frame 0.
  void restart();
  /// Sleeps until frame `index` is due. Returns how many whole periods it is late already (0 = in time): what a player
  /// may skip.
  int64_t wait_for(int64_t index) const;

 private:
  int64_t start_ns_ = 0;
  int64_t numerator_;
  int64_t denominator_;
};

}  // namespace auslan
