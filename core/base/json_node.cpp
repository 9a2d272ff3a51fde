#include "base/json_node.h"

#include "base/files.h"
#include "base/nearest_name.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace voluta::base {

using nlohmann::json;

JsonNode::JsonNode(std::shared_ptr<const json> root, const json* value, std::string file,
                   std::string key)
    : root_(std::move(root)), value_(value), file_(std::move(file)), key_(std::move(key)) {}

JsonNode JsonNode::readFile(const std::filesystem::path& file) {
  const std::string bytes = base::readFile(file);
  auto root = std::make_shared<json>();
  try {
    *root = json::parse(bytes);
  } catch (const json::exception& e) {
    throw Error(ErrorCode::UnreadableFile, std::string("not JSON: ") + e.what(), file.string());
  }
  JsonNode node(root, root.get(), file.string(), "");
  if (!root->is_object())
    node.fail("must be an object");
  return node;
}

void JsonNode::fail(const std::string& what) const {
  throw Error(ErrorCode::UnusableInput,
              key_.empty() ? "the file's top " + what : fmt::format("'{}' {}", key_, what), file_);
}

JsonNode JsonNode::at(std::string_view key) const {
  if (!value_->is_object())
    fail("must be an object");
  const std::string name(key);
  JsonNode child(root_, nullptr, file_, key_.empty() ? name : key_ + "." + name);
  const auto found = value_->find(name);
  if (found == value_->end())
    child.fail("is missing");
  child.value_ = &*found;
  return child;
}

bool JsonNode::has(std::string_view key) const {
  return value_->is_object() && value_->contains(std::string(key));
}

void JsonNode::allowOnly(std::initializer_list<std::string_view> keys) const {
  if (!value_->is_object())
    fail("must be an object");
  for (const auto& [key, value] : value_->items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      const std::vector<std::string> names(keys.begin(), keys.end());
      const std::string path = key_.empty() ? key : key_ + "." + key;
      throw Error(ErrorCode::UnusableInput, fmt::format("unknown key '{}'", path), file_,
                  "did you mean " + nearestName(key, names) + "?");
    }
}

std::string JsonNode::text() const {
  if (!value_->is_string())
    fail("must be a text");
  return value_->get<std::string>();
}

double JsonNode::number() const {
  if (!value_->is_number())
    fail("must be a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number))
    fail("must be a finite number");
  return number;
}

int JsonNode::integer() const {
  const double value = number();
  if (value != std::floor(value) || std::abs(value) > 1e6)
    fail("must be a whole number");
  return static_cast<int>(value);
}

double JsonNode::positive() const {
  const double value = number();
  if (value <= 0.0)
    fail("must be greater than 0");
  return value;
}

double JsonNode::notNegative() const {
  const double value = number();
  if (value < 0.0)
    fail("must not be negative");
  return value;
}

std::vector<JsonNode> JsonNode::items() const {
  if (!value_->is_array())
    fail("must be a list");
  std::vector<JsonNode> items;
  for (std::size_t i = 0; i < value_->size(); ++i)
    items.push_back(JsonNode(root_, &(*value_)[i], file_, fmt::format("{}[{}]", key_, i)));
  return items;
}

} // namespace voluta::base
