// User-visible text is a Text; the compiler enforces this for errors, findings and progress. The
// rest is checked here: sentences in core and scene that are plain strings.
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct Literal {
  std::size_t begin = 0; // of the first of those that are joined
  std::string text, suffix;
};

bool isWordPart(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Those of a source, adjacent ones joined; comments and includes aside.
std::vector<Literal> literalsOf(std::string_view s) {
  std::vector<Literal> found;
  bool joins = false;
  const auto skip = [&](std::size_t from, std::string_view to) {
    const std::size_t at = s.find(to, from);
    return at == std::string_view::npos ? s.size() : at;
  };
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.substr(i, 2) == "//" || s.substr(i, 8) == "#include") {
      i = skip(i, "\n");
    } else if (s.substr(i, 3) == "R\"(") {
      i = skip(i, ")\"") + 1; // shaders and tables of text
    } else if (s[i] == '\'' && (i == 0 || !isWordPart(s[i - 1]))) {
      for (++i; i < s.size() && s[i] != '\''; ++i)
        i += s[i] == '\\' ? 1 : 0;
    } else if (s[i] == '"') {
      if (!joins)
        found.push_back({i, {}, {}});
      for (++i; i < s.size() && s[i] != '"'; ++i) {
        found.back().text += s[i];
        if (s[i] == '\\')
          found.back().text += s[++i];
      }
      while (i + 1 < s.size() && isWordPart(s[i + 1]))
        found.back().suffix += s[++i];
      joins = found.back().suffix.empty();
    } else if (std::isspace(static_cast<unsigned char>(s[i])) == 0) {
      joins = false;
    }
  }
  return found;
}

// Three words in small letters or more.
bool isSentence(const std::string& text) {
  std::istringstream words(text);
  int count = 0;
  for (std::string word; words >> word;) {
    while (!word.empty() && std::ispunct(static_cast<unsigned char>(word.back())) != 0)
      word.pop_back();
    count += word.size() > 1 &&
             std::all_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  }
  return count >= 3;
}

// Preconditions are for developers of the program; a literal that ends with a line break is a key
// or a file's text.
bool isForUsers(std::string_view source, const Literal& literal) {
  if (literal.text.ends_with("\\n"))
    return false;
  const std::size_t before = source.rfind(';', literal.begin);
  const std::string_view statement =
      source.substr(before == std::string_view::npos ? 0 : before,
                    literal.begin - (before == std::string_view::npos ? 0 : before));
  constexpr std::array<std::string_view, 4> kForUs{"require(", "failPrecondition(", "static_assert",
                                                   "throw \""};
  const std::string_view withNext =
      source.substr(literal.begin - statement.size(), statement.size() + 1);
  return std::none_of(kForUs.begin(), kForUs.end(), [&](std::string_view call) {
    return withNext.find(call) != std::string_view::npos;
  });
}

// Comments in programs are for operators of a controller and are English, as are the rule of a
// comparison (command line and compare.json), the contents of robots' and cells' files, and the
// output of the program that collects texts.
bool isEnglishOnly(const fs::path& file) {
  const std::string name = file.filename().string();
  const bool isOfProgram = file.string().find("core/program/") != std::string::npos;
  return isOfProgram || name.starts_with("head_verdict.") || name == "compare_figures.cpp" ||
         name == "urdf_reader.cpp" || name == "urdf_shapes.cpp" ||
         name == "robot_file_writer.cpp" || name == "cell_layout.cpp" || name == "arm_import.cpp" ||
         name == "extract.cpp";
}

TEST(Texts, EverySentenceForUsersIsMarked) {
  std::size_t sentences = 0;
  for (const char* folder : {"core", "widgets/scene", "widgets/pictures"})
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(VOLUTA_SOURCE_DIR) / folder)) {
      const fs::path& file = entry.path();
      if ((file.extension() != ".cpp" && file.extension() != ".h") || isEnglishOnly(file))
        continue;
      std::ifstream in(file);
      std::ostringstream bytes;
      bytes << in.rdbuf();
      const std::string source = bytes.str();
      for (const Literal& literal : literalsOf(source)) {
        if (!isSentence(literal.text))
          continue;
        ++sentences;
        const bool marked = literal.suffix == "_text" || literal.suffix == "_plural";
        EXPECT_TRUE(marked || !isForUsers(source, literal))
            << file << ": \"" << literal.text << "\" cannot be translated";
      }
    }
  EXPECT_GT(sentences, 500u);
}

} // namespace
