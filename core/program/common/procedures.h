// Programs of procedures without arguments, one statement per line, in several files (KRL, SPEL+):
// finds the procedures and runs them, starting with the first.
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

// Structural role of a line in a program.
enum class LinePart { Begins, Ends, Other };

class Procedures {
public:
  struct Words {
    LineSyntax syntax;
    // `name`: returns the name of the procedure that the line begins, in lower case; empty if it is
    // not a valid procedure header.
    LinePart (*part)(LineCursor line, std::string& name) = nullptr;
  };
  // Both arguments must outlive the object.
  Procedures(const Words& words, ProgramBuilder& out, const base::RunContext& ctx)
      : words_(words), out_(out), ctx_(ctx) {}

  // Called with each non-empty line of code; out.file and out.line give its place.
  using Statement = std::function<void(std::string_view code)>;
  // Finds the procedures of all files and passes statements outside of them to `outside`. Adds
  // defects for unmatched begins or ends and for empty files; returns false if there was one.
  bool find(const std::vector<plan::ProgramFile>& files, const Statement& outside);
  // Runs the first procedure of the first file. Returns false if there is none, or if a file was
  // never reached.
  bool run(const Statement& statement);
  // To be called from a statement: runs that procedure. Returns false if it is unknown. A recursive
  // call is a defect.
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
