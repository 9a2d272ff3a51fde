// The form of programs by makers' texts, in the tests' own words: no code of core/program has a
// part in it. Each returns the line (1-based) that is wrong, 0 where none is.
#pragma once

#include <cstddef>
#include <string>

namespace voluta::test {

// ABB, Technical reference manual, RAPID Instructions and Data types, and RAPID Kernel (formal
// syntax): modules, declarations, routines, and of each instruction that Voluta writes how many
// arguments it has and which values the aggregates in them hold; names of at most 32 characters,
// strings of at most 80, CR LF. Not seen: whether a name is declared or a signal is there, types of
// names, ranges of values, whether a quaternion is one.
std::size_t wrongRapidLine(const std::string& module);

// KUKA's language as public grammars and programs from controllers have it: a file with DEF, with
// its head lines, INI fold, motions to aggregates of named axes, assignments to system variables,
// triggers; names of at most 24 characters, CR LF. Not seen: declared names, the advance run, and
// whether the first motion is a PTP with all axes.
std::size_t wrongKrlLine(const std::string& source);

// NIST RS274/NGC, version 3 (3.3 to 3.5), with the LinuxCNC manual's rules for G93: a block's
// letters once each, numbers without exponent, one word of a modal group, axes only with a motion,
// F on every G1 under G93, at most 255 characters; M and E words and texts as Marlin has them; the
// thesis' nX nY nZ where `directions`. Not seen: which axes a machine has, limits, speeds.
std::size_t wrongGcodeLine(const std::string& program, bool directions);

} // namespace voluta::test
