// Lines that must not be within a print, by format.
#pragma once

#include <string>
#include <vector>

namespace voluta::test {

std::vector<std::string> linesDuringPrint(const std::string& format);

} // namespace voluta::test
