// Names that a controller's language has for itself: a program that gives one of them to something
// of its own is not loaded, or calls what it did not mean.
#pragma once

#include <string>
#include <string_view>

namespace voluta::program {

// Keywords and built-in functions (URScript manual).
bool isUrscriptWord(std::string_view name);
// Keywords, instructions, functions, data types and predeclared data, letters of either case
// (Technical reference manual, RAPID Instructions, Functions and Data types).
bool isRapidWord(std::string_view name);
// Keywords, instructions and types of KRL, letters of either case (KSS programming manual for
// system integrators; public grammars).
bool isKrlWord(std::string_view name);
// Keywords, instructions and functions of SPEL+, letters of either case (SPEL+ Language Reference).
bool isSpelplusWord(std::string_view name);

// What a program is called after its part: "print_" and 20 characters of the part's name at most.
// No word of any of these languages begins so.
std::string programName(std::string_view part);

// Likewise for KRL, whose names have 24 characters: 19 at most, so that five are left for a file's
// number.
std::string krlName(std::string_view part);

// A name for RAPID that comes from a file: a letter first, 32 characters at most, none of its
// words.
std::string rapidName(std::string_view name);

} // namespace voluta::program
