// SPDX-License-Identifier: Apache-2.0
#include "element.h"

#include <algorithm>

namespace auslan::notation {

std::string Element::text(const char* attribute) {
  const pugi::xml_attribute found = node_.attribute(attribute);
  if (found.empty()) return {};
  read_.push_back(attribute);
  return found.value();
}

bool Element::flag(const char* attribute) {
  const std::string value = text(attribute);
  if (value.empty() || value == "true" || value == "1" || value == "yes") return !value.empty();
  if (value != "false" && value != "0" && value != "no")
    findings_->left_out(mark_, "the attribute " + std::string(attribute) + "=" + in_quotes(value) +
                                   " is neither true nor false; taken as false");
  return false;
}

void Element::not_carried(std::initializer_list<const char*> attributes) {
  for (const char* attribute : attributes) {
    const std::string value = text(attribute);
    if (!value.empty())
      findings_->left_out(mark_, "the attribute " + std::string(attribute) + "=" + in_quotes(value) + " of <" +
                                     std::string(name()) + "> is not carried");
  }
}

void Element::done() {
  for (const pugi::xml_attribute& attribute : node_.attributes()) {
    const std::string_view name = attribute.name();
    if (std::ranges::none_of(read_, [name](const char* known) { return name == known; }))
      findings_->left_out(mark_, "the attribute " + in_quotes(name) + " of the element " + in_quotes(this->name()) +
                                     " is not known and is left out");
  }
}

}  // namespace auslan::notation
