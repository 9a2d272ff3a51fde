#include "language/setting_labels.h"

#include "base/setting_marks.h"
#include "language/parameter_texts.h"
#include "language/translated.h"
#include "pipeline/stage_options.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <utility>

namespace voluta::language {

namespace {
// An option of the command line, and the label of its field. `context` is the form's.
struct Option {
  std::string_view name;
  const char* context;
  const char* label; // nullptr: no form has this option
};
constexpr std::array kOptions{
    Option{"--mode", "voluta::forms::ChoicesForm",
           QT_TRANSLATE_NOOP("voluta::forms::ChoicesForm", "Mode")},
    Option{"--cell", "voluta::forms::ChoicesForm",
           QT_TRANSLATE_NOOP("voluta::forms::ChoicesForm", "Cell")},
    Option{"--platform", "voluta::forms::ChoicesForm",
           QT_TRANSLATE_NOOP("voluta::forms::ChoicesForm", "Platform")},
    Option{"--scale fit", "voluta::panels::PlacementPanel",
           QT_TRANSLATE_NOOP("voluta::panels::PlacementPanel", "Fit to reach")},
    Option{"--scale", "voluta::panels::PlacementPanel",
           QT_TRANSLATE_NOOP("voluta::panels::PlacementPanel", "Scale")},
    Option{"--units", nullptr, nullptr},
    Option{"--pitch", nullptr, nullptr}};

const base::ParameterTable& parameters() {
  static const base::ParameterTable kTable = pipeline::allParameters();
  return kTable;
}

// Splits "orient=none" at the first of the separators; the second part is empty if there is none.
std::pair<std::string_view, std::string_view> split(std::string_view text, char separator) {
  const std::size_t at = text.find(separator);
  return at == std::string_view::npos ? std::pair(text, std::string_view())
                                      : std::pair(text.substr(0, at), text.substr(at + 1));
}

QString shown(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString quoted(const QString& label, const QString& value) {
  return QLocale().quoteString(value.isEmpty() ? label : label + QStringLiteral(": ") + value);
}

// A value that has a placeholder is shown as it is.
QString settingValue(const base::ParameterSpec& spec, std::string_view value) {
  if (value.empty() || value.starts_with('{'))
    return shown(value);
  return valueText(spec, base::parseParameter(spec, value));
}

QString optionText(std::string_view option) {
  const auto find = [](std::string_view name) {
    return std::ranges::find(kOptions, name, &Option::name);
  };
  const auto whole = find(option);
  const auto [name, value] = split(option, ' ');
  const auto found = whole != kOptions.end() ? whole : find(name);
  if (found == kOptions.end())
    return shown(option);
  if (found->label == nullptr)
    return {};
  return quoted(QCoreApplication::translate(found->context, found->label),
                whole != kOptions.end() ? QString() : shown(value));
}
} // namespace

QString settingText(std::string_view setting) {
  if (setting.starts_with("--"))
    return optionText(setting);
  const auto [key, value] = split(setting, '=');
  const base::ParameterSpec* spec = parameters().find(key);
  return spec ? quoted(translatedHeading(spec->label), settingValue(*spec, value)) : shown(setting);
}

std::string withSettingTexts(const std::string& sentence) {
  return base::withSettings(
      sentence, [](std::string_view setting) { return settingText(setting).toStdString(); });
}

} // namespace voluta::language
