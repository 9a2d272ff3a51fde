#include "texts/known_texts.h"

#include <functional>
#include <map>
#include <string>

namespace voluta::texts {

base::Text knownText(std::string_view english) {
  static const std::map<std::string, base::Text, std::less<>> kByEnglish = [] {
    std::map<std::string, base::Text, std::less<>> texts;
    for (const base::Text& text : knownTexts())
      texts.emplace(base::english(text), text);
    return texts;
  }();
  const auto found = kByEnglish.find(english);
  return found != kByEnglish.end() ? found->second : base::Text();
}

} // namespace voluta::texts
