#include "process/machine_laws.h"

#include "base/json_node.h"

#include <algorithm>

namespace voluta::process {

namespace {
using base::JsonNode;

constexpr double kMaxLagS = 10.0;
constexpr double kMinOverlapFactor = 0.5;

double readLag(const JsonNode& top, std::string_view key) {
  if (!top.has(key))
    return 0.0;
  const JsonNode node = top.at(key);
  const double seconds = node.notNegative();
  if (seconds > kMaxLagS)
    node.fail(base::message("must be at most {most}"_text, base::seconds(kMaxLagS)));
  return seconds;
}

std::vector<std::string> readStatements(const JsonNode& words, std::string_view key) {
  std::vector<std::string> statements;
  if (!words.has(key))
    return statements;
  for (const JsonNode& item : words.at(key).items()) {
    std::string text = item.text();
    if (text.find_first_not_of(' ') == std::string::npos ||
        text.find_first_of("\r\n") != std::string::npos)
      item.fail("must be one line that is not empty"_text);
    statements.push_back(std::move(text));
  }
  return statements;
}

bool hasForce(const std::vector<std::string>& statements) {
  return std::ranges::any_of(statements, [](const std::string& statement) {
    return statement.find("{press") != std::string::npos;
  });
}

std::vector<BeadWords> readBeadWords(const JsonNode& list) {
  std::vector<BeadWords> all;
  for (const JsonNode& item : list.items()) {
    item.allowOnly({"format", "start", "end"});
    BeadWords words{item.at("format").text(), readStatements(item, "start"),
                    readStatements(item, "end")};
    words.isForce = hasForce(words.start) || hasForce(words.end);
    if (words.start.empty() && words.end.empty())
      item.fail("has no statements"_text);
    if (std::ranges::any_of(all, [&](const BeadWords& w) { return w.format == words.format; }))
      item.at("format").fail("has its statements already"_text);
    all.push_back(std::move(words));
  }
  return all;
}
} // namespace

MachineLaws readMachineLaws(const JsonNode& top) {
  MachineLaws laws;
  laws.lag = {readLag(top, "startLagS"), readLag(top, "stopLagS")};
  if (top.has("overlapFactor")) {
    const JsonNode node = top.at("overlapFactor");
    laws.overlapFactor = node.number();
    if (!(laws.overlapFactor >= kMinOverlapFactor && laws.overlapFactor <= 1.0))
      node.fail(
          base::message("must be between {least} and 1"_text, base::number(kMinOverlapFactor)));
  }
  if (top.has("beadWords"))
    laws.beadWords = readBeadWords(top.at("beadWords"));
  return laws;
}

} // namespace voluta::process
