// Parses RAPID data: literals, names, declarations and assignments.
#pragma once

#include "base/text.h"
#include "program/rapid/rapid_data.h"
#include "program/rapid/rapid_tokens.h"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace voluta::program {

// A parser of values. Each function returns false if the text has another form; reason_ then gives
// the cause, or is empty if the text is not understood at all.
class RapidValues : protected RapidCursor {
protected:
  struct Declared {
    std::string type;
    RapidData data;
  };

  bool fail(base::Message reason);
  // The semicolon.
  bool takeEnd();

  // Nested brackets of numbers, booleans, strings and declared names.
  bool literal(RapidData& data, std::size_t depth = 0);
  // A literal, a name or (for robtarget) Offs(name, x, y, z) of this type.
  bool value(std::string_view type, RapidData& data);
  // PERS, CONST or VAR type name := value; a declaration `inProcedure` is made anew on every call
  // of the procedure.
  bool declaration(bool inProcedure);
  // After a declared name: := value;
  bool assignment(const std::string& name);

  base::Message reason_;
  bool closed_ = false; // The statement's semicolon was taken
  std::map<std::string, Declared, std::less<>> declared_;
  std::size_t toolLine_ = 0; // Line of the last tool's declaration; 0: none

private:
  bool offset(RapidData& target);
  bool sensible(const std::string& type, const RapidData& data);
};

} // namespace voluta::program
