// SPDX-License-Identifier: Apache-2.0
// `sign` and `render`: a show into a window, a clip, a picture or a list of digests.
#include "commands.h"
#include "frame_maker.h"
#include "media/clip.h"
#include "media/window.h"
#include "progress.h"
#include "session.h"
#include "stop_request.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

namespace auslan {
namespace {

/// Draws frames in order, several at once, and hands each to `take`.
template <typename Take>
Result<void> make_frames(const Body& body, const Show& show, const FrameOptions& options, int threads,
                         const std::vector<Tick>& times, Progress& progress, Take take) {
  const auto count = static_cast<int64_t>(times.size());
  const auto workers = static_cast<size_t>(std::clamp<int64_t>(threads, 1, count));
  std::vector<FrameMaker> makers;
  std::vector<Picture> frames;
  for (size_t i = 0; i < workers; ++i) {
    auto maker = FrameMaker::build(body, show, options);
    if (!maker) return tl::unexpected(maker.error());
    makers.push_back(std::move(*maker));
    frames.push_back(make_picture(options.stage.width, options.stage.height));
  }
  for (int64_t first = 0; first < count; first += static_cast<int64_t>(workers)) {
    if (stop_requested()) return stopped();
    const auto batch = static_cast<size_t>(std::min<int64_t>(static_cast<int64_t>(workers), count - first));
    const auto draw = [&](size_t i) { makers[i].make(times[static_cast<size_t>(first) + i], frames[i].span()); };
    std::vector<std::thread> others;
    for (size_t i = 1; i < batch; ++i)
      others.emplace_back(draw, i);
    draw(0);
    for (std::thread& other : others)
      other.join();
    for (size_t i = 0; i < batch; ++i) {
      if (auto taken = take(first + static_cast<int64_t>(i), frames[i].view()); !taken) return taken;
      progress.update(first + static_cast<int64_t>(i) + 1);
    }
  }
  return {};
}

void remark_warnings(const Options& options, const Show& show) {
  for (const std::string& warning : show.warnings)
    remark(options, "auslanjam: " + warning);
}

/// A file name from the text: "Where does it hurt?" gives where-does-it-hurt.mp4.
std::string clip_name(const Options& options) {
  std::string words = options.source.text.value_or("");
  for (const std::string& gloss : options.source.glosses)
    words += gloss + " ";
  std::string name;
  for (const char c : words) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 128 && std::isalnum(byte) != 0) {
      name += static_cast<char>(std::tolower(byte));
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
    if (name.size() >= 40) break;
  }
  while (!name.empty() && name.back() == '-')
    name.pop_back();
  return (name.empty() ? "auslan" : name) + ".mp4";
}

Result<void> render_to(const Options& options, Session& session, const Show& show, const std::string& output,
                       bool caption) {
  const auto body = session.body();
  if (!body) return tl::unexpected(body.error());
  std::vector<Tick> times;
  if (options.at) {
    times.push_back(std::min(ticks(*options.at), show.end));
  } else {
    for (int64_t i = 0; i < frame_count(show, options.fps); ++i)
      times.push_back(frame_time(i, options.fps));
  }
  std::unique_ptr<FrameSink> sink;
  if (!output.empty()) {
    ClipFormat format;
    format.width = options.stage.width;
    format.height = options.stage.height;
    format.fps_numerator = options.fps;
    format.single_picture = options.at.has_value();
    auto opened = open_clip(output, format);
    if (!opened) return tl::unexpected(opened.error());
    sink = std::move(*opened);
  }
  FrameOptions frames;
  frames.stage = session.stage();
  frames.caption = caption;
  std::string digests;
  Progress progress("drawing", static_cast<int64_t>(times.size()), options.quiet);
  auto made = make_frames(*body, show, frames, options.threads, times, progress,
                          [&](int64_t index, FrameView frame) -> Result<void> {
                            if (options.hash) digests += std::to_string(index) + " " + frame_digest(frame) + "\n";
                            return sink ? sink->write(frame) : Result<void>();
                          });
  if (!made) return made;
  if (sink)
    if (auto finished = sink->finish(); !finished) return finished;
  if (options.json) {
    nlohmann::ordered_json report;
    report["output"] = output;
    report["frames"] = times.size();
    report["fps"] = options.fps;
    report["seconds"] = seconds(show.end);
    report["width"] = options.stage.width;
    report["height"] = options.stage.height;
    report["reviewed"] = show.reviewed;
    report["glosses"] = nlohmann::ordered_json::array();
    for (const GlossSpan& gloss : show.glosses)
      report["glosses"].push_back(
          {{"gloss", gloss.label}, {"start", seconds(gloss.begin)}, {"end", seconds(gloss.end)}});
    if (options.hash) {
      report["digests"] = nlohmann::ordered_json::array();
      for (size_t begin = 0; begin < digests.size();) {
        const size_t end = digests.find('\n', begin);
        const size_t space = digests.find(' ', begin);
        report["digests"].push_back(digests.substr(space + 1, end - space - 1));
        begin = end + 1;
      }
    }
    return print(report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  }
  if (options.hash) return print(digests);
  return {};
}

/// Plays a show over and over until the window is closed.
Result<void> play(const Options& options, Session& session, const Show& show) {
  const auto body = session.body();
  if (!body) return tl::unexpected(body.error());
  FrameOptions frames;
  frames.stage = session.stage();
  frames.caption = true;
  auto maker = FrameMaker::build(*body, show, frames);
  if (!maker) return tl::unexpected(maker.error());
  auto window = Window::open("Auslan Jam", options.stage.width, options.stage.height);
  if (!window) return tl::unexpected(window.error());
  remark(options, "space pauses, r plays again, the arrow keys step a frame, q or escape closes");
  Picture frame = make_picture(options.stage.width, options.stage.height);
  FramePacer pacer(options.fps, 1);
  const int64_t count = frame_count(show, options.fps);
  int64_t index = 0, paced = 0;
  bool paused = false, dirty = true;
  while (!stop_requested()) {
    for (const WindowEvent event : window->poll()) {
      switch (event) {
        case WindowEvent::kQuit:
        case WindowEvent::kEscape:
        case WindowEvent::kQuitKey:
          return {};
        case WindowEvent::kSpace:
          paused = !paused;
          break;
        case WindowEvent::kReplay:
          index = 0;
          paused = false;
          break;
        case WindowEvent::kLeft:
          index = std::max<int64_t>(0, index - 1);
          paused = true;
          break;
        case WindowEvent::kRight:
          index = std::min(count - 1, index + 1);
          paused = true;
          break;
        case WindowEvent::kResized:
          break;
      }
      dirty = true;
    }
    if (dirty) {
      const auto changed = maker->update(frame_time(index, options.fps), frame.span());
      if (auto shown = window->show_changes(frame.view(), changed); !shown) return shown;
      dirty = false;
    }
    // A frame that is late already is skipped.
    const int64_t late = pacer.wait_for(++paced);
    paced += late;
    if (!paused && index + 1 < count) {
      index = std::min(count - 1, index + 1 + late);
      dirty = true;
    } else {
      paused = paused || index + 1 >= count;
    }
  }
  return {};
}

}  // namespace

Result<void> run_render(const Options& options) {
  Session session(options);
  const auto show = session.show();
  if (!show) return tl::unexpected(show.error());
  remark_warnings(options, *show);
  return render_to(options, session, *show, options.output, options.caption);
}

Result<void> run_sign(const Options& options) {
  Session session(options);
  const auto show = session.show();
  if (!show) return tl::unexpected(show.error());
  remark_warnings(options, *show);
  if (options.output.empty() && display_available()) return play(options, session, *show);
  const std::string output = options.output.empty() ? clip_name(options) : options.output;
  if (options.output.empty()) remark(options, "there is no display: signing into a clip");
  if (auto rendered = render_to(options, session, *show, output, true); !rendered || options.json) return rendered;
  return print(output + "\n");
}

}  // namespace auslan
