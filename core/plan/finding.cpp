#include "plan/finding.h"

#include "base/error.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <utility>

namespace voluta::plan {

namespace {
bool hasPlace(const FindingRow& row, std::string_view name) {
  for (const base::Text text : {row.reason, row.remedy}) {
    const std::vector<std::string_view> names = base::placeNames(text.english());
    if (std::find(names.begin(), names.end(), name) != names.end())
      return true;
  }
  return false;
}

void checkValues(const FindingRow& row, const Finding& finding) {
  const std::string id(row.id);
  for (const NamedValue& given : finding.values)
    base::require(hasPlace(row, given.name),
                  "finding " + id + " does not tell '" + std::string(given.name) + "'");
  for (const base::Text text : {row.reason, row.remedy})
    for (const std::string_view name : base::placeNames(text.english()))
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
} // namespace

const base::Value* Finding::value(std::string_view name) const {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const NamedValue& v) { return v.name == name; });
  return found == values.end() ? nullptr : &found->value;
}

Finding makeFinding(FindingKind kind, std::vector<NamedValue> values,
                    const std::optional<Eigen::Vector3d>& where, std::size_t count) {
  const FindingRow& row = rowOf(kind);
  Finding finding;
  finding.kind = kind;
  finding.values = std::move(values);
  finding.where = where;
  finding.count = count;
  finding.blocking = row.severity != Severity::Info;
  checkValues(row, finding);
  return finding;
}

base::Message factOf(const Finding& finding) {
  return filled(rowOf(finding.kind).reason, finding);
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
  return a.kind == b.kind && a.values == b.values && a.where.has_value() == b.where.has_value() &&
         (!a.where || (*a.where - *b.where).norm() <= kSameMm);
}

base::Point pointOf(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

} // namespace voluta::plan
