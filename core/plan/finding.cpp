#include "plan/finding.h"

#include "base/error.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <utility>

namespace voluta::plan {

namespace {
void checkValues(const FindingRow& row, const Finding& finding) {
  const std::string id(row.id);
  const std::vector<std::string_view> names = valueNames(row, finding.more);
  for (const NamedValue& given : finding.values)
    base::require(std::ranges::find(names, given.name) != names.end(),
                  "finding " + id + " does not tell '" + std::string(given.name) + "'");
  for (const std::string_view name : names)
    base::require(finding.value(name) != nullptr,
                  "finding " + id + " needs '" + std::string(name) + "'");
}

base::Message filled(base::Text text, const Finding& finding) {
  base::Message message(text);
  for (const std::string_view name : base::placeNames(text.english())) {
    const base::Value* value = finding.value(name);
    message.values.push_back(value ? *value : base::Value());
  }
  return message;
}

// As filled(), of FindingRow::more.
base::Message filledMore(const FindingRow& row, const Finding& finding) {
  base::Message message = filled(row.more, finding);
  const std::vector<std::string_view> names = base::placeNames(row.more.english());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == kCount)
      message.values[i] = finding.count;
    else if (names[i] == kReason)
      message.values[i] = filled(row.reason, finding);
  return message;
}

Finding finding(FindingKind kind, std::vector<NamedValue> values,
                const std::optional<Eigen::Vector3d>& where, std::size_t count, bool more) {
  const FindingRow& row = rowOf(kind);
  Finding finding;
  finding.kind = kind;
  finding.values = std::move(values);
  finding.where = where;
  finding.count = count;
  finding.more = more;
  finding.blocking = row.severity != Severity::Info;
  checkValues(row, finding);
  return finding;
}
} // namespace

const base::Value* Finding::value(std::string_view name) const {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const NamedValue& v) { return v.name == name; });
  return found == values.end() ? nullptr : &found->value;
}

Finding makeFinding(FindingKind kind, std::vector<NamedValue> values,
                    const std::optional<Eigen::Vector3d>& where, std::size_t count) {
  return finding(kind, std::move(values), where, count, false);
}

Finding makeMoreFinding(FindingKind kind, std::vector<NamedValue> values,
                        const std::optional<Eigen::Vector3d>& where, std::size_t count) {
  base::require(!rowOf(kind).more.empty(), "a kind of finding that stands for more");
  return finding(kind, std::move(values), where, count, true);
}

base::Message factOf(const Finding& finding) {
  const FindingRow& row = rowOf(finding.kind);
  return finding.more ? filledMore(row, finding) : filled(row.reason, finding);
}

base::Message reasonOf(const Finding& finding) {
  base::Message fact = factOf(finding);
  const ProgramLine& at = finding.program;
  // Line numbers are written without digit grouping, as editors show them, since users look them up
  // in the text.
  const std::string file = std::to_string(at.file), line = std::to_string(at.line);
  if (at.line > 0)
    fact = at.file > 0
               ? base::message("file {file}, line {line}: {what}"_text, file, line, std::move(fact))
               : base::message("line {line}: {what}"_text, line, std::move(fact));
  if (!at.format.empty())
    fact = base::message("{format}: {what}"_text, at.format, std::move(fact));
  return fact;
}

base::Message remedyOf(const Finding& finding) {
  return filled(rowOf(finding.kind).remedy, finding);
}

std::string englishReason(const Finding& finding) {
  return base::english(reasonOf(finding));
}

std::string englishRemedy(const Finding& finding) {
  return base::english(remedyOf(finding));
}

bool sameFact(const Finding& a, const Finding& b) {
  constexpr double kSameMm = 0.1;
  return a.kind == b.kind && a.more == b.more && a.values == b.values && a.item == b.item &&
         a.where.has_value() == b.where.has_value() &&
         (!a.where || (*a.where - *b.where).norm() <= kSameMm);
}

base::Point pointOf(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

} // namespace voluta::plan
