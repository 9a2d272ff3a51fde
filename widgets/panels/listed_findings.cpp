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

} // namespace voluta::panels
