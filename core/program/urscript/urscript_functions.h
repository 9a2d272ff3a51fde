// The functions of URScript programs without arguments, in several files, and the code outside of
// them.
#pragma once

#include "plan/program.h"
#include "program/program_builder.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

class UrscriptFunctions {
public:
  // The builder must outlive the object; its file and line are the current position.
  explicit UrscriptFunctions(ProgramBuilder& out) : out_(out) {}

  struct Line {
    std::size_t number;
    std::string_view code;
  };
  // Lines [first, end) of its body, of those with code; the line of its `def`, from 1.
  struct Function {
    std::size_t file, first, end, head;
    bool isCalled = false;
  };
  struct File {
    std::vector<Line> lines; // with code
    // Per definition at top level, by its own line: the line after it.
    std::map<std::size_t, std::size_t> behind;
    std::size_t last = 0;                  // line of the text
    std::string_view defined;              // function defined last
    bool mustCall = false, isPart = false; // as the file's notes say
    bool closed = true;
    bool isReached = false; // runs by itself, or a function of it is called
    bool isRun = false;     // runs by itself
  };

  // Finds the functions at top level of all files. Adds defects for definitions that are none.
  void find(const std::vector<plan::ProgramFile>& files);
  // Reads the definition in line i of the current file and sets i to the line after its end.
  // Returns false if there is none.
  bool define(std::size_t& i);

  File& file() { return files_[out_.file]; }
  bool contains(std::string_view name) const { return functions_.contains(name); }
  // Precondition: contains(name).
  const Function& call(std::string_view name);

  // Adds a defect for each line outside of functions in a file that only calls reach, and for each
  // function there that nothing calls: the controller runs that line when it reaches the file.
  void refuseBesideParts();

  static bool isDefinition(std::string_view code);

private:
  void collect(std::string_view text);

  ProgramBuilder& out_;
  std::vector<File> files_;
  std::map<std::string, Function, std::less<>> functions_;
};

} // namespace voluta::program
