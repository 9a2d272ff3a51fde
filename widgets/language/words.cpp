#include "language/words.h"

#include "language/numbers.h"
#include "language/setting_labels.h"
#include "language/translated.h"
#include "language/window_language.h"

#include <QLocale>

namespace voluta::language {

namespace {
class WindowLanguage : public base::Language {
public:
  std::string sentence(base::Text text, std::optional<long long> count) const override {
    return withSettingTexts(translated(text, count).toStdString());
  }
  std::string whole(long long number) const override {
    return QLocale().toString(static_cast<qlonglong>(number)).toStdString();
  }
  std::string number(double number, char format, int digits) const override {
    return (format == 'f' ? QLocale().toString(number, 'f', digits) : numberText(number, digits))
        .toStdString();
  }
  std::string withUnit(const std::string& number, base::Unit unit) const override {
    switch (unit) {
    case base::Unit::Mm2:
      return number + " mm²";
    case base::Unit::Mm3:
      return number + " mm³";
    case base::Unit::Degree:
      return number + "°";
    case base::Unit::DegreePerS:
      return number + "°/s";
    case base::Unit::Mm3PerS:
      return number + " mm³/s";
    default:
      return Language::withUnit(number, unit);
    }
  }
};
} // namespace

QString words(const base::Message& message) {
  return QString::fromStdString(base::inWords(message, WindowLanguage()));
}

QString words(const base::Value& value) {
  return QString::fromStdString(base::inWords(value, WindowLanguage()));
}

QString words(base::Text text) {
  return QString::fromStdString(WindowLanguage().sentence(text, std::nullopt));
}

QStringList words(const std::vector<base::Message>& messages) {
  QStringList all;
  for (const base::Message& message : messages)
    all << words(message);
  return all;
}

std::shared_ptr<const base::Language> windowLanguage() {
  return std::make_shared<WindowLanguage>();
}

std::string windowLanguageCode() {
  return QLocale().bcp47Name().toStdString();
}

QString heading(base::Text text) {
  return capitalized(words(text));
}

} // namespace voluta::language
