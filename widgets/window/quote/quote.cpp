#include "window/quote/quote.h"

#include "forms/duration_text.h"
#include "language/window_language.h"
#include "project/version.h"

#include <QCoreApplication>
#include <QDate>
#include <QLocale>
#include <QSettings>
#include <QStringList>
#include <algorithm>
#include <utility>

namespace voluta::window {

namespace {
constexpr const char* kMachine = "quote/machinePerHour"; // of any cell
constexpr const char* kFixed = "quote/fixed";
constexpr const char* kMargin = "quote/margin";

QString said(const char* text) {
  return QCoreApplication::translate("Quote", text);
}

QString machineKey(const std::string& cell) {
  return QStringLiteral("quote/machines/") + QString::fromStdString(cell);
}

QString numberText(double value, int digits) {
  return QLocale().toString(value, 'f', digits);
}

page::Fact fact(const QString& label, const QString& value) {
  return {label.toStdString(), value.toStdString()};
}
} // namespace

QuotePrices quotePrices(const std::string& cell) {
  const QSettings settings;
  const auto read = [&](const QString& key, double otherwise) {
    return std::max(0.0, settings.value(key, otherwise).toDouble());
  };
  const double ofAny = read(QLatin1String(kMachine), 0.0);
  return {read(machineKey(cell), ofAny), read(QLatin1String(kFixed), 0.0),
          read(QLatin1String(kMargin), 0.0)};
}

void keepQuotePrices(const QuotePrices& prices, const std::string& cell) {
  QSettings settings;
  settings.setValue(machineKey(cell), prices.machinePerHour);
  settings.setValue(QLatin1String(kFixed), prices.fixed);
  settings.setValue(QLatin1String(kMargin), prices.margin);
}

double PrintQuote::massG() const {
  double mass = 0.0;
  for (const Material& material : materials)
    mass += material.massG;
  return mass;
}

bool PrintQuote::isPriced() const {
  return std::ranges::all_of(
      materials, [](const Material& one) { return one.massG <= 0.0 || one.pricePerKg > 0.0; });
}

double PrintQuote::materialCost() const {
  double cost = 0.0;
  for (const Material& material : materials)
    cost += material.cost();
  return cost;
}

std::optional<PrintQuote> quoteOf(const pipeline::PlanResult& result, const QuotePrices& prices) {
  if (!result.job.trajectory || result.items.empty() || !result.items.front().resolved)
    return std::nullopt;
  PrintQuote quote;
  quote.prices = prices;
  const project::Report& report = result.job.report;
  quote.timeS = report.replay.controllerDurationS > 0.0 ? report.replay.controllerDurationS
                                                        : report.motion.durationS;
  quote.lengthMm = report.toolpath.lengthMm;
  const process::Tooling& tooling = result.tooling();
  const std::vector<process::ToolUse> uses = tooling.usesOf(*result.job.trajectory);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const process::Material& material = tooling.tools()[i].process.material;
    quote.materials.push_back(
        {QString::fromStdString(material.label),
         1e-3 * (uses[i].printedMm3 + uses[i].purgedMm3) * material.densityGPerCm3,
         material.pricePerKg});
  }
  return quote;
}

QString moneyText(double value) {
  const QString symbol = QLocale::system().currencySymbol();
  return symbol.isEmpty() ? QLocale().toCurrencyString(value)
                          : QLocale().toCurrencyString(value, symbol);
}

QString quoteText(const PrintQuote& quote) {
  QStringList parts{forms::durationText(quote.timeS),
                    QStringLiteral("%1 g").arg(numberText(quote.massG(), 1)),
                    QStringLiteral("%1 m").arg(numberText(1e-3 * quote.lengthMm, 1))};
  if (quote.isPriced())
    parts << moneyText(quote.total());
  return parts.join(QStringLiteral(", "));
}

page::Sheet quoteSheet(const PrintQuote& quote, const QString& name, const QString& size,
                       std::vector<std::string> pictures) {
  page::Sheet sheet;
  sheet.language = language::windowLanguageCode();
  sheet.title = said(QT_TRANSLATE_NOOP("Quote", "Quote: %1")).arg(name).toStdString();
  sheet.issued = QStringLiteral("%1, Voluta %2")
                     .arg(QLocale().toString(QDate::currentDate(), QLocale::LongFormat),
                          QLatin1String(project::kVersion))
                     .toStdString();
  sheet.verdict =
      said(QT_TRANSLATE_NOOP("Quote", "Price: %1")).arg(moneyText(quote.total())).toStdString();
  sheet.verdictDetail =
      (QChar(' ') + said(QT_TRANSLATE_NOOP("Quote", "printed in %1, %2 g of material"))
                        .arg(forms::durationText(quote.timeS), numberText(quote.massG(), 1)))
          .toStdString();
  if (!quote.isPriced()) {
    sheet.verdictMark = page::Mark::Caution;
    sheet.verdictDetail += (QStringLiteral(". ") +
                            said(QT_TRANSLATE_NOOP("Quote", "The price of a material is missing.")))
                               .toStdString();
  }
  for (std::string& picture : pictures)
    sheet.pictures.push_back({std::move(picture), {}});
  sheet.facts.push_back(fact(said(QT_TRANSLATE_NOOP("Quote", "Part")), name));
  sheet.facts.push_back(fact(said(QT_TRANSLATE_NOOP("Quote", "Size")), size));
  for (const PrintQuote::Material& material : quote.materials)
    sheet.facts.push_back(
        fact(said(QT_TRANSLATE_NOOP("Quote", "Material")),
             said(QT_TRANSLATE_NOOP("Quote", "%1, %2 g at %3 per kg: %4"))
                 .arg(material.name, numberText(material.massG, 1), moneyText(material.pricePerKg),
                      moneyText(material.cost()))));
  sheet.facts.push_back(
      fact(said(QT_TRANSLATE_NOOP("Quote", "Machine")),
           said(QT_TRANSLATE_NOOP("Quote", "%1 at %2 per hour: %3"))
               .arg(forms::durationText(quote.timeS), moneyText(quote.prices.machinePerHour),
                    moneyText(quote.machineCost()))));
  if (quote.prices.fixed > 0.0)
    sheet.facts.push_back(
        fact(said(QT_TRANSLATE_NOOP("Quote", "Set-up")), moneyText(quote.prices.fixed)));
  if (quote.prices.margin > 0.0)
    sheet.facts.push_back(fact(said(QT_TRANSLATE_NOOP("Quote", "Margin")),
                               QStringLiteral("%1 %: %2")
                                   .arg(numberText(100.0 * quote.prices.margin, 0),
                                        moneyText(quote.total() - quote.cost()))));
  sheet.facts.push_back(fact(said(QT_TRANSLATE_NOOP("Quote", "Price")), moneyText(quote.total())));
  return sheet;
}

} // namespace voluta::window
