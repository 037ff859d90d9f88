// SPDX-License-Identifier: Apache-2.0
// The 78 mouth gestures of SiGML (mouthing_tier, mouth_gesture) as postures of this face: each by the meaning that the
// reference gives its code. What repeats or changes within a gesture (chatter, trills, a circling tongue) is shown by
// the posture in its middle.
#include "synthesis/non_manual.h"

#include <initializer_list>

namespace auslan {
namespace {

using enum FaceChannel;

struct Pull {
  FaceChannel channel;
  float weight;
};
struct Gesture {
  std::string_view code;
  std::initializer_list<Pull> one_sided;  ///< as they are
  std::initializer_list<Pull> both;       ///< left channels that take their right ones along
};

constexpr float kLittle = 0.08F;

const std::initializer_list<Gesture>& gestures() {
  static const std::initializer_list<Gesture> kAll = {
      {"D01", {}, {{kMouthStretchLeft, 0.8F}, {kMouthUpperUpLeft, 0.6F}, {kMouthLowerDownLeft, 0.6F}}},
      {"D02", {{kMouthRollLower, 0.6F}, {kJawOpen, 0.03F}}, {{kMouthUpperUpLeft, 0.4F}}},
      {"D03", {{kMouthRollLower, 0.5F}, {kJawOpen, kLittle}}, {{kMouthUpperUpLeft, 0.4F}, {kMouthStretchLeft, 0.35F}}},
      {"D04", {{kMouthRollLower, 0.5F}, {kJawOpen, 0.25F}}, {{kMouthUpperUpLeft, 0.4F}}},
      {"D05", {{kJawOpen, 0.06F}}, {{kMouthStretchLeft, 0.5F}, {kMouthUpperUpLeft, 0.5F}, {kMouthLowerDownLeft, 0.5F}}},
      {"D06", {{kJawOpen, kLittle}}, {{kMouthUpperUpLeft, 0.9F}, {kMouthLowerDownLeft, 0.3F}}},
      {"D07", {}, {{kMouthUpperUpLeft, 0.7F}, {kMouthLowerDownLeft, 0.7F}}},
      {"D08", {}, {{kMouthStretchLeft, 1.0F}, {kMouthUpperUpLeft, 0.5F}, {kMouthLowerDownLeft, 0.5F}}},
      {"D09", {{kMouthRollLower, 0.5F}, {kTongueUp, 0.4F}, {kJawOpen, 0.05F}}, {{kMouthUpperUpLeft, 0.5F}}},

      {"J01", {{kJawLeft, 0.9F}}, {{kMouthPressLeft, 0.15F}}},
      {"J02", {{kJawLeft, 0.4F}, {kJawOpen, 0.05F}}, {{kMouthPressLeft, 0.4F}}},
      {"J03", {{kJawForward, 1.0F}, {kJawOpen, 0.05F}}, {{kMouthLowerDownLeft, 0.6F}}},
      {"J04", {{kJawOpen, 0.35F}, {kMouthShrugLower, 0.2F}}, {}},

      {"L01", {{kMouthFunnel, 0.6F}, {kMouthPucker, 0.4F}}, {}},
      {"L02", {{kMouthPucker, 0.5F}, {kCheekPuff, 0.3F}}, {{kMouthLowerDownLeft, 0.15F}}},
      {"L03", {{kMouthPucker, 0.45F}, {kCheekPuff, 0.15F}, {kJawOpen, 0.04F}}, {}},
      {"L04", {{kMouthPucker, 0.9F}}, {}},
      {"L05", {{kMouthFunnel, 0.8F}, {kJawOpen, 0.3F}}, {}},
      {"L06", {{kMouthPucker, 1.0F}, {kMouthFunnel, 0.15F}}, {}},
      {"L07", {{kMouthFunnel, 0.6F}, {kJawOpen, 0.4F}}, {}},
      {"L08", {{kMouthFunnel, 0.5F}, {kJawOpen, 0.1F}}, {{kMouthPressLeft, 0.5F}}},
      {"L09", {{kJawOpen, 0.15F}}, {{kMouthPressLeft, 0.6F}}},
      {"L10", {{kMouthFunnel, 0.45F}, {kJawOpen, 0.38F}}, {}},
      {"L11", {{kJawOpen, 0.42F}}, {{kMouthLowerDownLeft, 0.1F}}},
      {"L12", {{kJawOpen, 0.1F}}, {{kMouthStretchLeft, 0.6F}, {kMouthSmileLeft, 0.3F}}},
      {"L13", {}, {{kMouthStretchLeft, 0.5F}, {kMouthSmileLeft, 0.4F}, {kMouthPressLeft, 0.3F}}},
      {"L14", {{kMouthPucker, 0.4F}, {kMouthFunnel, 0.6F}}, {{kMouthPressLeft, 0.2F}}},
      {"L15", {{kJawOpen, 0.04F}}, {{kMouthStretchLeft, 0.35F}, {kMouthPressLeft, 0.35F}}},
      {"L16", {{kMouthRollLower, 0.5F}}, {{kMouthPressLeft, 0.35F}}},
      {"L17", {{kCheekPuff, 0.1F}}, {{kMouthPressLeft, 0.8F}}},
      {"L18", {{kCheekPuff, 0.2F}}, {{kMouthPressLeft, 0.6F}}},
      {"L19", {{kMouthPucker, 0.8F}, {kMouthFunnel, 0.15F}}, {}},
      {"L20", {{kMouthPucker, 0.75F}, {kCheekPuff, 0.7F}}, {}},
      {"L21", {{kMouthPucker, 0.65F}}, {}},
      {"L22", {{kMouthPucker, 0.6F}, {kCheekPuff, 0.5F}}, {}},
      {"L23", {}, {{kMouthPressLeft, 0.8F}}},
      {"L24", {{kCheekPuff, 0.25F}}, {{kMouthPressLeft, 1.0F}}},
      {"L25", {}, {{kMouthPressLeft, 0.6F}}},
      {"L26", {{kMouthUpperUpLeft, 1.0F}, {kNoseSneerLeft, 0.5F}}, {}},
      {"L27", {{kJawOpen, 0.12F}, {kTongueOut, 0.25F}}, {}},
      {"L28", {{kJawOpen, 0.15F}, {kTongueOut, 0.6F}, {kTongueUp, 1.0F}}, {}},
      {"L29", {{kMouthRollUpper, 0.9F}, {kMouthRollLower, 0.9F}}, {{kMouthFrownLeft, 0.6F}}},
      {"L30", {{kMouthPucker, 0.7F}}, {{kMouthFrownLeft, 0.6F}}},
      {"L31", {}, {{kMouthFrownLeft, 0.9F}, {kMouthPressLeft, 0.3F}}},
      {"L32", {{kMouthPucker, 0.5F}, {kCheekPuff, 0.4F}, {kMouthFunnel, 0.1F}}, {}},
      {"L33", {{kMouthFunnel, 0.55F}}, {{kMouthUpperUpLeft, 0.3F}, {kMouthLowerDownLeft, 0.4F}}},
      {"L34", {}, {{kMouthStretchLeft, 1.0F}, {kMouthPressLeft, 0.5F}}},
      {"L35", {{kMouthPucker, 0.7F}, {kCheekPuff, 0.3F}}, {}},

      {"C01", {{kCheekPuff, 1.0F}}, {{kMouthPressLeft, 0.4F}}},
      {"C02", {{kCheekPuff, 1.0F}, {kMouthPucker, 0.35F}, {kMouthShrugLower, 0.2F}}, {}},
      {"C03", {{kCheekPuff, 0.7F}}, {{kMouthPressLeft, 0.4F}}},
      {"C04", {{kCheekPuffLeft, 1.0F}}, {{kMouthPressLeft, 0.3F}}},
      {"C05", {{kCheekPuffLeft, 0.9F}, {kMouthPucker, 0.4F}}, {}},
      {"C06", {{kCheekSuckLeft, 1.0F}}, {{kMouthPressLeft, 0.3F}}},
      {"C07", {{kMouthPucker, 0.3F}}, {{kCheekSuckLeft, 1.0F}}},
      {"C08", {{kMouthPucker, 0.4F}, {kJawOpen, kLittle}}, {{kCheekSuckLeft, 0.8F}}},
      {"C09", {{kCheekPuffLeft, 0.6F}}, {{kMouthPressLeft, 0.2F}}},
      {"C10", {{kCheekPuffLeft, 0.75F}, {kMouthLeft, 0.15F}}, {{kMouthPressLeft, 0.3F}}},
      {"C11", {{kCheekPuffLeft, 0.5F}, {kMouthLeft, 0.4F}}, {}},
      {"C12", {{kMouthShrugLower, 0.9F}, {kJawOpen, 0.05F}}, {}},
      {"C13", {{kJawOpen, 0.25F}, {kMouthShrugLower, 0.6F}, {kCheekPuff, 0.2F}}, {{kMouthPressLeft, 0.6F}}},

      {"T01", {{kJawOpen, 0.25F}, {kTongueUp, 0.9F}}, {}},
      {"T02", {{kJawOpen, 0.12F}, {kTongueOut, 0.35F}}, {}},
      {"T03", {{kJawOpen, 0.2F}, {kTongueUp, 0.7F}, {kTongueOut, 0.2F}}, {}},
      {"T04", {{kJawOpen, 0.15F}, {kTongueOut, 0.6F}}, {}},
      {"T05", {{kJawOpen, 0.4F}, {kTongueOut, 1.0F}}, {}},
      {"T06", {{kJawOpen, 0.25F}, {kTongueOut, 0.8F}}, {}},
      {"T07", {{kJawOpen, 0.35F}, {kTongueUp, 0.7F}}, {}},
      {"T08", {{kJawOpen, 0.4F}, {kTongueUp, 0.5F}}, {}},
      {"T09", {{kJawOpen, 0.2F}, {kTongueUp, 0.5F}}, {{kMouthStretchLeft, 0.3F}}},
      {"T10", {{kTongueUp, 0.5F}, {kMouthRollLower, 0.4F}, {kJawOpen, kLittle}}, {{kMouthUpperUpLeft, 0.3F}}},
      {"T11", {{kJawOpen, 0.3F}, {kTongueUp, 0.4F}, {kMouthRollLower, 0.3F}}, {}},
      {"T12", {{kJawOpen, 0.15F}, {kTongueOut, 0.5F}, {kTongueLeft, 0.9F}}, {}},
      {"T13", {{kJawOpen, 0.35F}, {kTongueOut, 0.35F}}, {{kMouthLowerDownLeft, 0.3F}}},
      {"T14", {{kJawOpen, 0.25F}, {kTongueOut, 0.7F}, {kTongueLeft, 1.0F}}, {}},
      {"T15", {{kJawOpen, 0.3F}, {kTongueOut, 0.5F}, {kTongueUp, 0.6F}, {kTongueRight, 0.5F}}, {}},
      {"T16", {{kMouthPucker, 0.7F}, {kTongueOut, 0.4F}, {kJawOpen, kLittle}}, {}},
      {"T17", {{kJawOpen, 0.5F}, {kTongueOut, 0.45F}}, {}}};
  return kAll;
}

void add(FaceWeights& sum, FaceChannel channel, float weight) {
  float& value = sum[static_cast<size_t>(channel)];
  value = value + weight < 1.0F ? value + weight : 1.0F;
}

}  // namespace

bool add_mouth_gesture(std::string_view code, FaceWeights& weights) {
  for (const Gesture& gesture : gestures()) {
    if (gesture.code != code) continue;
    for (const Pull& pull : gesture.one_sided)
      add(weights, pull.channel, pull.weight);
    for (const Pull& pull : gesture.both) {
      add(weights, pull.channel, pull.weight);
      add(weights, right_of(pull.channel), pull.weight);
    }
    return true;
  }
  return false;
}

}  // namespace auslan
