#include "panels/listed_findings.h"

#include "plan/finding_kinds.h"

#include <algorithm>

namespace voluta::panels {

namespace {
using plan::Finding;

bool isAmount(const base::Value& value) {
  return std::holds_alternative<base::Quantity>(value.data()) ||
         std::holds_alternative<long long>(value.data());
}

bool isPlace(const base::Value& value) {
  return std::holds_alternative<base::Point>(value.data());
}

// Whether two rows state one fact at two places.
bool sameFactElsewhere(const ListedFinding& a, const ListedFinding& b) {
  const Finding &one = a.finding, &other = b.finding;
  if (one.kind != other.kind || one.blocking != other.blocking || one.item != other.item ||
      a.formats != b.formats || one.values.size() != other.values.size() || !one.where ||
      !other.where)
    return false;
  for (std::size_t i = 0; i < one.values.size(); ++i) {
    const base::Value &v = one.values[i].value, &w = other.values[i].value;
    const bool measured = (isAmount(v) && isAmount(w)) || (isPlace(v) && isPlace(w));
    if (one.values[i].name != other.values[i].name || (!measured && !(v == w)))
      return false;
  }
  return true;
}

bool sameButForAmounts(const Finding& a, const Finding& b) {
  Finding plain = b;
  if (a.blocking != b.blocking || a.values.size() != b.values.size())
    return false;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    if (isAmount(a.values[i].value) && isAmount(b.values[i].value))
      plain.values[i].value = a.values[i].value;
  return plan::sameFact(a, plain);
}

bool isOf(const ListedFinding& row, const std::string& format) {
  return std::find(row.formats.begin(), row.formats.end(), format) != row.formats.end();
}

bool saysWhy(const Finding& finding, const base::Value* format) {
  return finding.blocking && format && !finding.program.format.empty() &&
         base::Value(finding.program.format) == *format;
}
} // namespace

std::vector<ListedFinding> listed(const plan::Findings& findings) {
  std::vector<ListedFinding> rows;
  for (const Finding& finding : findings) {
    const std::string& format = finding.program.format;
    if (finding.kind == plan::FindingKind::ProgramRefused &&
        std::any_of(findings.begin(), findings.end(),
                    [&](const Finding& other) { return saysWhy(other, finding.value("format")); }))
      continue;
    const auto match = format.empty()
                           ? rows.end()
                           : std::find_if(rows.begin(), rows.end(), [&](const ListedFinding& row) {
                               return !row.formats.empty() && !isOf(row, format) &&
                                      sameButForAmounts(row.finding, finding);
                             });
    if (match != rows.end())
      match->formats.push_back(format);
    else
      rows.push_back({finding, format.empty() ? std::vector<std::string>{} : std::vector{format}});
  }
  return rows;
}

std::vector<ListedFinding> byFact(std::vector<ListedFinding> rows) {
  std::vector<ListedFinding> facts;
  for (ListedFinding& row : rows) {
    const auto fact = std::ranges::find_if(
        facts, [&](const ListedFinding& one) { return sameFactElsewhere(one, row); });
    if (fact != facts.end()) {
      fact->places.push_back(row.finding);
    } else {
      row.places = {row.finding};
      facts.push_back(std::move(row));
    }
  }
  return facts;
}

} // namespace voluta::panels
