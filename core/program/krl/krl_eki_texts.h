// What of the files beside lines for EthernetKRL is the same for every job. '%' stands for the
// channel's name, which is the program's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// The script that sends the lines.
std::string_view krlEkiSender();
// The channel's configuration; its address and port are the user's to set.
std::string_view krlEkiChannel();
// Between DEFDAT and ENDDAT.
std::string_view krlEkiData();
// From EKI_Init on; `joints`: motions by joints are to joints.
std::string krlEkiLoop(bool joints);

// The lines of a text, with the channel's name.
std::vector<std::string> linesFor(std::string_view text, std::string_view channel);

} // namespace voluta::program
