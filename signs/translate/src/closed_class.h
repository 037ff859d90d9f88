// SPDX-License-Identifier: Apache-2.0
// The closed classes of English words that the rules speak of. `word` is case-folded.
#pragma once

#include <string_view>

namespace auslan {

bool is_article(std::string_view word);             ///< a an the
bool is_copula(std::string_view word);              ///< forms of be
bool is_past_copula(std::string_view word);         ///< was were been
bool is_do_form(std::string_view word);             ///< do does did
bool is_have_form(std::string_view word);           ///< have has had
bool is_modal(std::string_view word);               ///< can could may might must shall should will would
bool is_auxiliary(std::string_view word);           ///< copula (am is are was were), do, have, modals
bool is_wh(std::string_view word);                  ///< what where when who whom whose which why how
bool is_negator(std::string_view word);             ///< not never no nothing none nobody nowhere neither nor
bool is_subject_pronoun(std::string_view word);     ///< I you he she it we they
bool is_pronoun(std::string_view word);             ///< subject pronouns and this that these those there anyone …
bool is_determiner(std::string_view word);          ///< articles, possessives, this that these those, some any no every
bool is_possessive_pronoun(std::string_view word);  ///< my your his her its our their
bool is_conjunction(std::string_view word);         ///< and but or so because if then when while
bool is_clause_opener(std::string_view word);  ///< words after which a new clause can begin: greetings, please, and …
bool is_clause_closer(std::string_view word);  ///< words that can follow a whole clause: please, thanks, but …
bool is_time_word(std::string_view word);      ///< today tomorrow yesterday now tonight
bool is_preposition(std::string_view word);
bool is_degree(std::string_view word);              ///< much many long old far often … : goes with "how"
bool is_title(std::string_view word);               ///< mr mrs ms miss dr doctor prof professor: a name follows
bool is_title_abbreviation(std::string_view word);  ///< titles written with a point, that does not end a sentence
bool is_unit(std::string_view word);                ///< mg ml kg am pm …: may be written onto a number
bool is_ordinal(std::string_view word);             ///< "2nd"
bool is_impersonal_verb(std::string_view word);  ///< hurt rain snow happen …, whose subject "it" stands for nothing
bool is_motion_verb(std::string_view word);      ///< go come walk …: the movement shows the direction
bool follows_copula(std::string_view word);      ///< after noun's: the 's is then "is"
/// Any of the above that cannot be a person's name.
bool is_closed_class(std::string_view word);

}  // namespace auslan
