#include "base/text.h"

#include "base/setting_marks.h"
#include "base/shown_number.h"
#include "base/valid_utf8.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace voluta::base {

namespace {
struct NumberFormat {
  char letter = 'g';
  int digits = 6;
};

NumberFormat numberFormat(std::string_view format) {
  NumberFormat f;
  if (format.empty())
    return f;
  f.letter = format.back();
  if (format.front() == '.')
    std::from_chars(format.data() + 1, format.data() + format.size() - 1, f.digits);
  return f;
}

// Returns 0 for numbers that would be written as -0.0.
double withoutIdleSign(double number, const NumberFormat& f) {
  return f.letter == 'f' && std::abs(number) < 0.5 * std::pow(10.0, -f.digits) ? 0.0 : number;
}

class Writer {
public:
  explicit Writer(const Language& language) : language_(language) {}

  std::string message(const Message& m) const {
    const std::vector<std::string_view> names = placeNames(m.text.english());
    const std::string sentence = language_.sentence(m.text, m.text.plural() ? count(m) : none());
    std::string out;
    std::size_t done = 0;
    PlaceMark mark;
    for (; findPlace(sentence, done, mark); done = mark.end) {
      out.append(sentence, done, mark.begin - done);
      const auto place = std::find(names.begin(), names.end(), mark.name);
      const auto i = static_cast<std::size_t>(place - names.begin());
      if (i < m.values.size())
        out += value(m.values[i], mark);
      else
        out.append(sentence, mark.begin, mark.end - mark.begin);
    }
    return out.append(sentence, done, sentence.npos);
  }

  std::string value(const Value& v, const PlaceMark& mark) const {
    return std::visit([&](const auto& data) { return written(data, mark); }, v.data());
  }

private:
  static std::optional<long long> none() { return std::nullopt; }
  static std::optional<long long> count(const Message& m) {
    for (const Value& v : m.values)
      if (const auto* whole = std::get_if<long long>(&v.data()))
        return *whole;
    return std::nullopt;
  }

  std::string number(double value, const NumberFormat& f) const {
    return language_.number(withoutIdleSign(value, f), f.letter, f.digits);
  }
  std::string written(const std::string& name, const PlaceMark&) const { return validText(name); }
  std::string written(long long whole, const PlaceMark&) const { return language_.whole(whole); }
  std::string written(const Quantity& q, const PlaceMark& mark) const {
    const NumberFormat f = numberFormat(mark.format);
    const std::string number = this->number(q.number, f);
    return mark.bare ? number : language_.withUnit(number, q.unit);
  }
  std::string written(const Point& p, const PlaceMark& mark) const {
    const NumberFormat f = numberFormat(mark.format);
    const auto part = [&](double x) { return number(x, f); };
    return fmt::format("({})", language_.list({part(p.x), part(p.y), part(p.z)}));
  }
  std::string written(Text word, const PlaceMark&) const {
    return language_.sentence(word, std::nullopt);
  }
  std::string written(const std::vector<Message>& sentences, const PlaceMark&) const {
    std::vector<std::string> parts;
    for (const Message& m : sentences)
      parts.push_back(message(m));
    return language_.list(parts);
  }

  const Language& language_;
};
} // namespace

std::vector<std::string_view> placeNames(std::string_view sentence) {
  std::vector<std::string_view> names;
  PlaceMark mark;
  for (std::size_t at = 0; findPlace(sentence, at, mark); at = mark.end)
    if (std::find(names.begin(), names.end(), mark.name) == names.end())
      names.push_back(mark.name);
  return names;
}

Value::Value() = default;
Value::Value(std::string name) : data_(std::move(name)) {}
Value::Value(std::string_view name) : data_(std::string(name)) {}
Value::Value(Quantity quantity) : data_(quantity) {}
Value::Value(Point point) : data_(point) {}
Value::Value(Text word) : data_(word) {}
Value::Value(Message part) : data_(std::vector<Message>{std::move(part)}) {}
Value::Value(std::vector<Message> sentences) : data_(std::move(sentences)) {}
Value::Value(Whole whole) : data_(whole.number) {}
Value::Value(const Value&) = default;
Value::Value(Value&&) noexcept = default;
Value& Value::operator=(const Value&) = default;
Value& Value::operator=(Value&&) noexcept = default;
Value::~Value() = default;

bool Value::empty() const {
  if (const auto* name = std::get_if<std::string>(&data_))
    return name->empty();
  if (const auto* word = std::get_if<Text>(&data_))
    return word->empty();
  if (const auto* sentences = std::get_if<std::vector<Message>>(&data_))
    return std::all_of(sentences->begin(), sentences->end(),
                       [](const Message& m) { return m.empty(); });
  return false;
}

bool operator==(const Value& a, const Value& b) {
  return a.data_ == b.data_;
}

Message::Message() = default;
Message::Message(Text given) : text(given) {}
Message::Message(Text given, std::vector<Value> given_values)
    : text(given), values(std::move(given_values)) {}

bool operator==(const Message& a, const Message& b) {
  return a.text == b.text && a.values == b.values;
}

std::string Language::sentence(Text text, std::optional<long long> count) const {
  return withSettingsAsTyped(text.plural() && count == 1 ? text.one() : text.english());
}

std::string Language::whole(long long number) const {
  return std::to_string(number);
}

std::string Language::number(double number, char format, int digits) const {
  if (format == 'f')
    return fmt::format("{:.{}f}", number, digits);
  const ShownNumber shown = shownNumber(number, digits);
  return fmt::format("{:.{}f}", shown.value, shown.decimals);
}

std::string Language::withUnit(const std::string& number, Unit unit) const {
  switch (unit) {
  case Unit::None:
    return number;
  case Unit::Mm:
    return number + " mm";
  case Unit::Mm2:
    return number + " mm2";
  case Unit::Mm3:
    return number + " mm3";
  case Unit::Degree:
    return number + " degrees";
  case Unit::DegreePerS:
    return number + " degrees/s";
  case Unit::Mm3PerS:
    return number + " mm3/s";
  case Unit::Percent:
    return number + " %";
  case Unit::Second:
    return number + " s";
  case Unit::Megabyte:
    return number + " MB";
  case Unit::Gigabyte:
    return number + " GB";
  }
  return number;
}

std::string Language::list(const std::vector<std::string>& parts) const {
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string inWords(const Message& message, const Language& language) {
  return Writer(language).message(message);
}

std::string inWords(const Value& value, const Language& language) {
  return Writer(language).value(value, {});
}

std::string english(const Message& message) {
  return inWords(message, Language());
}

std::string english(const Value& value) {
  return inWords(value, Language());
}

std::vector<std::string> english(const std::vector<Message>& messages) {
  std::vector<std::string> sentences;
  for (const Message& message : messages)
    sentences.push_back(english(message));
  return sentences;
}

std::string english(Text text) {
  return withSettingsAsTyped(text.english());
}

} // namespace voluta::base
