// Reserved names of the controllers' languages: a program that defines one of them is not loaded,
// or calls something else than intended.
#pragma once

#include <string>
#include <string_view>

namespace voluta::program {

// Keywords and built-in functions (URScript manual).
bool isUrscriptWord(std::string_view name);
// Keywords, instructions, functions, data types and predeclared data, case-insensitive (Technical
// reference manual, RAPID Instructions, Functions and Data types).
bool isRapidWord(std::string_view name);
// Keywords, instructions and types of KRL, case-insensitive (KSS programming manual for system
// integrators; public grammars).
bool isKrlWord(std::string_view name);
// Keywords, instructions and functions of SPEL+, case-insensitive (SPEL+ Language Reference).
bool isSpelplusWord(std::string_view name);

// Returns a program name made from the part's: "print_" and at most 20 characters. No reserved word
// of these languages begins so.
std::string programName(std::string_view part);

// The same for KRL, whose names have 24 characters: at most 19, so that five are left for a file
// number.
std::string krlName(std::string_view part);

// Returns a RAPID name for a name from a file: it starts with a letter, has at most 32 characters
// and is no reserved word.
std::string rapidName(std::string_view name);

} // namespace voluta::program
