// The words of a command line.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::cli {

// Joins values such as "-90,10" with their option, as they begin with a dash.
inline std::vector<std::string> joinedNegativeValues(int argc, char** argv) {
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if ((word == "--fk" || word == "--ik" || word == "--turn") && i + 1 < argc)
      words.push_back(word + "=" + argv[++i]);
    else
      words.push_back(word);
  }
  return words;
}

// Returns the assignments of --set with one more for all accepted shares, those of --set accept=
// among them.
inline std::vector<std::string> withAccepted(std::vector<std::string> sets,
                                             std::vector<std::string> accepted) {
  constexpr std::string_view kAccept = "accept=";
  for (const std::string& set : sets)
    if (set.starts_with(kAccept))
      accepted.push_back(set.substr(kAccept.size()));
  if (!accepted.empty())
    sets.push_back(fmt::format("{}{}", kAccept, fmt::join(accepted, ", ")));
  return sets;
}

} // namespace voluta::cli
