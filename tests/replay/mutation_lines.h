// Lines that have no business amid a print, a format at a time.
#pragma once

#include <string>
#include <vector>

namespace voluta::test {

std::vector<std::string> linesAmid(const std::string& format);

} // namespace voluta::test
