#include "language/parameter_texts.h"

#include "language/numbers.h"
#include "language/setting_words.h"
#include "language/translated.h"

#include <QCoreApplication>
#include <QLocale>

namespace voluta::language {

QString unitText(const std::string& unit) {
  return unit == "mm3"     ? QStringLiteral("mm³")
         : unit == "mm3/s" ? QStringLiteral("mm³/s")
         : unit == "deg"   ? QStringLiteral("°")
         : unit == "share" ? QStringLiteral("%")
                           : QString::fromStdString(unit);
}

double shownFactor(const base::ParameterSpec& spec) {
  return spec.unit == "share" ? 100.0 : 1.0;
}

QString valueText(const base::ParameterSpec& spec, const base::ParameterValue& value) {
  if (value == base::ParameterValue(0.0) || value == base::ParameterValue(0LL))
    if (const QString zero = zeroText(spec.key); !zero.isEmpty())
      return capitalized(zero);
  const QString unit = unitText(spec.unit);
  const QLocale locale;
  const QString space = unit.isEmpty() || unit == QStringLiteral("°") ? QString() : QString(' ');
  if (const auto* number = std::get_if<double>(&value))
    return numberText(shownFactor(spec) * *number, 6) + space + unit;
  if (const auto* whole = std::get_if<long long>(&value))
    return locale.toString(static_cast<qlonglong>(*whole)) + space + unit;
  if (const auto* yes = std::get_if<bool>(&value))
    return *yes ? QCoreApplication::translate("Parameters", "on")
                : QCoreApplication::translate("Parameters", "off");
  const std::string& text = std::get<std::string>(value);
  for (const base::Choice& choice : spec.choices)
    if (choice.id == text)
      return translatedHeading(choice.label);
  return QString::fromStdString(text);
}

QString parameterToolTip(const base::ParameterSpec& spec) {
  const auto line = [](const QString& text) { return QStringLiteral("<br>") + text; };
  QString tip = translatedHeading(spec.help).toHtmlEscaped();
  tip += QStringLiteral("<br>");
  if (spec.type == base::ParameterType::Number)
    tip += line(QCoreApplication::translate("Parameters", "Range: %1 to %2")
                    .arg(valueText(spec, spec.minimum), valueText(spec, spec.maximum)));
  if (spec.type == base::ParameterType::Integer)
    tip += line(QCoreApplication::translate("Parameters", "Range: %1 to %2")
                    .arg(valueText(spec, static_cast<long long>(spec.minimum)),
                         valueText(spec, static_cast<long long>(spec.maximum))));
  tip += line(QCoreApplication::translate("Parameters", "Default: %1")
                  .arg(valueText(spec, spec.defaultValue).toHtmlEscaped()));
  tip += line(QCoreApplication::translate("Parameters", "Key: %1")
                  .arg(QString::fromStdString(spec.key).toHtmlEscaped()));
  return QStringLiteral("<qt>%1</qt>").arg(tip);
}

} // namespace voluta::language
