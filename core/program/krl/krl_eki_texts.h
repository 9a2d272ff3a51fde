// The parts of the files for EthernetKRL that do not depend on the job. '%' is a placeholder for
// the channel's name, which is the program's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// The script that sends the lines.
std::string_view krlEkiSender();
// The channel's configuration; the user sets its address and port.
std::string_view krlEkiChannel();
// The lines between DEFDAT and ENDDAT.
std::string_view krlEkiData();
// The lines from EKI_Init on; `joints`: targets of joint motions are joint values.
std::string krlEkiLoop(bool joints);

// Returns the lines of a text, with the channel's name inserted.
std::vector<std::string> linesFor(std::string_view text, std::string_view channel);

} // namespace voluta::program
