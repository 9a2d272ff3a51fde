#include "build3mf/build_layer_reader.h"

#include "base/error.h"
#include "base/far_places.h"
#include "base/lower_case.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace voluta::build3mf {

using base::Error;
using base::ErrorCode;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using geometry::XmlAttributes;
using geometry::XmlName;

namespace {

constexpr std::size_t kMaxWaypoints = 20'000'000;
constexpr double kStepMm = 0.1;       // Length over which a stepwise change of section is spread
constexpr double kSameShare = 1e-4;   // Tolerance within which sections are the same
constexpr double kMinLengthMm = 1e-6; // Shorter lines deposit nothing

// A point's values by factor, at the line's begin and end; NaN: not given.
struct Factors {
  std::array<double, 4> from, to;
  Factors() { from.fill(nan()), to.fill(nan()); }
  static double nan() { return std::numeric_limits<double>::quiet_NaN(); }
};
struct Support { // A <sub>
  double t = 0.0;
  std::array<double, 4> at{};
};
struct Point {
  Vector3d position = Vector3d::Zero();
  Quaterniond frame = Quaterniond::Identity();
  Factors factors; // Of the line that ends at this point
  std::vector<Support> supports;
};

Error wrong(const base::Message& what) {
  return Error(ErrorCode::UnreadableFile, what);
}

double factorOf(const XmlAttributes& attributes, std::string_view word) {
  const double value = attributes.number(word);
  if (value < 0.0 || value > 1.0)
    throw wrong(base::message("the factor '{factor}' is not within 0 and 1"_text, word));
  return value;
}

Factors factorsOf(const XmlAttributes& attributes) {
  Factors factors;
  for (std::size_t k = 0; k < kFactors.size(); ++k) {
    const std::string letter(1, kFactors[k]), first = letter + "1", second = letter + "2";
    const bool pair = attributes.has(first) || attributes.has(second);
    if (attributes.has(letter)) {
      if (pair)
        throw wrong(base::message("the factor '{factor}' is given twice"_text, letter));
      factors.from[k] = factors.to[k] = factorOf(attributes, letter);
    } else if (pair) {
      factors.from[k] = factorOf(attributes, first);
      factors.to[k] = factorOf(attributes, second);
    }
  }
  return factors;
}

// A part of a line over which values change linearly.
struct Piece {
  double from = 0.0, to = 1.0;
  std::array<double, 3> begin{}, end{}; // In the order of Modulated
};

// Returns the value of a factor along the line, interpolated between its ends and the supports that
// give it.
double factorAt(const Point& point, std::size_t k, double t) {
  double t0 = 0.0, v0 = point.factors.from[k], t1 = 1.0, v1 = point.factors.to[k];
  for (const Support& s : point.supports) {
    if (std::isnan(s.at[k]))
      continue;
    if (s.t <= t) {
      t0 = s.t;
      v0 = s.at[k];
    } else {
      t1 = s.t;
      v1 = s.at[k];
      break;
    }
  }
  return v0 + (t1 > t0 ? (t - t0) / (t1 - t0) : 0.0) * (v1 - v0);
}

double valueAt(const Profile& profile, std::size_t m, const Point& point, double t) {
  const Modifier& modifier = profile.modifiers[m];
  if (!profile.modified[m] || std::isnan(point.factors.from[modifier.factor]))
    return profile.nominal[m];
  return modifier.minimum +
         factorAt(point, modifier.factor, t) * (modifier.maximum - modifier.minimum);
}

std::vector<Piece> piecesOf(const Profile& profile, const Point& point) {
  std::vector<double> at{0.0};
  for (const Support& s : point.supports)
    at.push_back(s.t);
  at.push_back(1.0);
  std::vector<Piece> pieces;
  for (std::size_t i = 1; i < at.size(); ++i) {
    Piece piece{at[i - 1], at[i], {}, {}};
    for (std::size_t m = 0; m < 3; ++m) {
      piece.begin[m] = valueAt(profile, m, point, piece.from);
      piece.end[m] = valueAt(profile, m, point, piece.to);
    }
    pieces.push_back(piece);
  }
  return pieces;
}

bool same(double a, double b) {
  return std::abs(a - b) <= kSameShare * std::max(std::abs(a), std::abs(b));
}

// Converts the points of a segment to waypoints.
class Laying {
public:
  Laying(const Profile& profile, const std::vector<Point>& points, plan::ToolPlan& into)
      : profile_(profile), points_(points), into_(into), first_(into.waypointCount()) {}

  // Returns the number of waypoints; fewer than two: the segment deposits nothing.
  std::size_t lay() {
    const Point* last = nullptr;
    for (const Point& point : points_) {
      if (!last) {
        last = &point;
        continue;
      }
      if ((point.position - last->position).norm() < kMinLengthMm)
        continue;
      for (const Piece& piece : piecesOf(profile_, point))
        addPiece(*last, point, piece);
      last = &point;
    }
    const std::size_t count = into_.waypointCount() - first_;
    if (count > 0)
      into_.speedMmPerS[first_] = into_.speedMmPerS[first_ + 1];
    return count;
  }

private:
  void addPiece(const Point& a, const Point& b, const Piece& piece) {
    const double distance = (b.position - a.position).norm();
    const double speed = 0.5 * (piece.begin[2] + piece.end[2]);
    if (into_.waypointCount() == first_) {
      add(a, b, piece.from, piece.begin[0], piece.begin[1], speed);
    } else if (!same(into_.widthMm.back(), piece.begin[0]) ||
               !same(into_.heightMm.back(), piece.begin[1])) {
      const double within = std::min(kStepMm / distance, 0.25 * (piece.to - piece.from));
      add(a, b, piece.from + within, piece.begin[0], piece.begin[1], speed);
    }
    add(a, b, piece.to, piece.end[0], piece.end[1], speed);
  }

  void add(const Point& a, const Point& b, double t, double width, double height, double speed) {
    if (into_.waypointCount() >= kMaxWaypoints)
      throw Error(ErrorCode::UnusableInput, "more tool-path points than can be planned"_text);
    // Interpolated the shorter way round and normalised (Part II, 1.4.2).
    Quaterniond end = b.frame;
    if (a.frame.dot(end) < 0.0)
      end.coeffs() = -end.coeffs();
    Quaterniond frame;
    frame.coeffs() = (1.0 - t) * a.frame.coeffs() + t * end.coeffs();
    into_.position.push_back(t < 1.0 ? Vector3d(a.position + t * (b.position - a.position))
                                     : b.position);
    into_.direction.push_back(frame.normalized() * Vector3d::UnitZ());
    into_.widthMm.push_back(static_cast<float>(width));
    into_.heightMm.push_back(static_cast<float>(height));
    into_.speedMmPerS.push_back(static_cast<float>(speed));
  }

  const Profile& profile_;
  const std::vector<Point>& points_;
  plan::ToolPlan& into_;
  std::size_t first_;
};

class LayerReader {
public:
  LayerReader(const LayerFrame& frame, ReadBuild& into) : frame_(frame), into_(into) {}

  void begin(XmlName name, const XmlAttributes& attributes) {
    if (inData_ > 0 || name.space != kToolpathSpace) {
      inData_ += inData_ > 0;
      return;
    }
    if (!begun_) {
      if (name.word != "layer")
        throw wrong("is not a layer of tool-paths"_text);
      begun_ = true;
    } else if (name.word == "data") {
      inData_ = 1;
    } else if (name.word == "part") {
      parts_.insert(attributes.integer("id"));
    } else if (name.word == "profile") {
      const std::string uuid = base::lowerCase(attributes.text("uuid"));
      const auto known = frame_.profiles.find(uuid);
      if (known == frame_.profiles.end())
        throw wrong(base::message("the profile '{uuid}' is not in the model"_text, uuid));
      profiles_[attributes.integer("id")] = &known->second;
    } else if (name.word == "segment") {
      beginSegment(attributes);
    } else if (name.word == "sub") {
      addSupport(attributes);
    } else if (name.word == "point6d" || name.word == "point3d" || name.word == "point" ||
               name.word == "hatch") {
      if (!profile_ || name.word != pointWord())
        throw wrong(base::message("an unexpected {point}"_text, name.word));
      if (name.word == "hatch")
        addHatch(attributes);
      else
        addPoint(attributes);
    }
  }
  void end(XmlName name) {
    if (inData_ > 0)
      --inData_;
    else if (name == XmlName{kToolpathSpace, "segment"} && profile_)
      endSegment();
  }
  bool inData() const { return inData_ > 0; }
  bool begun() const { return begun_; }

private:
  void beginSegment(const XmlAttributes& attributes) {
    type_ = attributes.text("type");
    const bool flat = type_ == "polyline" || type_ == "loop" || type_ == "hatch";
    if (frame_.axes == PathAxes::Planar ? !flat
                                        : type_ != (sixAxes() ? "polyline6d" : "polyline3d"))
      throw wrong(base::message("a segment of type '{type}' among tool-paths of {axes} axes"_text,
                                type_,
                                frame_.axes == PathAxes::Planar ? 2
                                : sixAxes()                     ? 6
                                                                : 3));
    const long long profile = attributes.integer("profileid"), part = attributes.integer("partid");
    if (!profiles_.contains(profile))
      throw wrong(base::message("the profile {id} of a segment is not in its layer"_text, profile));
    if (!parts_.contains(part))
      throw wrong(base::message("the part {id} of a segment is not in its layer"_text, part));
    profile_ = profiles_.at(profile);
    path_ = {};
    path_.kind = profile_->kind;
    const auto own = [&](std::string_view word, int otherwise) {
      const long long value = attributes.integerOr(word, otherwise, kOwnSpace);
      if (value < -1 || value > std::numeric_limits<int>::max())
        throw wrong(base::message("'{attribute}' is not an integer"_text, word));
      return static_cast<int>(value);
    };
    path_.layer = own("layer", frame_.layer);
    path_.patch = own("patch", 0);
    path_.group = own("group", 0);
    points_.clear();
    hatches_ = 0;
  }

  bool sixAxes() const { return frame_.axes == PathAxes::Six; }
  std::string_view pointWord() const {
    if (frame_.axes == PathAxes::Planar)
      return type_ == "hatch" ? "hatch" : "point";
    return sixAxes() ? "point6d" : "point3d";
  }

  // Coordinates by attribute name; of two the layer gives the third.
  template <std::size_t N>
  Vector3d positionOf(const XmlAttributes& attributes,
                      const std::array<std::string_view, N>& axes) const {
    Vector3d position(0.0, 0.0, frame_.topMm);
    for (std::size_t k = 0; k < N; ++k)
      position[static_cast<Eigen::Index>(k)] =
          frame_.unitMm * static_cast<double>(attributes.integer(axes[k]));
    if (!(position.cwiseAbs().maxCoeff() <= base::kFarthestMm))
      throw wrong("a point more than a kilometre away"_text);
    return position;
  }

  // A separate line.
  void addHatch(const XmlAttributes& attributes) {
    points_.assign(2, Point());
    points_[0].position = positionOf<2>(attributes, {"x1", "y1"});
    points_[1].position = positionOf<2>(attributes, {"x2", "y2"});
    points_[1].factors = factorsOf(attributes);
    ++hatches_;
    layPath();
    points_.clear();
  }

  void addPoint(const XmlAttributes& attributes) {
    Point point;
    point.position = frame_.axes == PathAxes::Planar ? positionOf<2>(attributes, {"x", "y"})
                                                     : positionOf<3>(attributes, {"x", "y", "z"});
    if (sixAxes()) {
      point.frame = Quaterniond(attributes.number("w"), attributes.number("i"),
                                attributes.number("j"), attributes.number("k"));
      const double norm = point.frame.norm();
      if (!(norm > 1e-9) || !std::isfinite(norm))
        throw wrong("a point's frame has no direction"_text);
      point.frame.coeffs() /= norm;
    }
    point.factors = factorsOf(attributes);
    if (points_.size() >= kMaxWaypoints)
      throw Error(ErrorCode::UnusableInput, "more tool-path points than can be planned"_text);
    points_.push_back(std::move(point));
  }

  void addSupport(const XmlAttributes& attributes) {
    if (!profile_ || points_.empty())
      throw wrong("a modifier's support point outside a point"_text);
    Point& point = points_.back();
    Support support{attributes.number("t"), {}};
    const double before = point.supports.empty() ? 0.0 : point.supports.back().t;
    if (!(support.t > before) || !(support.t < 1.0))
      throw wrong("a modifier's support points do not increase between 0 and 1"_text);
    for (std::size_t k = 0; k < kFactors.size(); ++k) {
      const std::string letter(1, kFactors[k]);
      support.at[k] = attributes.has(letter) ? factorOf(attributes, letter) : Factors::nan();
    }
    point.supports.push_back(support);
  }

  // Rejects factors finer than the modifier's type allows (Part I, 4.2).
  void checkFineness() const {
    for (std::size_t m = 0; m < 3; ++m) {
      if (!profile_->modified[m])
        continue;
      const Modifier& modifier = profile_->modifiers[m];
      for (const Point& point : points_) {
        const bool linear =
            !std::isnan(point.factors.from[modifier.factor]) &&
            point.factors.from[modifier.factor] != point.factors.to[modifier.factor];
        const bool bent =
            std::any_of(point.supports.begin(), point.supports.end(),
                        [&](const Support& s) { return !std::isnan(s.at[modifier.factor]); });
        if ((linear && modifier.type == ModifierType::Constant) ||
            (bent && modifier.type != ModifierType::Nonlinear))
          throw wrong(base::message(
              "factors of '{attribute}' are finer than its modifier's type allows"_text,
              kModulatedNames[m]));
      }
    }
  }

  void endSegment() {
    if (type_ == "hatch") {
      if (hatches_ == 0)
        throw wrong("a segment of fewer than two points"_text);
    } else {
      if (points_.size() < (type_ == "loop" ? 3 : 2))
        throw wrong("a segment of fewer than two points"_text);
      if (type_ == "loop")
        points_.push_back(points_.front()); // A zero-length path deposits nothing
      layPath();
    }
    profile_ = nullptr;
  }

  void layPath() {
    checkFineness();
    const std::size_t first = into_.plan.waypointCount();
    const std::size_t count = Laying(*profile_, points_, into_.plan).lay();
    for (std::size_t i = first; i < first + count; ++i)
      if (!(into_.plan.heightMm[i] > 0.0f))
        into_.plan.heightMm[i] = static_cast<float>(frame_.thicknessMm);
    if (count >= 2) {
      path_.first = first;
      path_.count = count;
      path_.closed = count >= 4 && (points_.back().position - points_.front().position).norm() <=
                                       1.5 * frame_.unitMm;
      into_.plan.paths.push_back(path_);
    }
  }

  const LayerFrame& frame_;
  ReadBuild& into_;
  std::set<long long> parts_;
  std::map<long long, const Profile*> profiles_;
  const Profile* profile_ = nullptr; // Of the segment being read
  plan::ToolPath path_;
  std::string type_; // Of that segment
  std::vector<Point> points_;
  std::size_t hatches_ = 0;
  int inData_ = 0; // Nesting depth within other makers' data
  bool begun_ = false;
};

} // namespace

void readLayer(std::string_view text, const std::string& where, const LayerFrame& frame,
               ReadBuild& into) {
  LayerReader reader(frame, into);
  geometry::XmlHandler handler;
  handler.begin = [&](XmlName name, const XmlAttributes& attributes) {
    reader.begin(name, attributes);
  };
  handler.end = [&](XmlName name) { reader.end(name); };
  handler.cdata = [&] {
    if (reader.inData())
      throw wrong("unparsed text in a layer's data"_text);
  };
  geometry::scanXml(text, where, handler);
  if (!reader.begun())
    throw Error(ErrorCode::UnreadableFile, "is not a layer of tool-paths"_text, where);
}

} // namespace voluta::build3mf
