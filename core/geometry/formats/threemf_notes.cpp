#include "geometry/formats/threemf_notes.h"

#include <algorithm>

namespace voluta::geometry {

void ThreemfNotes::addElement(const std::string& element, const std::string& space,
                              long long line) {
  Seen& seen = elements_[{element, space}];
  if (seen.count++ == 0)
    seen.line = line;
}

void ThreemfNotes::addAttribute(const std::string& attribute, const std::string& element,
                                long long line) {
  Seen& seen = attributes_[{attribute, element}];
  if (seen.count++ == 0)
    seen.line = line;
}

void ThreemfNotes::addMetadata(const std::string& name) {
  if (std::ranges::find(metadata_, name) == metadata_.end())
    metadata_.push_back(name);
}

std::vector<base::Message> ThreemfNotes::sentences() const {
  std::vector<base::Message> all = notes_;
  const auto names = [](const Names& of) {
    return of.second.empty() ? of.first : of.first + " (" + of.second + ")";
  };
  for (const auto& [of, seen] : elements_)
    all.emplace_back(
        "not used: {count} element {name}, in line {line} of {where}|"
        "not used: {count} elements {name}, the first in line {line} of {where}"_plural,
        std::vector<base::Value>{seen.count, names(of), seen.line, member_});
  for (const auto& [of, seen] : attributes_)
    all.emplace_back(
        "not used: attribute {name} of {count} element {element}, in line {line} of {where}|"
        "not used: attribute {name} of {count} elements {element}, the first in line {line} of {where}"_plural,
        std::vector<base::Value>{of.first, seen.count, of.second, seen.line, member_});
  for (const std::string& name : metadata_)
    all.push_back(base::message("not used: metadata '{name}' ({where})"_text, name, member_));
  return all;
}

} // namespace voluta::geometry
