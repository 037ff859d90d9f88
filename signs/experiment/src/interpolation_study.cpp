// SPDX-License-Identifier: Apache-2.0
#include "experiment/interpolation_study.h"

#include "kinematics/elementary.h"
#include "kinematics/interpolate.h"

#include <algorithm>

namespace auslan {

std::vector<StudyRun> run_study() {
  const Vec3 start = kStudyStart * kDegree;
  std::vector<StudyRun> runs;
  for (int end = 0; end < static_cast<int>(kStudyEnds.size()); ++end) {
    const Vec3 target = kStudyEnds[static_cast<size_t>(end)] * kDegree;
    const Quat from = from_euler(start, kPaperOrder), to = from_euler(target, kPaperOrder);
    for (const Method method : {Method::kEuler, Method::kLerp, Method::kSlerp}) {
      StudyRun run;
      run.method = method;
      run.end = end;
      for (int frame = 0; frame < kStudyFrames; ++frame) {
        const double t = static_cast<double>(frame) / static_cast<double>(kStudyFrames - 1);
        switch (method) {
          case Method::kEuler:
            run.orientation.push_back(lerp_euler(start, target, t, kPaperOrder));
            break;
          case Method::kLerp:
            run.orientation.push_back(lerp_normalised(from, to, t));
            break;
          case Method::kSlerp:
            run.orientation.push_back(slerp(from, to, t));
            break;
        }
        run.distance.push_back(angle_between(run.orientation.back(), to) / kDegree);
        if (frame > 0)
          run.velocity.push_back(angle_between(run.orientation[run.orientation.size() - 2], run.orientation.back()) /
                                 kDegree);
      }
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

StudySummary summarise(const StudyRun& run) {
  StudySummary summary;
  summary.least = run.velocity.front();
  for (const double v : run.velocity) {
    summary.path_degrees += v;
    summary.least = std::min(summary.least, v);
    summary.most = std::max(summary.most, v);
  }
  summary.mean = summary.path_degrees / static_cast<double>(run.velocity.size());
  summary.variation = (summary.most - summary.least) / summary.mean;
  return summary;
}

double largest_separation(const StudyRun& a, const StudyRun& b) {
  double largest = 0;
  for (size_t i = 0; i < a.orientation.size() && i < b.orientation.size(); ++i)
    largest = std::max(largest, angle_between(a.orientation[i], b.orientation[i]) / kDegree);
  return largest;
}

}  // namespace auslan
