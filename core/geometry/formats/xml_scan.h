// Sequential reading of XML elements with namespaces.
#pragma once

#include "base/text.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

struct XML_ParserStruct; // of expat

namespace voluta::geometry {

// The name of an element or attribute: the namespace's URI (empty without a namespace) and the
// local name.
struct XmlName {
  std::string_view space, word;
  friend bool operator==(const XmlName&, const XmlName&) = default;
};

// Attributes of one element; valid during the callback only.
class XmlAttributes {
public:
  XmlAttributes(const char** pairs, XML_ParserStruct* parser) : pairs_(pairs), parser_(parser) {}

  // Returns the number of attributes; namespace declarations are none.
  std::size_t size() const;
  // Returns the line of the element in the text, from 1.
  long long line() const;
  bool has(std::string_view word, std::string_view space = {}) const;
  // Returns an empty string if there is none.
  std::string_view text(std::string_view word, std::string_view space = {}) const;
  // These throw Error{UnreadableFile} naming the attribute if it is missing, not a number or not
  // finite.
  double number(std::string_view word, std::string_view space = {}) const;
  long long integer(std::string_view word, std::string_view space = {}) const;
  double numberOr(std::string_view word, double otherwise, std::string_view space = {}) const;
  long long integerOr(std::string_view word, long long otherwise,
                      std::string_view space = {}) const;
  // Calls `take` with each attribute's name and value, in the order of the text.
  void each(const std::function<void(XmlName, std::string_view)>& take) const;

private:
  const char** pairs_; // names as "space|word"
  XML_ParserStruct* parser_;
};

struct XmlHandler {
  std::function<void(XmlName, const XmlAttributes&)> begin;
  std::function<void(XmlName)> end;                                              // may be empty
  std::function<void(std::string_view prefix, std::string_view space)> declares; // may be empty
  std::function<void()> cdata; // a CDATA section begins; may be empty
  // Text between elements, in pieces of any length; may be empty.
  std::function<void(std::string_view)> text;
};

// Calls `handler` for the elements of a text; a base::Error thrown by it ends the scan. `where`
// names the text in errors. Throws Error{UnreadableFile} with the line if the text is not
// well-formed, has an undeclared prefix or a document type (entities may expand without bound);
// rethrows errors of the handler with the line.
void scanXml(std::string_view text, const std::string& where, const XmlHandler& handler);

} // namespace voluta::geometry
