// Programs of several files with text beside the part's own procedure: a controller runs it, or
// does not load the file, so that it is refused at its line.
#include "program_fixture.h"

#include "program/dialect.h"
#include "program/extruder.h"

#include <algorithm>
#include <sstream>

namespace voluta::program {
namespace {

class PartText : public test::Programs {
protected:
  // Dialects whose programs may be cut.
  static std::vector<std::string> ofSeveralFiles() {
    std::vector<std::string> ids;
    for (const Dialect& dialect : dialects())
      for (const base::ParameterSpec& option : optionsOf(dialect))
        if (option.key == "motionsPerFile")
          ids.emplace_back(dialect.id);
    return ids;
  }
  plan::Program programFor(const std::string& format) {
    randomFor(findDialect(format), 9, 300);
    ProgramInput in = input();
    in.options.motionsPerFile = 100;
    return writeProgram(format, in);
  }
  plan::ReadProgram read(const std::string& format,
                         const std::vector<plan::ProgramFile>& files) const {
    return readProgram(format, files, process::Tooling(process_));
  }
  static std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
      lines.push_back(line + "\n");
    return lines;
  }
  // Puts the text before line `at`, from 1, of a file.
  static std::vector<plan::ProgramFile> with(std::vector<plan::ProgramFile> files, std::size_t file,
                                             std::size_t at, const std::string& added) {
    std::vector<std::string> lines = linesOf(files[file].text);
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at) - 1, added);
    files[file].text.clear();
    for (const std::string& line : lines)
      files[file].text += line;
    return files;
  }
  static bool isReported(const plan::ReadProgram& program, std::size_t file, std::size_t line) {
    return std::ranges::any_of(program.defects, [&](const plan::ProgramDefect& d) {
      return d.file == file && d.line == line;
    });
  }
};

TEST_F(PartText, MotionsAndOtherWordsBesideItAreRefused) {
  EXPECT_GE(ofSeveralFiles().size(), 5u);
  for (const std::string& format : ofSeveralFiles()) {
    const plan::Program program = programFor(format);
    const plan::ReadProgram whole = read(format, program.files);
    ASSERT_TRUE(whole.defects.empty() && whole.complete) << format;
    const plan::ProgramMotion& motion = whole.motions[whole.motions.size() / 2];
    const std::size_t file = motion.file, end = linesOf(program.files[file].text).size() + 1;
    ASSERT_GT(file, 0u) << format;
    const std::string newLine =
        program.files[file].text.find('\r') == std::string::npos ? "\n" : "\r\n";
    const std::string move = linesOf(program.files[file].text)[motion.line - 1];
    for (const std::string& added : {move, "junk junk" + newLine})
      for (const std::size_t at : {std::size_t{1}, end}) {
        SCOPED_TRACE(format + " line " + std::to_string(at) + ": " + added);
        // Text behind `End` is a subroutine that nothing calls.
        if (format == "melfa" && at == end)
          continue;
        const plan::ReadProgram read = this->read(format, with(program.files, file, at, added));
        // A file of MELFA-BASIC has no frame, so that a motion before its steps is one of them.
        EXPECT_TRUE(isReported(read, file, at) || read.motions.size() != whole.motions.size());
      }
  }
}

TEST_F(PartText, OfUrscriptIsRefusedAtItsLine) {
  const plan::Program program = programFor("urscript");
  const std::vector<std::string> part = linesOf(program.files[1].text);
  const std::string call = part[0].substr(4, part[0].find(':') - 4) + "\n";
  for (const std::string& added :
       {std::string("movej([0,0,0,0,0,0],a=1.4,v=3)\n"),
        std::string("set_standard_digital_out(0,True)\n"), call,
        std::string("def other():\n  sleep(0)\nend\nother()\n"),
        std::string("def other():\n  movej([0,0,0,0,0,0])\nend\n"), std::string("x = 3\n"),
        std::string("end\n"), std::string("thread other():\n  sync()\nend\n"),
        std::string("junk junk\n")})
    for (const std::size_t at : {std::size_t{1}, part.size() + 1}) {
      SCOPED_TRACE("line " + std::to_string(at) + ": " + added);
      const plan::ReadProgram read = this->read("urscript", with(program.files, 1, at, added));
      EXPECT_TRUE(isReported(read, 1, at));
    }
  // Remarks and blank lines do nothing.
  for (const std::string added : {"# mine\n", "\n", "   \n"})
    EXPECT_TRUE(read("urscript", with(program.files, 1, part.size() + 1, added)).defects.empty());
}

// A port gets the files one by one, each of which runs by itself.
TEST_F(PartText, OfUrscriptForAPortIsRefusedAtItsLine) {
  randomFor(findDialect("urscript"), 9, 300);
  ProgramInput in = input();
  in.options.motionsPerFile = 100;
  in.options.own["urscriptForm"] = std::string("port");
  const plan::Program program = writeProgram("urscript", in);
  const std::size_t end = linesOf(program.files[1].text).size() + 1;
  for (const std::string added : {"movej([0,0,0,0,0,0])\n", "junk junk\n"})
    EXPECT_TRUE(isReported(read("urscript", with(program.files, 1, end, added)), 1, end)) << added;
}

// Each of them opens its own connection to the extruder, also in a file node: each part closes it.
TEST_F(PartText, OfUrscriptSendsOnlyByAnOpenConnection) {
  randomFor(findDialect("urscript"), 9, 300);
  for (const char* form : {"port", "node"}) {
    SCOPED_TRACE(form);
    ProgramInput in = input();
    in.options.motionsPerFile = 100;
    in.options.own["urscriptForm"] = std::string(form);
    in.options.own[std::string(kExtruderOption)] = std::string("castelli-serial");
    const plan::Program program = writeProgram("urscript", in);
    const plan::ReadProgram whole = read("urscript", program.files);
    ASSERT_TRUE(whole.defects.empty() && whole.complete);
    const auto last = program.files.size() - 1;
    const std::vector<std::string> lines = linesOf(program.files[last].text);
    const auto opens = std::ranges::find_if(lines, [](const std::string& line) {
      return line.find("socket_open(") != std::string::npos;
    });
    ASSERT_NE(opens, lines.end());
    const auto changed = [&](const std::string& by) {
      std::vector<plan::ProgramFile> files = program.files;
      std::string& text = files[last].text;
      text.replace(text.find(*opens), opens->size(), by);
      return read("urscript", files);
    };
    const auto at = static_cast<std::size_t>(opens - lines.begin()) + 1;
    std::string name = *opens, address = *opens;
    name.replace(name.find("\"extruder\""), 10, "\"other\"");
    address.replace(address.find(",5000,"), 6, ",5001,");
    for (const std::string& by : {std::string("  sync()\n"), name}) {
      const plan::ReadProgram read = changed(by);
      EXPECT_TRUE(isReported(read, last, at + 1)) << by;
      // Nothing is deposited by it.
      for (const plan::ProgramMotion& motion : read.motions)
        EXPECT_FALSE(motion.file == last && motion.extruding) << by << motion.line;
    }
    EXPECT_TRUE(isReported(changed(address), last, at + 1));
  }
}

// The first module stays loaded, and `main` is then ambiguous.
TEST_F(PartText, ASecondMainOfRapidIsRefusedAtItsLine) {
  const plan::Program program = programFor("rapid");
  const std::vector<std::string> part = linesOf(program.files[1].text);
  const auto last = std::ranges::find(part, "ENDMODULE\r\n");
  ASSERT_NE(last, part.end());
  const auto at = static_cast<std::size_t>(last - part.begin()) + 1;
  const auto files = with(program.files, 1, at, "  PROC main()\r\n    Stop;\r\n  ENDPROC\r\n");
  EXPECT_TRUE(isReported(read("rapid", files), 1, at));
  const auto local = with(program.files, 1, at, "  LOCAL PROC main()\r\n  ENDPROC\r\n");
  EXPECT_TRUE(read("rapid", local).defects.empty());
}

// Lines after End are not run, but set the values of variables.
TEST_F(PartText, SettingsBehindTheEndOfMelfaCountForNothing) {
  const plan::Program program = programFor("melfa");
  auto files = program.files;
  std::vector<std::string> lines = linesOf(files[1].text);
  const auto nozzle = std::ranges::find_if(lines, [](const std::string& line) {
    return line.find("P_WkCord(1)=") != std::string::npos;
  });
  ASSERT_NE(nozzle, lines.end());
  const std::string statement = nozzle->substr(nozzle->find(' ') + 1);
  lines.erase(nozzle);
  files[1].text.clear();
  for (const std::string& line : lines)
    files[1].text += line;
  files[1].text += statement;
  EXPECT_FALSE(read("melfa", files).defects.empty());
}

} // namespace
} // namespace voluta::program
