// How forms present settings: which come first, which are for research, the words by which a search
// finds them beside their labels, and the meaning of a 0.
#pragma once

#include <QString>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::language {

// Keys in the order in which they are shown.
const std::vector<std::string>& firstSettings();
const std::vector<std::string>& researchSettings();

// Returns other words for a setting, or for a field of the choices ("material"), in the language of
// the window; empty: none.
QString synonyms(std::string_view key);
// Returns the meaning of 0 as a value of the setting ("as process"); empty: it is a number.
QString zeroText(std::string_view key);

// All keys and fields that the two know.
std::vector<std::string_view> keysWithSynonyms();
std::vector<std::string_view> keysWithZeroText();

} // namespace voluta::language
