#include "program/melfa/melfa.h"

#include <array>

namespace voluta::program {

// CR750 series instruction manual, 4.13 (detailed explanation of command words). In lower case. The
// reader itself handles the words that set speeds, outputs and positions.
std::span<const KnownWord> melfaWords() {
  static constexpr std::array kTable = {
      KnownWord{"dim", kAnywhere, "declares arrays"},
      KnownWord{"title", kAnywhere, "a name for the program"},
      KnownWord{"hlt", kAtRest, "waits for the operator"},
      KnownWord{"wait", kOutsidePrint, "waits for an input"},
      KnownWord{"open", kAtRest, "opens a line to a screen"},
      KnownWord{"print", kAtRest, "shows a text there"},
      KnownWord{"close", kAtRest, "closes the line"},
      KnownWord{"servo", kOutsidePrint, "motors on or off"},
      KnownWord{"getm", kSetUp, "takes the arm for this program"},
      KnownWord{"relm", kAtEnd, "gives the arm back"},
      KnownWord{"fine", kSetUp, "how near a target counts as reached"},
      KnownWord{"colchk", kSetUp, "watches for collisions"},
      KnownWord{"collvl", kSetUp, "how closely"},
      KnownWord{"loadset", kSetUp, "which hand and work piece the arm carries"},
      KnownWord{"prec", kSetUp, "follows its path more closely"},
      KnownWord{"hopen", kOutsidePrint, "a hand that is not the extruder"},
      KnownWord{"hclose", kOutsidePrint, "a hand that is not the extruder"},
  };
  return kTable;
}

} // namespace voluta::program
