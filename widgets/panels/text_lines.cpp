#include "panels/text_lines.h"

#include "base/error.h"

#include <algorithm>
#include <cstring>

namespace voluta::panels {

namespace {
constexpr std::size_t kEvery = 64;

// Returns the position after the line: after its \n, or the end of the text.
std::size_t nextLine(const std::string& text, std::size_t from) {
  const void* end = std::memchr(text.data() + from, '\n', text.size() - from);
  return end ? static_cast<std::size_t>(static_cast<const char*>(end) - text.data()) + 1
             : text.size();
}
} // namespace

TextLines::TextLines(std::shared_ptr<const std::string> text) : text_(std::move(text)) {
  if (!text_)
    return;
  for (std::size_t at = 0; at < text_->size(); ++count_) {
    if (count_ % kEvery == 0)
      starts_.push_back(at);
    const std::size_t next = nextLine(*text_, at);
    longest_ = std::max(longest_, next - at);
    at = next;
  }
}

std::string_view TextLines::line(std::size_t index) const {
  base::require(index < count_, "TextLines: the line is there");
  std::size_t at = starts_[index / kEvery];
  for (std::size_t i = index % kEvery; i > 0; --i)
    at = nextLine(*text_, at);
  std::string_view line(text_->data() + at, nextLine(*text_, at) - at);
  if (line.ends_with('\n'))
    line.remove_suffix(1);
  if (line.ends_with('\r'))
    line.remove_suffix(1);
  return line;
}

} // namespace voluta::panels
