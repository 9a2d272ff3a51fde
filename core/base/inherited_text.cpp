#include "base/inherited_text.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace voluta::base {

namespace {
using Json = nlohmann::ordered_json;
constexpr const char* kInherits = "inherits";
constexpr const char* kBasedOn = "basedOn";

Json parsed(const std::string& text) {
  return Json::parse(text, nullptr, false);
}

// Replaces values by those that the differences state (RFC 7386).
void takeDifferences(Json& values, const Json& differences) {
  if (!values.is_object())
    values = Json::object();
  for (const auto& [key, value] : differences.items())
    if (value.is_null())
      values.erase(key);
    else if (value.is_object())
      takeDifferences(values[key], value);
    else
      values[key] = value;
}

// Returns the differences that lead from one object to the other; empty: there are none.
Json differencesOf(const Json& from, const Json& to) {
  Json out = Json::object();
  for (const auto& [key, value] : to.items()) {
    const auto at = from.find(key);
    if (at == from.end()) {
      out[key] = value;
    } else if (at->is_object() && value.is_object()) {
      if (Json inner = differencesOf(*at, value); !inner.empty())
        out[key] = std::move(inner);
    } else if (*at != value) {
      out[key] = value;
    }
  }
  for (const auto& [key, value] : from.items())
    if (!to.contains(key))
      out[key] = nullptr;
  return out;
}

// `line`: the ids of the texts that inherit, from the first one on.
Json wholeOf(const std::string& folder, Json json, const std::string& name,
             std::vector<std::string>& line) {
  const std::string id = json.value("id", std::string());
  const std::string parent = json.at(kInherits).get<std::string>();
  line.push_back(id);
  if (std::ranges::find(line, parent) != line.end())
    throw Error(ErrorCode::UnusableInput,
                message("'{id}' inherits from itself, through its parents"_text, parent), name,
                "name another parent"_text);
  const std::vector<std::string> ids = dataFileIds(folder);
  if (std::ranges::find(ids, parent) == ids.end())
    throw Error(ErrorCode::UnusableInput,
                message("'{id}' inherits from '{parent}', which does not exist"_text, id, parent),
                name, "import the parent first, or name another one"_text);
  const std::filesystem::path file = dataFile(folder, parent, "unknown parent '{id}'"_text);
  const std::string text = readFile(file);
  Json whole = parsed(text);
  if (!whole.is_object())
    throw Error(ErrorCode::UnusableInput, "is not a JSON object"_text, file.string());
  if (!parentOf(text).empty())
    whole = wholeOf(folder, std::move(whole), file.string(), line);
  json.erase(kInherits);
  json[kBasedOn] = parent;
  takeDifferences(whole, json);
  return whole;
}
} // namespace

std::string parentOf(const std::string& text) {
  const Json json = parsed(text);
  const auto at = json.is_object() ? json.find(kInherits) : json.end();
  return json.is_object() && at != json.end() && at->is_string() ? at->get<std::string>()
                                                                 : std::string();
}

std::string wholeText(const std::string& folder, const std::string& text, const std::string& name) {
  if (parentOf(text).empty())
    return text;
  std::vector<std::string> line;
  return wholeOf(folder, parsed(text), name, line)
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

std::string textOfDifferences(const std::string& text, const std::string& parent,
                              const std::string& parentText) {
  Json to = parsed(text), from = parsed(parentText);
  require(to.is_object() && from.is_object(), "textOfDifferences: JSON objects");
  to.erase(kBasedOn);
  from.erase(kBasedOn);
  Json out = Json::object();
  for (const char* key : {"id", "label"}) {
    if (to.contains(key))
      out[key] = to.at(key);
    from.erase(key);
    to.erase(key);
  }
  out[kInherits] = parent;
  out.update(differencesOf(from, to));
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace voluta::base
