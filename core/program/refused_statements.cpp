#include "program/refused_statements.h"

#include "base/lower_case.h"
#include "program/common/program_text.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace voluta::program {

namespace {

enum class Effect { Motion, Heat, Frame, Flow, Output, Stop, Jump, Unknown };

struct EffectRow {
  Effect effect;
  base::Text does, instead;
};
const EffectRow kEffects[] = {
    {Effect::Motion, "moves the arm, or changes how it moves"_text,
     "leave it out: the plan moves the arm"_text},
    {Effect::Heat, "changes a temperature"_text, "set the temperatures of the material"_text},
    {Effect::Frame, "changes the origin, the tool or the units"_text,
     "set it in the cell before the program starts"_text},
    {Effect::Flow, "changes the extruder"_text, "set it in the process"_text},
    {Effect::Output, "sets an output"_text, "use an event for it, for example 30 output 3 on"_text},
    {Effect::Stop, "stops or ends the program"_text,
     "use an event for it, for example 12 pause Put in the nut"_text},
    {Effect::Jump, "changes the order of the program's lines"_text,
     "put it into a routine on the controller, and call that"_text},
    {Effect::Unknown, "may do anything: Voluta does not know it"_text,
     "put it into a routine on the controller, and call that"_text},
};

// Codes of G-code that leave the print alone, whatever their firmware.
constexpr std::string_view kHarmless =
    "g4 m31 m73 m75 m77 m78 m105 m114 m115 m117 m118 m119 m150 m300 m400";

// Small letters, separated by blanks; a star stands for any end.
struct WordRow {
  std::string_view dialect;
  Effect effect;
  std::string_view words;
};
constexpr WordRow kWords[] = {
    // URScript manual
    {"urscript", Effect::Motion,
     "move* servo* speedj speedl stopj stopl force_mode* end_force_mode freedrive_mode* "
     "end_freedrive_mode teach_mode end_teach_mode path_offset_* optimove* *track_conveyor* "
     "track_conveyor_* stop_conveyor_tracking screw_driving end_screw_driving direct_torque "
     "set_payload* set_target_payload* set_gravity reset_revolution_counter jog* powerdown "
     "power_off mc_* interpreter_mode *torque_command* power_down shutdown rtde_*"},
    {"urscript", Effect::Frame, "set_tcp set_pos set_base* set_frame*"},
    {"urscript", Effect::Output,
     "set_digital_out set_standard_* set_analog_* set_configurable_* set_tool_digital_out "
     "set_runstate_* set_euromap_* modbus_set_* write_*"},
    {"urscript", Effect::Stop, "halt pause popup protective_stop"},
    {"urscript", Effect::Jump,
     "def end sec if elif else while for break continue return goto thread run kill join "
     "enter_critical exit_critical"},
    // RAPID Instructions, Functions and Data types
    {"rapid", Effect::Motion,
     "move* trigg* search* stopmove* startmove* clearpath storepath restopath contactl accset "
     "velset speedrefresh pathacclim worldacclim singarea softact softdeact confj confl "
     "circpathmode motionsup gripload actunit deactunit mechunitload pathresol corr* indamove "
     "indrmove indcmove inddmove indreset egm* arcl* arcc* setleadthrough pathrec* spot* cap* "
     "manloadid* mtooltcpcalib mtoolrotcalib"},
    {"rapid", Effect::Frame,
     "pdispon pdispoff pdispset eoffson eoffsoff eoffsset tooldata wobjdata loaddata setdataval "
     "setalldataval setsysdata"},
    {"rapid", Effect::Output,
     "setdo setao setgo set reset invertdo pulsedo iodisable ioenable aliasio"},
    {"rapid", Effect::Stop, "stop exit exitcycle systemstopaction uimsgbox tpread* systemrestart"},
    {"rapid", Effect::Jump,
     "goto if then elseif else endif for endfor while endwhile test case endtest return raise "
     "load unload startload waitload save erasemodule idelete isleep iwatch "
     "trynext retry proc endproc module trap connect callbyvar %"},
    // KSS programming manual for system integrators
    {"krl", Effect::Motion,
     "ptp lin circ sptp slin scirc spl spline endspline ptp_* lin_* circ_* *_rel asyptp brake "
     "bas $vel* $acc* $ov_* $ipo_mode $apo* $ori_type $circ_type $advance $axis_* $async_* "
     "$load* $red_vel $act_ex_ax $softplc* $softn_end* $softp_end* $jerk* rsi_* pdat_act ldat_act "
     "fdat_act trigger"},
    {"krl", Effect::Frame,
     "$tool* $base* $nullframe $world $robroot $act_tool $act_base tool_data base_data load_data "
     "$tool_c $base_c"},
    {"krl", Effect::Output, "$out $out_c $anout anout pulse cwrite signal"},
    {"krl", Effect::Stop, "halt resume exit"},
    {"krl", Effect::Jump,
     "if then else endif for endfor while endwhile loop endloop repeat until goto return switch "
     "case default endswitch interrupt def deffct end endfct ext cancel"},
    // SPEL+ Language Reference
    {"spel", Effect::Motion,
     "go move arc arc3 jump* bgo bmove tgo tmove pulse home jtran ptran cvmove pass speed* accel* "
     "power motor sfree slock weight inertia brake fine cp curve qp autoljm ptpboost limz arch "
     "force* calib mcal reset jog"},
    {"spel", Effect::Frame, "tool tlset base local localclr arm* ecp* pallet"},
    {"spel", Effect::Output, "on off out outw opbcd aio_out* memout setsw"},
    {"spel", Effect::Stop, "pause halt quit msgbox restart shutdown"},
    {"spel", Effect::Jump,
     "goto gosub return if then else elseif endif for next do loop while wend select case send "
     "exit xqt resume function fend onerr trap"},
    // CR750 series instruction manual
    {"melfa", Effect::Motion,
     "mov mvs mvspl mvr* mvc mva mvtune emv* espd mxt* spd ovrd jovrd accel oadl cnt fine servo "
     "hopen hclose prec "
     "torq cmp cmpoff* cmppos colchk collvl loadset jrc spdopt trk* wth wthif getm relm fsc* "
     "m_nspd m_novrd"},
    {"melfa", Effect::Frame, "tool base m_tool p_tool* p_base* p_ntool p_nbase"},
    {"melfa", Effect::Output, "m_out* m_dout* m_hndcq m_ao* out clr"},
    {"melfa", Effect::Stop, "hlt end error xstp xrst reset"},
    {"melfa", Effect::Jump,
     "goto gosub return if then else endif for next while wend select case on def act callp xrun "
     "xclr xload break skip"},
    // Expression Editor and Listen Node manual
    {"tmscript", Effect::Motion,
     "ptp line circle pline move_* pvt* continuev* stopcontinue* suspendcontinue* stopandclear* "
     "resetmotion vision_* set_load changeload force* pathoffset* stop"},
    {"tmscript", Effect::Frame, "changebase changetcp base tcp"},
    {"tmscript", Effect::Output, "io modbus_write*"},
    {"tmscript", Effect::Stop, "pause resume scriptexit exit"},
    {"tmscript", Effect::Jump,
     "goto if else for while do switch case break continue return define thread* waitqueuetag"},
    // RepRap G-code dictionary, Marlin, Klipper
    {"gcode", Effect::Motion,
     "g0 g1 g2 g3 g5 g6 g7 g12 g27 g28 g29 g30 g31 g32 g33 g34 g35 g38 g42 g60 g61 g76 g80 g81 "
     "g82 g83 g84 g85 g86 g87 g88 g89 g425 m17 m18 m84 m125 m201 m202 m203 m204 m205 m220 m290 "
     "m410 m566 m593 m600 m603 m701 m702 m906 force_move manual_stepper set_velocity_limit "
     "restore_gcode_state quad_gantry_level z_tilt_adjust bed_mesh_calibrate"},
    {"gcode", Effect::Heat,
     "m104 m109 m116 m140 m141 m144 m190 m191 m301 m302 m303 m304 m143 m80 m81 "
     "set_heater_temperature turn_off_heaters temperature_wait pid_calibrate"},
    {"gcode", Effect::Frame,
     "g10 g15 g16 g17 g18 g19 g20 g21 g43 g44 g49 g50 g51 g52 g53 g54 g55 g56 g57 g58 g59 g68 g69 "
     "g90 g91 g92 g93 g94 g95 m6 m82 m83 m92 m206 m211 m218 m350 m420 m421 m428 m500 m501 m502 "
     "m503 m569 m665 m666 m851 m852 m999 t set_gcode_offset set_kinematic_position "
     "activate_extruder bed_mesh_profile bed_mesh_clear"},
    {"gcode", Effect::Flow,
     "g11 g22 g23 m101 m102 m103 m108 m200 m207 m208 m209 m221 m572 m900 set_pressure_advance "
     "set_retraction"},
    {"gcode", Effect::Output, "m3 m4 m5 m42 m62 m63 m64 m65 m67 m68 set_pin"},
    {"gcode", Effect::Stop,
     "m0 m1 m2 m25 m30 m60 m76 m112 m226 m524 m601 m602 pause cancel_print firmware_restart "
     "restart"},
    {"gcode", Effect::Jump,
     "m23 m24 m26 m32 m47 m98 m99 m808 if while goto do end call sub return o"},
};

bool isNamed(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}
bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

// Removes quoted texts.
std::string unquoted(std::string_view statement) {
  std::string code;
  bool isQuoted = false;
  for (const char c : statement) {
    if (c == '"')
      isQuoted = !isQuoted;
    else if (!isQuoted)
      code += c;
  }
  return code;
}

// The names in a line, in small letters.
std::vector<std::string> namesIn(std::string_view code) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < code.size();) {
    std::size_t end = i;
    while (end < code.size() && isNamed(code[end]))
      ++end;
    if (end > i && !isDigit(code[i]))
      names.push_back(base::lowerCase(code.substr(i, end - i)));
    i = std::max(end, i + 1);
  }
  return names;
}

// The commands in a line of G-code: letters with their numbers, without leading zeros and
// decimals, and names. An axis without a command moves as the line before.
std::vector<std::string> commandsIn(std::string_view line) {
  const std::string code = base::lowerCase(line.substr(0, line.find(';')));
  std::vector<std::string> commands;
  bool isFirst = true;
  for (std::size_t i = 0; i < code.size();) {
    if (std::isalpha(static_cast<unsigned char>(code[i])) == 0) {
      ++i;
      continue;
    }
    const char letter = code[i];
    std::size_t at = i + 1;
    if (at < code.size() &&
        (std::isalpha(static_cast<unsigned char>(code[at])) != 0 || code[at] == '_')) {
      while (at < code.size() && isNamed(code[at]))
        ++at;
      commands.push_back(code.substr(i, at - i));
      isFirst = false;
      i = at;
      continue;
    }
    while (at < code.size() && code[at] == ' ')
      ++at;
    const std::size_t from = at;
    while (at < code.size() && isDigit(code[at]))
      ++at;
    const std::size_t leading = std::min(code.find_first_not_of('0', from), at);
    std::string number = code.substr(leading, at - leading);
    if (number.empty() && at > from)
      number = "0";
    if (letter == 'g' || letter == 'm')
      commands.push_back(letter + number);
    else if (isFirst && letter != 'n')
      commands.emplace_back(letter == 't' || letter == 'o' ? std::string(1, letter) : "g1");
    isFirst = isFirst && letter == 'n';
    i = std::max(at, i + 1);
    if (letter == 'm' && (number == "117" || number == "118")) { // a text follows
      const std::size_t quote = code.find('"', i);
      if (quote == std::string::npos)
        break;
      i = std::min(code.find('"', quote + 1), code.size() - 1) + 1;
    }
  }
  return commands;
}

// Returns whether a command is a G or an M with its number, or without one that can be read.
bool isCode(std::string_view word) {
  return (word.starts_with('g') || word.starts_with('m')) &&
         std::ranges::all_of(word.substr(1), isDigit);
}

bool fits(std::string_view word, std::string_view pattern) {
  if (pattern.starts_with('*'))
    return word.find(pattern.substr(1, pattern.find('*', 1) - 1)) != std::string_view::npos;
  if (pattern.ends_with('*'))
    return word.starts_with(pattern.substr(0, pattern.size() - 1));
  return word == pattern;
}

bool has(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (end > 0 && fits(word, words.substr(0, end)))
      return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

// A remark's text does nothing.
std::string_view withoutRemark(std::string_view dialect, std::string_view statement) {
  const std::string_view mark = dialect == "urscript"   ? "#"
                                : dialect == "rapid"    ? "!"
                                : dialect == "krl"      ? ";"
                                : dialect == "tmscript" ? "//"
                                                        : "'";
  return statement.substr(0, findUnquoted(statement, mark));
}

} // namespace

std::optional<RefusedWord> refusedWord(std::string_view dialect, std::string_view statement) {
  const std::string_view family = dialect.starts_with("gcode") ? "gcode" : dialect;
  std::vector<std::string> words;
  if (family == "gcode") {
    words = commandsIn(statement);
  } else {
    const std::string code = unquoted(withoutRemark(dialect, statement));
    words = namesIn(code);
    if (code.find('%') != std::string::npos)
      words.emplace_back("%");
  }
  for (const std::string& word : words)
    for (const WordRow& row : kWords)
      if (row.dialect == family && has(row.words, word)) {
        const auto* const effect = std::ranges::find(kEffects, row.effect, &EffectRow::effect);
        return RefusedWord{word, effect->does, effect->instead};
      }
  if (family == "gcode")
    for (const std::string& word : words)
      if (isCode(word) && !has(kHarmless, word)) {
        const EffectRow& unknown =
            *std::ranges::find(kEffects, Effect::Unknown, &EffectRow::effect);
        return RefusedWord{word, unknown.does, unknown.instead};
      }
  return std::nullopt;
}

namespace {
std::string assignedIn(std::string_view code) {
  int depth = 0;
  for (std::size_t i = 0; i < code.size(); ++i) {
    depth += code[i] == '(' || code[i] == '[' || code[i] == '{' ? 1 : 0;
    depth -= code[i] == ')' || code[i] == ']' || code[i] == '}' ? 1 : 0;
    if (code[i] != '=' || depth > 0)
      continue;
    if ((i + 1 < code.size() && code[i + 1] == '=') ||
        (i > 0 && std::string_view("=<>!").find(code[i - 1]) != std::string_view::npos))
      return {};
    std::string left(code.substr(0, i));
    left.resize(std::min(left.find_first_of("[{(."), left.size()));
    std::vector<std::string> names = namesIn(left);
    return names.empty() ? std::string() : std::move(names.back());
  }
  return {};
}
} // namespace

std::vector<std::string> assignedNames(std::string_view statement) {
  const std::string code = unquoted(statement);
  std::vector<std::string> names;
  for (std::size_t from = 0; from <= code.size();) {
    const std::size_t end = std::min(code.find(';', from), code.size());
    if (std::string name = assignedIn(std::string_view(code).substr(from, end - from));
        !name.empty())
      names.push_back(std::move(name));
    from = end + 1;
  }
  return names;
}

bool hasName(std::string_view line, std::string_view name) {
  for (std::size_t i = 0; i + name.size() <= line.size(); ++i) {
    const bool isHere =
        std::equal(name.begin(), name.end(), line.begin() + static_cast<std::ptrdiff_t>(i),
                   [](char a, char b) {
                     return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
                   });
    if (isHere && (i == 0 || !isNamed(line[i - 1])) &&
        (i + name.size() == line.size() || !isNamed(line[i + name.size()])))
      return true;
  }
  return false;
}

} // namespace voluta::program
