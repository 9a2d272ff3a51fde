// A value in a JSON file that knows its file and key, so that every error names both.
#pragma once

#include "base/error.h"

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {

class JsonNode {
public:
  // Reads and parses a file whose top level is an object. Throws Error{UnreadableFile} if it is
  // missing, unreadable or not JSON; Error{UnusableInput} if it is no object.
  static JsonNode readFile(const std::filesystem::path& file);
  // The same from text; `file` names it in errors.
  static JsonNode parse(std::string_view text, const std::string& file);

  // All functions below throw Error{UnusableInput} with the file as context and the key's path in
  // the message.
  JsonNode at(std::string_view key) const; // A required member
  bool has(std::string_view key) const;
  // Throws if there are other keys, so that a typing error in an optional key is reported.
  void allowOnly(std::initializer_list<std::string_view> keys) const;

  std::string text() const;
  bool boolean() const;
  double number() const; // Finite
  int integer() const;
  std::vector<JsonNode> items() const; // Of an array
  double positive() const;             // number() > 0
  double notNegative() const;          // number() >= 0

  [[noreturn]] void fail(const Message& what) const; // "'key' what"

private:
  JsonNode(std::shared_ptr<const nlohmann::json> root, const nlohmann::json* value,
           std::string file, std::string key);

  std::shared_ptr<const nlohmann::json> root_; // Keeps value_ alive
  const nlohmann::json* value_;
  std::string file_, key_;
};

} // namespace voluta::base
