// Data of RAPID in its text: literals, names, declarations and assignments.
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

// A parser of values. Each function gives false where the text is no such thing; reason_ then says
// why, or is empty where it is not understood at all.
class RapidValues : protected RapidCursor {
protected:
  struct Declared {
    std::string type;
    RapidData data;
  };

  bool fail(base::Message reason);
  // The semicolon.
  bool takeEnd();

  // Nested brackets of numbers, truths, strings and declared names.
  bool literal(RapidData& data, std::size_t depth = 0);
  // A literal, a name or (of robtarget) Offs(name, x, y, z) of this type.
  bool value(std::string_view type, RapidData& data);
  // PERS, CONST or VAR type name := value; one `inProcedure` is made anew whenever that is called.
  bool declaration(bool inProcedure);
  // Behind a declared name: := value;
  bool assignment(const std::string& name);

  base::Message reason_;
  bool closed_ = false; // the statement's semicolon was taken
  std::map<std::string, Declared, std::less<>> declared_;
  std::size_t toolLine_ = 0; // where the last tool was declared; 0: nowhere

private:
  bool offset(RapidData& target);
  bool sensible(const std::string& type, const RapidData& data);
};

} // namespace voluta::program
