// SPDX-License-Identifier: Apache-2.0
// The closed lists of words for non-manual features, by channel: what an entry or a span of a phrase may ask of the
// face, the head and the trunk. An empty word asks nothing.
#pragma once

#include <span>
#include <string_view>

namespace auslan {

enum class FaceTier { kBrows, kEyes, kMouth, kCheeks, kHead, kShoulders, kGaze, kFace };

/// The words of a channel, in a fixed order.
std::span<const std::string_view> face_words(FaceTier channel);
/// The channel's key in text and database: "brows", "eyes" …
std::string_view tier_name(FaceTier channel);
inline constexpr int kFaceTiers = 8;

/// True for a word of the channel and for the empty word.
bool is_face_word(FaceTier channel, std::string_view word);

/// Kinds of NonManualSpan: topic, yn, wh, neg, cond, aff, cmd, polite.
std::span<const std::string_view> span_kinds();
/// How a span may end: "hold last sign", "pause/blink".
std::span<const std::string_view> span_endings();
/// Parts of speech of keywords.
std::span<const std::string_view> parts_of_speech();

}  // namespace auslan
