// The defects that a reader found in a program.
#pragma once

#include "plan/program.h"

#include <cstddef>
#include <gtest/gtest.h>
#include <string>

namespace voluta::test {

// A defect of this line whose reason holds `part`.
inline void expectDefect(const plan::ReadProgram& program, std::size_t line,
                         const std::string& part) {
  for (const plan::ProgramDefect& d : program.defects)
    if (d.line == line && voluta::base::english(d.reason).find(part) != std::string::npos)
      return;
  ADD_FAILURE() << "no defect '" << part << "' in line " << line;
  for (const plan::ProgramDefect& d : program.defects)
    ADD_FAILURE() << "found: " << d.line << ": " << voluta::base::english(d.reason);
}

} // namespace voluta::test
