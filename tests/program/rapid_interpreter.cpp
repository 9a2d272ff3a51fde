#include "program/rapid_interpreter.h"

#include <cctype>
#include <cmath>
#include <stdexcept>

namespace voluta::test {

namespace {

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t"), to = text.find_last_not_of(" \t");
  return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}
bool isName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}
std::string nameAt(const std::string& text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && isName(text[end]))
    ++end;
  return text.substr(at, end - at);
}

// Without remarks, its lines joined.
std::string flat(const std::string& module) {
  std::string out;
  bool quoted = false, remark = false;
  for (const char c : module) {
    if (c == '\r' || c == '\n') {
      out += ' ';
      remark = quoted = false;
      continue;
    }
    quoted = quoted != (c == '"' && !remark);
    remark = remark || (c == '!' && !quoted);
    if (!remark)
      out += c;
  }
  return out;
}

// Between commas outside of brackets and quotes.
std::vector<std::string> parts(const std::string& text, char mark = ',') {
  std::vector<std::string> all(1);
  int depth = 0;
  bool quoted = false;
  for (const char c : text) {
    quoted = quoted != (c == '"');
    depth += quoted ? 0 : c == '[' || c == '(' ? 1 : c == ']' || c == ')' ? -1 : 0;
    if (c == mark && depth == 0 && !quoted)
      all.emplace_back();
    else
      all.back() += c;
  }
  for (std::string& part : all)
    part = trimmed(part);
  return all;
}

} // namespace

struct RapidInterpreter::Parser {
  std::string text;
  std::size_t at = 0;

  void blanks() {
    while (at < text.size() && text[at] == ' ')
      ++at;
  }
  std::string peek() {
    blanks();
    return nameAt(text, at);
  }
  std::string upTo(const std::string& word) { // which is a word, or ";"
    bool quoted = false;
    for (std::size_t i = at; i < text.size(); ++i) {
      quoted = quoted != (text[i] == '"');
      const bool whole =
          word == ";" || ((i == 0 || !isName(text[i - 1])) && nameAt(text, i) == word);
      if (!quoted && whole && text.compare(i, word.size(), word) == 0) {
        const std::string found = text.substr(at, i - at);
        at = i + word.size();
        return trimmed(found);
      }
    }
    throw std::runtime_error("no " + word + " behind " + text.substr(at, 60));
  }

  std::vector<Statement> block() {
    std::vector<Statement> all;
    for (;;) {
      const std::string word = peek();
      if (word == "ELSEIF" || word == "ELSE" || word.starts_with("END"))
        return all;
      Statement s;
      if (word == "IF") {
        s.kind = Statement::If;
        upTo("IF");
        do {
          const std::string condition = upTo("THEN");
          s.branches.emplace_back(condition, block());
        } while (peek() == "ELSEIF" && (upTo("ELSEIF"), true));
        if (peek() == "ELSE") {
          upTo("ELSE");
          s.branches.emplace_back("TRUE", block());
        }
        upTo("ENDIF");
      } else if (word == "WHILE") {
        s.kind = Statement::While;
        upTo("WHILE");
        const std::string condition = upTo("DO");
        s.branches.emplace_back(condition, block());
        upTo("ENDWHILE");
      } else {
        s.text = upTo(";");
      }
      all.push_back(std::move(s));
    }
  }
};

// Or, and, not, comparison, sum, product, in this order of strength.
struct RapidInterpreter::Expression {
  RapidInterpreter& in;
  Variables& own;
  const std::string& text;
  std::size_t at = 0;

  bool take(const std::string& word) {
    while (at < text.size() && text[at] == ' ')
      ++at;
    if (text.compare(at, word.size(), word) != 0 ||
        (isName(word.front()) && nameAt(text, at) != word))
      return false;
    at += word.size();
    return true;
  }
  Value either() {
    Value a = both();
    while (take("OR")) {
      const Value b = both();
      a = number(a.number != 0.0 || b.number != 0.0);
    }
    return a;
  }
  Value both() {
    Value a = compared();
    while (take("AND")) {
      const Value b = compared();
      a = number(a.number != 0.0 && b.number != 0.0);
    }
    return a;
  }
  Value compared() {
    if (take("NOT"))
      return number(compared().number == 0.0);
    const Value a = sum();
    for (const char* op : {"<=", ">=", "<>", "<", ">", "="})
      if (take(op)) {
        const Value b = sum();
        const bool same = a.kind == Value::Text ? a.text == b.text : a.number == b.number;
        const bool less = a.number < b.number;
        const std::string o = op;
        return number(o == "="    ? same
                      : o == "<>" ? !same
                      : o == "<"  ? less
                      : o == "<=" ? less || same
                      : o == ">"  ? !less && !same
                                  : !less);
      }
    return a;
  }
  Value sum() {
    Value a = product();
    for (;;) {
      if (take("+")) {
        const Value b = product();
        a.text += b.text;
        a.number += b.number;
      } else if (take("-")) {
        a.number -= product().number;
      } else {
        return a;
      }
    }
  }
  Value product() {
    Value a = primary();
    for (;;) {
      if (take("*"))
        a.number *= primary().number;
      else if (take("/"))
        a.number /= primary().number;
      else
        return a;
    }
  }
  std::vector<Value> listTo(const char* end) {
    std::vector<Value> all;
    if (take(end))
      return all;
    do {
      all.push_back(either());
      if (take("\\")) // a switch
        at += nameAt(text, at).size();
    } while (take(","));
    if (!take(end))
      throw std::runtime_error("not closed: " + text);
    return all;
  }
  Value primary() {
    if (take("-"))
      return number(-primary().number);
    if (take("(")) {
      Value v = either();
      take(")");
      return v;
    }
    Value v;
    if (take("[")) {
      v.kind = Value::List;
      v.list = listTo("]");
      return v;
    }
    if (take("\"")) {
      v.kind = Value::Text;
      const std::size_t end = text.find('"', at);
      v.text = text.substr(at, end - at);
      at = end + 1;
      return v;
    }
    if (at < text.size() &&
        (std::isdigit(static_cast<unsigned char>(text[at])) || text[at] == '.')) {
      std::size_t length = 0;
      v.number = std::stod(text.substr(at), &length);
      at += length;
      return v;
    }
    const std::string name = nameAt(text, at);
    if (name.empty())
      throw std::runtime_error("no value: " + text.substr(at));
    at += name.size();
    if (name == "TRUE" || name == "FALSE")
      return number(name == "TRUE");
    if (name == "EOF") {
      v.kind = Value::Text;
      v.text = "EOF";
      return v;
    }
    if (name == "StrToVal") { // its second argument is set
      take("(");
      const std::string of = either().text;
      take(",");
      const std::string into = nameAt(text, at);
      at += into.size();
      take(")");
      std::size_t length = 0;
      try {
        own.at(into) = number(std::stod(of, &length));
      } catch (const std::logic_error&) {
        length = 0;
      }
      return number(length == of.size() && length > 0);
    }
    if (take("("))
      return in.call(name, listTo(")"));
    v = own.contains(name) ? own.at(name) : in.variables_.at(name);
    while (take(".")) {
      const std::string part = nameAt(text, at);
      at += part.size();
      const std::size_t k = part == "x" || part == "trans" ? 0
                            : part == "y" || part == "rot" ? 1
                                                           : 2;
      v = Value(v.list.at(k));
    }
    return v;
  }
};

RapidInterpreter::Value RapidInterpreter::number(double value) {
  Value v;
  v.number = value;
  return v;
}
Eigen::Vector3d RapidInterpreter::position(const Value& v) {
  return {v.list.at(0).number, v.list.at(1).number, v.list.at(2).number};
}
Eigen::Quaterniond RapidInterpreter::rotation(const Value& v) {
  return {v.list.at(0).number, v.list.at(1).number, v.list.at(2).number, v.list.at(3).number};
}
RapidInterpreter::Value RapidInterpreter::ofRotation(const Eigen::Quaterniond& q) {
  Value v;
  v.kind = Value::List;
  v.list = {number(q.w()), number(q.x()), number(q.y()), number(q.z())};
  return v;
}

RapidInterpreter::RapidInterpreter(const std::string& module, const std::string& file)
    : file_(file) {
  Parser parser{flat(module)};
  parser.upTo("MODULE");
  parser.at += parser.peek().size();
  for (std::string word = parser.peek(); word != "ENDMODULE"; word = parser.peek()) {
    if (word != "PROC" && word != "FUNC") {
      declare(parser.upTo(";"), variables_);
      continue;
    }
    parser.upTo(word);
    const std::size_t open = parser.text.find('(', parser.at), close = parser.text.find(')', open);
    const std::string head = trimmed(parser.text.substr(parser.at, open - parser.at));
    Routine routine;
    for (const std::string& part : parts(parser.text.substr(open + 1, close - open - 1)))
      if (!part.empty())
        routine.parameters.push_back(part.substr(part.rfind(' ') + 1));
    parser.at = close + 1;
    routine.body = parser.block();
    parser.upTo(word == "PROC" ? "ENDPROC" : "ENDFUNC");
    routines_.emplace(head.substr(head.rfind(' ') + 1), std::move(routine));
  }
}

void RapidInterpreter::run() {
  Value fine;
  fine.kind = Value::List;
  fine.list = {number(1), number(0)};
  variables_["fine"] = fine;
  call("main", {});
}

// CONST, PERS or VAR, a type, a name and a value.
void RapidInterpreter::declare(const std::string& text, Variables& into) {
  const std::size_t assigned = text.find(":=");
  const std::string head = trimmed(text.substr(0, assigned));
  const std::string name = head.substr(head.rfind(' ') + 1);
  Value v;
  if (assigned != std::string::npos) {
    v = value(text.substr(assigned + 2), into);
  } else if (head.find(" pos ") != std::string::npos) {
    v.kind = Value::List;
    v.list.assign(3, Value());
  }
  into[name] = v;
}

RapidInterpreter::Value RapidInterpreter::value(const std::string& text, Variables& own) {
  Expression e{*this, own, text};
  Value v = e.either();
  if (!trimmed(text.substr(e.at)).empty())
    throw std::runtime_error("what is left: " + text.substr(e.at) + " of " + text);
  return v;
}

RapidInterpreter::Value RapidInterpreter::call(const std::string& name,
                                               const std::vector<Value>& a) {
  if (const auto own = routines_.find(name); own != routines_.end()) {
    Variables variables;
    for (std::size_t k = 0; k < a.size(); ++k)
      variables[own->second.parameters.at(k)] = a[k];
    returned_ = {};
    runAll(own->second.body, variables);
    return returned_;
  }
  Value v;
  if (name == "StrLen") {
    v.number = static_cast<double>(a.at(0).text.size());
  } else if (name == "StrPart") {
    const auto from = static_cast<std::size_t>(a.at(1).number),
               count = static_cast<std::size_t>(a.at(2).number);
    if (from < 1 || count < 1 || from + count - 1 > a[0].text.size())
      throw std::runtime_error("StrPart beyond its text");
    v.kind = Value::Text;
    v.text = a[0].text.substr(from - 1, count);
  } else if (name == "StrFind") {
    const std::size_t found =
        a.at(0).text.find_first_of(a.at(2).text, static_cast<std::size_t>(a.at(1).number) - 1);
    v.number = static_cast<double>(found == std::string::npos ? a[0].text.size() + 1 : found + 1);
  } else if (name == "ReadStr") { // at most 80 characters of a line
    v.kind = Value::Text;
    if (at_ >= file_.size()) {
      v.text = "EOF";
      return v;
    }
    const std::size_t end = std::min(file_.find('\n', at_), file_.size());
    v.text = file_.substr(at_, std::min<std::size_t>(end - at_, 80));
    at_ += v.text.size() < 80 ? v.text.size() + 1 : 80;
  } else if (name == "Abs") {
    v.number = std::abs(a.at(0).number);
  } else if (name == "Distance") {
    v.number = (position(a.at(0)) - position(a.at(1))).norm();
  } else if (name == "DotProd") {
    v.number = position(a.at(0)).dot(position(a.at(1)));
  } else if (name == "NOrient") {
    v = ofRotation(rotation(a.at(0)).normalized());
  } else if (name == "PoseVect") {
    const Eigen::Vector3d p =
        rotation(a.at(0).list.at(1)) * position(a.at(1)) + position(a[0].list[0]);
    v.kind = Value::List;
    v.list = {number(p.x()), number(p.y()), number(p.z())};
  } else if (name == "PoseMult") {
    v = a.at(0);
    v.list[1] = ofRotation(rotation(a[0].list.at(1)) * rotation(a.at(1).list.at(1)));
  } else {
    throw std::runtime_error("unknown function " + name);
  }
  return v;
}

RapidInterpreter::Flow RapidInterpreter::runAll(const std::vector<Statement>& all, Variables& own) {
  for (const Statement& s : all)
    if (const Flow next = runOne(s, own); next != Flow::On || exits_)
      return exits_ ? Flow::Exit : next;
  return Flow::On;
}

RapidInterpreter::Flow RapidInterpreter::runOne(const Statement& s, Variables& own) {
  if (s.kind == Statement::If) {
    for (const auto& [condition, body] : s.branches)
      if (value(condition, own).number != 0.0)
        return runAll(body, own);
    return Flow::On;
  }
  if (s.kind == Statement::While) {
    while (value(s.branches[0].first, own).number != 0.0)
      if (const Flow next = runAll(s.branches[0].second, own); next != Flow::On)
        return next;
    return Flow::On;
  }
  return simple(s.text, own);
}

RapidInterpreter::Flow RapidInterpreter::simple(const std::string& text, Variables& own) {
  const std::string word = nameAt(text, 0);
  const std::string rest = trimmed(text.substr(word.size()));
  if (word == "VAR") {
    declare(text, own);
  } else if (word == "RETURN") {
    returned_ = rest.empty() ? Value() : value(rest, own);
    return Flow::Return;
  } else if (word == "EXIT") {
    exits_ = true;
    return Flow::Exit;
  } else if (rest.starts_with(":=")) {
    const Value v = value(rest.substr(2), own);
    (own.contains(word) ? own.at(word) : variables_[word]) = v;
  } else if (!instruction(word, rest, own)) {
    std::vector<Value> arguments;
    if (!rest.empty())
      for (const std::string& part : parts(rest))
        arguments.push_back(value(part, own));
    call(word, arguments);
  }
  return exits_ ? Flow::Exit : Flow::On;
}

bool RapidInterpreter::instruction(const std::string& word, const std::string& rest,
                                   Variables& own) {
  const std::vector<std::string> a = parts(rest);
  if (word == "SetDO") {
    on = value(a.at(1), own).number != 0.0;
  } else if (word == "SetAO") {
    flow = value(a.at(1), own).number;
  } else if (word == "WaitTime") {
    waits.emplace_back(value(a.at(1), own).number, on ? flow : 0.0);
  } else if (word == "TriggEquip") {
    trigger_ = value(a.at(3), own).number;
  } else if (word == "UIMsgBox") {
    const std::string said = value(rest, own).text;
    if (said.starts_with("Not understood: "))
      refused = said.substr(16);
  } else if (word == "Open") {
    opened =
        value(rest.substr(rest.find(":=") + 2, rest.find(',') - rest.find(":=") - 2), own).text;
  } else if (word == "Close") {
    closed = true;
  } else if (word == "MoveL" || word == "TriggL" || word == "MoveJ" || word == "MoveAbsJ") {
    motion(word, a, own);
  } else {
    return word == "ConfL" || word == "ConfJ";
  }
  return true;
}

void RapidInterpreter::motion(const std::string& word, const std::vector<std::string>& a,
                              Variables& own) {
  RapidMotion m;
  m.word = word;
  const bool triggers = word == "TriggL";
  if (triggers)
    flow = trigger_;
  const Value target = value(word == "MoveAbsJ" ? "pStart" : a.at(0), own);
  m.position = position(target.list.at(0));
  m.rotation = rotation(target.list.at(1));
  m.speed = value(a.at(1), own).list.at(0).number;
  const Value zone = value(a.at(triggers ? 3 : 2), own);
  m.zoneMm = zone.list.at(0).number != 0.0 ? 0.0 : zone.list.at(1).number;
  m.on = on;
  m.flow = flow;
  motions.push_back(m);
}

} // namespace voluta::test
