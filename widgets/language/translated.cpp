#include "language/translated.h"

#include <QCoreApplication>

namespace voluta::language {

namespace {
constexpr const char* kContext = "Core";
} // namespace

QString translated(base::Text text, std::optional<long long> count) {
  if (text.empty())
    return {};
  const std::string english(text.english());
  const QString sentence = QCoreApplication::translate(kContext, english.c_str(), nullptr,
                                                       count ? static_cast<int>(*count) : -1);
  // English has no translation file: its singular forms are core's own.
  const bool isEnglish = sentence == QString::fromStdString(english);
  if (isEnglish && text.plural() && count == 1)
    return QString::fromStdString(std::string(text.one()));
  return sentence;
}

QString capitalized(QString text) {
  if (!text.isEmpty())
    text[0] = text[0].toUpper();
  return text;
}

QString translatedHeading(base::Text text) {
  return capitalized(translated(text));
}

} // namespace voluta::language
