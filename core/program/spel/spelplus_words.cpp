#include "program/common/language_words.h"
#include "program/rapid/rapid_tokens.h"
#include "program/spel/spelplus.h"

#include <algorithm>
#include <array>

namespace voluta::program {

// SPEL+ Language Reference. In lower case.
std::span<const KnownWord> spelplusWords() {
  static constexpr std::array kTable = {
      KnownWord{"print", kAnywhere, "writes a line on the screen"},
      KnownWord{"cls", kAnywhere, "clears the screen"},
      KnownWord{"memon", kAnywhere, "sets a memory bit of the program"},
      KnownWord{"memoff", kAnywhere, "clears a memory bit of the program"},
      KnownWord{"pause", kAtRest, "waits for the operator"},
      KnownWord{"msgbox", kAtRest, "waits for the operator"},
      KnownWord{"setnet", kSetUp, "address of another machine"},
      KnownWord{"opennet", kSetUp, "connection to another machine"},
      KnownWord{"waitnet", kSetUp, "waits for the connection"},
      KnownWord{"closenet", kAtEnd, "closes the connection"},
      KnownWord{"out", kOutsidePrint, "outputs other than the extruder's"},
      KnownWord{"accel", kAnywhere, "acceleration of Go, percent"},
      KnownWord{"autoljm", kSetUp, "motions keep the arm's posture"},
      KnownWord{"fine", kSetUp, "positioning tolerance at the end of a motion"},
      KnownWord{"inertia", kSetUp, "inertia of the load"},
      KnownWord{"robot", kSetUp, "selects the robot"},
      KnownWord{"reset", kSetUp, "clears errors"},
      KnownWord{"limz", kSetUp, "height of Jump"},
      KnownWord{"arch", kSetUp, "shape of Jump"},
      KnownWord{"ptpboost", kSetUp, "acceleration of short Go"},
  };
  return kTable;
}

bool isSpelplusWord(std::string_view name) {
  static constexpr auto kWords = std::to_array<std::string_view>(
      {"abs",      "accel",      "accelmax",   "accelr",   "accels",   "acos",     "agl",
       "agltopls", "aio_in",     "aio_out",    "aio_set",  "align",    "alignecp", "and",
       "arc",      "arc3",       "arch",       "arm",      "armclr",   "armset",   "as",
       "asc",      "asin",       "atan",       "atan2",    "atclr",    "atrq",     "autoljm",
       "base",     "bclose",     "bgo",        "bmove",    "boolean",  "bopen",    "box",
       "brake",    "bset",       "btst",       "byref",    "byte",     "byval",    "call",
       "case",     "ccls",       "chain",      "chdir",    "clear",    "close",    "closecom",
       "closenet", "cls",        "cnv_queadd", "continue", "copy",     "cos",      "cp",
       "ctr",      "ctreset",    "cu",         "curdir",   "curve",    "cv",       "cvmove",
       "cw",       "cx",         "cy",         "cz",       "date",     "declare",  "default",
       "degtorad", "del",        "dist",       "do",       "double",   "eclr",     "ecp",
       "ecpset",   "elbow",      "else",       "elseif",   "end",      "endif",    "eof",
       "erase",    "errb",       "error",      "eval",     "exit",     "fend",     "find",
       "fine",     "fix",        "fmtstr",     "for",      "force",    "function", "getcurrentuser",
       "global",   "go",         "gosub",      "goto",     "halt",     "hand",     "here",
       "hofs",     "home",       "homeset",    "hordr",    "hour",     "if",       "in",
       "inbcd",    "include",    "inertia",    "inpos",    "input",    "int",      "integer",
       "inw",      "isin",       "ja",         "jrange",   "js",       "jt",       "jtran",
       "jump",     "jump3",      "jump3cp",    "kill",     "lcase",    "left",     "len",
       "limz",     "line",       "ljm",        "local",    "localclr", "lof",      "long",
       "loop",     "lshift",     "mcal",       "memin",    "memoff",   "memon",    "memout",
       "memsw",    "mid",        "mkdir",      "mod",      "monitor",  "motor",    "move",
       "msgbox",   "newton",     "next",       "not",      "off",      "on",       "onerr",
       "op_bcd",   "opbcd",      "opencom",    "opennet",  "oport",    "or",       "out",
       "outw",     "p",          "pagl",       "palet",    "pallet",   "pass",     "pause",
       "pdel",     "peak",       "pg_scan",    "plabel",   "plane",    "pls",      "point",
       "power",    "preserve",   "print",      "ptpboost", "ptptime",  "pulse",    "quit",
       "radtodeg", "randmize",   "range",      "read",     "readbin",  "real",     "redim",
       "rename",   "rename_dir", "reset",      "restart",  "resume",   "return",   "right",
       "rnd",      "robot",      "ropen",      "rot",      "rshift",   "rtrim",    "savepoints",
       "select",   "send",       "sense",      "setcom",   "setnet",   "setsw",    "sfree",
       "short",    "signal",     "sin",        "slock",    "space",    "speed",    "speedr",
       "speeds",   "sqr",        "stat",       "step",     "str",      "string",   "sw",
       "sync",     "syncrobots", "tan",        "tc",       "tclim",    "tgo",      "till",
       "time",     "tlclr",      "tlset",      "tmove",    "tool",     "trap",     "trim",
       "tw",       "ubyte",      "ucase",      "until",    "uopen",    "val",      "wait",
       "waitnet",  "waitsig",    "weight",     "wend",     "while",    "wopen",    "wrist",
       "write",    "xor",        "xqt",        "xy",       "xylim",    "zeroflg"});
  return std::find(kWords.begin(), kWords.end(), inSmallLetters(name)) != kWords.end();
}

} // namespace voluta::program
