// SPDX-License-Identifier: Apache-2.0
#include "session.h"

#include "avatar_images.h"
#include "commands.h"
#include "data_files.h"
#include "gltf/avatar_gltf.h"
#include "gltf/figure_gltf.h"
#include "kinematics/figure_file.h"
#include "media/motion_file.h"
#include "notation/notation.h"
#include "synthesis/choreography.h"
#include "translate/audience.h"
#include "translate/translator.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace auslan {
namespace {

/// A performance longer than this is refused: it would keep a machine busy for hours without a word.
constexpr double kLongestSeconds = 45 * 60;
// No sign and no letter is shorter than this: a transition, a stroke and a hold.
constexpr double kShortestSign = 0.44, kShortestLetter = 0.25;

bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool ends_with(const std::string& text, std::string_view suffix) {
  return text.size() >= suffix.size() && std::string_view(text).substr(text.size() - suffix.size()) == suffix;
}

/// The lexicon's name of an entry as people write it: digits are numbers.
std::string entry_name(std::string_view gloss) {
  return is_digits(gloss) ? "num:" + std::string(gloss) : std::string(gloss);
}

Error as_usage(Error error) {
  error.code = ErrorCode::kUsage;
  return error;
}

/// The baked file of the built-in figure.
std::string figure_name(const std::string& detail) {
  return detail == "normal" ? "signer.figure" : "signer_" + detail + ".figure";
}

/// A lower bound of the time that a translation takes to sign at speed 1.
double least_seconds(const Translation& translation) {
  double least = 0;
  for (const Item& item : translation.items)
    least += item.pause_seconds + static_cast<double>(item.glosses.size()) *
                                      (item.kind == ItemKind::kSpelled ? kShortestLetter : kShortestSign);
  return least;
}

tl::unexpected<Error> too_long(const std::string& what) {
  return fail(ErrorCode::kLimit, "this text is too long to sign in one piece (" + what +
                                     "); the most is 45 minutes of signing: give it in parts");
}

Result<TranslatorData> translator_data(const Lexicon& lexicon) {
  TranslatorData data;
  const auto entries = lexicon.list();
  if (!entries) return tl::unexpected(entries.error());
  for (const SignSummary& entry : *entries)
    data.entries.push_back({entry.gloss, entry.confidence, entry.review, entry.region, entry.safety_critical});
  data.phrases = lexicon.phrases();
  data.keywords = lexicon.keywords();
  return data;
}

}  // namespace

Result<void> Session::load_avatar() {
  auto avatar = read_avatar(options_.avatar);
  if (!avatar) return tl::unexpected(avatar.error());
  auto fitted = fit_avatar(std::move(*avatar));
  if (!fitted) {
    fitted.error().place = options_.avatar;
    return tl::unexpected(fitted.error());
  }
  avatar_ = std::make_unique<SigningAvatar>(std::move(*fitted));
  textures_ = decode_images(avatar_->avatar, avatar_->warnings);
  for (const std::string& warning : avatar_->warnings)
    remark(options_, "auslanjam: " + options_.avatar + ": " + warning);
  return {};
}

Result<const Figure*> Session::figure() {
  if (avatar_) return &avatar_->figure;
  if (figure_) return figure_.get();
  std::string name = options_.avatar;
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool foreign = ends_with(name, ".glb") || ends_with(name, ".gltf") || ends_with(name, ".vrm");
  // A figure of our own form keeps its smooth joints; everything else is a foreign avatar.
  auto figure = foreign ? read_gltf(options_.avatar)
                        : read_figure(options_.avatar.empty() ? data_file(figure_name(options_.detail))
                                                              : std::filesystem::path(options_.avatar));
  if (foreign && !figure) {
    if (auto loaded = load_avatar(); !loaded) return tl::unexpected(loaded.error());
    return &avatar_->figure;
  }
  if (!figure) return tl::unexpected(figure.error());
  if (!options_.appearance.empty() || !figure->appearances.empty()) {
    const auto worn =
        put_on(*figure, options_.appearance.empty() ? figure->appearances.front().name : options_.appearance);
    if (!worn) return tl::unexpected(worn.error());
    const glm::u8vec3& colour = (*worn)->background;
    background_ = uint32_t{colour.x} << 16U | uint32_t{colour.y} << 8U | colour.z;
  }
  figure_ = std::make_unique<Figure>(std::move(*figure));
  return figure_.get();
}

std::vector<std::string> Session::figure_lacks() const {
  if (!avatar_) return {};
  std::vector<std::string> lacks = avatar_->warnings;
  std::string channels;
  for (size_t i = 0; i < kFaceChannelNames.size(); ++i)
    if (avatar_->avatar.face[i].means == FaceDrive::Means::kNone)
      channels += (channels.empty() ? "" : ", ") + std::string(kFaceChannelNames[i]);
  if (!channels.empty()) lacks.push_back("of its face these cannot be moved: " + channels);
  return lacks;
}

Result<Body> Session::body() {
  const auto figure = this->figure();
  if (!figure) return tl::unexpected(figure.error());
  return Body{.figure = *figure, .avatar = avatar_.get(), .textures = textures_};
}

StageOptions Session::stage() const {
  StageOptions stage = options_.stage;
  stage.background = background_.value_or(stage.background);
  return stage;
}

std::filesystem::path Session::database() const {
  return options_.database.empty() ? data_file("lexicon.sqlite") : std::filesystem::path(options_.database);
}

Result<const Lexicon*> Session::lexicon() {
  if (!lexicon_) {
    auto opened = Lexicon::open(database());
    if (!opened) return tl::unexpected(opened.error());
    lexicon_.emplace(std::move(*opened));
  }
  return &*lexicon_;
}

Result<Translation> Session::translation() {
  const auto lexicon = this->lexicon();
  if (!lexicon) return tl::unexpected(lexicon.error());
  if (!options_.source.glosses.empty()) {
    std::vector<std::string> names;
    for (const std::string& gloss : options_.source.glosses) {
      // A single letter that is no sign of its own is the letter of the alphabet.
      const auto sign = (*lexicon)->sign(entry_name(gloss));
      if (!sign) return tl::unexpected(sign.error());
      const bool letter = gloss.size() == 1 && std::isalpha(static_cast<unsigned char>(gloss[0])) != 0;
      if (!*sign && letter) {
        names.push_back(std::string("fs:") + static_cast<char>(std::toupper(static_cast<unsigned char>(gloss[0]))));
      } else {
        names.push_back(entry_name(gloss));
      }
    }
    return translation_of_glosses(names);
  }
  return translation_of(*options_.source.text);
}

Result<Translation> Session::translation_of(const std::string& english) {
  const auto lexicon = this->lexicon();
  if (!lexicon) return tl::unexpected(lexicon.error());
  auto data = translator_data(**lexicon);
  if (!data) return tl::unexpected(data.error());
  suit(*data, {dialect_from_name(options_.dialect), options_.strict});
  // Without WordNet's lists the rules for endings still stand; "teeth" is then spelled, and said so.
  auto forms = read_wordnet_exceptions();
  if (forms) data->irregular_lemmas = std::move(*forms);
  auto translator = Translator::build(std::move(*data));
  if (!translator) {
    Error error = translator.error();
    if (error.place.empty()) error.place = database().string();
    return tl::unexpected(error);
  }
  auto translation = translator->translate(english);
  if (!translation) return tl::unexpected(as_usage(translation.error()));
  if (!forms)
    translation->warnings.push_back("Irregular words such as \"teeth\" are not known: " + to_string(forms.error()) +
                                    "; install wordnet-base.");
  return translation;
}

Result<Show> Session::show_of_motion_file() {
  const auto figure = this->figure();
  if (!figure) return tl::unexpected(figure.error());
  auto clip = read_motion_jsonl(*options_.source.motion_file);
  if (!clip) return tl::unexpected(clip.error());
  std::vector<Pose> poses;
  std::vector<Tick> times;
  for (const MotionFrame& frame : clip->frames) {
    auto pose = pose_from_frame(*clip, frame, (*figure)->skeleton);
    if (!pose) return tl::unexpected(pose.error());
    poses.push_back(std::move(*pose));
    times.push_back(ticks(frame.time));
  }
  Show show;
  show.end = times.back();
  for (const MotionGloss& gloss : clip->header.glosses)
    show.glosses.push_back({gloss.gloss, ticks(gloss.start), ticks(gloss.end), false, 0});
  show.sample = [poses = std::move(poses), times = std::move(times)](Tick time, Pose& pose) {
    // The frame that is on at that time: recorded frames are shown as they are.
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    pose = poses[static_cast<size_t>(std::max<std::ptrdiff_t>(0, after - times.begin() - 1))];
  };
  return show;
}

Result<Session::Spoken> Session::notated() {
  std::vector<NotatedSign> signs;
  std::string source = "HamNoSys";
  if (options_.source.sigml_file) {
    source = *options_.source.sigml_file;
    auto read = read_sigml(source);
    if (!read) return tl::unexpected(read.error());
    signs = std::move(*read);
  } else {
    auto parsed = parse_hamnosys(*options_.source.hamnosys);
    if (!parsed) return tl::unexpected(as_usage(parsed.error()));
    signs.push_back(std::move(*parsed));
  }
  Spoken spoken;
  for (const NotatedSign& notated : signs) {
    for (const Diagnostic& diagnostic : notated.diagnostics)
      if (diagnostic.grade != Diagnostic::Grade::kNote)
        spoken.warnings.push_back(source + ":" + to_string(diagnostic) + " (in " + notated.sign.gloss + ")");
    if (!notated.signable)
      return fail(ErrorCode::kUnsupported,
                  "the sign " + notated.sign.gloss +
                      " cannot be signed: " + (spoken.warnings.empty() ? "it has no posture" : spoken.warnings.back()),
                  source);
    Unit unit;
    unit.sign = notated.sign;
    unit.label = notated.sign.gloss;
    unit.mouthing = notated.sign.non_manual.mouthing;
    spoken.utterance.units.push_back(std::move(unit));
    for (const Handshape& shape : notated.handshapes)
      spoken.utterance.handshapes.emplace(shape.id, shape);
  }
  spoken.utterance.sentences = {source};
  spoken.utterance.all_reviewed = false;
  return spoken;
}

Result<Session::Spoken> Session::spoken() {
  if (options_.source.sigml_file || options_.source.hamnosys) return notated();
  const auto translation = this->translation();
  if (!translation) return tl::unexpected(translation.error());
  // Told before the work is begun.
  if (const double least = least_seconds(*translation) / options_.speed; least > kLongestSeconds)
    return too_long("at least " + std::to_string(static_cast<int>(least / 60)) + " minutes");
  auto utterance = composed(*translation);
  if (!utterance) return tl::unexpected(utterance.error());
  return Spoken{std::move(*utterance), translation->warnings};
}

Result<Utterance> Session::composed(const Translation& translation) {
  return compose(
      translation, [this](std::string_view gloss) { return lexicon_->sign(gloss); },
      [this](std::string_view id) { return lexicon_->handshape(id); });
}

Result<Utterance> Session::utterance_of(const std::string& gloss) {
  const auto lexicon = this->lexicon();
  if (!lexicon) return tl::unexpected(lexicon.error());
  Translation translation = translation_of_glosses({entry_name(gloss)});
  // A letter is performed as in a spelled word.
  if (gloss.starts_with("fs:")) translation.items.front().kind = ItemKind::kSpelled;
  return composed(translation);
}

Result<Utterance> Session::utterance_of_text(const std::string& english) {
  const auto translation = translation_of(english);
  if (!translation) return tl::unexpected(translation.error());
  return composed(*translation);
}

Result<const Signer*> Session::signer() {
  const auto body = this->body();
  if (!body) return tl::unexpected(body.error());
  if (!signer_) {
    auto signer = Signer::build(*body->figure, body->traits());
    if (!signer) return tl::unexpected(signer.error());
    signer_.emplace(std::move(*signer));
  }
  return &*signer_;
}

Result<Show> Session::show() {
  if (options_.source.motion_file) return show_of_motion_file();
  const auto spoken = this->spoken();
  if (!spoken) return tl::unexpected(spoken.error());
  const Utterance& utterance = spoken->utterance;
  const auto signer = this->signer();
  if (!signer) return tl::unexpected(signer.error());
  auto score = choreograph(**signer, utterance, {options_.speed, 3.0, true});
  if (!score) return tl::unexpected(score.error());
  if (seconds(score->end) > kLongestSeconds)
    return too_long("about " + std::to_string(static_cast<int>(seconds(score->end) / 60)) + " minutes");
  Show show;
  show.end = score->end;
  show.glosses = score->glosses;
  show.sentences = utterance.sentences;
  for (const GlossSpan& gloss : show.glosses)
    show.sentence_of_gloss.push_back(utterance.units[static_cast<size_t>(gloss.unit)].sentence);
  show.reviewed = utterance.all_reviewed;
  show.warnings = spoken->warnings;
  const auto performance = std::make_shared<const Performance>(
      **signer, std::move(*score), PerformanceOptions{options_.left_handed, options_.idle, options_.seed});
  show.sample = [performance](Tick time, Pose& pose) { performance->sample(time, pose); };
  return show;
}

}  // namespace auslan
