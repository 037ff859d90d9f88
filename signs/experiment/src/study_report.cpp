// SPDX-License-Identifier: Apache-2.0
#include "experiment/study_report.h"

#include "experiment/line_plot.h"
#include "kinematics/anatomy.h"
#include "kinematics/atomic_file.h"
#include "kinematics/elementary.h"
#include "stage/stage.h"

#include <array>
#include <charconv>
#include <system_error>
#include <utility>

namespace auslan {
namespace {

constexpr std::array<uint32_t, 3> kColours = {0xC0392B, 0x2471A3, 0x1E8449};
constexpr std::array<int, 3> kDashes = {0, 0, 9};
constexpr std::array<const char*, 2> kEndNames = {"90_270_90", "0_270_0"};
constexpr std::array<const char*, 2> kEndTexts = {"(90°, 270°, 90°)", "(0°, 270°, 0°)"};
constexpr int kPictureWidth = 270, kPictureHeight = 200, kPicturesInRow = 8;

std::string number(double value, int digits) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits).ptr;
  return {text, end};
}

std::string scientific(double value) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 1).ptr;
  return {text, end};
}

const StudyRun& run_of(const std::vector<StudyRun>& runs, int end, Method method) {
  return runs[static_cast<size_t>(end) * 3 + static_cast<size_t>(method)];
}

LinePlot plot_of(const std::vector<StudyRun>& runs, int end, bool velocity) {
  LinePlot plot;
  plot.title = std::string(velocity ? "Angular velocity" : "Angular distance to the end pose") +
               ", (0°, 180°, 0°) to " + kEndTexts[static_cast<size_t>(end)];
  plot.x_label = "frame";
  plot.y_label = velocity ? "degrees a frame" : "degrees";
  for (size_t m = 0; m < 3; ++m) {
    const StudyRun& run = run_of(runs, end, static_cast<Method>(m));
    plot.series.push_back(
        {std::string(kMethodNames[m]), kColours[m], kDashes[m], velocity ? run.velocity : run.distance});
  }
  return plot;
}

/// A row a method and end: the figure's right arm at evenly spaced frames.
Result<Picture> picture_strip(const Figure& figure, const std::vector<StudyRun>& runs, const CaptionPainter& text) {
  StageOptions options;
  options.width = kPictureWidth;
  options.height = kPictureHeight;
  options.camera = CameraName::kThreeQuarter;
  options.background = 0xE6EAED;
  auto stage = Stage::build(figure, options);
  if (!stage) return tl::unexpected(stage.error());
  const int label_width = 250;
  Picture strip = make_picture(label_width + kPicturesInRow * kPictureWidth,
                               static_cast<int>(runs.size()) * kPictureHeight, 0xFFFFFF);
  Picture tile = make_picture(kPictureWidth, kPictureHeight);
  Pose pose = rest_pose(figure.skeleton);
  const ArmNodes left = arm_nodes(figure.skeleton, Side::kLeft), right = arm_nodes(figure.skeleton, Side::kRight);
  // The left arm hangs; the right arm's zero orientation is the one that puts the study's start at our rest pose, the
  // arm out to the side.
  pose.rotation[static_cast<size_t>(left.shoulder)] = axis_angle(Vec3(0, 0, 1), -75 * kDegree);
  const Quat zero = glm::conjugate(from_euler(kStudyStart * kDegree, kPaperOrder));
  for (size_t row = 0; row < runs.size(); ++row) {
    const StudyRun& run = runs[row];
    const int top = static_cast<int>(row) * kPictureHeight;
    text.text(strip.span(), 8, top + 92, std::string(kMethodNames[static_cast<size_t>(run.method)]), 15, 0x20262B);
    text.text(strip.span(), 8, top + 116, std::string("to ") + kEndTexts[static_cast<size_t>(run.end)], 15, 0x20262B);
    for (int column = 0; column < kPicturesInRow; ++column) {
      const int frame = column * (kStudyFrames - 1) / (kPicturesInRow - 1);
      pose.rotation[static_cast<size_t>(right.shoulder)] = run.orientation[static_cast<size_t>(frame)] * zero;
      stage->render(pose, tile.span().pixels);
      text.text(tile.span(), 8, 18, std::to_string(frame), 13, 0x20262B);
      for (int y = 0; y < kPictureHeight; ++y)
        for (int x = 0; x < kPictureWidth; ++x)
          strip.pixels[static_cast<size_t>(top + y) * static_cast<size_t>(strip.width) +
                       static_cast<size_t>(label_width + column * kPictureWidth + x)] =
              tile.pixels[static_cast<size_t>(y * kPictureWidth + x)];
    }
  }
  return strip;
}

std::string report(const std::vector<StudyRun>& runs) {
  const double ends = angle_between(run_of(runs, 0, Method::kSlerp).orientation.back(),
                                    run_of(runs, 1, Method::kSlerp).orientation.back()) /
                      kDegree;
  std::string text =
      "# Euler angles, lerp and slerp\n\n"
      "The right shoulder turns from Euler angles (0°, 180°, 0°) to (90°, 270°, 90°) and to (0°, 270°, 0°) in " +
      std::to_string(kStudyFrames) +
      " frames, after section 4.2 of the paper *Auslan Jam: A Graphical Sign Language Display System*. Angles are "
      "about X, "
      "then the new Y, then the newest Z (intrinsic XYZ): of the six axis orders the only one in which the two ends "
      "are the "
      "same orientation, as the paper says they are.\n\n"
      "| end | method | path | velocity: least | mean | most | variation |\n| --- | --- | ---: | ---: | ---: | ---: | "
      "---: |\n";
  for (const StudyRun& run : runs) {
    const StudySummary s = summarise(run);
    text += std::string("| ") + kEndTexts[static_cast<size_t>(run.end)] + " | " +
            std::string(kMethodNames[static_cast<size_t>(run.method)]) + " | " + number(s.path_degrees, 2) + "° | " +
            number(s.least, 5) + " | " + number(s.mean, 5) + " | " + number(s.most, 5) + " | " +
            scientific(s.variation) + " |\n";
  }
  text += "\nVelocity is in degrees a frame; variation is (most - least) / mean.\n\n## What the numbers show\n\n";
  text += "- The two ends are the same orientation: they lie " + scientific(ends) + "° apart.\n";
  text += "- Interpolated Euler angles take different paths to them: the runs are up to " +
          number(largest_separation(run_of(runs, 0, Method::kEuler), run_of(runs, 1, Method::kEuler)), 2) +
          "° apart at the same frame, and their paths are " +
          number(summarise(run_of(runs, 0, Method::kEuler)).path_degrees, 2) + "° and " +
          number(summarise(run_of(runs, 1, Method::kEuler)).path_degrees, 2) + "° long.\n";
  text += "- lerp takes the same path whichever end is given (runs at most " +
          scientific(largest_separation(run_of(runs, 0, Method::kLerp), run_of(runs, 1, Method::kLerp))) +
          "° apart), and so does slerp (" +
          scientific(largest_separation(run_of(runs, 0, Method::kSlerp), run_of(runs, 1, Method::kSlerp))) + "°).\n";
  const double slerp = summarise(run_of(runs, 0, Method::kSlerp)).variation;
  const double lerp = summarise(run_of(runs, 0, Method::kLerp)).variation;
  const double euler = summarise(run_of(runs, 0, Method::kEuler)).variation;
  const double plain = summarise(run_of(runs, 1, Method::kEuler)).variation;
  text += "- slerp's speed is constant (variation " + scientific(slerp) + "); lerp's is not (" + number(100 * lerp, 1) +
          " % of its mean: fastest half way), nor is that of Euler angles to (90°, 270°, 90°) (" +
          number(100 * euler, 1) + " %).\n";
  text +=
      "- To (0°, 270°, 0°) only one Euler angle changes, a turn about a fixed axis; that run's speed is constant "
      "(variation " +
      scientific(plain) +
      ") and it is slerp's own path: Euler angles are at their best when they are hardly needed.\n\n"
      "## Files\n\n"
      "`to_*.csv`: angular distance to the end and angular velocity by frame. `distance_*`, `velocity_*`: plots (PNG, "
      "SVG). "
      "`strip.png`: the figure, a row a run. In the pictures the arm's zero orientation is chosen such that the start "
      "is "
      "the arm stretched out to the side.\n";
  return text;
}

Result<void> write_text(const std::filesystem::path& path, const std::string& text) {
  auto file = AtomicFile::create(path.string());
  if (!file) return tl::unexpected(file.error());
  if (auto written = file->write(std::string_view(text)); !written) return written;
  return file->commit();
}

}  // namespace

std::string study_table(const std::vector<StudyRun>& runs, int end) {
  std::string text =
      "frame,euler_distance_deg,euler_velocity_deg,lerp_distance_deg,lerp_velocity_deg,slerp_distance_deg,slerp_"
      "velocity_deg\n";
  for (int frame = 0; frame < kStudyFrames; ++frame) {
    text += std::to_string(frame);
    for (const Method method : {Method::kEuler, Method::kLerp, Method::kSlerp}) {
      const StudyRun& run = run_of(runs, end, method);
      const auto i = static_cast<size_t>(frame);
      text += "," + number(run.distance[i], 9) + "," + (i < run.velocity.size() ? number(run.velocity[i], 9) : "");
    }
    text += "\n";
  }
  return text;
}

Result<std::vector<std::filesystem::path>> write_study(const Figure& figure, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return fail(ErrorCode::kUnwritable, "cannot make the folder (" + error.message() + "); choose another with -o",
                folder.string());
  auto text = CaptionPainter::open();
  if (!text) return tl::unexpected(text.error());
  const std::vector<StudyRun> runs = run_study();
  std::vector<std::filesystem::path> written;
  const auto add_text = [&](const std::string& name, const std::string& content) {
    written.push_back(folder / name);
    return write_text(written.back(), content);
  };
  const auto add_picture = [&](const std::string& name, const Picture& picture) {
    written.push_back(folder / name);
    return write_png(written.back().string(), picture.view());
  };
  for (int end = 0; end < static_cast<int>(kStudyEnds.size()); ++end) {
    const std::string name = kEndNames[static_cast<size_t>(end)];
    if (auto done = add_text("to_" + name + ".csv", study_table(runs, end)); !done) return tl::unexpected(done.error());
    for (const bool velocity : {false, true}) {
      const LinePlot plot = plot_of(runs, end, velocity);
      const std::string file = (velocity ? "velocity_" : "distance_") + name;
      if (auto done = add_text(file + ".svg", to_svg(plot)); !done) return tl::unexpected(done.error());
      if (auto done = add_picture(file + ".png", to_picture(plot, *text)); !done) return tl::unexpected(done.error());
    }
  }
  auto strip = picture_strip(figure, runs, *text);
  if (!strip) return tl::unexpected(strip.error());
  if (auto done = add_picture("strip.png", *strip); !done) return tl::unexpected(done.error());
  if (auto done = add_text("report.md", report(runs)); !done) return tl::unexpected(done.error());
  return written;
}

}  // namespace auslan
