// Elements of an XML text in turn, with their namespaces.
#pragma once

#include "base/text.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace voluta::geometry {

// An element's or an attribute's name: the namespace's URI, empty where it has none, and the word.
struct XmlName {
  std::string_view space, word;
  friend bool operator==(const XmlName&, const XmlName&) = default;
};

// Attributes of one element; good while it is looked at.
class XmlAttributes {
public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}

  bool has(std::string_view word, std::string_view space = {}) const;
  // Empty where there is none.
  std::string_view text(std::string_view word, std::string_view space = {}) const;
  // Throw Error{UnreadableFile} that names the attribute: missing, no number, not finite.
  double number(std::string_view word, std::string_view space = {}) const;
  long long integer(std::string_view word, std::string_view space = {}) const;
  double numberOr(std::string_view word, double otherwise, std::string_view space = {}) const;
  long long integerOr(std::string_view word, long long otherwise,
                      std::string_view space = {}) const;
  // Calls with each attribute's name and value, in the order of the text.
  void each(const std::function<void(XmlName, std::string_view)>& take) const;

private:
  const char** pairs_; // names as "space|word"
};

struct XmlHandler {
  std::function<void(XmlName, const XmlAttributes&)> begin;
  std::function<void(XmlName)> end;                                              // may be empty
  std::function<void(std::string_view prefix, std::string_view space)> declares; // may be empty
  std::function<void()> cdata; // a CDATA section begins; may be empty
};

// Hands the elements of a text to `handler`, whose base::Error stops it. `where` names the text in
// errors. Throws Error{UnreadableFile}, with the line: not well-formed, a prefix that nothing
// declares, a document type (entities may be endless); and what the handler throws, with the line.
void scanXml(std::string_view text, const std::string& where, const XmlHandler& handler);

} // namespace voluta::geometry
