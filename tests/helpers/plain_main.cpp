#include "helpers/kept_source.h"

#include <gmock/gmock.h>

// test_NAME [--source=NAME_test.cpp]: all cases, or those of one source file.
int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  return voluta::test::keepCasesOfSource(argc, argv) ? RUN_ALL_TESTS() : 1;
}
