// Statements of a 3MF model part that the reader does not act on, each once.
#pragma once

#include "base/text.h"

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace voluta::geometry {

class ThreemfNotes {
public:
  // `member`: of the package.
  explicit ThreemfNotes(std::string member) : member_(std::move(member)) {}

  const std::string& member() const { return member_; }
  void add(base::Message note) { notes_.push_back(std::move(note)); }
  // Equal ones are counted; the line is that of the first. `space`: may be empty.
  void addElement(const std::string& element, const std::string& space, long long line);
  void addAttribute(const std::string& attribute, const std::string& element, long long line);
  void addMetadata(const std::string& name);

  // Returns a sentence for each, those given whole first.
  std::vector<base::Message> sentences() const;

private:
  struct Seen {
    std::size_t count = 0;
    long long line = 0;
  };
  using Names = std::pair<std::string, std::string>;

  std::string member_;
  std::vector<base::Message> notes_;
  std::map<Names, Seen> elements_, attributes_;
  std::vector<std::string> metadata_;
};

} // namespace voluta::geometry
