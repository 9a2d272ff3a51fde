// The two programs beside a stream of joints for Universal Robots, without what is of a job
// (program/stream/urscript_stream.h).
#pragma once

#include <string_view>

namespace voluta::program {

// The receiver behind its head, from a remark that says so to the function's end. It calls a
// computer whose address the sender puts in the place of SENDER_ADDRESS.
std::string_view urscriptReceiver();
// Its first line; what a job has of its own stands before it.
std::string_view urscriptReceiverBegin();

// All of the sender.
std::string_view urscriptSender();

} // namespace voluta::program
