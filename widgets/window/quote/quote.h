// The cost of a print, from its material and the time of its machine.
#pragma once

#include "page/sheet.h"
#include "pipeline/plan_result.h"

#include <QString>
#include <optional>
#include <string>
#include <vector>

namespace voluta::window {

// In the user's currency; kept in the window's settings, the price of the machine for each cell.
struct QuotePrices {
  double machinePerHour = 0.0, fixed = 0.0;
  double margin = 0.0; // Share of the cost that is added
};
// `cell`: of the print (base::dataName()); one without a price of its own has the price of older
// settings, which all cells shared.
QuotePrices quotePrices(const std::string& cell);
void keepQuotePrices(const QuotePrices& prices, const std::string& cell);

struct PrintQuote {
  struct Material {
    QString name;
    double massG = 0.0;      // Purges after tool changes included
    double pricePerKg = 0.0; // 0: unknown
    double cost() const { return 1e-3 * massG * pricePerKg; }
  };
  std::vector<Material> materials; // By tool
  double timeS = 0.0;    // On the controller if the programs were replayed, else as planned
  double lengthMm = 0.0; // Of all beads
  QuotePrices prices;

  double massG() const;
  bool isPriced() const; // All used materials have a price
  double materialCost() const;
  double machineCost() const { return timeS / 3600.0 * prices.machinePerHour; }
  double cost() const { return materialCost() + machineCost() + prices.fixed; }
  double total() const { return (1.0 + prices.margin) * cost(); }
};

// none: there is no motion yet.
std::optional<PrintQuote> quoteOf(const pipeline::PlanResult& result, const QuotePrices& prices);

// In the currency of the system's locale.
QString moneyText(double value);
// "1 h 12 min, 34.5 g, 11.2 m, € 3.20"; without the cost if a price is missing.
QString quoteText(const PrintQuote& quote);

// The page for a customer: the price first, then the facts it follows from.
page::Sheet quoteSheet(const PrintQuote& quote, const QString& name, const QString& size,
                       std::vector<std::string> pictures);

} // namespace voluta::window
