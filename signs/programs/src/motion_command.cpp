// SPDX-License-Identifier: Apache-2.0
// `motion`: the motion itself, frame by frame.
#include "commands.h"
#include "frame_maker.h"
#include "media/motion_file.h"
#include "progress.h"
#include "session.h"
#include "stop_request.h"

#include <algorithm>
#include <vector>

namespace auslan {

Result<void> run_motion(const Options& options) {
  Session session(options);
  const auto show = session.show();
  if (!show) return tl::unexpected(show.error());
  for (const std::string& warning : show->warnings)
    remark(options, "auslanjam: " + warning);
  const auto figure = session.figure();
  if (!figure) return tl::unexpected(figure.error());
  MotionHeader header;
  header.fps = options.fps;
  for (const GlossSpan& gloss : show->glosses)
    header.glosses.push_back({gloss.label, seconds(gloss.begin), seconds(gloss.end)});
  auto sink = open_motion(options.output, header, (*figure)->skeleton);
  if (!sink) return tl::unexpected(sink.error());
  const int64_t count = options.at ? 1 : frame_count(*show, options.fps);
  Progress progress("writing", count, options.quiet);
  Pose pose;
  std::vector<Transform> world(static_cast<size_t>((*figure)->skeleton.size()));
  for (int64_t i = 0; i < count; ++i) {
    if (stop_requested()) return stopped();
    const Tick time = options.at ? std::min(ticks(*options.at), show->end) : frame_time(i, options.fps);
    show->sample(time, pose);
    forward((*figure)->skeleton, pose, world);
    if (auto written = (*sink)->write(seconds(time), pose, world); !written) return written;
    progress.update(i + 1);
  }
  return (*sink)->finish();
}

}  // namespace auslan
