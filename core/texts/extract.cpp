// Extracts the texts shown to users: string literals marked _text or _plural (core/base/text.h).
//   voluta_extract_texts LIST.cpp NOTES.cpp FOLDER... LIST.cpp: all of them, for
//   core/texts/known_texts.h. NOTES.cpp: the same for lupdate. Unchanged files are not written.

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kContext = "Core";

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return std::move(bytes).str();
}

void writeIfChanged(const fs::path& file, const std::string& text) {
  if (fs::exists(file) && read(file) == text)
    return;
  std::ofstream(file, std::ios::binary) << text;
}

bool isWordPart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// Iterates over the literals of a source: adjacent ones joined, escapes unresolved, with their
// suffix.
class Literals {
public:
  explicit Literals(std::string_view source) : source_(source) {}

  bool next(std::string& literal, std::string& suffix) {
    literal.clear();
    suffix.clear();
    bool any = false;
    while (at_ < source_.size()) {
      const char c = source_[at_];
      if (starts("//")) {
        skipTo("\n");
      } else if (starts("/*")) {
        skipTo("*/");
      } else if (c == '\'' && !(at_ > 0 && isWordPart(source_[at_ - 1]))) {
        skipQuoted('\'');
      } else if (c == '"') {
        const std::size_t begin = at_ + 1;
        skipQuoted('"');
        literal += source_.substr(begin, at_ - 1 - begin);
        any = true;
        const std::size_t end = at_;
        while (at_ < source_.size() && isWordPart(source_[at_]))
          ++at_;
        suffix = source_.substr(end, at_ - end);
        if (!suffix.empty())
          return true;
      } else if (any && c != ' ' && c != '\n' && c != '\t' && c != '\r') {
        return true;
      } else {
        ++at_;
      }
    }
    return any;
  }

private:
  bool starts(std::string_view what) const { return source_.substr(at_, what.size()) == what; }
  void skipTo(std::string_view what) {
    const std::size_t found = source_.find(what, at_);
    at_ = found == std::string_view::npos ? source_.size() : found + what.size();
  }
  void skipQuoted(char quote) {
    for (++at_; at_ < source_.size() && source_[at_] != quote; ++at_)
      at_ += source_[at_] == '\\' ? 1 : 0;
    ++at_;
  }

  std::string_view source_;
  std::size_t at_ = 0;
};

struct Found {
  std::string literal; // As written in the source
  bool plural = false;
};

// Keyed by the English plural form.
using Texts = std::map<std::string, Found>;

void addTexts(const std::string& source, Texts& texts) {
  Literals literals(source);
  std::string literal, suffix;
  while (literals.next(literal, suffix)) {
    const bool plural = suffix == "_plural";
    if (literal.empty() || (!plural && suffix != "_text"))
      continue;
    const std::string many = plural ? literal.substr(literal.find('|') + 1) : literal;
    texts[many] = {literal, plural};
  }
}

std::string listOf(const Texts& texts) {
  std::string out = "#include \"texts/known_texts.h\"\n\nnamespace voluta::texts {\n\n"
                    "std::span<const base::Text> knownTexts() {\n"
                    "  static constexpr base::Text kTexts[] = {\n";
  for (const auto& [many, found] : texts)
    out += "      \"" + found.literal + (found.plural ? "\"_plural,\n" : "\"_text,\n");
  return out + "  };\n  return kTexts;\n}\n\n} // namespace voluta::texts\n";
}

// Returns whether the text contains anything but placeholders and punctuation.
bool hasWords(std::string_view text) {
  bool within = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == '{' || text[i] == '}')
      within = text[i] == '{';
    else if (!within && (std::isalpha(static_cast<unsigned char>(text[i])) != 0))
      return true;
  }
  return false;
}

std::string notesOf(const Texts& texts) {
  std::string out = "// Read by lupdate, never compiled.\nconst char* const kTexts[] = {\n";
  for (const auto& [many, found] : texts)
    if (hasWords(many))
      out += (found.plural ? "    QT_TRANSLATE_N_NOOP(\"" : "    QT_TRANSLATE_NOOP(\"") +
             std::string(kContext) + "\", \"" + many + "\"),\n";
  return out + "};\n";
}

} // namespace

int main(int count, char** arguments) {
  if (count < 4) {
    std::cerr << "voluta_extract_texts LIST.cpp NOTES.cpp FOLDER...\n";
    return 2;
  }
  Texts texts;
  for (int i = 3; i < count; ++i)
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(arguments[i])) {
      const fs::path extension = entry.path().extension();
      if (extension == ".cpp" || extension == ".h")
        addTexts(read(entry.path()), texts);
    }
  writeIfChanged(arguments[1], listOf(texts));
  writeIfChanged(arguments[2], notesOf(texts));
  return 0;
}
