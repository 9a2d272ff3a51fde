#include "program/makers_grammars.h"

#include "program/peg.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

namespace voluta::test {

namespace {

constexpr std::string_view kRapid = R"PEG(
Module <- _ 'MODULE' S Name _ Data* Routine+ 'ENDMODULE' _
_ <- ([ \t] / '\r\n' / '!' [^\r\n]*)*
S <- [ \t]+
C <- _ ',' _
End <- _ ';' _

Data <- ('PERS' / 'VAR' / 'CONST') S (ToolData / WobjData / OtherData) End
ToolData <- 'tooldata' S Name _ ':=' _ '[' _ Bool C Pose C Load _ ']'
WobjData <- 'wobjdata' S Name _ ':=' _ '[' _ Bool C Bool C String C Pose C Pose _ ']'
OtherData <- !('tooldata' / 'wobjdata') Name S Name (_ ':=' _ Value)?
Load <- '[' _ Number C Position C Turn C Number C Number C Number _ ']'

Routine <- ('LOCAL' S)? ('PROC' S Name _ '(' _ Parameters? _ ')' _ Body 'ENDPROC'
                         / 'FUNC' S Name S Name _ '(' _ Parameters? _ ')' _ Body 'ENDFUNC') _
Parameters <- Name S Name (C Name S Name)*
Body <- ('VAR' S OtherData End)* Statement*
Statement <- !Keyword (Branch / Loop / Simple End)
Branch <- 'IF' S Expression S 'THEN' _ Statement* ('ELSEIF' S Expression S 'THEN' _ Statement*)*
          ('ELSE' !NameChar _ Statement*)? 'ENDIF' !NameChar _
Loop <- 'WHILE' S Expression S 'DO' _ Statement* 'ENDWHILE' !NameChar _
Simple <- Motion / Instruction / 'RETURN' (S Expression)? !NameChar / 'EXIT' !NameChar
        / Variable _ ':=' _ Expression / Call
Keyword <- ('ENDPROC' / 'ENDFUNC' / 'ENDIF' / 'ENDWHILE' / 'ELSEIF' / 'ELSE' / 'THEN' / 'DO' / 'VAR'
          / 'ENDMODULE') !NameChar
Expression <- Term (_ Operator _ Term)*
Operator <- '<=' / '>=' / '<>' / '<' / '>' / '=' / '+' / '-' / '*' / '/' / ('AND' / 'OR') !NameChar
Term <- 'NOT' S Term / '-' _ Variable / Number / String / Bool / Function / Variable
      / '[' _ Expression (C Expression)* _ ']' / '(' _ Expression _ ')'
Function <- Name _ '(' _ (Expression (_ '\\' Name (_ ':=' _ Expression)?)* (C Expression)*)? _ ')'
Variable <- !Keyword Name ('.' Name)*
Motion <- (('MoveL' / 'MoveJ') S Robtarget C Speed C Zone
         / 'TriggL' S Robtarget C Speed C Name C Zone
         / 'MoveAbsJ' S Jointtarget _ ('\\NoEOffs')? C Speed C Zone) C Name _ ('\\WObj' _ ':=' _ Name)?
        / 'MoveExtJ' S Jointtarget C Speed C Zone
Robtarget <- '[' _ Position C Turn C Four C Six _ ']' / Name
Jointtarget <- '[' _ Six C Six _ ']' / Name
Speed <- (Four / Name) _ ('\\' ('T' / 'V') _ ':=' _ Number)?
Zone <- ('[' _ Bool (C Number){6,6} _ ']' / Name) _ ('\\' ('Z' / 'Inpos') _ ':=' _ Value)?

Instruction <- ('SetDO' / 'SetAO') S Name C Expression
             / 'WaitTime' _ '\\InPos' C Expression
             / 'WaitTime' S Number
             / ('ConfL' / 'ConfJ') _ '\\' ('On' / 'Off') !NameChar
             / ('ActUnit' / 'DeactUnit') S Name
             / 'UIMsgBox' S Expression
             / 'Open' S String _ '\\File' _ ':=' _ Expression C Name _ '\\' ('Read' / 'Write' / 'Append' / 'Bin')
             / 'Close' S Name
             / 'TPWrite' S String
             / 'TriggEquip' S Name C Number _ ('\\Start')? C Number _
               '\\' ('AOp' / 'DOp' / 'GOp') _ ':=' _ Name C Expression
             / 'TriggSpeed' S Name C Number _ ('\\' ('Start' / 'Next'))? C Number C Name C Number
             / 'Load' _ '\\Dynamic' C String _ '\\File' _ ':=' _ String
             / 'UnLoad' S String _ '\\File' _ ':=' _ String
Call <- '%' _ String _ '%' / !Known Name (S Expression (C Expression)*)?
Known <- ('MoveL' / 'MoveJ' / 'MoveAbsJ' / 'MoveC' / 'MoveExtJ' / 'TriggL' / 'SetDO' / 'SetAO' / 'WaitTime'
        / 'ConfL' / 'ConfJ' / 'ActUnit' / 'UIMsgBox' / 'Open' / 'Close' / 'TPWrite' / 'TriggEquip' / 'TriggSpeed' / 'Load' / 'UnLoad')
        !NameChar

Value <- Number / String / Bool / '[' _ Value (C Value)* _ ']' / Name
Position <- '[' _ Number C Number C Number _ ']'
Turn <- Four
Pose <- '[' _ Position C Turn _ ']'
Four <- '[' _ Number (C Number){3,3} _ ']'
Six <- '[' _ Number (C Number){5,5} _ ']'
Bool <- ('TRUE' / 'FALSE') !NameChar
Number <- '-'? ([0-9]+ ('.' [0-9]*)? / '.' [0-9]+) ('E' [-+]? [0-9]+)? !NameChar
String <- '"' [^"\r\n]{0,80} '"'
Name <- [A-Za-z] NameChar{0,31} !NameChar
NameChar <- [A-Za-z0-9_]
)PEG";

constexpr std::string_view kKrl = R"PEG(
File <- ('&' Rest)* Blank* 'DEF' S Name _ '(' _ ')' Eol Line* 'END' !NameChar Blank* ('\r\n')*
Rest <- [^\r\n]* '\r\n'
Blank <- [ \t] / '\r\n' / ';' [^\r\n]*
_ <- [ \t]*
S <- [ \t]+
Eol <- _ (';' [^\r\n]*)? '\r\n'
Line <- _ !('END' !NameChar) Statement? Eol

Statement <- Motion / Trigger / Interrupt / Declaration / Assignment / Analogue / Bas / Word / Call
Motion <- ('PTP' / 'LIN' / 'SPTP' / 'SLIN') S Target (S ('C_PTP' / 'C_DIS' / 'C_VEL' / 'C_ORI'))*
Target <- Aggregate / Name
Trigger <- 'TRIGGER' S 'WHEN' S ('DISTANCE' / 'PATH') _ '=' _ Number S 'DELAY' _ '=' _ Number
           S 'DO' S (Assignment / Call)
Interrupt <- 'GLOBAL'? _ 'INTERRUPT' S ('DECL' S [0-9]+ S 'WHEN' S Expression S 'DO' S Call
           / ('ON' / 'OFF') (S [0-9]+)?)
Declaration <- 'DECL' S Name S Name (_ ',' _ Name)* / 'SIGNAL' S Name S Variable
Assignment <- Variable _ '=' _ Expression
Analogue <- 'ANOUT' S ('ON' S Name _ '=' _ Expression (S Name _ '=' _ Number)* / 'OFF' S Name)
Bas <- 'BAS' _ '(' _ '#' Name _ ',' _ Number _ ')'
Word <- ('CONTINUE' / 'HALT' / 'WAIT' S ('SEC' S Number / 'FOR' S Expression)) !NameChar
Call <- !Reserved Name _ '(' _ (Expression (_ ',' _ Expression)*)? _ ')'
Reserved <- ('PTP' / 'LIN' / 'TRIGGER' / 'END' / 'DEF' / 'BAS') !NameChar

Expression <- Term (_ ('==' / '<>' / '<=' / '>=' / '+' / '-' / '*' / '/' / '<' / '>') _ Term)*
Term <- Number / Truth / '#' Name / Aggregate / '\'' [BH] [0-9A-F]+ '\''
        / '"' [^"\r\n]* '"' / Variable
Truth <- ('TRUE' / 'FALSE') !NameChar
Variable <- Name (_ '[' _ Expression _ ']')? ('.' Name)*
Aggregate <- '{' _ (Name ':' _)? Pair (_ ',' _ Pair)* _ '}'
Pair <- Name S (Expression / Aggregate)
Number <- [-+]? ([0-9]+ ('.' [0-9]*)? / '.' [0-9]+) ('E' [-+]? [0-9]+)? !NameChar
Name <- [A-Za-z_$] NameChar{0,23} !NameChar
NameChar <- [A-Za-z0-9_$]
)PEG";

// One block of G-code.
class Block {
public:
  Block(std::string_view code, bool directions) : directions_(directions) { read(code); }
  bool good() const { return good_; }
  bool has(char letter) const { return words_.count(std::string(1, letter)) > 0; }
  const std::set<std::string>& commands() const { return commands_; }
  bool hasAxis() const {
    return std::any_of(words_.begin(), words_.end(), [](const auto& word) {
      return word.second &&
             std::string_view("XYZABCUVW").find(word.first.back()) != std::string_view::npos;
    });
  }

private:
  void read(std::string_view rest) {
    while (good_ && !rest.empty()) {
      if (rest.front() == ' ' || rest.front() == '\t') {
        rest.remove_prefix(1);
        continue;
      }
      std::string letter;
      if (directions_ && rest.front() == 'n' && rest.size() > 1) {
        letter = "n";
        rest.remove_prefix(1);
      }
      letter += rest.front();
      good_ = std::isalpha(static_cast<unsigned char>(rest.front()));
      rest.remove_prefix(1);
      const std::size_t length = number(rest);
      const std::string value(rest.substr(0, length));
      rest.remove_prefix(length);
      const bool command = letter == "G" || letter == "M";
      good_ = good_ && (command ? length > 0 : length > 0 || has('G'));
      if (command)
        good_ = good_ && commands_.insert(letter + value).second;
      else
        good_ = good_ && words_.emplace(letter, length > 0).second;
    }
  }
  // Digits with a point, no exponent; none: 0.
  static std::size_t number(std::string_view text) {
    std::size_t at = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0, digits = 0;
    bool point = false;
    for (; at < text.size(); ++at)
      if (text[at] >= '0' && text[at] <= '9')
        ++digits;
      else if (text[at] == '.' && !point)
        point = true;
      else
        break;
    return digits > 0 ? at : 0;
  }

  bool directions_, good_ = true;
  std::map<std::string, bool> words_; // has it a number
  std::set<std::string> commands_;
};

int modalGroup(const std::string& command) {
  static const std::map<std::string, int> kGroups = {
      {"G0", 1},  {"G1", 1},  {"G2", 1},  {"G3", 1},  {"G90", 3}, {"G91", 3}, {"G93", 5},
      {"G94", 5}, {"G20", 6}, {"G21", 6}, {"M82", 9}, {"M83", 9}, {"M0", 4},  {"M1", 4}};
  const auto it = kGroups.find(command);
  return it == kGroups.end() ? 0 : it->second;
}

} // namespace

std::size_t wrongRapidLine(const std::string& module) {
  static const Peg grammar(kRapid, true);
  return grammar.wrongLine(module);
}

std::size_t wrongKrlLine(const std::string& source) {
  static const Peg grammar(kKrl, true);
  return grammar.wrongLine(source);
}

std::size_t wrongGcodeLine(const std::string& program, bool directions) {
  std::istringstream lines(program);
  bool inverseTime = false;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.size() > 255)
      return number;
    const std::string code = line.substr(0, line.find(';'));
    if (code.starts_with("M117"))
      continue;
    const Block block(code, directions);
    if (!block.good())
      return number;
    std::set<int> groups;
    for (const std::string& command : block.commands())
      if (const int group = modalGroup(command); group != 0 && !groups.insert(group).second)
        return number;
    const bool rapid = block.commands().count("G0") > 0;
    const bool moves = rapid || block.commands().count("G1") > 0;
    if (block.hasAxis() && !moves)
      return number;
    inverseTime =
        (inverseTime || block.commands().count("G93") > 0) && block.commands().count("G94") == 0;
    if (inverseTime && moves && !rapid && !block.has('F'))
      return number;
  }
  return number == 0 ? 1 : 0;
}

} // namespace voluta::test
