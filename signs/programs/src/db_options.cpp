// SPDX-License-Identifier: Apache-2.0
#include "db_options.h"

#include "phonology/vocabulary.h"

#include <string>

namespace auslan {
namespace {

template <typename E>
std::vector<std::string> words_of() {
  const auto names = names_of<E>();
  return {names.begin(), names.end()};
}

/// What a sign can be chosen by, for the look-up from what was seen.
void add_filters(CLI::App& app, Options& options) {
  app.add_option("--kind", options.kind, "sign, letter or number")->check(CLI::IsMember({"sign", "letter", "number"}));
  app.add_option("--category", options.category, "Only this category")->type_name("NAME");
  app.add_option("--region", options.region, "Only this region: all, north, south or a state")->type_name("NAME");
  app.add_option("--handshape", options.handshape, "Made with this handshape, by either hand")->type_name("ID");
  // As names, not as IsMember: the lists are too long for a help text.
  app.add_option("--at", options.place, "Made at this place: chin, chest, neutral, nd_palm ...")->type_name("PLACE");
  app.add_option("--hands", options.hands, "one, two-symmetric, two-alternating or dominant+base")
      ->check(CLI::IsMember(words_of<Handedness>()));
  app.add_option("--movement", options.movement, "With this movement: tap, circle, straight ...")->type_name("KIND");
  app.add_option("--review", options.review, "Only what is unreviewed, reviewed or rejected")
      ->check(CLI::IsMember(words_of<ReviewState>()));
}

}  // namespace

std::vector<std::pair<CLI::App*, Command>> add_db(CLI::App& app, Options& options) {
  CLI::App* db = app.add_subcommand("db", "Look into the lexicon, review it, and bring lexicons together");
  db->require_subcommand(1);
  std::vector<std::pair<CLI::App*, Command>> commands;
  const auto add = [&](const char* name, const char* help, Command command) {
    CLI::App* sub = db->add_subcommand(name, help);
    commands.emplace_back(sub, command);
    return sub;
  };
  CLI::App* list = add("list", "List the entries, all or those that look like what you saw", Command::kDbList);
  add_filters(*list, options);
  list->footer(
      "Examples:\n"
      "  auslanjam db list --category health\n"
      "  auslanjam db list --handshape point --at chin --hands one\n"
      "  auslanjam db list --review unreviewed --json");
  CLI::App* show = add("show", "Show whole entries", Command::kDbShow);
  show->add_option("GLOSS", options.words, "Which")->required();
  CLI::App* search = add("search", "Search glosses, English words and definitions", Command::kDbSearch);
  search->add_option("WORDS", options.words, "What to look for, in any form of the words")->required();
  add("check", "Check the database against its rules", Command::kDbCheck);
  add("stats", "Count what there is and what it rests on", Command::kDbStats);

  CLI::App* build = add("build", "Compile the text of a lexicon into a database", Command::kDbBuild);
  build->add_option("FOLDER", options.words, "The folder with handshapes.toml")->required()->expected(1);
  build->add_option("-o,--output", options.output, "The database")->type_name("FILE")->required();
  build->footer("The same text gives the same bytes.\nExample:\n  auslanjam db build assets/lexicon -o mine.sqlite");
  CLI::App* export_text = add("export", "Write a database as text again", Command::kDbExport);
  export_text->add_option("-o,--output", options.output, "The folder for the text")->type_name("FOLDER")->required();
  export_text->footer("Nothing is lost.\nExample:\n  auslanjam db export --db mine.sqlite -o assets/lexicon");
  CLI::App* import = add("import", "Take over what another lexicon has", Command::kDbImport);
  import->add_option("SOURCE", options.words, "A folder of text, or a database")->required()->expected(1);
  import->add_option("--conflicts", options.conflicts, "What becomes of entries that differ: ours or theirs")
      ->check(CLI::IsMember({"ours", "theirs"}));
  import->footer(
      "New entries and new reviews are taken over. Entries that say different things are listed, and then nothing is\n"
      "written unless you say which side stays.\nExample:\n  auslanjam db import theirs.sqlite --db mine.sqlite");
  CLI::App* review = add("review", "Note what a reviewer says of an entry", Command::kDbReview);
  review->add_option("ENTRY", options.words, "A gloss, fs:LETTER, num:N, phrase:ID or handshape:ID")
      ->required()
      ->expected(1);
  review->add_option("--by", options.reviewer, "Who says it")->type_name("NAME")->required();
  review->add_option("--verdict", options.verdict, "reviewed (approved), rejected, or unreviewed (taken back)")
      ->check(CLI::IsMember(words_of<ReviewState>()))
      ->required();
  review->add_option("--remark", options.remark, "What is to be said about it")->type_name("TEXT");
  review->add_option("--on", options.reviewed_on, "When, if not today")->type_name("YYYY-MM-DD");
  review->footer(
      "The verdict holds for the entry as it is now: when the entry is changed, `db check` asks for another.\n"
      "Only a Deaf signer's verdict makes an entry reviewed.\n"
      "Example:\n  auslanjam db review HURT --by \"A. Signer\" --verdict rejected --remark \"one hand\" --db "
      "mine.sqlite");
  CLI::App* diff = add("diff", "Compare two lexicons, entry by entry", Command::kDbDiff);
  diff->add_option("OLD NEW", options.words, "Two folders of text or databases")->required()->expected(2);
  CLI::App* migrate = add("migrate", "Bring a database of an older version up to date", Command::kDbMigrate);
  migrate->add_option("FILE", options.words, "The database")->required()->expected(1);
  return commands;
}

}  // namespace auslan
