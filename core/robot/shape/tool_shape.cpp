#include "robot/shape/tool_shape.h"

#include "robot/body.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr Rgb kBrass{0.80, 0.62, 0.30}, kSteel{0.70, 0.72, 0.74}, kBlock{0.55, 0.57, 0.60},
    kCasing{0.30, 0.33, 0.37}, kMotor{0.17, 0.18, 0.20}, kRail{0.74, 0.76, 0.78},
    kSlot{0.32, 0.34, 0.36}, kClamp{0.24, 0.26, 0.29};
// Side of a square with rounded corners inscribed in a circle, divided by the circle's radius
constexpr double kInSquare = 1.38;
constexpr double kRailFromRadii = 12.0; // A holder at least this many radii long is drawn as a rail
constexpr double kClampMm = 12.0;

class Builder {
public:
  explicit Builder(const Body& body) : body_(body) {}

  std::vector<ShapeSolid> head() {
    std::vector<Frustum> parts;
    for (const Shape& shape : body_.shapes)
      if (const auto* part = std::get_if<Frustum>(&shape))
        parts.push_back(*part);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Frustum& part = parts[i];
      const bool round = std::abs(part.r0 - part.r1) < 0.05 * part.r1;
      if (i == 0 || !round)
        addNozzle(part);
      else if (i + 1 < parts.size())
        addHotEnd(part);
      else
        addExtruder(part);
    }
    return std::move(solids_);
  }

  std::vector<ShapeSolid> holder() {
    for (std::size_t i = 0; i < body_.shapes.size(); ++i) {
      const auto* part = std::get_if<Frustum>(&body_.shapes[i]);
      if (!part)
        continue;
      const double length = (part->p1 - part->p0).norm(), r = std::min(part->r0, part->r1);
      if (length > kRailFromRadii * r)
        addRail(*part, length, r);
      else
        addTube(*part, length, r, i == 0, i + 1 == body_.shapes.size());
    }
    return std::move(solids_);
  }

  std::vector<ShapeSolid> stem() {
    for (const Shape& shape : body_.shapes)
      if (const auto* part = std::get_if<Frustum>(&shape)) {
        const double length = (part->p1 - part->p0).norm();
        add(kClamp, part->p0, part->p1 - part->p0,
            {circleSection(0.0, part->r0), circleSection(length, part->r1)}, 1.0);
      }
    return std::move(solids_);
  }

private:
  void add(const Rgb& colour, const Vector3d& from, const Vector3d& axis,
           std::vector<LoftSection> sections, double roundMm) {
    solids_.push_back(
        {body_.frame, colour, {loftPose(from, axis, across(axis)), std::move(sections), roundMm}});
  }
  // Square parts are aligned with the frame's x.
  static Vector3d across(const Vector3d& axis) {
    return std::abs(axis.normalized().x()) > 0.9 ? Vector3d::UnitY() : Vector3d::UnitX();
  }

  // A cone with a nut on it.
  void addNozzle(const Frustum& part) {
    const Vector3d axis = part.p1 - part.p0;
    const double length = axis.norm(), nut = 0.6 * length;
    const double atNut = part.r0 + 0.6 * (part.r1 - part.r0);
    add(kBrass, part.p0, axis, {circleSection(0.0, part.r0), circleSection(nut, atNut)}, 0.0);
    const double corner = 0.06 * atNut;
    LoftSection hexagon{nut, {}};
    for (int i = 0; i < 6; ++i) {
      const double angle = i * base::kPi / 3.0;
      hexagon.discs.push_back(
          {(atNut - corner) * Vector2d(std::cos(angle), std::sin(angle)), corner});
    }
    LoftSection upper = hexagon;
    upper.at = length;
    add(kBrass, part.p0, axis, {hexagon, upper}, 0.0);
  }

  // Heater block, heat break and fins.
  void addHotEnd(const Frustum& part) {
    const Vector3d axis = part.p1 - part.p0, unit = axis.normalized();
    const double length = axis.norm(), r = std::min(part.r0, part.r1);
    const double block = std::min(1.2 * r, 0.45 * length);
    add(kBlock, part.p0, axis,
        {rectangleSection(0.0, Vector2d(kInSquare * r, kInSquare * r), 0.1 * r),
         rectangleSection(block, Vector2d(kInSquare * r, kInSquare * r), 0.1 * r)},
        0.06 * r);
    add(kSteel, part.p0, axis,
        {circleSection(block - 0.2, 0.3 * r), circleSection(length, 0.3 * r)}, 0.0);
    const double from = block + 0.25 * r, room = length - from;
    const int fins = std::max(1, static_cast<int>(room / (0.36 * r)));
    const double pitch = room / fins;
    for (int i = 0; i < fins; ++i)
      add(kSteel, part.p0 + (from + i * pitch) * unit, axis,
          {circleSection(0.0, 0.94 * r), circleSection(0.5 * pitch, 0.94 * r)}, 0.0);
  }

  // Drive housing with a cover, with the motor behind it.
  void addExtruder(const Frustum& part) {
    const Vector3d axis = part.p1 - part.p0, unit = axis.normalized();
    const double length = axis.norm(), side = kInSquare * std::min(part.r0, part.r1);
    const auto square = [&](double at, double share) {
      return rectangleSection(at, Vector2d(share * side, share * side), 0.14 * side);
    };
    const double drive = 0.42 * length;
    add(kCasing, part.p0, axis, {square(0.0, 0.86), square(0.12 * drive, 1.0), square(drive, 1.0)},
        1.2);
    add(kSteel, part.p0 + drive * unit, axis, {square(-0.5, 0.95), square(3.0, 0.95)}, 0.4);
    add(kMotor, part.p0 + drive * unit, axis,
        {square(2.5, 0.985), square(length - drive - 3.0, 0.985)}, 0.8);
    add(kSteel, part.p0 + drive * unit, axis,
        {square(length - drive - 3.2, 0.93), square(length - drive, 0.93)}, 0.5);
    const Vector3d x = across(axis);
    add(kBrass, part.p0 + 0.5 * drive * unit + (0.5 * side - 0.5) * x, x,
        {circleSection(0.0, 0.22 * side), circleSection(1.5, 0.22 * side)}, 0.4);
  }

  void addTube(const Frustum& part, double length, double r, bool first, bool last) {
    const Vector3d axis = part.p1 - part.p0, unit = axis.normalized();
    add(kSteel, part.p0, axis, {circleSection(0.2, 0.66 * r), circleSection(length, 0.66 * r)},
        0.5);
    const double clamp = std::min(kClampMm, 0.3 * length);
    if (first)
      add(kClamp, part.p0, axis, {circleSection(0.0, 0.98 * r), circleSection(clamp, 0.98 * r)},
          1.0);
    if (last)
      add(kClamp, part.p1 - clamp * unit, axis,
          {circleSection(0.0, 0.98 * r), circleSection(clamp, 0.98 * r)}, 1.0);
    else
      addBall(part.p1, unit, 0.8 * r);
  }

  // At a bend.
  void addBall(const Vector3d& centre, const Vector3d& axis, double r) {
    std::vector<LoftSection> sections;
    for (int i = 0; i <= 8; ++i) {
      const double a = (i - 4) * 0.38;
      sections.push_back(circleSection(r * std::sin(a), r * std::cos(a)));
    }
    add(kClamp, centre, axis, std::move(sections), 0.1 * r);
  }

  // A square profile with a slot along each side.
  void addRail(const Frustum& part, double length, double r) {
    const Vector3d axis = part.p1 - part.p0;
    const double side = kInSquare * r;
    const auto bar = [&](double at, double w, double h, double round) {
      return rectangleSection(at, Vector2d(w, h), round);
    };
    add(kRail, part.p0, axis,
        {bar(0.3, side, side, 0.06 * side), bar(length, side, side, 0.06 * side)}, 0.5);
    const double proud = side + 0.8, slot = 0.26 * side;
    add(kSlot, part.p0, axis, {bar(1.0, slot, proud, 0.3), bar(length - 1.0, slot, proud, 0.3)},
        0.0);
    add(kSlot, part.p0, axis, {bar(1.0, proud, slot, 0.3), bar(length - 1.0, proud, slot, 0.3)},
        0.0);
    add(kClamp, part.p0, axis, {circleSection(0.0, 0.98 * r), circleSection(kClampMm, 0.98 * r)},
        1.0);
  }

  const Body& body_;
  std::vector<ShapeSolid> solids_;
};

} // namespace

std::vector<ShapeSolid> toolShape(const Body& body) {
  switch (body.role) {
  case BodyRole::Head:
    return Builder(body).head();
  case BodyRole::Holder:
    return Builder(body).holder();
  case BodyRole::Platform:
    return Builder(body).stem();
  default:
    return {};
  }
}

} // namespace voluta::robot
