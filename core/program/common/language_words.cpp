#include "program/common/language_words.h"

#include "program/common/program_text.h"
#include "program/rapid/rapid_data.h"
#include "program/rapid/rapid_tokens.h"

#include <algorithm>
#include <array>

namespace voluta::program {

namespace {

constexpr std::array kUrscript =
    std::to_array<std::string_view>({"False",
                                     "Inf",
                                     "NaN",
                                     "None",
                                     "True",
                                     "acos",
                                     "and",
                                     "asin",
                                     "assert",
                                     "atan",
                                     "atan2",
                                     "binary_list_to_integer",
                                     "blinky",
                                     "break",
                                     "ceil",
                                     "clear_binary_output",
                                     "conveyor_pulse_decode",
                                     "continue",
                                     "cos",
                                     "d2r",
                                     "def",
                                     "elif",
                                     "else",
                                     "encoder_enable_pulse_decode",
                                     "end",
                                     "end_force_mode",
                                     "end_freedrive_mode",
                                     "end_screwdriving",
                                     "end_teach_mode",
                                     "enter_critical",
                                     "exit_critical",
                                     "floor",
                                     "for",
                                     "force",
                                     "force_mode",
                                     "freedrive_mode",
                                     "from",
                                     "get_actual_joint_positions",
                                     "get_actual_joint_speeds",
                                     "get_actual_tcp_pose",
                                     "get_actual_tcp_speed",
                                     "get_forward_kin",
                                     "get_inverse_kin",
                                     "get_list_length",
                                     "get_steptime",
                                     "get_target_joint_positions",
                                     "get_target_tcp_pose",
                                     "get_tcp_force",
                                     "global",
                                     "halt",
                                     "if",
                                     "in",
                                     "integer_to_binary_list",
                                     "interpolate_pose",
                                     "is_steady",
                                     "join",
                                     "kill",
                                     "len",
                                     "length",
                                     "list",
                                     "local",
                                     "log",
                                     "make_list",
                                     "modbus_add_signal",
                                     "movec",
                                     "movej",
                                     "movel",
                                     "movep",
                                     "norm",
                                     "not",
                                     "optimovej",
                                     "optimovel",
                                     "or",
                                     "pass",
                                     "path_offset_enable",
                                     "popup",
                                     "pose_add",
                                     "pose_dist",
                                     "pose_inv",
                                     "pose_sub",
                                     "pose_trans",
                                     "position_deviation_warning",
                                     "pow",
                                     "protective_stop",
                                     "r2d",
                                     "random",
                                     "request_boolean_from_primary_client",
                                     "reset_revolution_counter",
                                     "return",
                                     "rotvec2rpy",
                                     "rpc_factory",
                                     "rpy2rotvec",
                                     "run",
                                     "sec",
                                     "servoc",
                                     "servoj",
                                     "set_analog_out",
                                     "set_analog_outputdomain",
                                     "set_digital_out",
                                     "set_gravity",
                                     "set_payload",
                                     "set_standard_analog_out",
                                     "set_standard_digital_out",
                                     "set_target_payload",
                                     "set_tcp",
                                     "set_tool_voltage",
                                     "sin",
                                     "size",
                                     "sleep",
                                     "socket_close",
                                     "socket_open",
                                     "socket_send_line",
                                     "speedj",
                                     "speedl",
                                     "sqrt",
                                     "stopj",
                                     "stopl",
                                     "str_at",
                                     "str_cat",
                                     "str_empty",
                                     "str_find",
                                     "str_len",
                                     "str_sub",
                                     "sync",
                                     "tan",
                                     "teach_mode",
                                     "textmsg",
                                     "then",
                                     "thread",
                                     "timer",
                                     "to_num",
                                     "to_str",
                                     "transpose",
                                     "true",
                                     "while",
                                     "xor",
                                     "zero_ftsensor"});

// In lower case.
constexpr std::array kRapid = std::to_array<std::string_view>(
    {"abs",         "accset",        "acos",      "activated",
     "actunit",     "add",           "alias",     "and",
     "asin",        "atan",          "atan2",     "backward",
     "bitand",      "bool",          "break",     "byte",
     "callbyvar",   "case",          "ceil",      "clear",
     "clkread",     "clkreset",      "clkstart",  "clkstop",
     "clock",       "close",         "confdata",  "confj",
     "confl",       "connect",       "const",     "cos",
     "cpos",        "crobt",         "ctime",     "deactunit",
     "default",     "defframe",      "div",       "dnum",
     "do",          "dotprod",       "else",      "elseif",
     "endfor",      "endfunc",       "endif",     "endmodule",
     "endproc",     "endrecord",     "endtest",   "endtrap",
     "endwhile",    "eoffsset",      "erase",     "errno",
     "error",       "errwrite",      "eulerzyx",  "exit",
     "exitcycle",   "exp",           "extjoint",  "false",
     "fine",        "for",           "from",      "func",
     "goto",        "gripload",      "idelete",   "if",
     "inout",       "intnum",        "inv",       "isignaldi",
     "iwatch",      "jointtarget",   "label",     "load",
     "loaddata",    "local",         "main",      "mechunit",
     "mirpos",      "mod",           "module",    "moveabsj",
     "movec",       "movecdo",       "moveextj",  "movej",
     "movejdo",     "movel",         "moveldo",   "noframe",
     "nostepin",    "not",           "noview",    "num",
     "numtostr",    "offs",          "open",      "opmode",
     "or",          "orient",        "orientzyx", "pathacclim",
     "pathresol",   "pers",          "pos",       "pose",
     "poseinv",     "posemult",      "pow",       "present",
     "proc",        "pulsedo",       "raise",     "readonly",
     "record",      "reltool",       "reset",     "resetaxisdistance",
     "restart",     "retry",         "return",    "robtarget",
     "round",       "searchl",       "set",       "setao",
     "setdo",       "setgo",         "shapedata", "signalao",
     "signaldo",    "sin",           "singarea",  "softact",
     "speeddata",   "sqrt",          "startload", "step",
     "stop",        "stoppointdata", "string",    "sysmodule",
     "tan",         "task",          "test",      "then",
     "to",          "tool0",         "tooldata",  "tperase",
     "tpreadfk",    "tpwrite",       "trap",      "triggdata",
     "triggequip",  "triggint",      "triggio",   "triggl",
     "triggspeed",  "true",          "trunc",     "trynext",
     "uimsgbox",    "undo",          "unload",    "var",
     "velset",      "viewonly",      "waitdi",    "waitdo",
     "waitload",    "waitrob",       "waittime",  "waituntil",
     "while",       "with",          "wobj0",     "wobjdata",
     "worldacclim", "wzboxdef",      "xor",       "zonedata"});

} // namespace

bool isUrscriptWord(std::string_view name) {
  return std::find(kUrscript.begin(), kUrscript.end(), name) != kUrscript.end();
}

bool isRapidWord(std::string_view name) {
  const std::string small = inSmallLetters(name);
  return std::find(kRapid.begin(), kRapid.end(), small) != kRapid.end() ||
         predeclaredRapid("speeddata", small) || predeclaredRapid("zonedata", small);
}

std::string programName(std::string_view part) {
  return joined({"print_", identifierOf(part).substr(0, 20)});
}

std::string krlName(std::string_view part) {
  return joined({"print_", identifierOf(part).substr(0, 13)});
}

std::string rapidName(std::string_view name) {
  std::string id = identifierOf(name);
  if (id.front() == '_' || isRapidWord(id))
    id = joined({"unit_", id.substr(0, 26)});
  return id;
}

} // namespace voluta::program
