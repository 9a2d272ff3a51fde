#include "base/setting_marks.h"

namespace voluta::base {

namespace {
constexpr char kQuote = '`';

// Removes an opening parenthesis and the blank before it from the end of `text`; returns whether
// there was one.
bool dropOpening(std::string& text) {
  if (!text.ends_with('('))
    return false;
  text.pop_back();
  if (text.ends_with(' '))
    text.pop_back();
  return true;
}
} // namespace

std::string withSettings(std::string_view sentence,
                         const std::function<std::string(std::string_view)>& written) {
  std::string out;
  std::size_t done = 0;
  for (std::size_t begin; (begin = sentence.find(kQuote, done)) != std::string_view::npos;) {
    const std::size_t end = sentence.find(kQuote, begin + 1);
    if (end == std::string_view::npos)
      break;
    out.append(sentence, done, begin - done);
    done = end + 1;
    const std::string setting = written(sentence.substr(begin + 1, end - begin - 1));
    if (setting.empty() && sentence.substr(done).starts_with(')') && dropOpening(out))
      ++done;
    out += setting;
  }
  return out.append(sentence, done, sentence.npos);
}

std::string withSettingsAsTyped(std::string_view sentence) {
  return withSettings(sentence, [](std::string_view setting) { return std::string(setting); });
}

std::vector<std::string> settingsIn(std::string_view sentence) {
  std::vector<std::string> settings;
  withSettings(sentence, [&](std::string_view setting) { return settings.emplace_back(setting); });
  return settings;
}

} // namespace voluta::base
