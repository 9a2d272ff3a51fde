// Programs that are procedures without arguments, a statement a line, over some files (KRL, SPEL+):
// found, then run in turn from the first one.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/common/line_cursor.h"
#include "program/program_builder.h"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// What a line is to the structure of a program.
enum class LinePart { Begins, Ends, Other };

class Procedures {
public:
  struct Words {
    LineSyntax syntax;
    // `name`: of the procedure that it begins, in small letters; empty: not the head of one that is
    // read.
    LinePart (*part)(LineCursor line, std::string& name) = nullptr;
  };
  // Both keep what they are given for as long as they live.
  Procedures(const Words& words, ProgramBuilder& out, const base::RunContext& ctx)
      : words_(words), out_(out), ctx_(ctx) {}

  // Called with a line of code, none of them empty; out.file and out.line are its place.
  using Statement = std::function<void(std::string_view code)>;
  // Finds the procedures of all files; `outside` is given each statement that stands in none.
  // Defects: what begins or ends twice, a file that is empty. false: there was one.
  bool find(const std::vector<plan::ProgramFile>& files, const Statement& outside);
  // Runs the first file's first procedure. false: there is none, or a file was not come to.
  bool run(const Statement& statement);
  // Within a statement: runs that procedure. false: it is not known, or calls itself (a defect).
  bool call(const std::string& name);
  bool contains(const std::string& name) const { return procedures_.contains(name); }

private:
  struct Line {
    std::size_t number;
    std::string_view code;
  };
  struct Procedure {
    std::size_t file = 0, first = 0, end = 0; // lines of the file's code
  };
  bool findIn(std::size_t file, const Statement& outside);
  void runLines(const Procedure& procedure);

  const Words& words_;
  ProgramBuilder& out_;
  const base::RunContext& ctx_;
  std::vector<std::vector<Line>> lines_; // per file
  std::map<std::string, Procedure, std::less<>> procedures_;
  std::string first_;
  std::vector<std::string> running_;
  std::vector<bool> cameTo_; // per file
  const Statement* statement_ = nullptr;
  std::size_t statements_ = 0, calls_ = 0;
};

} // namespace voluta::program
