// SPDX-License-Identifier: Apache-2.0
// The window of a build without SDL2: there is none.
#include "media/window.h"

namespace auslan {

struct Window::State {};

bool display_available() {
  return false;
}

Result<Window> Window::open(const std::string&, int, int) {
  return fail(
      ErrorCode::kUnsupported,
      "this program was built without SDL2 and cannot open a window; install libsdl2-dev and build again, or write "
      "a clip with `auslanjam render`");
}

Window::Window(std::unique_ptr<State> state) : state_(std::move(state)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;
Result<void> Window::show(FrameView) {
  return {};
}
Result<void> Window::show_changes(FrameView, std::span<const PixelRect>) {
  return {};
}
std::span<const WindowEvent> Window::poll() {
  return {};
}
int Window::width() const {
  return 0;
}
int Window::height() const {
  return 0;
}

}  // namespace auslan
