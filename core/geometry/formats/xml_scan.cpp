#include "geometry/formats/xml_scan.h"

#include "base/error.h"
#include "geometry/formats/text_scanner.h"

#include <cmath>
#include <exception>
#include <expat.h>
#include <memory>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;

namespace {

constexpr char kBetween = '|';

// Expat renames it in 2.9, and warns of the old name.
long long lineNumber(XML_Parser parser) {
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
  return static_cast<long long>(XML_GetCurrentLineNumber64(parser));
#else
  return static_cast<long long>(XML_GetCurrentLineNumber(parser));
#endif
}

XmlName nameOf(std::string_view whole) {
  const std::size_t at = whole.rfind(kBetween);
  return at == std::string_view::npos ? XmlName{{}, whole}
                                      : XmlName{whole.substr(0, at), whole.substr(at + 1)};
}

class Scan {
public:
  Scan(const XmlHandler& handler, XML_Parser parser) : handler_(handler), parser_(parser) {
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
        parser,
        [](void* self, const XML_Char* name, const XML_Char** pairs) {
          of(self).guarded([&](const XmlHandler& h) {
            h.begin(nameOf(name), XmlAttributes(pairs, of(self).parser_));
          });
        },
        [](void* self, const XML_Char* name) {
          of(self).guarded([&](const XmlHandler& h) {
            if (h.end)
              h.end(nameOf(name));
          });
        });
    XML_SetStartNamespaceDeclHandler(parser,
                                     [](void* self, const XML_Char* prefix, const XML_Char* space) {
                                       of(self).guarded([&](const XmlHandler& h) {
                                         if (h.declares)
                                           h.declares(prefix ? prefix : "", space ? space : "");
                                       });
                                     });
    XML_SetStartCdataSectionHandler(parser, [](void* self) {
      of(self).guarded([](const XmlHandler& h) {
        if (h.cdata)
          h.cdata();
      });
    });
    if (handler.text)
      XML_SetCharacterDataHandler(parser, [](void* self, const XML_Char* text, int length) {
        of(self).guarded([&](const XmlHandler& h) {
          h.text({text, static_cast<std::size_t>(length)});
        });
      });
    XML_SetStartDoctypeDeclHandler(parser, [](void* self, const XML_Char*, const XML_Char*,
                                              const XML_Char*, int) {
      of(self).guarded([](const XmlHandler&) {
        throw Error(ErrorCode::UnreadableFile, "has a document type, which is not accepted"_text);
      });
    });
  }

  // Exceptions must not cross the parser, which is written in C.
  template <typename Call> void guarded(const Call& call) {
    if (wrong_)
      return;
    try {
      call(handler_);
    } catch (const Error& e) {
      wrong_ = std::make_unique<Error>(e);
      XML_StopParser(parser_, XML_FALSE);
    } catch (...) {
      other_ = std::current_exception();
      XML_StopParser(parser_, XML_FALSE);
    }
  }

  void rethrow(const base::Message& where) const {
    if (other_)
      std::rethrow_exception(other_);
    if (wrong_)
      throw Error(wrong_->code(), wrong_->message(), where);
  }

private:
  static Scan& of(void* self) { return *static_cast<Scan*>(self); }

  const XmlHandler& handler_;
  XML_Parser parser_;
  std::unique_ptr<Error> wrong_;
  std::exception_ptr other_;
};

} // namespace

bool XmlAttributes::has(std::string_view word, std::string_view space) const {
  for (const char** pair = pairs_; *pair; pair += 2)
    if (nameOf(*pair) == XmlName{space, word})
      return true;
  return false;
}

std::size_t XmlAttributes::size() const {
  std::size_t count = 0;
  while (pairs_[2 * count])
    ++count;
  return count;
}

long long XmlAttributes::line() const {
  return lineNumber(parser_);
}

std::string_view XmlAttributes::text(std::string_view word, std::string_view space) const {
  for (const char** pair = pairs_; *pair; pair += 2)
    if (nameOf(*pair) == XmlName{space, word})
      return pair[1];
  return {};
}

double XmlAttributes::number(std::string_view word, std::string_view space) const {
  const std::optional<double> value = numberOf(text(word, space));
  if (!value || !std::isfinite(*value))
    throw Error(ErrorCode::UnreadableFile,
                base::message("'{attribute}' is not a number"_text, word));
  return *value;
}

long long XmlAttributes::integer(std::string_view word, std::string_view space) const {
  const std::optional<long long> value = integerOf(text(word, space));
  if (!value)
    throw Error(ErrorCode::UnreadableFile,
                base::message("'{attribute}' is not an integer"_text, word));
  return *value;
}

double XmlAttributes::numberOr(std::string_view word, double otherwise,
                               std::string_view space) const {
  return has(word, space) ? number(word, space) : otherwise;
}

long long XmlAttributes::integerOr(std::string_view word, long long otherwise,
                                   std::string_view space) const {
  return has(word, space) ? integer(word, space) : otherwise;
}

void XmlAttributes::each(const std::function<void(XmlName, std::string_view)>& take) const {
  for (const char** pair = pairs_; *pair; pair += 2)
    take(nameOf(*pair), pair[1]);
}

void scanXml(std::string_view text, const std::string& where, const XmlHandler& handler) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreateNS(nullptr, kBetween), &XML_ParserFree);
  base::require(parser != nullptr, "an XML parser");
  Scan scan(handler, parser.get());
  const XML_Status status =
      XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
  const base::Message line = base::lineOf(where, lineNumber(parser.get()));
  scan.rethrow(line);
  if (status != XML_STATUS_OK)
    throw Error(
        ErrorCode::UnreadableFile,
        base::message("{why}"_text, std::string(XML_ErrorString(XML_GetErrorCode(parser.get())))),
        line);
}

} // namespace voluta::geometry
