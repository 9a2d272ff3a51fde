// One process for each source file of tests: data shared by its cases is made once.
#pragma once

namespace voluta::test {

// Sets the filter to the cases of the source that `--source=NAME_test.cpp` names, if that is an
// argument. Returns whether the program can go on: false, with a line on stderr, if that source has
// no cases, or if a case is in a file that is not named ..._test.cpp, which ctest has no entry for.
// Precondition: testing::InitGoogleTest was called.
bool keepCasesOfSource(int argc, char** argv);

} // namespace voluta::test
