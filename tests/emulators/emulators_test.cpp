// Exported senders, run against emulators of their receivers (emulators.py).
#include "program/program_fixture.h"

#include <array>
#include <cstdio>
#include <sys/wait.h>

namespace voluta::program {
namespace {

struct Ended {
  int code = -1;
  std::string said;
};

class Emulators : public test::Programs {
protected:
  // The files of a format; `arm` is that of the bench.
  plan::Program written(const std::string& format, const char* arm = nullptr,
                        const char* extruder = nullptr) {
    std::string json = test::kCellJson;
    if (arm)
      json.replace(json.find("\"ur5\""), 5, arm);
    if (extruder)
      json.insert(json.find("\"label\""), "\"extruder\": \"" + std::string(extruder) + "\", ");
    const test::TemporaryFolder folder;
    base::writeFile(folder / "bench.json", json);
    cell_.emplace(robot::Cell::read(folder / "bench.json", process_,
                                    {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}));
    trajectory_ = {};
    plan_ = {};
    appendRandom(5, 400);
    return writeProgram(format, input());
  }

  // Writes the files, each changed by `change`, and runs the emulator on them.
  static Ended run(const std::string& kind, const plan::Program& program,
                   const std::string& fault = {},
                   const std::function<std::string(std::string)>& change = {}) {
    const test::TemporaryFolder folder;
    for (const plan::ProgramFile& file : program.files)
      base::writeFile(folder / file.name,
                      change && file.name.ends_with(".py") ? change(file.text) : file.text);
    const std::string command = std::string(VOLUTA_PYTHON) + " " + VOLUTA_SOURCE_DIR +
                                "/tests/emulators/emulators.py " + kind + " " +
                                folder.path().string() + " " + fault + " 2>&1";
    Ended ended;
    FILE* pipe = ::popen(command.c_str(), "r");
    if (!pipe)
      return ended;
    std::array<char, 512> text{};
    while (std::fgets(text.data(), static_cast<int>(text.size()), pipe))
      ended.said += text.data();
    const int status = ::pclose(pipe);
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return ended;
  }

  static void expectTaken(const Ended& ended) {
    EXPECT_EQ(ended.code, 0) << ended.said;
    EXPECT_TRUE(ended.said.starts_with("taken ")) << ended.said;
    EXPECT_GT(std::atoi(ended.said.c_str() + 6), 20) << ended.said;
  }
  static void expectWrong(const Ended& ended, const std::string& why) {
    EXPECT_EQ(ended.code, 1) << ended.said;
    EXPECT_NE(ended.said.find(why), std::string::npos) << ended.said;
  }

  static std::function<std::string(std::string)> replacing(std::string was, std::string is) {
    return [was, is](std::string text) {
      const std::size_t at = text.find(was);
      EXPECT_NE(at, std::string::npos) << was;
      return at == std::string::npos ? text : text.replace(at, was.size(), is);
    };
  }
};

TEST_F(Emulators, DataLinkTakesEveryLine) {
  const plan::Program program = written("melfa-datalink", "\"rv2f\"");
  expectTaken(run("datalink", program));
  expectWrong(run("datalink", program, "close"), "the controller has closed the link");
  expectWrong(run("datalink", program, "silent", replacing("600, 600", "600, 2")), "timed out");
  // Senders that are not the exported one.
  expectWrong(run("datalink", program, {},
                  replacing("for line in lines(path):", "for line in list(lines(path))[1:]:")),
              "line 1 is");
  expectWrong(run("datalink", program, {}, replacing("10003, 16,", "10003, 10000,")), "too many");
}

TEST_F(Emulators, EkiTakesEveryRecord) {
  const plan::Program program = written("krl-eki");
  expectTaken(run("eki", program));
  expectWrong(run("eki", program, "close"), "the controller has closed the link");
  expectWrong(run("eki", program, "silent", replacing("600, 600", "600, 2")), "timed out");
  expectWrong(
      run("eki", program, {}, replacing("NAMES = \"XYZABCVWFD\"", "NAMES = \"YXZABCVWFD\"")),
      "not a record of the channel");
}

TEST_F(Emulators, MxtTakesEveryPacket) {
  const plan::Program program = written("melfa-stream", "\"rv2f\"");
  expectTaken(run("mxt", program));
  expectWrong(run("mxt", program, "silent"), "timed out");
}

TEST_F(Emulators, UrscriptReceiverCallsBackForItsRows) {
  const plan::Program program = written("urscript-stream");
  expectTaken(run("urscript", program));
  expectWrong(run("urscript", program, {},
                  replacing("yield \"(\" + row + \")\\n\"",
                            "yield \"(\" + row.replace(\"2,\", \"3,\", 1) + \")\\n\"")),
              "instead of");
}

TEST_F(Emulators, CastelliBoardTakesEveryText) {
  expectTaken(run("castelli", written("urscript", nullptr, "castelli-serial")));
}

} // namespace
} // namespace voluta::program
