// Access to the lines of a long text without copying it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::panels {

// Stores the position of every 64th line: 40 MB of program take a few milliseconds and 130 kB.
class TextLines {
public:
  TextLines() = default;
  // nullptr: no lines. Lines end with \n, \r\n or the text's end.
  explicit TextLines(std::shared_ptr<const std::string> text);

  const std::shared_ptr<const std::string>& text() const { return text_; }
  std::size_t count() const { return count_; }
  // Bytes of the longest line.
  std::size_t longest() const { return longest_; }
  // Without its end. Precondition: index < count(). Valid during the lifetime of this object.
  std::string_view line(std::size_t index) const;

private:
  std::shared_ptr<const std::string> text_;
  std::vector<std::size_t> starts_; // of lines 0, 64, 128, ...
  std::size_t count_ = 0, longest_ = 0;
};

} // namespace voluta::panels
