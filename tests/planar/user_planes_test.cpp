// Planes that a user gives, as text.
#include "planar/slicing/user_planes.h"

#include "base/error.h"

#include <gtest/gtest.h>

namespace voluta::planar {
namespace {

TEST(UserPlanes, WrongOnesAreRefusedWithTheirPlace) {
  for (const char* wrong :
       {"", "{}", "[]", "[3]", R"([{"point": [0,0], "normal": [0,0,1]}])",
        R"([{"point": [0,0,1], "normal": [0,0,0]}])", R"([{"corners": [[0,0,0],[1,0,0],[1,1,0]]}])",
        R"([{"corners": [[0,0,0],[9,0,0],[9,9,5],[0,9,0]]}])",
        R"([{"corners": [[0,0,0],[9,0,0],[1,1,0],[0,9,0]]}])"})
    EXPECT_THROW(readUserPlanes(wrong, "here"), base::Error) << wrong;
}

} // namespace
} // namespace voluta::planar
