#include "program/stop_text.h"

#include "program/common/program_text.h"
#include "program/gcode/gcode_text.h"

namespace voluta::program {

std::string shownText(std::string_view format, std::string_view text) {
  return format.starts_with("gcode") ? std::string(trimmed(gcodeStopText(text)))
                                     : std::string(text);
}

} // namespace voluta::program
