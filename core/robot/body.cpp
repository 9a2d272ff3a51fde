#include "robot/body.h"

namespace voluta::robot {

base::Value nameOf(const Body& body) {
  switch (body.role) {
  case BodyRole::Head:
    return "head"_text;
  case BodyRole::Holder:
    return "holder"_text;
  case BodyRole::Platform:
    return "platform"_text;
  default:
    return body.name;
  }
}

} // namespace voluta::robot
