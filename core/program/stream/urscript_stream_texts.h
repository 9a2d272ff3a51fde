// The two programs that accompany a stream of joints for Universal Robots, without the job-specific
// parts (program/stream/urscript_stream.h).
#pragma once

#include <string_view>

namespace voluta::program {

// Returns the receiver after its head, from a remark that marks the beginning to the function's
// end. It connects to a computer whose address the sender inserts for SENDER_ADDRESS.
std::string_view urscriptReceiver();
// Returns its first line; the job-specific part is before it.
std::string_view urscriptReceiverBegin();

// Returns the whole sender.
std::string_view urscriptSender();

} // namespace voluta::program
