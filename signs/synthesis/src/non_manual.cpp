// SPDX-License-Identifier: Apache-2.0
#include "synthesis/non_manual.h"

#include "kinematics/elementary.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace auslan {
namespace {

using enum FaceChannel;
using Weights = std::initializer_list<std::pair<FaceChannel, float>>;

struct Word {
  std::string_view word;
  Weights weights;
};

void add(Weights weights, FaceWeights& sum) {
  for (const auto& [channel, weight] : weights) {
    float& value = sum[static_cast<size_t>(channel)];
    value = std::min(1.0F, value + weight);
  }
}

bool add_word(std::initializer_list<Word> table, std::string_view word, FaceWeights& sum) {
  if (word.empty() || word == "neutral") return true;
  for (const Word& entry : table) {
    if (entry.word != word) continue;
    add(entry.weights, sum);
    return true;
  }
  return false;
}

}  // namespace

bool add_brows(std::string_view word, FaceWeights& weights) {
  return add_word(
      {{"raise",
        {{kBrowInnerUp, 0.9F},
         {kBrowOuterUpLeft, 1.0F},
         {kBrowOuterUpRight, 1.0F},
         {kEyeWideLeft, 0.35F},
         {kEyeWideRight, 0.35F}}},
       {"raise-left", {{kBrowInnerUp, 0.4F}, {kBrowOuterUpLeft, 1.0F}}},
       {"raise-right", {{kBrowInnerUp, 0.4F}, {kBrowOuterUpRight, 1.0F}}},
       {"raise-slight", {{kBrowInnerUp, 0.5F}, {kBrowOuterUpLeft, 0.5F}, {kBrowOuterUpRight, 0.5F}}},
       {"furrow", {{kBrowDownLeft, 1.0F}, {kBrowDownRight, 1.0F}, {kEyeBlinkLeft, 0.12F}, {kEyeBlinkRight, 0.12F}}},
       {"furrow-slight", {{kBrowDownLeft, 0.5F}, {kBrowDownRight, 0.5F}}},
       {"inner-raise", {{kBrowInnerUp, 1.0F}, {kBrowDownLeft, 0.2F}, {kBrowDownRight, 0.2F}}}},
      word, weights);
}

bool add_eyes(std::string_view word, FaceWeights& weights) {
  return add_word(
      {{"wide", {{kEyeWideLeft, 1.0F}, {kEyeWideRight, 1.0F}}},
       {"narrow", {{kEyeSquintLeft, 0.7F}, {kEyeSquintRight, 0.7F}}},
       {"squint", {{kEyeSquintLeft, 1.0F}, {kEyeSquintRight, 1.0F}, {kBrowDownLeft, 0.4F}, {kBrowDownRight, 0.4F}}},
       {"wide-left", {{kEyeWideLeft, 1.0F}}},
       {"wide-right", {{kEyeWideRight, 1.0F}}},
       {"narrow-left", {{kEyeSquintLeft, 0.7F}}},
       {"narrow-right", {{kEyeSquintRight, 0.7F}}},
       {"closed-left", {{kEyeBlinkLeft, 1.0F}}},
       {"closed-right", {{kEyeBlinkRight, 1.0F}}},
       {"squint-left", {{kEyeSquintLeft, 1.0F}, {kEyeBlinkLeft, 0.5F}, {kBrowDownLeft, 0.4F}}},
       {"squint-right", {{kEyeSquintRight, 1.0F}, {kEyeBlinkRight, 0.5F}, {kBrowDownRight, 0.4F}}},
       {"half-closed", {{kEyeBlinkLeft, 0.55F}, {kEyeBlinkRight, 0.55F}}},
       {"blink", {{kEyeBlinkLeft, 1.0F}, {kEyeBlinkRight, 1.0F}}},
       {"closed", {{kEyeBlinkLeft, 1.0F}, {kEyeBlinkRight, 1.0F}}}},
      word, weights);
}

bool add_mouth(std::string_view word, FaceWeights& weights) {
  if (add_mouth_gesture(word, weights)) return true;
  return add_word({{"teeth-showing",
                    {{kMouthStretchLeft, 0.7F},
                     {kMouthStretchRight, 0.7F},
                     {kMouthUpperUpLeft, 0.8F},
                     {kMouthUpperUpRight, 0.8F},
                     {kMouthLowerDownLeft, 0.6F},
                     {kMouthLowerDownRight, 0.6F}}},
                   {"blow", {{kMouthPucker, 0.8F}, {kCheekPuff, 0.5F}}},
                   {"breathe", {{kMouthFunnel, 0.5F}, {kJawOpen, 0.15F}}},
                   {"exhale", {{kMouthFunnel, 0.6F}, {kJawOpen, 0.1F}}},
                   {"open-close", {{kJawOpen, 0.5F}}},
                   {"open", {{kJawOpen, 0.6F}}},
                   {"cough", {{kJawOpen, 0.35F}, {kMouthFunnel, 0.4F}}},
                   {"ow", {{kMouthFunnel, 0.8F}, {kJawOpen, 0.3F}}},
                   {"smile", {{kMouthSmileLeft, 0.9F}, {kMouthSmileRight, 0.9F}}},
                   {"smile-slight", {{kMouthSmileLeft, 0.5F}, {kMouthSmileRight, 0.5F}}},
                   {"down-turned", {{kMouthFrownLeft, 0.9F}, {kMouthFrownRight, 0.9F}}},
                   {"pressed", {{kMouthPressLeft, 0.9F}, {kMouthPressRight, 0.9F}}},
                   {"pursed", {{kMouthPucker, 0.9F}}},
                   {"shh", {{kMouthPucker, 0.5F}, {kMouthFunnel, 0.5F}}},
                   {"puffed", {{kCheekPuff, 1.0F}, {kMouthPressLeft, 0.4F}, {kMouthPressRight, 0.4F}}},
                   {"stretched", {{kMouthStretchLeft, 0.9F}, {kMouthStretchRight, 0.9F}}}},
                  word, weights);
}

bool add_cheeks(std::string_view word, FaceWeights& weights) {
  return add_word({{"puffed", {{kCheekPuff, 1.0F}}}}, word, weights);
}

bool add_face(std::string_view word, FaceWeights& weights) {
  return add_word(
      {{"pained",
        {{kBrowDownLeft, 0.7F},
         {kBrowDownRight, 0.7F},
         {kBrowInnerUp, 0.5F},
         {kEyeBlinkLeft, 0.4F},
         {kEyeBlinkRight, 0.4F},
         {kMouthStretchLeft, 0.5F},
         {kMouthStretchRight, 0.5F},
         {kMouthFrownLeft, 0.3F},
         {kMouthFrownRight, 0.3F}}},
       {"nose-wrinkled", {{kNoseSneerLeft, 0.9F}, {kNoseSneerRight, 0.9F}}},
       {"nose-twitch", {{kNoseSneerLeft, 0.6F}, {kNoseSneerRight, 0.3F}}},
       {"nose-widened",
        {{kNoseSneerLeft, 0.4F}, {kNoseSneerRight, 0.4F}, {kMouthUpperUpLeft, 0.2F}, {kMouthUpperUpRight, 0.2F}}},
       {"dislike",
        {{kBrowDownLeft, 0.4F},
         {kBrowDownRight, 0.4F},
         {kNoseSneerLeft, 0.9F},
         {kNoseSneerRight, 0.9F},
         {kMouthFrownLeft, 0.7F},
         {kMouthFrownRight, 0.7F}}}},
      word, weights);
}

bool add_head(std::string_view word, BodyFeature& feature) {
  if (word.empty() || word == "neutral") return true;
  if (word == "tilt-forward") {
    feature.head += Vec3(7, 0, 0) * kDegree;
    feature.trunk += Vec3(2, 0, 0) * kDegree;
  } else if (word == "forward") {
    feature.head += Vec3(4, 0, 0) * kDegree;
    feature.trunk += Vec3(4, 0, 0) * kDegree;
  } else if (word == "lean-forward") {
    feature.trunk += Vec3(6, 0, 0) * kDegree;
  } else if (word == "tilt-back-slight") {
    feature.head += Vec3(-6, 0, 0) * kDegree;
  } else if (word == "tilt") {
    feature.head += Vec3(0, 0, 9) * kDegree;
  } else if (word == "tilt-slight") {
    feature.head += Vec3(-3, 0, 4) * kDegree;
  } else if (word == "nod" || word == "nod-slight") {
    feature.swing += Vec3(word == "nod" ? 7 : 4, 0, 0) * kDegree;
    feature.swing_hz = 1.6;
  } else if (word == "nod-up") {
    feature.head += Vec3(-4, 0, 0) * kDegree;
    feature.swing += Vec3(4, 0, 0) * kDegree;
    feature.swing_hz = 1.6;
  } else if (word == "tilt-left") {
    feature.head += Vec3(0, 0, -9) * kDegree;
  } else if (word == "turn-left" || word == "turn-right") {
    feature.head += Vec3(0, word == "turn-left" ? 18 : -18, 0) * kDegree;
  } else if (word == "back") {
    feature.head += Vec3(-3, 0, 0) * kDegree;
    feature.trunk += Vec3(-3, 0, 0) * kDegree;
  } else if (word == "follow-gaze" || word == "straight") {
    // The head goes with the eyes in any case, and stands straight where nothing turns it.
  } else if (word == "lean-back") {
    feature.trunk += Vec3(-5, 0, 0) * kDegree;
  } else if (word == "lean-left" || word == "lean-right") {
    feature.trunk += Vec3(0, 0, word == "lean-left" ? -5 : 5) * kDegree;
  } else if (word == "body-left" || word == "body-right") {
    feature.trunk += Vec3(0, word == "body-left" ? 12 : -12, 0) * kDegree;
  } else if (word == "sigh") {
    feature.trunk += Vec3(3, 0, 0) * kDegree;
    feature.head += Vec3(3, 0, 0) * kDegree;
  } else if (word == "heave") {
    feature.trunk += Vec3(-3, 0, 0) * kDegree;
  } else if (word == "rounded") {
    feature.trunk += Vec3(5, 0, 0) * kDegree;
    feature.head += Vec3(5, 0, 0) * kDegree;
  } else if (word == "shake") {
    feature.swing += Vec3(0, 11, 0) * kDegree;
    feature.swing_hz = 1.8;
  } else if (word == "sway") {
    feature.swing += Vec3(0, 0, 5) * kDegree;
    feature.swing_hz = 0.8;
  } else {
    return false;
  }
  return true;
}

bool add_shoulders(std::string_view word, BodyFeature& feature) {
  if (word.empty() || word == "neutral") return true;
  // Without collar bones of its own the figure shows the shoulders by the trunk and the neck.
  if (word == "hunched" || word == "shrug" || word == "raised") {
    feature.head += Vec3(6, 0, 0) * kDegree;
    feature.trunk += Vec3(3, 0, 0) * kDegree;
  } else if (word == "hunched-left" || word == "hunched-right") {
    feature.trunk += Vec3(2, word == "hunched-left" ? -4 : 4, 0) * kDegree;
  } else if (word == "shrug-left" || word == "raised-left") {
    feature.trunk += Vec3(0, 0, 4) * kDegree;
    feature.head += Vec3(0, 0, -4) * kDegree;
  } else if (word == "shrug-right" || word == "raised-right") {
    feature.trunk += Vec3(0, 0, -4) * kDegree;
    feature.head += Vec3(0, 0, 4) * kDegree;
  } else if (word == "drop") {
    feature.trunk += Vec3(4, 0, 0) * kDegree;
  } else {
    return false;
  }
  return true;
}

bool add_gaze(std::string_view word, BodyFeature& feature, FaceWeights& weights) {
  if (word.empty() || word == "neutral" || word == "addressee") return true;
  if (word == "far" || word == "unfocused") {
    // Past the addressee: the eyes a little up and wide.
    add({{kEyeLookUpLeft, 0.15F}, {kEyeLookUpRight, 0.15F}}, weights);
    return true;
  }
  if (word == "down-to-other-hand") {
    return add_gaze("down", feature, weights) &&
           (add({{kEyeLookOutLeft, 0.3F}, {kEyeLookInRight, 0.3F}}, weights), true);
  }
  if (word == "rolling") {
    add({{kEyeLookUpLeft, 0.7F}, {kEyeLookUpRight, 0.7F}, {kEyeLookOutLeft, 0.4F}, {kEyeLookInRight, 0.4F}}, weights);
    return true;
  }
  if (const size_t dash = word.find('-'); dash != std::string_view::npos && word != "down-to-hand") {
    // Two directions at once: "left-up".
    return add_gaze(word.substr(0, dash), feature, weights) && add_gaze(word.substr(dash + 1), feature, weights);
  }
  // The eyes go first and farthest, the head a little with them.
  if (word == "down-to-hand" || word == "down") {
    feature.head += Vec3(5, 0, 0) * kDegree;
    add({{kEyeLookDownLeft, 0.6F}, {kEyeLookDownRight, 0.6F}}, weights);
  } else if (word == "up") {
    feature.head += Vec3(-3, 0, 0) * kDegree;
    add({{kEyeLookUpLeft, 0.8F}, {kEyeLookUpRight, 0.8F}}, weights);
  } else if (word == "left") {
    feature.head += Vec3(0, 5, 0) * kDegree;
    add({{kEyeLookOutLeft, 0.8F}, {kEyeLookInRight, 0.8F}}, weights);
  } else if (word == "right") {
    feature.head += Vec3(0, -5, 0) * kDegree;
    add({{kEyeLookInLeft, 0.8F}, {kEyeLookOutRight, 0.8F}}, weights);
  } else {
    return false;
  }
  return true;
}

}  // namespace auslan
