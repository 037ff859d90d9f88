// SPDX-License-Identifier: Apache-2.0
#include "lexicon/lexicon_compare.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace auslan {
namespace {

/// The keywords of every gloss, each list in the order of the text.
std::map<std::string, std::vector<Keyword>> by_gloss(const std::vector<Keyword>& keywords) {
  std::map<std::string, std::vector<Keyword>> lists;
  for (const Keyword& keyword : keywords)
    lists[keyword.gloss].push_back(keyword);
  return lists;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t start = 0; start < text.size();) {
    const size_t end = std::min(text.find('\n', start), text.size());
    if (end > start) lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

/// What one has and the other has not, in order; of equal lines each counts once.
void add_missing(const std::vector<std::string>& lines, const std::vector<std::string>& other, const char* mark,
                 std::vector<std::string>& out) {
  std::multiset<std::string> left(other.begin(), other.end());
  for (const std::string& line : lines) {
    if (const auto found = left.find(line); found != left.end())
      left.erase(found);
    else
      out.push_back(mark + line);
  }
}

/// One entry, whatever its kind, as far as comparing goes.
struct Entry {
  std::string name;
  std::string content;
  std::string text;
  const std::vector<Review>* history = nullptr;
};

/// A lexicon of this entry alone, as text; one that has nothing else to say.
std::string text_of(LexiconText one) {
  std::string text;
  for (const TextSource& source : write_lexicon_text(one))
    text += source.text;
  return text;
}

std::vector<Entry> entries_of(const LexiconText& text) {
  std::vector<Entry> entries;
  for (const Handshape& shape : text.handshapes)
    entries.push_back(
        {"handshape " + shape.id, content_digest(shape), text_of({{shape}, {}, {}, {}}), &shape.provenance.history});
  const auto keywords = by_gloss(text.keywords);
  for (const Sign& sign : text.signs) {
    const auto own = keywords.find(sign.gloss);
    const std::vector<Keyword> words = own == keywords.end() ? std::vector<Keyword>{} : own->second;
    entries.push_back(
        {sign.gloss, content_digest(sign, words), text_of({{}, {sign}, words, {}}), &sign.provenance.history});
  }
  for (const Phrase& phrase : text.phrases)
    entries.push_back(
        {"phrase " + phrase.id, content_digest(phrase), text_of({{}, {}, {}, {phrase}}), &phrase.provenance.history});
  return entries;
}

std::vector<std::string> differing_lines(const Entry& before, const Entry& after) {
  const std::vector<std::string> old_lines = lines_of(before.text), new_lines = lines_of(after.text);
  std::vector<std::string> lines;
  add_missing(old_lines, new_lines, "- ", lines);
  add_missing(new_lines, old_lines, "+ ", lines);
  return lines;
}

bool begins_with(const std::vector<Review>& history, const std::vector<Review>& beginning) {
  return history.size() >= beginning.size() && std::equal(beginning.begin(), beginning.end(), history.begin());
}

/// Merges the lists of one kind: `name_of` gives an entry's name in `known`, which holds both sides' entries.
struct Sides {
  std::map<std::string, const Entry*> ours, theirs;
};

template <typename T, typename NameOf>
void merge_list(std::vector<T>& ours, const std::vector<T>& theirs, const NameOf& name_of, const Sides& sides,
                OnConflict on_conflict, LexiconMerge& merge, std::set<std::string>& taken) {
  for (const T& their : theirs) {
    const std::string name = name_of(their);
    const Entry& incoming = *sides.theirs.at(name);
    const auto known = sides.ours.find(name);
    if (known == sides.ours.end()) {
      ours.push_back(their);
      merge.added.push_back(name);
      taken.insert(name);
      continue;
    }
    const Entry& own = *known->second;
    if (own.text == incoming.text) continue;
    const auto mine = std::ranges::find_if(ours, [&](const T& one) { return name_of(one) == name; });
    if (own.content == incoming.content && begins_with(*own.history, *incoming.history)) continue;
    if (own.content == incoming.content && begins_with(*incoming.history, *own.history)) {
      mine->provenance = their.provenance;
      merge.reviewed.push_back(name);
      continue;
    }
    merge.conflicts.push_back({name, own.content == incoming.content ? ChangeKind::kReviewed : ChangeKind::kChanged,
                               differing_lines(own, incoming)});
    if (on_conflict != OnConflict::kTakeTheirs) continue;
    *mine = their;
    taken.insert(name);
  }
}

}  // namespace

std::string_view to_name(ChangeKind kind) {
  constexpr std::array<std::string_view, 4> kNames = {"added", "removed", "changed", "reviewed"};
  return kNames[static_cast<size_t>(kind)];
}

std::vector<EntryChange> compare_lexicons(const LexiconText& before, const LexiconText& after) {
  const std::vector<Entry> old_entries = entries_of(before), new_entries = entries_of(after);
  std::map<std::string, const Entry*> of_old, of_new;
  for (const Entry& entry : old_entries)
    of_old[entry.name] = &entry;
  for (const Entry& entry : new_entries)
    of_new[entry.name] = &entry;
  std::vector<EntryChange> changes;
  for (const Entry& entry : old_entries) {
    const auto found = of_new.find(entry.name);
    if (found == of_new.end())
      changes.push_back({entry.name, ChangeKind::kRemoved, {}});
    else if (found->second->text != entry.text)
      changes.push_back({entry.name,
                         found->second->content == entry.content ? ChangeKind::kReviewed : ChangeKind::kChanged,
                         differing_lines(entry, *found->second)});
  }
  for (const Entry& entry : new_entries)
    if (!of_old.contains(entry.name)) changes.push_back({entry.name, ChangeKind::kAdded, {}});
  return changes;
}

LexiconMerge merge_lexicons(const LexiconText& ours, const LexiconText& theirs, OnConflict on_conflict) {
  const std::vector<Entry> own = entries_of(ours), incoming = entries_of(theirs);
  Sides sides;
  for (const Entry& entry : own)
    sides.ours[entry.name] = &entry;
  for (const Entry& entry : incoming)
    sides.theirs[entry.name] = &entry;
  LexiconMerge merge;
  merge.merged = ours;
  std::set<std::string> taken;
  const auto merge_kind = [&](auto& mine, const auto& their, const auto& name_of) {
    merge_list(mine, their, name_of, sides, on_conflict, merge, taken);
  };
  merge_kind(merge.merged.handshapes, theirs.handshapes,
             [](const Handshape& shape) { return "handshape " + shape.id; });
  merge_kind(merge.merged.signs, theirs.signs, [](const Sign& sign) { return sign.gloss; });
  merge_kind(merge.merged.phrases, theirs.phrases, [](const Phrase& phrase) { return "phrase " + phrase.id; });
  // The keywords of a sign go with it.
  std::erase_if(merge.merged.keywords, [&](const Keyword& keyword) { return taken.contains(keyword.gloss); });
  for (const Keyword& keyword : theirs.keywords)
    if (taken.contains(keyword.gloss)) merge.merged.keywords.push_back(keyword);
  return merge;
}

}  // namespace auslan
