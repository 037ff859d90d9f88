// SPDX-License-Identifier: Apache-2.0
#include "media/window.h"

#include "letterbox.h"

#include <SDL2/SDL.h>
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

namespace auslan {

namespace {

constexpr int kAttempts = 5;
constexpr Uint32 kBetweenAttemptsMs = 100;

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

/// SDL's video subsystem, counted: each object holds it once.
class Video {
 public:
  static Result<Video> start() {
    if (!is_set("DISPLAY"))
      return fail(ErrorCode::kNotFound,
                  is_set("WAYLAND_DISPLAY")
                      ? "this Wayland session has no X server for the window; install Xwayland, or write a clip with "
                        "`auslanjam render`"
                      : "there is no display here (DISPLAY is not set); run this in a desktop session, or write a clip "
                        "with `auslanjam render`");
    // Read when the window's surface is made. Without it even SDL's software path goes through OpenGL.
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "0");
    if (!is_set("SDL_VIDEODRIVER")) SDL_SetHint(SDL_HINT_VIDEODRIVER, "x11");
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0)
      return fail(ErrorCode::kNotFound, std::string("the display ") + std::getenv("DISPLAY") +
                                            " does not answer: " + SDL_GetError() +
                                            "; check DISPLAY and the rights to it, or write a clip with `auslanjam "
                                            "render`");
    return Video();
  }

  Video(Video&& other) noexcept : held_(std::exchange(other.held_, false)) {}
  Video& operator=(Video&& other) noexcept {
    std::swap(held_, other.held_);
    return *this;
  }
  ~Video() {
    if (held_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
  }

 private:
  Video() = default;
  bool held_ = true;
};

tl::unexpected<Error> not_drawn() {
  return fail(ErrorCode::kUnwritable,
              std::string("the window cannot be drawn: ") + SDL_GetError() + "; the display may be gone, start again");
}

bool event_of_key(SDL_Keycode key, WindowEvent& event) {
  using enum WindowEvent;
  switch (key) {
    case SDLK_ESCAPE:
      event = kEscape;
      return true;
    case SDLK_SPACE:
      event = kSpace;
      return true;
    case SDLK_r:
      event = kReplay;
      return true;
    case SDLK_LEFT:
      event = kLeft;
      return true;
    case SDLK_RIGHT:
      event = kRight;
      return true;
    case SDLK_q:
      event = kQuitKey;
      return true;
    default:
      return false;
  }
}

}  // namespace

bool display_available() {
  return Video::start().has_value();
}

struct Window::State {
  explicit State(Video started) : video(std::move(started)) {}
  ~State() {
    if (window != nullptr) SDL_DestroyWindow(window);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  /// SDL throws the surface away when the window changes its size; asking again makes the new one.
  SDL_Surface* surface() { return SDL_GetWindowSurface(window); }
  void push(WindowEvent event) { events.push_back(event); }

  Video video;
  SDL_Window* window = nullptr;
  Uint32 id = 0;
  bool shown = false;  ///< the surface holds a picture that an exposure may repeat
  std::vector<WindowEvent> events;
  std::vector<SDL_Rect> changed;  ///< of the last show_changes
};

Window::Window(std::unique_ptr<State> state) : state_(std::move(state)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

Result<Window> Window::open(const std::string& title, int width, int height) {
  if (width < 1 || height < 1 || width > 16384 || height > 16384)
    return fail(ErrorCode::kUsage, "a window must measure from 1x1 to 16384x16384 pixels");
  auto video = Video::start();
  // A bare X server starts afresh when its last client leaves, as display_available() may just have done, and turns
  // clients away for a moment.
  for (int attempt = 0; attempt < kAttempts && !video && is_set("DISPLAY"); ++attempt) {
    SDL_Delay(kBetweenAttemptsMs);
    video = Video::start();
  }
  if (!video) return tl::unexpected(video.error());
  auto state = std::make_unique<State>(std::move(*video));
  state->window = SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                                   SDL_WINDOW_RESIZABLE);
  if (state->window == nullptr)
    return fail(ErrorCode::kUnsupported,
                std::string("no window opens: ") + SDL_GetError() + "; write a clip with `auslanjam render`");
  state->id = SDL_GetWindowID(state->window);
  const SDL_Surface* surface = state->surface();
  if (surface == nullptr || surface->format->BytesPerPixel != 4 || surface->format->Rmask != 0xFF0000 ||
      surface->format->Gmask != 0xFF00 || surface->format->Bmask != 0xFF)
    return fail(ErrorCode::kUnsupported,
                "the display does not take 32-bit pixels; use a display of 24-bit colour, or write a clip with "
                "`auslanjam render`");
  state->events.reserve(64);
  return Window(std::move(state));
}

Result<void> Window::show(FrameView frame) {
  if (!is_well_formed(frame)) return fail(ErrorCode::kUsage, "a picture's size does not agree with its pixels");
  SDL_Surface* surface = state_->surface();
  if (surface == nullptr || (SDL_MUSTLOCK(surface) && SDL_LockSurface(surface) != 0)) return not_drawn();
  letterbox(frame, {static_cast<uint32_t*>(surface->pixels), surface->w, surface->h,
                    surface->pitch / static_cast<int>(sizeof(uint32_t))});
  if (SDL_MUSTLOCK(surface)) SDL_UnlockSurface(surface);
  if (SDL_UpdateWindowSurface(state_->window) != 0) return not_drawn();
  state_->shown = true;
  return {};
}

Result<void> Window::show_changes(FrameView frame, std::span<const PixelRect> changed) {
  SDL_Surface* surface = state_->surface();
  if (!state_->shown || surface == nullptr || surface->w != frame.width || surface->h != frame.height ||
      !is_well_formed(frame))
    return show(frame);
  state_->changed.clear();
  for (const PixelRect& rect : changed) {
    const PixelRect inside = intersection(rect, {0, 0, frame.width, frame.height});
    if (inside.width > 0) state_->changed.push_back({inside.x, inside.y, inside.width, inside.height});
  }
  if (state_->changed.empty()) return {};
  if (SDL_MUSTLOCK(surface) && SDL_LockSurface(surface) != 0) return not_drawn();
  for (const SDL_Rect& rect : state_->changed)
    for (int y = rect.y; y < rect.y + rect.h; ++y) {
      const uint32_t* from = &frame.pixels[static_cast<size_t>(y) * static_cast<size_t>(frame.width)];
      auto* to = reinterpret_cast<uint32_t*>(static_cast<std::byte*>(surface->pixels) + ptrdiff_t{y} * surface->pitch);
      std::copy(from + rect.x, from + rect.x + rect.w, to + rect.x);
    }
  if (SDL_MUSTLOCK(surface)) SDL_UnlockSurface(surface);
  if (SDL_UpdateWindowSurfaceRects(state_->window, state_->changed.data(), static_cast<int>(state_->changed.size())) !=
      0)
    return not_drawn();
  return {};
}

std::span<const WindowEvent> Window::poll() {
  state_->events.clear();
  bool exposed = false;
  bool resized = false;
  SDL_Event event;
  while (SDL_PollEvent(&event) != 0) {
    WindowEvent key{};
    if (event.type == SDL_QUIT) {
      state_->push(WindowEvent::kQuit);
    } else if (event.type == SDL_KEYDOWN && event_of_key(event.key.keysym.sym, key)) {
      state_->push(key);
    } else if (event.type == SDL_WINDOWEVENT && event.window.windowID == state_->id) {
      exposed |= event.window.event == SDL_WINDOWEVENT_EXPOSED;
      resized |= event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED;
    }
  }
  if (resized) {
    state_->shown = false;
    state_->push(WindowEvent::kResized);
  } else if (exposed && state_->shown) {
    SDL_UpdateWindowSurface(state_->window);
  }
  return state_->events;
}

int Window::width() const {
  int width = 0;
  SDL_GetWindowSize(state_->window, &width, nullptr);
  return width;
}

int Window::height() const {
  int height = 0;
  SDL_GetWindowSize(state_->window, nullptr, &height);
  return height;
}

}  // namespace auslan
