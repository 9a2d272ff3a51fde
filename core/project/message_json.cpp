#include "project/message_json.h"

#include "base/error.h"
#include "plan/finding_kinds.h"
#include "texts/known_texts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace voluta::project {

namespace {
using Json = nlohmann::ordered_json;

struct UnitName {
  base::Unit unit;
  const char* ending; // suffix of a key
};
constexpr std::array<UnitName, 11> kUnits{{{base::Unit::None, ""},
                                           {base::Unit::Mm, "Mm"},
                                           {base::Unit::Mm2, "Mm2"},
                                           {base::Unit::Mm3, "Mm3"},
                                           {base::Unit::Degree, "Deg"},
                                           {base::Unit::DegreePerS, "DegPerS"},
                                           {base::Unit::Mm3PerS, "Mm3PerS"},
                                           {base::Unit::Percent, "Percent"},
                                           {base::Unit::Second, "S"},
                                           {base::Unit::Megabyte, "Mb"},
                                           {base::Unit::Gigabyte, "Gb"}}};

const char* endingOf(base::Unit unit) {
  for (const UnitName& row : kUnits)
    if (row.unit == unit)
      return row.ending;
  return "";
}

base::Unit unitWith(const std::string& ending) {
  for (const UnitName& row : kUnits)
    if (row.ending == ending)
      return row.unit;
  return base::Unit::None;
}

Json pointJson(double x, double y, double z) {
  return Json::array({x, y, z});
}

Json pointJson(const Eigen::Vector3d& p) {
  return pointJson(p.x(), p.y(), p.z());
}

// "10 voxels" is stored as the count 10.
const long long* countOf(const base::Value& value) {
  const auto* sentences = std::get_if<std::vector<base::Message>>(&value.data());
  return sentences && sentences->size() == 1 && sentences->front().text.plural() &&
                 sentences->front().values.size() == 1
             ? std::get_if<long long>(&sentences->front().values.front().data())
             : nullptr;
}

// For readers of the report: adds a number or a text.
void addPlain(Json& all, const std::string& name, const base::Value& value) {
  if (const auto* whole = std::get_if<long long>(&value.data()))
    all[name] = *whole;
  else if (const long long* count = countOf(value))
    all[name] = *count;
  else if (const auto* quantity = std::get_if<base::Quantity>(&value.data()))
    all[name + endingOf(quantity->unit)] = quantity->number;
  else if (const auto* point = std::get_if<base::Point>(&value.data()))
    all[name + "Mm"] = pointJson(point->x, point->y, point->z);
  else
    all[name] = base::english(value);
}

// Returns the value with its type: {"whole": 3}, {"number": 1.5, "unit": "Mm"} ...
Json exactJson(const base::Value& value) {
  struct Written {
    Json operator()(const std::string& name) const { return name; }
    Json operator()(long long whole) const { return Json{{"whole", whole}}; }
    Json operator()(const base::Quantity& q) const {
      return Json{{"number", q.number}, {"unit", endingOf(q.unit)}};
    }
    Json operator()(const base::Point& p) const {
      return Json{{"point", pointJson(p.x, p.y, p.z)}};
    }
    Json operator()(base::Text word) const { return Json{{"word", base::english(word)}}; }
    Json operator()(const std::vector<base::Message>& sentences) const {
      return Json{{"sentences", messagesJson(sentences)}};
    }
  };
  return std::visit(Written{}, value.data());
}

base::Value readExact(const Json& j) {
  if (j.is_string())
    return j.get<std::string>();
  if (j.contains("whole"))
    return j.at("whole").get<long long>();
  if (j.contains("number")) // null: not a number
    return base::Quantity{j.at("number").is_null() ? std::nan("") : j.at("number").get<double>(),
                          unitWith(j.at("unit").get<std::string>())};
  if (j.contains("point")) {
    const Json& p = j.at("point");
    return base::Point{p.at(0).get<double>(), p.at(1).get<double>(), p.at(2).get<double>()};
  }
  if (j.contains("word")) {
    const auto word = j.at("word").get<std::string>();
    const base::Text text = texts::knownText(word);
    return text.empty() ? base::Value(word) : base::Value(text);
  }
  return readMessages(j.at("sentences"));
}

// Returns the stored values of a finding of this kind; none if one is missing or not of this kind.
// Values of the kinds of older versions that have become Finding::count are left out.
std::optional<std::vector<plan::NamedValue>>
readValues(const Json& stored, const plan::FindingRow& row, bool more, bool old) {
  const std::vector<std::string_view> names = plan::valueNames(row, more);
  std::vector<plan::NamedValue> values;
  for (const Json& value : stored) {
    const auto name = std::ranges::find(names, value.at("name").get<std::string>());
    if (name != names.end())
      values.push_back({*name, readExact(value.at("value"))});
    else if (!old)
      return std::nullopt;
  }
  const auto isGiven = [&](std::string_view name) {
    return std::ranges::count(values, name, &plan::NamedValue::name) > 0;
  };
  if (!std::ranges::all_of(names, isGiven))
    return std::nullopt;
  return values;
}
} // namespace

Json findingJson(const plan::Finding& f) {
  Json values = Json::object();
  if (f.kind != plan::FindingKind::Verbatim)
    for (const plan::NamedValue& value : f.values)
      addPlain(values, std::string(value.name), value.value);
  const auto fits = values.find("fitsMm");
  Json json{{"stage", plan::stageName(plan::stageOf(f))},
            {"kind", plan::reportId(f)},
            {"where", f.where ? pointJson(*f.where) : Json()},
            {"when", f.whenS ? Json(*f.whenS) : Json()},
            {"count", f.count},
            {"reason", plan::englishReason(f)},
            {"remedy", plan::englishRemedy(f)},
            {"remedyMm", fits != values.end() ? Json(*fits) : Json()},
            {"blocking", f.blocking},
            {"concerns", plan::rowOf(f.kind).concern == plan::Concern::Safety ? "safety" : "part"},
            {"values", std::move(values)}};
  if (f.item >= 0) // Reports of one item have no such key
    json["item"] = f.item;
  return json;
}

plan::Finding readFinding(const Json& j) {
  plan::Finding f = plan::verbatimFinding(
      plan::stageNamed(j.at("stage").get<std::string>()).value_or(plan::Stage::Load),
      j.at("kind").get<std::string>(), j.at("reason").get<std::string>(),
      j.at("remedy").get<std::string>());
  if (const Json& p = j.at("where"); !p.is_null())
    f.where = Eigen::Vector3d(p.at(0).get<double>(), p.at(1).get<double>(), p.at(2).get<double>());
  if (!j.at("when").is_null())
    f.whenS = j.at("when").get<double>();
  j.at("count").get_to(f.count);
  j.at("blocking").get_to(f.blocking);
  f.item = j.value("item", -1);
  return f;
}

Json factJson(const plan::Finding& f) {
  Json values = Json::array();
  for (const plan::NamedValue& value : f.values)
    values.push_back(Json{{"name", value.name}, {"value", exactJson(value.value)}});
  Json fact{
      {"fact", plan::rowOf(f.kind).id},
      {"values", std::move(values)},
      {"program",
       Json{{"format", f.program.format}, {"file", f.program.file}, {"line", f.program.line}}}};
  if (f.more)
    fact["more"] = true;
  if (f.item >= 0)
    fact["item"] = f.item;
  return fact;
}

void readFact(const Json& j, plan::Finding& finding) {
  const auto id = j.at("fact").get<std::string>();
  const plan::FindingRow* row = plan::rowWithId(id);
  if (!row || row->kind == plan::FindingKind::Verbatim)
    return;
  const bool old = row->id != id;
  const bool more = (plan::isIdOfMore(id) || j.value("more", false)) && !row->more.empty();
  auto values = readValues(j.at("values"), *row, more, old);
  if (!values)
    return;
  finding.kind = row->kind;
  finding.more = more;
  finding.values = std::move(*values);
  const Json& program = j.at("program");
  program.at("format").get_to(finding.program.format);
  program.at("file").get_to(finding.program.file);
  program.at("line").get_to(finding.program.line);
  finding.item = j.value("item", -1);
}

Json messageJson(const base::Message& message) {
  Json values = Json::array();
  for (const base::Value& value : message.values)
    values.push_back(exactJson(value));
  return Json{{"text", base::english(message.text)},
              {"values", std::move(values)},
              {"english", base::english(message)}};
}

base::Message readMessage(const Json& j) {
  const auto verbatim = [](std::string text) {
    return base::message("{text}"_text, std::move(text));
  };
  if (j.is_string())
    return verbatim(j.get<std::string>());
  const base::Text text = texts::knownText(j.at("text").get<std::string>());
  base::Message message(text);
  for (const Json& value : j.at("values"))
    message.values.push_back(readExact(value));
  return text.empty() || base::placeNames(text.english()).size() != message.values.size()
             ? verbatim(j.at("english").get<std::string>())
             : message;
}

Json messagesJson(const std::vector<base::Message>& messages) {
  Json all = Json::array();
  for (const base::Message& message : messages)
    all.push_back(messageJson(message));
  return all;
}

std::vector<base::Message> readMessages(const Json& j) {
  std::vector<base::Message> messages;
  for (const Json& message : j)
    messages.push_back(readMessage(message));
  return messages;
}

} // namespace voluta::project
