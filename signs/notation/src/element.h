// SPDX-License-Identifier: Apache-2.0
// An XML element with its place in the text, and a record of the attributes that were asked for: what is left over is
// told, never dropped.
#pragma once

#include "written_sign.h"
#include "xml_bounds.h"

#include <initializer_list>
#include <pugixml.hpp>

namespace auslan::notation {

class Element {
 public:
  Element(const pugi::xml_node& node, const Lines& lines, Findings& findings)
      : node_(node), lines_(&lines), findings_(&findings) {
    const std::ptrdiff_t offset = node.offset_debug();
    // pugixml points at the name, the place is that of the "<" before it.
    mark_ = lines.mark(offset > 0 ? static_cast<size_t>(offset) - 1 : 0);
  }

  std::string_view name() const { return node_.name(); }
  const Mark& mark() const { return mark_; }
  const Lines& lines() const { return *lines_; }
  Findings& findings() const { return *findings_; }
  const pugi::xml_node& node() const { return node_; }

  /// The value, marked as read; empty where there is none.
  std::string text(const char* attribute);
  /// "true", "1" or "yes".
  bool flag(const char* attribute);
  bool has(const char* attribute) const { return !node_.attribute(attribute).empty(); }
  /// Told as not carried when present and not in `harmless`.
  void not_carried(std::initializer_list<const char*> attributes);
  /// Ends the reading of this element: warns of each attribute that nobody asked for.
  void done();

  template <typename Visit>
  void each_child(Visit visit) const {
    for (const pugi::xml_node& child : node_.children()) {
      if (child.type() != pugi::node_element) continue;
      Element element(child, *lines_, *findings_);
      visit(element);
    }
  }

 private:
  pugi::xml_node node_;
  const Lines* lines_;
  Findings* findings_;
  Mark mark_;
  std::vector<const char*> read_;
};

/// The attributes speed and timescale as one factor; 1 where there are none.
double read_pace(Element& element);
/// sign_manual and what is in it.
void read_manual(Element& manual, WrittenSign& sign);
/// sign_nonmanual of gestural SiGML.
void read_tiers(Element& tiers, NonManual& face);
/// hamnosys_nonmanual of HamNoSys SiGML.
void read_hnm(Element& elements, NonManual& face);

}  // namespace auslan::notation
