// SPDX-License-Identifier: Apache-2.0
// A sign as it is written, before anything is decided about space: the one form that both kinds of SiGML and HamNoSys
// strings are read into. Words are SiGML's attribute values; an empty string means "not written".
#pragma once

#include "notation/notation.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace auslan::notation {

/// A place in the source text.
struct Mark {
  int line = 1, column = 1;
};

/// Collects what is to be told; stops keeping (but not counting) beyond a bound, so that a hostile file stays cheap.
class Findings {
 public:
  void error(const Mark& mark, std::string message) { add(Diagnostic::Grade::kError, mark, std::move(message)); }
  void warning(const Mark& mark, std::string message) { add(Diagnostic::Grade::kWarning, mark, std::move(message)); }
  void note(const Mark& mark, std::string message) { add(Diagnostic::Grade::kNote, mark, std::move(message)); }
  /// A warning that something which is written has no part in what is signed.
  void left_out(const Mark& mark, std::string message) {
    add(Diagnostic::Grade::kWarning, mark, std::move(message), true);
  }
  /// What was found, with a last line that counts what was not kept.
  std::vector<Diagnostic> take();

 private:
  void add(Diagnostic::Grade grade, const Mark& mark, std::string message, bool left_out = false);
  std::vector<Diagnostic> kept_;
  size_t left_off_ = 0;
  bool lost_ = false;  ///< something was left out in what was not kept
};

/// Text of a file inside a message: cut to a readable length.
std::string in_quotes(std::string_view text);

/// A handshape. Digits are written "1" (thumb) to "5" (little).
struct WrittenShape {
  std::string base;                       ///< flat, finger2 …
  std::string thumb;                      ///< out, across, opposed
  std::string bend;                       ///< bent, round, hooked, dblbent, dblhooked, halfbent or three digits 0 to 4
  std::array<std::string, 5> digit_bend;  ///< by digit, as `bend`
  std::string special;                    ///< digits that replace the selected ones
  std::string exempt;                     ///< digits that the bend spares
  std::string opening;                    ///< tight, slack
  std::string splay;                      ///< 0, 1, 2
  std::string crossed;                    ///< two digits
  std::string contact_kind;               ///< with which part of the second the two digits touch
  std::string opposed;                    ///< the digit that the thumb opposes
  std::string thumb_contact;              ///< the part of the finger that the thumb touches
  std::string successive;                 ///< towards_pinky, towards_thumb: the fingers change one after another
  std::string thumb_between;              ///< two digits
  bool thumb_enclosed = false;

  bool empty() const;
};

struct WrittenHand {
  Mark mark;
  Mark shape_mark, fingers_mark, palm_mark;  ///< where each was written last; set by merge()
  std::optional<WrittenShape> shape, second_shape;
  std::string fingers, second_fingers;  ///< extended finger direction letters
  std::string palm, second_palm;        ///< palm letters
  bool palm_absolute = false;           ///< the palm letters are the direction itself, whatever the fingers do
  bool empty() const;
  /// Later words of one posture complete the earlier ones.
  void merge(const WrittenHand& more);
};

/// A place on a hand or arm.
struct WrittenHandSite {
  Mark mark;
  std::string part;  ///< palm, tip, wristback …
  std::string digits;
  std::string side;  ///< palmar, dorsal, radial, ulnar …
  std::string contact;
  std::string second_part, second_digits, second_side;  ///< midway to this place
  bool behind = false;
  std::vector<WrittenHandSite> with;  ///< at most one: the part of the moving hand
};

/// A place on head or trunk.
struct WrittenBodySite {
  Mark mark;
  std::string location, second_location;
  std::string side, second_side;  ///< left_beside, left_at, right_at, right_beside
  std::string contact;            ///< touch, close, armextended
  bool behind = false;
  std::string name;                        ///< by which the place may be used again
  std::optional<WrittenHandSite> on_hand;  ///< the place is on the other hand or arm
  std::optional<WrittenHandSite> with;     ///< the part of the moving hand
};

/// The two hands at each other.
struct WrittenMeeting {
  Mark mark;
  std::string contact;
  std::optional<WrittenHandSite> dominant, other;
};

/// A posture, or a change of one. Index 0 is the dominant hand. What is not split holds for both hands, mirrored as the
/// part's symmetry asks.
struct WrittenPosture {
  Mark mark;
  WrittenHand shared;
  std::array<WrittenHand, 2> split;  ///< what the two hands have of their own
  bool split_hands = false;
  std::array<std::optional<WrittenBodySite>, 2> body;
  bool split_body = false;
  std::optional<WrittenHandSite> on_other;  ///< the dominant hand is placed at the other hand or arm
  std::optional<WrittenMeeting> meeting;
  std::string use_name;  ///< a place that was named before
  bool empty() const;
  bool has_shape() const { return shared.shape || split[0].shape; }
};

struct WrittenMotion {
  enum class Kind {
    kDirected,
    kCircular,
    kWrist,
    kFingerplay,
    kChange,
    kNothing,
    kSequence,
    kParallel,
    kSplit,
    kTarget,
    kRepeat,
  };
  Mark mark;
  Kind kind = Kind::kNothing;
  std::string direction, second_direction;  ///< of a path; the axis of a circle
  std::string wrist;                        ///< nodding, swinging, twisting, stircw, stirccw
  std::string size, second_size;            ///< small, big
  std::string curve, curve_size;
  std::string waviness;  ///< wavy, zigzag
  std::string waviness_size, waviness_growth;
  std::string clock_start, clock_end;
  int extra_turns = 0;
  std::string ellipse, ellipse_size;  ///< h, ur, v, ul: the longer axis on the circle's face
  std::string growth, growth_size;    ///< increasing, decreasing
  std::string digits;                 ///< of fingerplay
  double pace = 1;                    ///< twice as fast: 2
  bool fused = false;                 ///< of a sequence: no stop between its parts
  bool fast = false, slow = false, tense = false, rest = false, halt = false, alternating = false, brushing = false;
  std::string repetition, second_repetition;  ///< of kRepeat
  std::string repetition_growth, repetition_growth_size;
  std::string shift, shift_size;        ///< of kRepeat: by which each repetition begins farther on
  std::vector<WrittenPosture> brushed;  ///< places that are brushed in passing
  std::vector<WrittenMotion> parts;     ///< of the structured kinds; two of kSplit
  WrittenPosture target;                ///< of kTarget
};

/// One manual part; a compound sign has several.
struct WrittenPart {
  Mark mark;
  bool both_hands = false, mirror_lr = false, mirror_ud = false, mirror_oi = false;
  bool out_of_phase = false, literal_space = false, non_dominant = false;
  WrittenPosture start;
  std::vector<WrittenMotion> motions;
};

struct WrittenSign {
  Mark mark;
  std::string gloss;
  std::vector<WrittenPart> parts;
  NonManual non_manual;
  double pace = 1;
};

/// What the sign means in the model. Total: what cannot be carried is told to `findings`.
NotatedSign sign_of(const WrittenSign& written, Findings& findings);

}  // namespace auslan::notation
