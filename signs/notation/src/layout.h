// SPDX-License-Identifier: Apache-2.0
// The layout of a sign: both hands are kept explicitly while postures and movements are put after each other
// (layout_postures.cpp, layout_movements.cpp); only at the end is a sign whose hands are mirror images told as a
// symmetric one (sign_of.cpp).
#pragma once

#include "place_of.h"
#include "timeline.h"

namespace auslan::notation {

inline constexpr size_t kMaxPhases = 96;

/// One hand within the layout.
struct Hand {
  bool present = false;
  std::optional<WrittenShape> written;  ///< what later changes build on
  Handshape shape;
  Vec3 fingers{0, 1, 0};
  Vec3 palm_letter{1, 0, 0}, palm{1, 0, 0};
  bool palm_absolute = false;  ///< the letters are the direction itself
  Spot spot;
  std::optional<HandPart> part;            ///< the part that is placed
  std::optional<Location> other_location;  ///< placed at the other hand or arm, `spot.offset` from it
  bool placed = false;                     ///< by the notation, not by default
};

/// The two hands at each other: from where on, and with which parts.
struct Meeting {
  HandPart part = HandPart::kPalm, other_part = HandPart::kPalm;
  Location other_location = Location::kHands;
  ContactKind contact = ContactKind::kTouch;
  Vec3 dominant_offset{0.0}, other_offset{0.0};  ///< of the two hands when they met
};

struct Phase {
  std::array<Hand, 2> hands;
  std::optional<Meeting> meeting;
};
/// The mirror image in the signer's middle plane.
inline Vec3 image(const Vec3& v) {
  return {-v.x, v.y, v.z};
}

class Layout {
 public:
  Layout(const WrittenSign& written, Findings& findings) : written_(written), findings_(findings) {}
  NotatedSign run();

 private:
  // postures
  void begin_part(const WrittenPart& part);
  void apply(const WrittenPosture& posture, Hands hands, Phase& phase);
  void apply_config(const WrittenHand& config, size_t which, Phase& phase);
  void apply_body(const WrittenBodySite& site, size_t which, Phase& phase);
  void apply_meeting(const WrittenMeeting& meeting, Phase& phase);
  void apply_on_other(const WrittenHandSite& site, Phase& phase);
  void mirror_place(Phase& phase);
  HeldHand held(const Phase& phase, size_t which) const;
  void default_base(Phase& phase, const Mark& mark, bool arm);
  std::optional<Vec3> direction(const std::string& letters, const std::string& second, const Mark& mark,
                                std::string_view what);
  // movements
  void make_strokes(const WrittenPart& part);
  void make(const Stroke& stroke);
  void shift(Phase& phase, size_t which, const Vec3& by, bool brushing);
  void make_directed(const StrokeItem& item, const Stroke& stroke, bool other_moves, MovingHands moving, Phase& next,
                     std::vector<Movement>& made);
  void make_circle(const StrokeItem& item, const Stroke& stroke, bool other_moves, MovingHands moving, Phase& next,
                   std::vector<Movement>& made, bool& changes);
  void make_wrist(const WrittenMotion& motion, MovingHands moving, std::vector<Movement>& made);
  /// A movement of both hands that are no mirror images is told for each of them.
  void part_hands();
  size_t append(const Phase& phase);
  // the model
  Posture posture_of(const Phase& phase, size_t which, bool symmetric);
  bool is_mirror(const Phase& phase) const;
  void keep_shape(const Handshape& shape);

  const WrittenSign& written_;
  Findings& findings_;
  const WrittenPart* part_ = nullptr;
  Phase now_;
  std::vector<Phase> phases_;
  std::vector<size_t> stroke_starts_;  ///< phase at which each stroke of this part began
  std::vector<Movement> movements_;
  std::vector<const WrittenPart*> part_of_movement_;  ///< for each movement, whose symmetry it has
  std::vector<WrittenBodySite> named_;
  bool hands_differ_ = false;  ///< some movement moves the hands differently
  bool alternating_ = false;
  NotatedSign result_;
};

}  // namespace auslan::notation
