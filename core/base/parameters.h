// Parameters declared once: form, validation, project file, command line and manual use the same
// table (docs/design.md, Parameters). A module exports its table and converts values to a typed
// struct.
#pragma once

#include "base/text.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace voluta::base {

using ParameterValue = std::variant<double, long long, bool, std::string>;

enum class ParameterType { Number, Integer, Boolean, Choice, Text };

struct Choice {
  std::string id; // As typed
  Text label;
};

// Whether all items of a job share one value, each item has its own, or each region of an item too.
enum class ParameterScope { Job, Item, Region };

// The files that the value of a text parameter may name.
struct ParameterFile {
  std::string patterns; // of names, separated by blanks: "*.json"
  std::string prefix;   // precedes the name in the value
  // Returns the content of the file that a value names; any other value unchanged. Throws
  // Error{UnreadableFile}. nullptr: the job stores the file's name.
  std::string (*read)(const std::string& value) = nullptr;
};

struct ParameterSpec {
  std::string key; // Unique over all tables, camelCase
  ParameterType type = ParameterType::Number;
  // "mm", "mm/s", "deg", "" for none; "share" of a whole: 0.2 in files, 20 % in forms
  std::string unit;
  ParameterValue defaultValue;
  double minimum = 0.0, maximum = 0.0; // Inclusive; Number and Integer
  std::vector<base::Choice> choices;   // Choice
  Text group;                          // Heading in the form
  Text label;                          // A few words
  Text help;                           // One or two sentences
  bool simple = false;                 // Shown in the simple form too
  ParameterScope scope = ParameterScope::Job;
  ParameterFile file; // Text
};

ParameterSpec numberParameter(std::string key, std::string unit, double defaultValue,
                              double minimum, double maximum, Text group, Text label, Text help,
                              bool simple = false);
ParameterSpec integerParameter(std::string key, long long defaultValue, long long minimum,
                               long long maximum, Text group, Text label, Text help,
                               bool simple = false);
ParameterSpec booleanParameter(std::string key, bool defaultValue, Text group, Text label,
                               Text help, bool simple = false);
// Empty by default.
ParameterSpec textParameter(std::string key, Text group, Text label, Text help,
                            bool simple = false);
ParameterSpec choiceParameter(std::string key, std::string defaultValue,
                              std::vector<Choice> choices, Text group, Text label, Text help,
                              bool simple = false);

// Returns the spec with a value for each item.
ParameterSpec ofItem(ParameterSpec spec);
// Returns the spec with a value for each item, and for each of its regions.
ParameterSpec ofRegion(ParameterSpec spec);
// Returns the spec of a text whose value may be the name of a file.
ParameterSpec withFile(ParameterSpec spec, ParameterFile file);

// A parameter's key of an older version, which project files and scripts may still contain.
struct RenamedKey {
  std::string_view oldKey, key;
};
std::span<const RenamedKey> renamedKeys();
// Returns the current key of a renamed parameter; any other key unchanged.
std::string_view currentKey(std::string_view key);
// Returns the note to the user that a key was renamed. Precondition: `oldKey` is in renamedKeys().
Message renamedNote(std::string_view oldKey);

// Returns the keys of parameters of older versions that no longer exist. Project files and scripts
// may still contain them; their values have no effect.
std::span<const std::string_view> droppedKeys();
// Returns the note to the user about such a key.
Message droppedNote(std::string_view key);

class ParameterTable {
public:
  ParameterTable() = default;
  // Throws Error{Internal} if two specs share a key.
  explicit ParameterTable(std::vector<ParameterSpec> specs);

  const std::vector<ParameterSpec>& specs() const { return specs_; }
  // Returns nullptr if there is no such key.
  const ParameterSpec* find(std::string_view key) const;
  // Appends another module's table. Throws Error{Internal} on a shared key.
  void append(const ParameterTable& other);
  // As append(), with a value for each item; parameters of regions stay so.
  void appendOfItems(const ParameterTable& other);

private:
  std::vector<ParameterSpec> specs_;
};

// Returns the value of `text` for `spec`. Throws Error{Usage} that names the key and its range,
// choices or type, and for a wrong choice the nearest one.
ParameterValue parseParameter(const ParameterSpec& spec, std::string_view text);
std::string formatParameter(const ParameterValue& value);

// Values by key over one table; a key that was not set has its default.
class ParameterValues {
public:
  explicit ParameterValues(ParameterTable table) : table_(std::move(table)) {}

  const ParameterTable& table() const { return table_; }
  // Accepts the old key of a renamed parameter. Throws Error{Usage} for an unknown key (naming the
  // nearest) or an invalid value.
  void set(std::string_view key, std::string_view text);
  // "key=value", as on the command line.
  void setAssignment(std::string_view assignment);

  bool changed(std::string_view key) const;
  const std::map<std::string, ParameterValue, std::less<>>& changes() const { return changed_; }

  // Precondition (Error{Internal}): the key exists and has that type. number() accepts integers
  // too.
  double number(std::string_view key) const;
  long long integer(std::string_view key) const;
  bool boolean(std::string_view key) const;
  std::string text(std::string_view key) const;

private:
  const ParameterValue& value(std::string_view key) const;

  ParameterTable table_;
  std::map<std::string, ParameterValue, std::less<>> changed_;
};

} // namespace voluta::base
