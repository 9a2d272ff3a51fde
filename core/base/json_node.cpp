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
  return readText(base::readFile(file), file);
}

JsonNode JsonNode::readText(const std::string& bytes, const std::filesystem::path& file) {
  auto root = std::make_shared<json>();
  try {
    *root = json::parse(bytes);
  } catch (const json::exception& e) {
    throw Error(ErrorCode::UnreadableFile, message("not JSON: {why}"_text, std::string(e.what())),
                file.string());
  }
  JsonNode node(root, root.get(), file.string(), "");
  if (!root->is_object())
    node.fail("must be an object"_text);
  return node;
}

void JsonNode::fail(const Message& what) const {
  throw Error(ErrorCode::UnusableInput,
              key_.empty() ? message("the file's top {what}"_text, what)
                           : message("'{key}' {what}"_text, key_, what),
              file_);
}

JsonNode JsonNode::at(std::string_view key) const {
  if (!value_->is_object())
    fail("must be an object"_text);
  const std::string name(key);
  JsonNode child(root_, nullptr, file_, key_.empty() ? name : key_ + "." + name);
  const auto found = value_->find(name);
  if (found == value_->end())
    child.fail("is missing"_text);
  child.value_ = &*found;
  return child;
}

bool JsonNode::has(std::string_view key) const {
  return value_->is_object() && value_->contains(std::string(key));
}

void JsonNode::allowOnly(std::initializer_list<std::string_view> keys) const {
  if (!value_->is_object())
    fail("must be an object"_text);
  for (const auto& [key, value] : value_->items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      const std::vector<std::string> names(keys.begin(), keys.end());
      const std::string path = key_.empty() ? key : key_ + "." + key;
      throw Error(ErrorCode::UnusableInput, message("unknown key '{key}'"_text, path), file_,
                  didYouMean(key, names));
    }
}

std::string JsonNode::text() const {
  if (!value_->is_string())
    fail("must be a text"_text);
  return value_->get<std::string>();
}

bool JsonNode::boolean() const {
  if (!value_->is_boolean())
    fail("must be true or false"_text);
  return value_->get<bool>();
}

double JsonNode::number() const {
  if (!value_->is_number())
    fail("must be a number"_text);
  const double number = value_->get<double>();
  if (!std::isfinite(number))
    fail("must be a finite number"_text);
  return number;
}

int JsonNode::integer() const {
  const double value = number();
  if (value != std::floor(value) || std::abs(value) > 1e6)
    fail("must be a whole number"_text);
  return static_cast<int>(value);
}

double JsonNode::positive() const {
  const double value = number();
  if (value <= 0.0)
    fail("must be greater than 0"_text);
  return value;
}

double JsonNode::notNegative() const {
  const double value = number();
  if (value < 0.0)
    fail("must not be negative"_text);
  return value;
}

std::vector<JsonNode> JsonNode::items() const {
  if (!value_->is_array())
    fail("must be a list"_text);
  std::vector<JsonNode> items;
  for (std::size_t i = 0; i < value_->size(); ++i)
    items.push_back(JsonNode(root_, &(*value_)[i], file_, fmt::format("{}[{}]", key_, i)));
  return items;
}

} // namespace voluta::base
