#include "program/tmscript/tmscript.h"

#include <array>

namespace voluta::program {

// Expression Editor and Listen Node manual; tmr_ros1.
std::span<const KnownWord> tmscriptWords() {
  static constexpr std::array kTable = {
      KnownWord{"QueueTag", kAnywhere, "a mark in the queue, told when it is reached"},
      KnownWord{"WaitQueueTag", kAtRest, "waits until the queue is there"},
      KnownWord{"ListenSend", kAtRest, "sends a text to the sender of the frames"},
      KnownWord{"Pause", kAtRest, "waits for the operator"},
      KnownWord{"Resume", kOutsidePrint, "goes on"},
  };
  return kTable;
}

bool needsRest(std::string_view word) {
  return word == "Pause" || word == "ListenSend" || word == "while" || word.ends_with("QueueTag");
}

} // namespace voluta::program
