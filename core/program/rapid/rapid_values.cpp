#include "program/rapid/rapid_values.h"

#include <utility>

namespace voluta::program {

namespace {
constexpr std::size_t kMaxNumbers = 32, kMaxDepth = 4;
} // namespace

bool RapidValues::fail(base::Message reason) {
  reason_ = std::move(reason);
  return false;
}

bool RapidValues::takeEnd() {
  closed_ = takeMark(';');
  return closed_;
}

bool RapidValues::literal(RapidData& data, std::size_t depth) {
  if (data.numbers.size() >= kMaxNumbers || depth > kMaxDepth)
    return false;
  if (takeMark('[')) {
    data.shape += '[';
    do {
      if (!literal(data, depth + 1))
        return false;
    } while (takeMark(','));
    data.shape += ']';
    return takeMark(']');
  }
  double value = 0.0;
  if (takeNumberToken(value)) {
    data.shape += 'n';
  } else if (token_.kind == RapidTokenKind::Text) {
    value = token_.text.empty() ? 0.0 : 1.0;
    data.text = inSmallLetters(token_.text);
    data.shape += 's';
    advance();
  } else if (isWord("true") || isWord("false")) {
    value = isWord("true") ? 1.0 : 0.0;
    data.shape += 'b';
    advance();
  } else if (std::string name; takeName(name)) {
    const auto known = declared_.find(name);
    if (known == declared_.end() ||
        data.numbers.size() + known->second.data.numbers.size() > kMaxNumbers)
      return fail(base::message("'{name}' is not known to the reader"_text, name.substr(0, 40)));
    const RapidData& part = known->second.data;
    data.shape += rapidShape(known->second.type);
    data.text += part.text;
    data.numbers.insert(data.numbers.end(), part.numbers.begin(), part.numbers.end());
    return true;
  } else {
    return false;
  }
  data.numbers.push_back(value);
  return true;
}

// After Offs: ( robtarget , x , y , z ).
bool RapidValues::offset(RapidData& target) {
  if (!takeMark('(') || !value("robtarget", target))
    return false;
  for (std::size_t k = 0; k < 3; ++k) {
    double mm = 0.0;
    if (!takeMark(',') || !takeNumberToken(mm))
      return false;
    target.numbers[k] += mm;
  }
  return takeMark(')');
}

// A literal or a name of this type.
bool RapidValues::value(std::string_view type, RapidData& data) {
  if (std::string name; takeName(name)) {
    if (name == "offs" && type == "robtarget" && isMark('('))
      return offset(data);
    if (const auto known = declared_.find(name); known != declared_.end()) {
      data = known->second.data;
      return known->second.type == type ||
             fail(base::message("'{name}' is not of type {type}"_text, name.substr(0, 40), type));
    }
    if (auto given = predeclaredRapid(type, name)) {
      data = std::move(*given);
      return true;
    }
    return fail(base::message("'{name}' is not declared as {type}"_text, name.substr(0, 40), type));
  }
  data = {};
  return literal(data) && (data.shape == rapidShape(type) ||
                           fail(base::message("a {type} must have other components"_text, type)));
}

bool RapidValues::declaration(bool inProcedure) {
  takeWord("local");
  if (!takeWord("pers") && !takeWord("const") && !takeWord("var"))
    return false;
  std::string type, name;
  if (!takeName(type) || !takeName(name))
    return false;
  if (type == "triggdata") // Filled by TriggEquip
    return takeEnd() && (declared_.try_emplace(std::move(name), Declared{type, {}}).second ||
                         fail("a name is declared twice"_text));
  if (rapidShape(type).empty())
    return fail(base::message("data of the type {type} is not known to the reader"_text,
                              type.substr(0, 40)));
  RapidData data;
  if (!takeAssign() || !value(type, data) || !takeEnd() || !sensible(type, data))
    return false;
  if (inProcedure)
    declared_.erase(name);
  return declared_.try_emplace(std::move(name), Declared{type, std::move(data)}).second ||
         fail("a name is declared twice"_text);
}

// name := value; after its name.
bool RapidValues::assignment(const std::string& name) {
  const auto known = declared_.find(name);
  if (known == declared_.end())
    return fail(base::message("'{word}' is not known to the reader"_text, name.substr(0, 40)));
  RapidData data;
  if (!takeAssign() || !value(known->second.type, data) || !takeEnd() ||
      !sensible(known->second.type, data))
    return false;
  known->second.data = std::move(data);
  return true;
}

bool RapidValues::sensible(const std::string& type, const RapidData& data) {
  if (type == "tooldata")
    toolLine_ = token_.line;
  if (type == "wobjdata" && isMoved(data) == data.text.empty())
    return fail("a work object must name the mechanical unit that moves it, or be stationary"_text);
  return true;
}

} // namespace voluta::program
