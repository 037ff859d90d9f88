// SPDX-License-Identifier: Apache-2.0
#include "command_line.h"

#include "auslanjam_version.h"
#include "db_options.h"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <string_view>

namespace auslan {
namespace {

constexpr std::string_view kDescription =
    "English in, Australian Sign Language (Auslan) out, signed by a 3D figure that is drawn on the CPU.\n"
    "No Deaf signer has checked these signs yet: what is signed carries a mark that says so.\n";
constexpr std::string_view kExamples =
    "\nExamples:\n"
    "  auslanjam \"Where does it hurt?\"                    sign it, in a window or into a clip\n"
    "  auslanjam render \"Hello, my name is Kim.\" -o k.mp4  the same into a film file\n"
    "  auslanjam render --gloss HURT --at 0.9 -o h.png     one frame\n"
    "  auslanjam motion \"Thank you\" -o t.jsonl             the motion itself\n"
    "  auslanjam translate \"I do not understand.\"          the glosses and why\n"
    "  auslanjam db search hospital                        look a sign up\n"
    "  auslanjam avatar figure.vrm                         what another maker's figure can do\n"
    "  auslanjam check HURT                                how well it is signed, in numbers\n"
    "  auslanjam notation signs.sigml                      what is understood of SiGML or HamNoSys\n"
    "  auslanjam bench                                     what a frame costs here\n"
    "`auslanjam COMMAND --help` tells what each takes. Exit status: 0 done, 1 the work failed, 2 the command line was "
    "wrong.\n";

constexpr std::array<std::string_view, 10> kCommands = {"sign",       "render", "motion", "translate", "db",
                                                        "experiment", "bench",  "avatar", "check",     "notation"};

/// A whole number in a range, or a message that names it.
std::string parse_int(const std::string& text, int least, int most, int& value) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc() && result.ptr == text.data() + text.size() && value >= least && value <= most) return {};
  return "takes a whole number from " + std::to_string(least) + " to " + std::to_string(most) + ", not \"" + text +
         "\"";
}

std::string parse_number(const std::string& text, double least, double most, double& value) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc() && result.ptr == text.data() + text.size() && value >= least && value <= most) return {};
  const auto plain = [](double number) {
    std::string digits = std::to_string(number);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return digits;
  };
  return "takes a number from " + plain(least) + " to " + plain(most) + ", not \"" + text + "\"";
}

std::string parse_size(const std::string& text, StageOptions& stage) {
  const size_t cross = text.find('x');
  int width = 0, height = 0;
  if (cross == std::string::npos || !parse_int(text.substr(0, cross), 1, 16384, width).empty() ||
      !parse_int(text.substr(cross + 1), 1, 16384, height).empty())
    return "takes WIDTHxHEIGHT in pixels, each from 1 to 16384, as 1280x720, not \"" + text + "\"";
  stage.width = width;
  stage.height = height;
  return {};
}

/// Adds an option whose text `parse` turns into a value; it returns what is wrong, or nothing.
template <typename Parse>
CLI::Option* add_parsed(CLI::App& app, const std::string& name, const std::string& help, const std::string& type,
                        Parse parse) {
  CLI::Option* option = app.add_option_function<std::string>(
      name,
      [name, parse](const std::string& text) {
        const std::string wrong = parse(text);
        if (!wrong.empty()) throw CLI::ValidationError(name, wrong);
      },
      help);
  option->type_name(type);
  return option;
}

void add_source(CLI::App& app, Options& options) {
  app.add_option("TEXT", options.source.text, "English to sign; quote it");
  app.add_option("--region", options.dialect,
                 "The dialect: north (New South Wales, Queensland) or south (the others), where signs differ")
      ->check(CLI::IsMember({"north", "south"}));
  app.add_flag("--strict", options.strict,
               "Spell safety-critical signs that are doubtful and that no Deaf signer has approved, and caption");
  app.add_option("--gloss", options.source.glosses, "Entries to sign in place of TEXT, as --gloss HELLO")
      ->type_name("GLOSS");
  app.add_option("--motion", options.source.motion_file, "A motion file (.jsonl) to play in place of TEXT")
      ->type_name("FILE");
  app.add_option("--sigml", options.source.sigml_file, "The signs of a SiGML file in place of TEXT")->type_name("FILE");
  app.add_option("--hamnosys", options.source.hamnosys, "A sign in HamNoSys (symbols or their names) in place of TEXT")
      ->type_name("STRING");
}

/// Which figure signs.
void add_figure(CLI::App& app, Options& options) {
  app.add_option("--avatar", options.avatar,
                 "Another figure signs: any humanoid in .vrm, .glb or .gltf, of any size and rest pose, or a baked "
                 ".figure. `auslanjam avatar FILE` tells what it can do")
      ->type_name("FILE");
  add_parsed(app, "--detail", "Of the signer: low, normal or high, about 5, 20 or 80 thousand triangles (normal)",
             "NAME", [&options](const std::string& text) -> std::string {
               if (text != "low" && text != "normal" && text != "high")
                 return "takes low, normal or high, not \"" + text + "\"";
               options.detail = text;
               return {};
             });
  app.add_option("--appearance", options.appearance,
                 "Of the signer's skin, hair and shirt, by name; \"list\" prints the names")
      ->type_name("NAME");
}

void add_performance(CLI::App& app, Options& options) {
  add_figure(app, options);
  add_parsed(app, "--fps", "Frames a second (25)", "N",
             [&options](const std::string& text) { return parse_int(text, 1, 240, options.fps); });
  add_parsed(app, "--speed", "Of the signing: 0.5 is half as fast (1)", "X",
             [&options](const std::string& text) { return parse_number(text, 0.25, 4.0, options.speed); });
  app.add_flag("--left-handed", options.left_handed, "A left-handed signer: the exact mirror image");
  app.add_flag("!--no-idle", options.idle, "No breathing and blinking");
  add_parsed(app, "--seed", "Of the idle motion (1)", "N", [&options](const std::string& text) {
    const auto result = std::from_chars(text.data(), text.data() + text.size(), options.seed);
    if (result.ec == std::errc() && result.ptr == text.data() + text.size()) return std::string();
    return "takes a whole number, not \"" + text + "\"";
  });
  add_parsed(app, "--at", "Only the frame at this time", "SECONDS", [&options](const std::string& text) {
    double at = 0;
    std::string wrong = parse_number(text, 0.0, 86400.0, at);
    if (wrong.empty()) options.at = at;
    return wrong;
  });
}

void add_yes_or_no(CLI::App& app, const char* name, const std::string& what, bool& value) {
  add_parsed(app, name, what + (value ? "; yes or no (yes)" : "; yes or no (no)"), "WORD",
             [&value](const std::string& text) -> std::string {
               if (text != "yes" && text != "no") return "takes yes or no, not \"" + text + "\"";
               value = text == "yes";
               return {};
             });
}

/// What a frame looks like.
void add_frame_form(CLI::App& app, Options& options) {
  add_parsed(app, "--size", "Of the picture in pixels (1280x720)", "WxH",
             [&options](const std::string& text) { return parse_size(text, options.stage); });
  add_parsed(app, "--aa", "Anti-aliasing samples a pixel: 1, 2, 4 or 8 (4)", "N",
             [&options](const std::string& text) -> std::string {
               for (const int samples : {1, 2, 4, 8}) {
                 if (text != std::to_string(samples)) continue;
                 options.stage.samples = samples;
                 return {};
               }
               return "takes 1, 2, 4 or 8, not \"" + text + "\"";
             });
  add_parsed(app, "--shading", "flat or gouraud (gouraud)", "NAME", [&options](const std::string& text) -> std::string {
    if (text != "flat" && text != "gouraud") return "takes flat or gouraud, not \"" + text + "\"";
    options.stage.flat = text == "flat";
    return {};
  });
  add_parsed(app, "--joints", "smooth, or rigid segments as the paper has them (smooth)", "NAME",
             [&options](const std::string& text) -> std::string {
               if (text != "smooth" && text != "rigid") return "takes smooth or rigid, not \"" + text + "\"";
               options.stage.rigid = text == "rigid";
               return {};
             });
  add_yes_or_no(app, "--shadow", "Hands throw a shadow on body and face", options.stage.shadow);
  add_yes_or_no(app, "--outline", "A dark line round hands, face and clothes, for eyes or screens that lack contrast",
                options.stage.outline);
  add_parsed(app, "--camera", "front, three-quarter, side, signer, hands or face (front)", "NAME",
             [&options](const std::string& text) -> std::string {
               const auto camera = camera_from_name(text);
               if (!camera) return "takes front, three-quarter, side, signer, hands or face, not \"" + text + "\"";
               options.stage.camera = *camera;
               return {};
             });
}

void add_picture(CLI::App& app, Options& options) {
  add_frame_form(app, options);
  app.add_flag("--caption", options.caption, "Write the English under the picture");
  add_parsed(app, "--threads", "How many frames are drawn at once (1)", "N",
             [&options](const std::string& text) { return parse_int(text, 1, 64, options.threads); });
}

void add_bench(CLI::App& app, Options& options) {
  app.add_option("TEXT", options.source.text, "English to sign; quote it (\"Where does it hurt?\")");
  add_figure(app, options);
  add_frame_form(app, options);
  add_parsed(
      app, "--threads", "How many threads share the work of a frame (1)", "N",
      [&options](const std::string& text) { return parse_int(text, 1, raster::kMaxThreads, options.stage.threads); });
  add_parsed(app, "--kernel", "Of the rasteriser: the instructions it may use (the fastest that runs here)", "NAME",
             [&options](const std::string& text) {
               std::string names;
               for (const raster::Kernel kernel : raster::runnable_kernels()) {
                 if (raster::name_of(kernel) == text) options.stage.kernel = kernel;
                 names += (names.empty() ? "" : ", ") + std::string(raster::name_of(kernel));
               }
               return options.stage.kernel ? std::string()
                                           : "takes one that runs here (" + names + "), not \"" + text + "\"";
             });
  add_parsed(app, "--frames", "How many to time after the first (those of the sentence)", "N",
             [&options](const std::string& text) { return parse_int(text, 1, 1000000, options.frames); });
  app.footer(
      "Draws the sentence as the window does, each frame on what the last one left, and times the steps of a frame:\n"
      "  animate    the score gives a pose, the pose places the figure's parts\n"
      "  transform  their vertices go to the screen and are lit\n"
      "  set_up     triangles are culled, cut and sorted into tiles\n"
      "  raster     tiles become pixels\n"
      "  present    what changed goes into the window; without a display it is copied in memory\n"
      "Wall-clock time, the least and the median of the frames after the first; \"cpu\" is what all threads used.\n"
      "No text is written on the frames. Compare figures of one computer only, when nothing else runs on it.\n"
      "Examples:\n"
      "  auslanjam bench\n"
      "  auslanjam bench --size 640x480 --aa 1 --kernel sse2 --json");
}

void add_avatar(CLI::App& app, Options& options) {
  app.add_option("FILE", options.avatar, "A humanoid in .vrm, .glb or .gltf")->required();
  app.footer(
      "Tells what a figure of another maker has and what it lacks. `--avatar FILE` of sign, render, motion and bench\n"
      "signs with it: its bones are turned into a T-pose, and signs are solved on its own proportions and skin.\n"
      "  Bones  who plays which part, named as VRM 1.0 names them. A VRM says so itself; elsewhere, and where a VRM "
      "has\n"
      "         gaps, the names of nodes tell: those of Mixamo, Ready Player Me, Unreal, MakeHuman, Rigify, VRoid,\n"
      "         3ds Max, Character Creator and WebXR hands are known. Signing needs the head, both arms and both "
      "hands; fingers that are missing are left out of the picture, and told.\n"
      "  Face   the channels that signing uses, named as ARKit names them: by a morph target of that name (or of\n"
      "         MakeHuman, VRoid or Oculus), roughly by an expression that moves more than the channel, or by the "
      "bones\n"
      "         of eyes and jaw.\n"
      "  Note   what will look or move otherwise than its maker meant.\n"
      "A figure with gaps is no error; a file that is broken, or holds nothing to draw, is.\n"
      "Examples:\n"
      "  auslanjam avatar figure.vrm\n"
      "  auslanjam avatar figure.glb --json\n"
      "  auslanjam render \"Where does it hurt?\" --avatar figure.vrm -o hurt.mp4");
}

void add_check(CLI::App& app, Options& options) {
  app.add_option("GLOSS", options.words,
                 "Which, or phrase:ID; all entries and phrases of the lexicon when none is given (takes a minute)");
  app.add_option("--picture", options.output, "A folder for pictures of the worst moment of each that is outside")
      ->type_name("FOLDER");
  app.add_option("--exceptions", options.exceptions,
                 "What is known to be outside (the built-in list, for the built-in figure and lexicon)")
      ->type_name("FILE");
  app.add_option("--write-exceptions", options.write_exceptions, "Write such a list of what is outside now")
      ->type_name("FILE");
  add_parsed(app, "--threads", "How many are checked at once (1)", "N",
             [&options](const std::string& text) { return parse_int(text, 1, 64, options.threads); });
  add_figure(app, options);
  app.footer(
      "Performs each without idle motion, looks 120 times a second and measures it on the figure's own surface. The "
      "exit\nstatus is 1 where a limit is broken that is not listed as an exception, where one is broken farther than "
      "listed,\nand where an exception is needless.\n"
      "Examples:\n"
      "  auslanjam check\n"
      "  auslanjam check HURT fs:A phrase:hello-how-are-you --picture worst\n"
      "  auslanjam check --avatar figure.vrm --json");
}

void add_notation(CLI::App& app, Options& options) {
  app.add_option("FILE", options.source.sigml_file, "SiGML, of either kind (hns_sign, hamgestural_sign)");
  app.add_option("--hamnosys", options.source.hamnosys, "A sign in HamNoSys (symbols or their names) in place of FILE")
      ->type_name("STRING");
  app.add_option("--gloss", options.source.glosses, "Entries of the lexicon in place of FILE")->type_name("GLOSS ...");
  app.add_option("--to", options.notation,
                 "Write it as SiGML with symbols (hns) or attributes (gestural), as strings of HamNoSys symbols "
                 "(hamnosys), or as the lexicon's own text (text)")
      ->check(CLI::IsMember({"hns", "gestural", "hamnosys", "text"}));
  app.add_option("-o,--output", options.output, "Where it is written, in place of stdout")->type_name("FILE");
  app.footer(
      "Each finding has its line and column: an error (cannot be signed), a warning (signed with the stated "
      "assumption, or without what is said to be left out) or a note.\n"
      "Examples:\n"
      "  auslanjam notation signs.sigml\n"
      "  auslanjam notation signs.sigml --to gestural -o other.sigml\n"
      "  auslanjam notation --hamnosys hamflathand,hamextfingeru,hampalmd,hammoveo --to text\n"
      "  auslanjam notation --gloss HURT WHERE --to hns -o entries.sigml");
}

void add_common(CLI::App& app, Options& options) {
  app.add_option("--db", options.database, "Another lexicon database")->type_name("FILE");
  app.add_flag("--quiet", options.quiet, "No progress, no remarks");
  app.add_flag("--json", options.json, "Answer as JSON on stdout");
}

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t\r\n\v\f") == std::string::npos;
}

/// What only makes sense together.
std::string check(const Options& options) {
  if (options.appearance == kListAppearances) return {};
  const Source& source = options.source;
  const int sources = (source.text ? 1 : 0) + (source.glosses.empty() ? 0 : 1) + (source.motion_file ? 1 : 0) +
                      (source.sigml_file ? 1 : 0) + (source.hamnosys ? 1 : 0);
  switch (options.command) {
    case Command::kSign:
    case Command::kRender:
    case Command::kMotion:
    case Command::kTranslate:
    case Command::kBench:
      if (sources == 0) return "there is no TEXT to sign: give English in quotes, as auslanjam \"Where does it hurt?\"";
      if (sources > 1) return "give only one of TEXT, --gloss, --sigml, --hamnosys and --motion";
      if (source.text && is_blank(*source.text)) return "the TEXT is empty: give English to sign";
      break;
    case Command::kNotation:
      if (sources != 1) return "notation takes one FILE of SiGML, --hamnosys STRING or --gloss GLOSS";
      if (!source.glosses.empty() && options.notation.empty())
        return "notation --gloss needs --to, which says what to write";
      if (options.notation.empty() && !options.output.empty())
        return "notation -o needs --to, which says what to write";
      break;
    default:
      break;
  }
  if (options.command == Command::kTranslate && !source.text && source.glosses.empty())
    return "translate takes TEXT or --gloss; motions and notations hold no English";
  if (options.command == Command::kRender && options.output.empty() && !options.hash)
    return "render needs -o OUTPUT (.mp4 .webm .webp .gif .y4m .png) or --hash";
  if (options.command == Command::kMotion && options.output.empty()) return "motion needs -o OUTPUT (.jsonl or .bvh)";
  if (options.command == Command::kExperiment && options.output.empty()) return "experiment needs -o FOLDER";
  return {};
}

}  // namespace

std::variant<Options, ExitNow> parse_command_line(int argc, const char* const* argv) {
  Options options;
  CLI::App app(std::string(kDescription), "auslanjam");
  app.footer(std::string(kExamples));
  app.set_version_flag("--version", AUSLANJAM_VERSION);
  app.require_subcommand(1);
  app.failure_message([](const CLI::App* failed, const CLI::Error& error) {
    return "auslanjam: " + std::string(error.what()) + "\n`" + failed->get_name() + " --help` tells how to use it\n";
  });

  CLI::App* sign =
      app.add_subcommand("sign", "Sign it: in a window where there is a display, else into a clip (says where)");
  add_source(*sign, options);
  sign->add_option("-o,--output", options.output, "Where the clip goes, and no window")->type_name("FILE");
  CLI::App* render = app.add_subcommand("render", "Sign it into a film or picture file");
  add_source(*render, options);
  render
      ->add_option("-o,--output", options.output,
                   ".mp4 .webm .webp .gif .y4m, or .png (a numbered sequence, or one picture with --at)")
      ->type_name("FILE");
  render->add_flag("--hash", options.hash, "Print a digest of each frame's pixels");
  for (CLI::App* sub : {sign, render}) {
    add_performance(*sub, options);
    add_picture(*sub, options);
  }
  CLI::App* motion = app.add_subcommand("motion", "Write the motion itself");
  add_source(*motion, options);
  motion->add_option("-o,--output", options.output, ".jsonl or .bvh")->type_name("FILE");
  add_performance(*motion, options);
  CLI::App* translate = app.add_subcommand("translate", "Show the glosses and the rule behind each");
  add_source(*translate, options);
  CLI::App* experiment =
      app.add_subcommand("experiment", "Repeat the paper's interpolation experiment: tables, plots, pictures");
  experiment->add_option("-o,--output", options.output, "The folder to fill; it is made when missing")
      ->type_name("FOLDER");
  add_figure(*experiment, options);
  CLI::App* bench = app.add_subcommand("bench", "Time the steps of a frame on this computer");
  add_bench(*bench, options);
  CLI::App* avatar = app.add_subcommand("avatar", "Tell what a figure of another maker has, and lacks for signing");
  add_avatar(*avatar, options);
  CLI::App* check_signs = app.add_subcommand(
      "check", "Measure how well entries are signed: contact, body parts inside each other, directions, joints, speed");
  add_check(*check_signs, options);
  CLI::App* notation =
      app.add_subcommand("notation", "Tell what is understood of signs in SiGML or HamNoSys, or write them otherwise");
  add_notation(*notation, options);
  const auto db = add_db(app, options);
  for (CLI::App* sub : {sign, render, motion, translate, experiment, bench, avatar, check_signs, notation})
    add_common(*sub, options);
  for (const auto& [sub, command] : db)
    add_common(*sub, options);

  // `auslanjam TEXT` is `auslanjam sign TEXT`.
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const auto is_command = [](const std::string& word) {
    for (const std::string_view command : kCommands)
      if (word == command) return true;
    return word == "--help" || word == "-h" || word == "--version";
  };
  if (arguments.empty()) {
    std::cerr << app.help();
    return ExitNow{2};
  }
  if (!is_command(arguments.front())) arguments.insert(arguments.begin(), "sign");

  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    app.parse(reversed);
  } catch (const CLI::Success& asked) {
    app.exit(asked, std::cout, std::cerr);
    return ExitNow{0};
  } catch (const CLI::ParseError& error) {
    app.exit(error, std::cout, std::cerr);
    return ExitNow{2};
  }
  if (*sign) options.command = Command::kSign;
  if (*render) options.command = Command::kRender;
  if (*motion) options.command = Command::kMotion;
  if (*translate) options.command = Command::kTranslate;
  if (*experiment) options.command = Command::kExperiment;
  if (*avatar) options.command = Command::kAvatar;
  if (*check_signs) options.command = Command::kCheck;
  if (*notation) options.command = Command::kNotation;
  if (*bench) options.command = Command::kBench;
  if (*bench && !options.source.text) options.source.text = "Where does it hurt?";
  for (const auto& [sub, command] : db)
    if (*sub) options.command = command;
  options.caption = options.caption || options.strict;
  if (const std::string wrong = check(options); !wrong.empty()) {
    std::cerr << "auslanjam: " << wrong << "\n`auslanjam --help` tells how to use it\n";
    return ExitNow{2};
  }
  return options;
}

}  // namespace auslan
