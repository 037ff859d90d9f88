// SPDX-License-Identifier: Apache-2.0
// What the commands work with: the figure, the lexicon and the translator, each opened when first needed.
#pragma once

#include "body.h"
#include "kinematics/result.h"
#include "lexicon/lexicon.h"
#include "options.h"
#include "synthesis/performance.h"
#include "synthesis/signer.h"
#include "synthesis/utterance.h"
#include "translate/translation.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace auslan {

/// A motion that can be sampled, with what is known about it.
struct Show {
  Tick end = 0;
  std::function<void(Tick, Pose&)> sample;
  std::vector<GlossSpan> glosses;
  std::vector<std::string> sentences;  ///< English, for captions
  std::vector<int> sentence_of_gloss;  ///< by index into glosses
  bool reviewed = false;               ///< every entry in it has been approved by a Deaf reviewer
  std::vector<std::string> warnings;
};

class Session {
 public:
  explicit Session(const Options& options) : options_(options) {}

  /// In the appearance that was asked for.
  Result<const Figure*> figure();
  /// The figure and how it is drawn.
  Result<Body> body();
  /// The stage that was asked for, before the figure's background. After figure().
  StageOptions stage() const;
  Result<const Lexicon*> lexicon();
  Result<Translation> translation();
  Result<Show> show();
  Result<const Signer*> signer();
  /// One entry of the lexicon. kNotFound when there is none.
  Result<Utterance> utterance_of(const std::string& gloss);
  /// English, translated.
  Result<Utterance> utterance_of_text(const std::string& english);
  /// What a foreign figure lacks for signing or does otherwise; after figure().
  std::vector<std::string> figure_lacks() const;

 private:
  /// The file of the lexicon.
  std::filesystem::path database() const;
  /// What is to be performed, and what has to be said about it.
  struct Spoken {
    Utterance utterance;
    std::vector<std::string> warnings;
  };
  Result<Translation> translation_of(const std::string& english);
  Result<Utterance> composed(const Translation& translation);
  Result<Spoken> spoken();
  Result<Spoken> notated();
  Result<Show> show_of_motion_file();

  const Options& options_;
  Result<void> load_avatar();

  std::unique_ptr<Figure> figure_;
  std::unique_ptr<SigningAvatar> avatar_;
  std::vector<std::optional<raster::Texture>> textures_;
  std::optional<uint32_t> background_;  ///< of its appearance
  std::optional<Lexicon> lexicon_;
  std::optional<Signer> signer_;
};

}  // namespace auslan
