// SPDX-License-Identifier: Apache-2.0
// figure_sheets FOLDER [AVATAR...] writes what a person should look at after a change of the figure or of the signing:
// FOLDER/figure.png, every handshape from the viewer's side and from behind (FOLDER/handshapes.png), every letter of
// the alphabet (FOLDER/letters.png), and the same sentence signed by the figure and by each avatar
// that is there: FOLDER/avatars.png.
#include "avatar_images.h"
#include "body.h"
#include "gltf/avatar_gltf.h"
#include "kinematics/arm_ik.h"
#include "kinematics/rotation.h"
#include "media/picture.h"
#include "sheet.h"
#include "shipped.h"
#include "stage/stage.h"
#include "synthesis/mouthing.h"
#include "synthesis/non_manual.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace auslan::sheets {
namespace {

constexpr int kCell = 240;

StageOptions before_background_of(const Figure& figure, const std::string& appearance);

Picture drawn(const Figure& figure, const Pose& pose, CameraName camera, const std::string& appearance = "") {
  StageOptions options = before_background_of(figure, appearance);
  options.width = options.height = kCell;
  options.camera = camera;
  Stage stage = Stage::build(figure, options).value();
  Picture picture = make_picture(kCell, kCell);
  stage.render(pose, picture.pixels);
  return picture;
}

/// The shipped figure in a level of detail and an appearance.
Figure figure_of(const std::string& file, const std::string& appearance) {
  Figure figure = read_figure(std::string(AUSLANJAM_BINARY_DIR) + "/share/auslanjam/" + file).value();
  if (!appearance.empty()) put_on(figure, appearance).value();
  return figure;
}

StageOptions before_background_of(const Figure& figure, const std::string& appearance) {
  StageOptions options;
  for (const Appearance& look : figure.appearances)
    if (look.name == appearance || (appearance.empty() && &look == &figure.appearances.front()))
      options.background = uint32_t{look.background.x} << 16U | uint32_t{look.background.y} << 8U | look.background.z;
  return options;
}

/// What lies round the right hand's knuckles, from a larger picture.
Picture hand_close_up(const Figure& figure, const Pose& pose) {
  constexpr int kLarge = 5 * kCell / 2;
  const Skeleton& skeleton = figure.skeleton;
  std::vector<Transform> world(static_cast<size_t>(skeleton.size()));
  forward(skeleton, pose, world);
  const int knuckle = arm_nodes(skeleton, Side::kRight).digits[2][0];
  const raster::Camera camera = stage_camera(figure, CameraName::kHands, 1.0F);
  const glm::vec4 clip = camera.clip_from_view * camera.view_from_world *
                         glm::vec4(glm::vec3(world[static_cast<size_t>(knuckle)].position), 1.0F);
  const auto pixel = [](float unit) {
    return std::clamp(static_cast<int>((unit + 1.0F) * 0.5F * kLarge) - kCell / 2, 0, kLarge - kCell);
  };
  const int left = pixel(clip.x / clip.w);
  const int top = pixel(-clip.y / clip.w);
  StageOptions options;
  options.width = options.height = kLarge;
  options.camera = CameraName::kHands;
  Stage stage = Stage::build(figure, options).value();
  Picture large = make_picture(kLarge, kLarge);
  stage.render(pose, large.pixels);
  Picture part = make_picture(kCell, kCell);
  for (int y = 0; y < kCell; ++y)
    std::copy_n(large.pixels.begin() + static_cast<std::ptrdiff_t>(top + y) * kLarge + left, kCell,
                part.pixels.begin() + static_cast<std::ptrdiff_t>(y) * kCell);
  return part;
}

/// Arms hanging, as before and after all signing.
Pose standing() {
  static const Pose pose = [] {
    PerformanceOptions still;
    still.idle = false;
    Pose made;
    Performance(*shipped().signer, score_of({"WHERE"}), still).sample(0, made);
    return made;
  }();
  return pose;
}

/// Both hands before the body.
Pose signing() {
  PerformanceOptions still;
  still.idle = false;
  const Score score = score_of({"WHERE"});
  Pose pose;
  Performance(*shipped().signer, score, still).sample(score.glosses.front().end - ticks(0.05), pose);
  return pose;
}

Pose with_face(const FaceWeights& face) {
  Pose pose = standing();
  pose.face = face;
  return pose;
}

/// The right hand up before the shoulder in a handshape, its palm to the viewer, or to the signer.
Pose showing(const Handshape& handshape, bool from_behind = false) {
  const Signer& signer = *shipped().signer;
  const Skeleton& skeleton = shipped().figure.skeleton;
  Posture posture;
  posture.fingers = {0, 1, 0};
  posture.palm = {0, 0, from_behind ? -1 : 1};
  posture.offset = Vec3(0.0, 0.0, 0.25);
  const HandState state = signer.place(posture, handshape, Side::kRight, {}).state;
  Pose pose = standing();
  const ArmNodes nodes = arm_nodes(skeleton, Side::kRight);
  const Transform trunk{kIdentity, skeleton.rest_position(nodes.trunk)};
  const ArmSolution arm = solve_arm(skeleton, Side::kRight, trunk, state.wrist, state.swivel);
  pose_arm(nodes, arm, pose);
  pose_hand(skeleton, Side::kRight, state.angles, pose);
  return pose;
}

Row views() {
  Row row{"Views, at rest and signing", {}};
  for (const CameraName camera : {CameraName::kFront, CameraName::kThreeQuarter, CameraName::kSide, CameraName::kFace})
    row.cells.push_back(
        {std::string(kCameraNames[static_cast<size_t>(camera)]), drawn(shipped().figure, standing(), camera)});
  for (const CameraName camera : {CameraName::kSigner, CameraName::kHands})
    row.cells.push_back({std::string(kCameraNames[static_cast<size_t>(camera)]) + ", WHERE",
                         drawn(shipped().figure, signing(), camera)});
  return row;
}

/// The right arm out as far as it goes with the help of its clavicle.
Row reaching() {
  const Skeleton& skeleton = shipped().figure.skeleton;
  const ArmNodes nodes = arm_nodes(skeleton, Side::kRight);
  const Transform trunk{kIdentity, skeleton.rest_position(nodes.trunk)};
  Row row{"At the edge of reach", {}};
  for (const auto& [label, direction] :
       {std::pair("forwards", Vec3(0, 0.1, 1)), std::pair("across", Vec3(0.7, 0, 1)),
        std::pair("up", Vec3(-0.1, 1, 0.2)), std::pair("up and aside", Vec3(-1, 1, 0.2)),
        std::pair("aside", Vec3(-1, 0, 0.1))}) {
    const Vec3 far = skeleton.rest_position(nodes.shoulder) + unit(direction);
    const Transform wrist{orient_hand(rest_hand_frame(skeleton, Side::kRight), direction, Vec3(0, -0.3, 1)), far};
    Pose pose = standing();
    pose_arm(nodes, solve_arm(skeleton, Side::kRight, trunk, wrist, 0.3), pose);
    for (const CameraName camera : {CameraName::kFront, CameraName::kThreeQuarter})
      row.cells.push_back({label, drawn(shipped().figure, pose, camera)});
  }
  return row;
}

Row hands() {
  Row row{"Handshapes", {}};
  for (const char* id :
       {"flat", "fist", "point", "two", "okay", "good", "spread", "letter_c", "hook", "love", "bad", "mother"}) {
    const auto handshape = shipped().lexicon->handshape(id);
    row.cells.push_back({id, hand_close_up(shipped().figure, showing(handshape.value().value()))});
  }
  return row;
}

/// Every handshape of the lexicon: its palm, and its back.
Row all_handshapes() {
  Row row{"All handshapes: palm to the viewer, back to the viewer", {}};
  const std::vector<Handshape> handshapes = shipped().lexicon->handshapes().value();
  for (const Handshape& handshape : handshapes) {
    row.cells.push_back({handshape.id, hand_close_up(shipped().figure, showing(handshape))});
    row.cells.push_back({handshape.id + ", back", hand_close_up(shipped().figure, showing(handshape, true))});
  }
  return row;
}

/// Every letter as it is held, from the viewer's side, and its hands from nearer.
Row all_letters() {
  Row row{"The alphabet, held, from the viewer's side", {}};
  PerformanceOptions still;
  still.idle = false;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const Score score = score_of({std::string("fs:") + letter});
    Pose pose;
    Performance(*shipped().signer, score, still).sample(score.glosses.front().end - ticks(0.05), pose);
    row.cells.push_back({std::string(1, letter), drawn(shipped().figure, pose, CameraName::kFront)});
    row.cells.push_back({std::string(1, letter) + ", hands", drawn(shipped().figure, pose, CameraName::kHands)});
  }
  return row;
}

Row mouths() {
  Row row{"Mouth shapes of speech", {}};
  for (int i = 0; i < kVisemeCount; ++i)
    row.cells.push_back({std::string(kVisemeNames[static_cast<size_t>(i)]),
                         drawn(shipped().figure, with_face(weights_of(static_cast<Viseme>(i))), CameraName::kFace)});
  return row;
}

Row expressions() {
  struct Expression {
    const char* label;
    bool (*add)(std::string_view, FaceWeights&);
    const char* word;
  };
  Row row{"Expressions", {}};
  const auto gaze = [](std::string_view word, FaceWeights& face) {
    BodyFeature body;
    return add_gaze(word, body, face);
  };
  for (const Expression& one : {Expression{"brows raised", add_brows, "raise"},
                                {"brows furrowed", add_brows, "furrow"},
                                {"inner brows raised", add_brows, "inner-raise"},
                                {"eyes wide", add_eyes, "wide"},
                                {"eyes narrow", add_eyes, "narrow"},
                                {"eyes closed", add_eyes, "closed"},
                                {"smile", add_mouth, "smile"},
                                {"mouth down", add_mouth, "down-turned"},
                                {"cheeks puffed", add_cheeks, "puffed"},
                                {"pained", add_face, "pained"},
                                {"dislike", add_face, "dislike"},
                                {"gaze left", +gaze, "left"}}) {
    FaceWeights face{};
    if (!one.add(one.word, face)) throw std::runtime_error(std::string("no such word: ") + one.word);
    row.cells.push_back({one.label, drawn(shipped().figure, with_face(face), CameraName::kFace)});
  }
  return row;
}

Row appearances() {
  Row row{"Appearances", {}};
  for (const Appearance& look : shipped().figure.appearances) {
    const Figure figure = figure_of("signer.figure", look.name);
    row.cells.push_back({look.name, drawn(figure, signing(), CameraName::kFront, look.name)});
  }
  return row;
}

Row levels() {
  Row row{"Levels of detail", {}};
  for (const char* level : {"low", "normal", "high"}) {
    const std::string name = level;
    const Figure figure = figure_of(name == "normal" ? "signer.figure" : "signer_" + name + ".figure", "");
    row.cells.push_back({name, drawn(figure, standing(), CameraName::kFace)});
    row.cells.push_back({name, hand_close_up(figure, showing(shipped().lexicon->handshape("two").value().value()))});
  }
  return row;
}

Row sentence(const std::string& name, const Body& body) {
  const Signer signer = Signer::build(*body.figure, body.traits()).value();
  const Score score =
      choreograph(signer, utterance_of({"HELLO", "MY", "NAME", "fs:K", "fs:I", "fs:M", "HURT", "WHERE"})).value();
  PerformanceOptions still;
  still.idle = false;
  const Performance performance(signer, score, still);
  StageOptions options = before_background_of(*body.figure, "");
  options.width = options.height = kCell;
  Stage stage = body.stage(options).value();
  Row row{name, {}};
  for (const GlossSpan& gloss : score.glosses) {
    Pose pose;
    performance.sample(gloss.end - ticks(0.05), pose);
    Picture picture = make_picture(kCell, kCell);
    stage.render(pose, picture.pixels);
    row.cells.push_back({gloss.label, std::move(picture)});
  }
  return row;
}

Row sentence_of_avatar(const std::string& path) {
  const SigningAvatar avatar = fit_avatar(read_avatar(path).value()).value();
  std::vector<std::string> warnings;
  const std::vector<std::optional<raster::Texture>> textures = decode_images(avatar.avatar, warnings);
  return sentence(avatar.avatar.name, Body{&avatar.figure, &avatar, textures});
}

void write(const std::string& path, const Picture& picture) {
  if (const auto written = write_png(path, picture.view()); !written) throw std::runtime_error(written.error().message);
}

void write_all(const std::string& folder, std::span<char*> avatars) {
  const CaptionPainter text = CaptionPainter::open().value();
  write(folder + "/figure.png",
        contact_sheet({views(), reaching(), hands(), mouths(), expressions(), appearances(), levels()}, 6, kCell, kCell,
                      text));
  write(folder + "/handshapes.png", contact_sheet({all_handshapes()}, 12, kCell, kCell, text));
  write(folder + "/letters.png", contact_sheet({all_letters()}, 8, kCell, kCell, text));
  if (avatars.empty()) return;
  std::vector<Row> rows = {sentence("signer", Body{.figure = &shipped().figure})};
  for (const char* path : avatars) {
    if (std::filesystem::exists(path)) {
      rows.push_back(sentence_of_avatar(path));
    } else {
      std::fprintf(stderr, "figure_sheets: there is no %s; the sheet goes without it\n", path);
    }
  }
  write(folder + "/avatars.png", contact_sheet(rows, 8, kCell, kCell, text));
}

}  // namespace
}  // namespace auslan::sheets

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: figure_sheets FOLDER [AVATAR...]\n");
    return 2;
  }
  try {
    auslan::sheets::write_all(argv[1], std::span(argv + 2, argv + argc));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "figure_sheets: %s\n", error.what());
    return 1;
  }
  return 0;
}
