// User-visible text as data: a sentence with named placeholders and their values. It is formatted
// in English for command line, report and log, and in other languages by the same rules.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace voluta::base {

class Text;

// A placeholder in a sentence: "{name}", "{name:.2f}" or "{name:.3g#}": the format of a number, and
// # if its unit is omitted. begin and end are positions in the sentence.
struct PlaceMark {
  std::size_t begin = 0, end = 0;
  std::string_view name, format;
  bool bare = false;
};
// Finds the first placeholder at or after `from`; other braces are text.
constexpr bool findPlace(std::string_view sentence, std::size_t from, PlaceMark& mark);
// Returns the names of the placeholders in order of first occurrence, without duplicates.
std::vector<std::string_view> placeNames(std::string_view sentence);
constexpr std::size_t countPlaces(std::string_view sentence);

} // namespace voluta::base

namespace voluta {
inline namespace literals {
// "platform '{platform}' has no valid size"_text
consteval base::Text operator""_text(const char* sentence, std::size_t length);
// "{pieces} piece is left out|{pieces} pieces are left out"_plural: for one and for any other
// number. The first value that is a whole number decides.
consteval base::Text operator""_plural(const char* sentences, std::size_t length);
// A name that no language translates: a key, an option, a format's id.
inline std::string operator""_name(const char* name, std::size_t length) {
  return {name, length};
}
} // namespace literals
} // namespace voluta

namespace voluta::base {

using namespace literals;

// A sentence or a word of the program, in English. It can only be made from a literal with one of
// the two suffixes above, which put it on the translators' list, so every text shown to users can
// be translated.
// A setting that it names is in backquotes, as it is typed: `orient=none` (setting_marks.h).
class Text {
public:
  constexpr Text() = default; // Empty

  // For other numbers, if the forms differ
  constexpr std::string_view english() const { return english_; }
  constexpr std::string_view one() const { return one_; } // Empty: no separate form
  constexpr bool empty() const { return english_.empty(); }
  constexpr bool plural() const { return !one_.empty(); }
  friend constexpr bool operator==(const Text&, const Text&) = default;

private:
  friend consteval Text literals::operator""_text(const char*, std::size_t);
  friend consteval Text literals::operator""_plural(const char*, std::size_t);
  constexpr Text(std::string_view english, std::string_view one) : english_(english), one_(one) {}
  std::string_view english_, one_;
};

enum class Unit {
  None,
  Mm,
  Mm2,
  Mm3,
  Degree,
  DegreePerS,
  Mm3PerS,
  Percent,
  Second,
  Megabyte,
  Gigabyte
};

struct Quantity {
  double number = 0.0;
  Unit unit = Unit::None;
  friend bool operator==(const Quantity&, const Quantity&) = default;
};
inline Quantity number(double value) {
  return {value, Unit::None};
}
inline Quantity mm(double value) {
  return {value, Unit::Mm};
}
inline Quantity mm2(double value) {
  return {value, Unit::Mm2};
}
inline Quantity mm3(double value) {
  return {value, Unit::Mm3};
}
inline Quantity degrees(double value) {
  return {value, Unit::Degree};
}
inline Quantity percent(double value) {
  return {value, Unit::Percent};
}
inline Quantity seconds(double value) {
  return {value, Unit::Second};
}

// A point [mm], written "(1, 2, 3)".
struct Point {
  double x = 0.0, y = 0.0, z = 0.0;
  friend bool operator==(const Point&, const Point&) = default;
};

struct Message;

// The value of a placeholder. Text from elsewhere (files, keys, ids, user input, library messages)
// is a name and is not translated.
class Value {
public:
  using Data = std::variant<std::string, long long, Quantity, Point, Text, std::vector<Message>>;

  Value();                      // An empty name
  Value(std::string name);      // NOLINT(google-explicit-constructor)
  Value(std::string_view name); // NOLINT(google-explicit-constructor)
  Value(const char*) = delete;  // A word of the program is a Text, a name in the code is "..."_name
  template <std::integral T>
  requires(!std::same_as<T, bool> && !std::same_as<T, char>) Value(T whole)
      : Value(Whole{static_cast<long long>(whole)}) {} // NOLINT
  template <std::floating_point T> Value(T) = delete;  // Use number(), mm() ... to state the unit
  Value(Quantity quantity);                            // NOLINT(google-explicit-constructor)
  Value(Point point);                                  // NOLINT(google-explicit-constructor)
  Value(Text word);                                    // NOLINT(google-explicit-constructor)
  Value(Message part);                                 // NOLINT(google-explicit-constructor)
  Value(std::vector<Message> sentences); // NOLINT(google-explicit-constructor): a list
  Value(const Value&);
  Value(Value&&) noexcept;
  Value& operator=(const Value&);
  Value& operator=(Value&&) noexcept;
  ~Value();

  const Data& data() const { return data_; }
  bool empty() const; // An empty name, word or list
  friend bool operator==(const Value& a, const Value& b);

private:
  struct Whole {
    long long number;
  };
  explicit Value(Whole whole);
  Data data_;
};

// A sentence with its values, in the order in which their placeholders first occur in
// text.english().
struct Message {
  Message();
  Message(Text text); // NOLINT(google-explicit-constructor): one without places
  Message(Text text, std::vector<Value> values);

  bool empty() const { return text.empty(); }
  friend bool operator==(const Message&, const Message&);

  Text text;
  std::vector<Value> values;
};

// A text with exactly as many placeholders as there are values.
template <std::size_t N> struct TextWithPlaces {
  consteval TextWithPlaces(Text given) : text(given) { // NOLINT(google-explicit-constructor)
    if (countPlaces(given.english()) != N)
      throw "as many values as the text has places";
  }
  Text text;
};

// message("{there} of {wanted} vertices"_text, n, m)
template <typename... V> Message message(TextWithPlaces<sizeof...(V)> text, V&&... values) {
  std::vector<Value> all;
  all.reserve(sizeof...(V));
  (all.emplace_back(std::forward<V>(values)), ...);
  return Message(text.text, std::move(all));
}

// Formats messages in a language. This class writes English, as in reports.
class Language {
public:
  virtual ~Language() = default;
  // Returns the sentence with its placeholders, and settings in this language's form (here: as
  // typed); `count` is set if the number decides the form.
  virtual std::string sentence(Text text, std::optional<long long> count) const;
  virtual std::string whole(long long number) const;
  // `format`: "g", "f" or empty (as "g"); `digits`: significant digits or decimals.
  virtual std::string number(double number, char format, int digits) const;
  virtual std::string withUnit(const std::string& number, Unit unit) const;
  virtual std::string list(const std::vector<std::string>& parts) const;
};

std::string inWords(const Message& message, const Language& language);
std::string inWords(const Value& value, const Language& language);
std::string english(const Message& message);
std::string english(const Value& value);
std::string english(Text text); // For texts without placeholders
std::vector<std::string> english(const std::vector<Message>& messages);

// ---- Needed at compile time

constexpr bool findPlace(std::string_view s, std::size_t from, PlaceMark& mark) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t b = s.find('{', from); b != std::string_view::npos; b = s.find('{', b + 1)) {
    std::size_t e = b + 1;
    while (e < s.size() && (isLetter(s[e]) || (e > b + 1 && isDigit(s[e]))))
      ++e;
    const std::string_view name = s.substr(b + 1, e - b - 1);
    const std::size_t colon = e;
    if (e < s.size() && s[e] == ':') {
      if (++e < s.size() && s[e] == '.')
        while (++e < s.size() && isDigit(s[e])) {
        }
      if (e >= s.size() || (s[e] != 'g' && s[e] != 'f'))
        continue;
      ++e;
    }
    const std::string_view format = e > colon ? s.substr(colon + 1, e - colon - 1) : s.substr(e, 0);
    const bool bare = e < s.size() && s[e] == '#';
    e += bare ? 1 : 0;
    if (name.empty() || e >= s.size() || s[e] != '}')
      continue;
    mark = {b, e + 1, name, format, bare};
    return true;
  }
  return false;
}

constexpr std::size_t countPlaces(std::string_view sentence) {
  std::size_t count = 0;
  PlaceMark mark, earlier;
  for (std::size_t at = 0; findPlace(sentence, at, mark); at = mark.end) {
    bool known = false;
    for (std::size_t b = 0; !known && findPlace(sentence, b, earlier) && earlier.begin < mark.begin;
         b = earlier.end)
      known = earlier.name == mark.name;
    count += known ? 0 : 1;
  }
  return count;
}

} // namespace voluta::base

namespace voluta {
inline namespace literals {
consteval base::Text operator""_text(const char* sentence, std::size_t length) {
  return {std::string_view(sentence, length), {}};
}

consteval base::Text operator""_plural(const char* sentences, std::size_t length) {
  const std::string_view both(sentences, length);
  const std::size_t cut = both.find('|');
  if (cut == std::string_view::npos || cut == 0)
    throw "a form for one | a form for others";
  const std::string_view one = both.substr(0, cut), other = both.substr(cut + 1);
  base::PlaceMark mark, same;
  for (std::size_t at = 0; base::findPlace(one, at, mark); at = mark.end) {
    bool known = false;
    for (std::size_t b = 0; !known && base::findPlace(other, b, same); b = same.end)
      known = same.name == mark.name;
    if (!known)
      throw "a place of the form for one that the other has not";
  }
  return {other, one};
}
} // namespace literals
} // namespace voluta
