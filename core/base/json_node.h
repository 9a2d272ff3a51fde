// A value in a JSON file that knows its file and its key, so that every complaint names both.
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
  // Reads and parses a file whose top is an object. Throws Error{UnreadableFile}: not there, not
  // readable or not JSON; Error{UnusableInput}: no object.
  static JsonNode readFile(const std::filesystem::path& file);
  // The same of what such a file would hold.
  static JsonNode readText(const std::string& bytes, const std::filesystem::path& file);

  // All below throw Error{UnusableInput} with the file as context and the key's path in the
  // message.
  JsonNode at(std::string_view key) const; // a member that must be there
  bool has(std::string_view key) const;
  // A typing error in an optional key must not pass in silence.
  void allowOnly(std::initializer_list<std::string_view> keys) const;

  std::string text() const;
  bool boolean() const;
  double number() const; // finite
  int integer() const;
  std::vector<JsonNode> items() const; // of an array
  double positive() const;             // number() > 0
  double notNegative() const;          // number() >= 0

  [[noreturn]] void fail(const Message& what) const; // "'key' what"

private:
  JsonNode(std::shared_ptr<const nlohmann::json> root, const nlohmann::json* value,
           std::string file, std::string key);

  std::shared_ptr<const nlohmann::json> root_; // keeps value_ alive
  const nlohmann::json* value_;
  std::string file_, key_;
};

} // namespace voluta::base
