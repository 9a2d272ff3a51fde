#include "texts/known_texts.h"

#include <algorithm>

namespace voluta::texts {

base::Text knownText(std::string_view english) {
  const std::span<const base::Text> all = knownTexts();
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const base::Text& text) { return text.english() == english; });
  return found != all.end() ? *found : base::Text();
}

} // namespace voluta::texts
