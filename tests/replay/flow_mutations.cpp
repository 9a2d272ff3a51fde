#include "replay/flow_mutations.h"

#include "replay/mutation_text.h"

#include <algorithm>
#include <map>
#include <regex>

namespace voluta::test {

namespace {

// Patterns of a dialect whose flow is a rate: the flow, its value alone in brackets, and the switch
// that turns it on.
struct RateWords {
  std::string flow, on;
  int decimals = 6;
};
const std::map<std::string, RateWords>& rateWords() {
  static const std::map<std::string, RateWords> kTable = {
      {"urscript", {R"(set_standard_analog_out\(0,([0-9.]+)\))", R"(digital_out\(0,True\))"}},
      {"rapid", {R"(aoFlow,([0-9.]+))", R"(SetDO doExtruder,1)"}},
      {"krl", {R"(\$ANOUT\[1\]=([0-9.]+))", R"(^\$OUT\[1\]=TRUE)"}},
      {"spel", {R"(AIO_Out 1, ([0-9.]+))", R"( On 1\r?$)"}},
      {"melfa", {R"(M_Outw\(16\)=([0-9]+))", R"(M_Out\(10\)=1)", 0}},
      {"tmscript", {R"(AO\[0\]=([0-9.]+))", R"(DO\[0\]=1)"}},
  };
  return kTable;
}
// The text before a cumulative amount.
std::string amountWords(const std::string& format) {
  return format == "csv" ? R"(^[0-9].*,([0-9.]+),-?[0-9]+,[a-z]+)" : R"(^G1 .*E([0-9.]+))";
}

struct Found {
  std::size_t begin, length;
  double value;
};
std::optional<Found> valueIn(const std::string& line, const std::regex& words) {
  std::smatch match;
  if (!std::regex_search(line, match, words))
    return std::nullopt;
  return Found{static_cast<std::size_t>(match.position(1)),
               static_cast<std::size_t>(match.length(1)), std::stod(match[1].str())};
}
std::string with(const std::string& line, const Found& found, double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  return line.substr(0, found.begin) + buffer + line.substr(found.begin + found.length);
}

// From the next bead on, whatever its flow in the text; behind the stretch the next bead has its
// own again.
Line lowerRate(Subject& s, std::size_t m, const RateWords& words, double share, std::size_t lines) {
  const std::regex flow(words.flow), on(words.on);
  std::vector<std::string>& text = s.text.lines;
  std::size_t begin = s.read.motions[m].line;
  while (begin <= text.size() && !std::regex_search(text[begin - 1], on))
    ++begin;
  if (begin > text.size())
    return std::nullopt;
  std::string held;
  for (std::size_t l = 1; l < begin; ++l)
    if (valueIn(text[l - 1], flow))
      held = std::regex_replace(text[l - 1], std::regex(R"(^\d+\s+)"), "");
  const auto lowered = [&](const std::string& line) {
    const Found found = *valueIn(line, flow);
    return with(line, found, share * found.value, words.decimals);
  };
  text.insert(text.begin() + at(begin), lowered(held));
  const std::size_t end = std::min(begin + lines, text.size());
  for (std::size_t l = begin + 1; l <= end; ++l)
    if (valueIn(text[l - 1], flow)) {
      held = text[l - 1];
      text[l - 1] = lowered(held);
    }
  for (std::size_t l = end + 1; l <= text.size(); ++l)
    if (std::regex_search(text[l - 1], on)) {
      text.insert(text.begin() + at(l), held);
      break;
    }
  return begin;
}

// Cumulative amounts: the amount missing in the stretch is missing from all behind it, too.
Line lowerAmounts(Subject& s, std::size_t m, const std::string& pattern, double share,
                  std::size_t lines) {
  const std::regex words(pattern);
  const std::size_t begin = s.read.motions[m].line;
  std::optional<double> before;
  double last = 0.0;
  for (std::size_t l = 1; l <= s.text.lines.size(); ++l) {
    std::string& line = s.text.lines[l - 1];
    const auto found = valueIn(line, words);
    if (!found)
      continue;
    if (l < begin) {
      before = last = found->value;
      continue;
    }
    if (!before)
      return std::nullopt;
    if (l < begin + lines)
      last = found->value;
    line = with(line, *found, found->value - (1.0 - share) * (last - *before), 5);
  }
  return begin;
}

// Each line states its own amount, after which none of it remains.
Line lowerEach(Subject& s, std::size_t m, const std::string& pattern, int decimals, double share,
               std::size_t lines) {
  const std::regex words(pattern);
  const std::size_t begin = s.read.motions[m].line;
  const std::size_t end = std::min(begin + lines, s.text.lines.size() + 1);
  for (std::size_t l = begin; l < end; ++l)
    if (const auto found = valueIn(s.text.lines[l - 1], words))
      s.text.lines[l - 1] = with(s.text.lines[l - 1], *found, share * found->value, decimals);
  return begin;
}

} // namespace

Mutation lowerFlow(const std::string& format, double share, std::size_t lines) {
  return {"flow is " + std::to_string(static_cast<int>(100.0 * share)) + " % over " +
              std::to_string(lines) + " lines",
          [=](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
            if (format.ends_with("-stream"))
              return lowerEach(s, m, ",1,([0-9.]+)$", 6, share, lines);
            if (format == "melfa-datalink")
              return lowerEach(s, m, ",([0-9]+),[^,]*$", 0, share, lines);
            if (format == "krl-eki")
              return lowerEach(s, m, ",([0-9.]+),[^,]*$", 6, share, lines);
            const auto rate = rateWords().find(format);
            return rate == rateWords().end() ? lowerAmounts(s, m, amountWords(format), share, lines)
                                             : lowerRate(s, m, rate->second, share, lines);
          }};
}

} // namespace voluta::test
