#include "planar/slicing/support_columns.h"

#include "base/units.h"
#include "planar/slicing/section_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace voluta::planar {

using ClipperLib::Path;
using ClipperLib::Paths;
using Eigen::Vector3d;

namespace {

constexpr double kArcMm = 0.05;          // of round corners
constexpr double kSliverMm = 0.1;        // half of the minimum width
constexpr double kNarrowest = 0.25;      // of a bead: smaller overhangs need no column
constexpr double kMinPrintedWidth = 0.5; // of a bead: narrower areas stay empty
constexpr double kNarrowColumn = 0.9;    // of a bead
constexpr double kNarrowFooting = 0.45;  // of a bead: its middle is supported
constexpr double kTaper = 0.5; // of a layer's permitted overhang: a bead's middle stays supported
constexpr double kTrunk = 4.0; // beads: minimum width to which columns taper downwards
// Of the first layer: depth below a base at which its support is checked
constexpr double kUnderBase = 0.25;

Paths pathsOf(const Section& section, const PlaneFrame& frame) {
  Paths loops = loopsOf(section, frame);
  ClipperLib::SimplifyPolygons(loops, ClipperLib::pftNonZero);
  return cleaned(std::move(loops));
}

Paths combined(const Paths& a, const Paths& b, ClipperLib::ClipType how) {
  return cleaned(geometry::combined(a, b, how));
}
Paths united(const Paths& a, const Paths& b) {
  return combined(a, b, ClipperLib::ctUnion);
}
Paths without(const Paths& a, const Paths& b) {
  return a.empty() || b.empty() ? a : combined(a, b, ClipperLib::ctDifference);
}
Paths shared(const Paths& a, const Paths& b) {
  return a.empty() || b.empty() ? Paths() : combined(a, b, ClipperLib::ctIntersection);
}

Paths grown(const Paths& a, double byMm, ClipperLib::JoinType corners = ClipperLib::jtRound) {
  if (a.empty())
    return a;
  return cleaned(geometry::offsetPaths(a, byMm, {.arcMm = kArcMm, .corners = corners}));
}
// Removes areas narrower than twice `byMm`.
Paths opened(const Paths& a, double byMm) {
  return grown(grown(a, -byMm), byMm);
}

// Returns each outline with its holes.
std::vector<Paths> components(const Paths& paths) {
  ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
  clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  std::vector<Paths> out;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node; node = node->GetNext()) {
    if (node->IsHole())
      continue;
    Paths one{node->Contour};
    for (const ClipperLib::PolyNode* hole : node->Childs)
      one.push_back(hole->Contour);
    out.push_back(std::move(one));
  }
  return out;
}

// Shrinks by `byMm` where at least a trunk is left. Printable thinner areas stay, wherever they are
// attached.
Paths tapered(const Paths& a, double byMm, double beadWidthMm) {
  if (a.empty() || byMm <= 0.0)
    return a;
  const double half = byMm + 0.5 * kTrunk * beadWidthMm;
  const Paths wide = shared(a, grown(grown(a, -half), half, ClipperLib::jtMiter));
  const Paths thin = opened(without(a, wide), 0.5 * kMinPrintedWidth * beadWidthMm);
  // The overlap joins both
  return united(grown(wide, -byMm), shared(a, grown(thin, byMm + kSliverMm)));
}

// Removes components that are narrower than twice `byMm` everywhere. Others keep their shape:
// rounding corners at every level would consume a column.
Paths wideEnough(const Paths& a, double byMm) {
  Paths out;
  for (const Paths& one : components(a))
    if (!grown(one, -byMm).empty())
      out.insert(out.end(), one.begin(), one.end());
  return out;
}

// Removes areas that cannot be printed and therefore carry nothing: components too small for a bead
// (layers::makePatches) and areas too narrow for one.
Paths printable(const Paths& a, double beadWidthMm) {
  const double quarter = 0.5 * kMinPrintedWidth * beadWidthMm;
  Paths out;
  for (const Paths& one : components(grown(grown(a, -quarter), quarter, ClipperLib::jtMiter)))
    if (geometry::areaMm2(one) >= 0.25 * base::kPi * beadWidthMm * beadWidthMm)
      out.insert(out.end(), one.begin(), one.end());
  return out;
}

// Adds a margin to components that are narrower than twice `byMm` everywhere.
Paths widened(const Paths& a, double byMm) {
  Paths out;
  for (const Paths& one : components(a))
    out = united(out, grown(one, -byMm).empty() ? grown(one, byMm) : one);
  return out;
}

// Where walls cut into a column from below and leave only a narrow rest, replaces it by a strip
// along the wall, one bead wide.
Paths besideWalls(const Paths& a, const Paths& walls, double halfBeadMm) {
  Paths wide, more;
  for (const Paths& one : components(a)) {
    const bool narrow = grown(one, -kNarrowColumn * halfBeadMm).empty();
    if (narrow && grown(one, -kSliverMm).empty())
      continue;
    const Paths part = narrow ? without(grown(one, halfBeadMm), walls) : one;
    Paths& to = narrow ? more : wide;
    to.insert(to.end(), part.begin(), part.end());
  }
  return united(wide, more);
}

// The sections of all pieces at the levels of one of them.
class Levels {
public:
  Levels(const std::vector<Piece>& pieces, std::size_t piece, const std::vector<Sections>& sections,
         const std::vector<double>& bounds, double beadWidthMm)
      : sections_(sections), piece_(piece), base_(pieces[piece].base),
        frame_(frameOf(pieces[piece].base.normal)), bounds_(bounds) {
    for (std::size_t k = 0; k < count(); ++k)
      own_.push_back(printable(at(piece, middle(k)), beadWidthMm));
  }

  std::size_t count() const { return bounds_.size() - 1; }
  double heightMm(std::size_t k) const { return bounds_[k + 1] - bounds_[k]; }
  double middle(std::size_t k) const {
    return base_.offsetMm + 0.5 * (bounds_[k] + bounds_[k + 1]);
  }
  const PlaneFrame& frame() const { return frame_; }
  const Paths& own(std::size_t k) const { return own_[k]; }
  Paths earlier(double offsetMm) const { return of(0, piece_, offsetMm); }
  Paths later(double offsetMm) const { return of(piece_ + 1, sections_.size(), offsetMm); }
  Plane plane(std::size_t k) const { return {base_.normal, middle(k)}; }

private:
  Paths at(std::size_t piece, double offsetMm) const {
    return pathsOf(sections_[piece].at(offsetMm), frame_);
  }
  Paths of(std::size_t from, std::size_t to, double offsetMm) const {
    Paths all;
    for (std::size_t p = from; p < to; ++p)
      if (offsetMm > sections_[p].lowestMm() && offsetMm < sections_[p].highestMm())
        all = united(all, at(p, offsetMm));
    return all;
  }

  const std::vector<Sections>& sections_;
  std::size_t piece_;
  Plane base_;
  PlaneFrame frame_;
  const std::vector<double>& bounds_;
  std::vector<Paths> own_;
};

// The places of regions with rules of their own, in planes of one direction.
class RuledPlaces {
public:
  RuledPlaces(const ColumnOptions& options, const Vector3d& normal, const PlaneFrame& frame)
      : rule_(options.rule), places_(options.places), frame_(frame) {
    if (!places_)
      return;
    for (const layers::SupportPlace& place : places_->places)
      ruled_.emplace_back(place.body, normal);
    for (const geometry::TriangleMesh& body : places_->printedLater)
      later_.emplace_back(body, normal);
  }

  // Returns what protrudes over `below` and has to be carried: by more than `reachMm`, or at all.
  Paths carried(const Paths& area, const Paths& below, double reachMm, double offsetMm) const {
    std::array<Paths, layers::kSupportRules> byRule;
    byRule[indexOf(rule_)] = area;
    for (std::size_t i = 0; i < ruled_.size(); ++i) {
      const Paths place = sectionOf(ruled_[i], offsetMm);
      if (place.empty())
        continue;
      for (Paths& part : byRule)
        part = without(part, place);
      Paths& own = byRule[indexOf(places_->places[i].rule)];
      own = united(own, shared(area, place));
    }
    Paths out = without(byRule[indexOf(layers::SupportRule::Auto)], grown(below, reachMm));
    if (const Paths& all = byRule[indexOf(layers::SupportRule::Always)]; !all.empty())
      out = united(out, without(all, below));
    return out;
  }
  Paths printedLater(double offsetMm) const {
    Paths all;
    for (const Sections& later : later_)
      all = united(all, sectionOf(later, offsetMm));
    return all;
  }

private:
  static std::size_t indexOf(layers::SupportRule rule) { return static_cast<std::size_t>(rule); }
  Paths sectionOf(const Sections& sections, double offsetMm) const {
    return offsetMm > sections.lowestMm() && offsetMm < sections.highestMm()
               ? pathsOf(sections.at(offsetMm), frame_)
               : Paths();
  }

  layers::SupportRule rule_;
  const layers::SupportPlaces* places_;
  const PlaneFrame& frame_;
  std::vector<Sections> ruled_, later_;
};

} // namespace

SupportColumns supportColumns(const std::vector<Piece>& pieces, std::size_t piece,
                              const std::vector<Sections>& sections,
                              const std::vector<double>& bounds, const ColumnOptions& options,
                              const base::RunContext& ctx) {
  const Levels levels(pieces, piece, sections, bounds, options.beadWidthMm);
  const RuledPlaces places(options, pieces[piece].base.normal, levels.frame());
  const std::size_t n = levels.count();
  SupportColumns out;
  out.sections.resize(n);
  const double half = 0.5 * options.beadWidthMm;
  // From the top: overhangs, and the columns that carry them one level lower.
  std::vector<Paths> unsupported(n), columns(n),
      standing(n); // standing: printed before, including this piece
  bool any = false;
  for (std::size_t k = n; k-- > 1;) {
    ctx.checkpoint();
    const double reach = (levels.middle(k) - levels.middle(k - 1)) * std::tan(options.overhangRad);
    const auto carriedOver = [&](const Paths& area, const Paths& below) {
      return opened(places.carried(area, below, reach, levels.middle(k)), kNarrowest * half);
    };
    unsupported[k] = carriedOver(levels.own(k), levels.own(k - 1));
    if (unsupported[k].empty() && columns[k].empty())
      continue;
    standing[k - 1] = united(levels.own(k - 1), levels.earlier(levels.middle(k - 1)));
    unsupported[k] = carriedOver(unsupported[k], standing[k - 1]);
    // Widen the heads, because an overhanging tip may be narrower than the column that carries it.
    const Paths heads = widened(shared(grown(unsupported[k], half), levels.own(k)), half);
    const Paths carried = united(heads, tapered(columns[k], kTaper * reach, options.beadWidthMm));
    const Paths occupied = grown(united(united(standing[k - 1], levels.later(levels.middle(k - 1))),
                                        places.printedLater(levels.middle(k - 1))),
                                 options.gapMm);
    columns[k - 1] =
        wideEnough(besideWalls(without(carried, occupied), occupied, half), kNarrowColumn * half);
    any = true;
  }
  if (!any)
    return out;
  // From the bottom: keep only columns that are supported.
  Paths below;
  if (pieces[piece].baseTag == kPlate) {
    Path plate;
    for (const Eigen::Vector2d& p : options.plate)
      plate.emplace_back(std::llround(kPathUnits * levels.frame().across.head<2>().dot(p)),
                         std::llround(kPathUnits * levels.frame().along.head<2>().dot(p)));
    if (plate.size() > 2 && !ClipperLib::Orientation(plate))
      std::reverse(plate.begin(), plate.end());
    below = {plate};
  } else {
    below = levels.earlier(pieces[piece].base.offsetMm - kUnderBase * levels.heightMm(0));
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (k > 0 && !unsupported[k].empty()) {
      const Paths loose = without(unsupported[k], grown(columns[k - 1], half + options.gapMm));
      const Paths unheld = opened(loose, kNarrowest * half);
      if (const double area = geometry::areaMm2(unheld); area > 0.0) {
        if (out.unheldMm2 == 0.0)
          out.unheldAt = sectionOf(unheld, levels.plane(k), levels.frame()).points.front();
        out.unheldMm2 += area;
      }
    }
    // Keep the supported part of a column plus half a bead around it, from which it grows. On a
    // steep slope each step carries half a bead, up to the wall.
    Paths kept;
    for (const Paths& column : components(columns[k])) {
      if (!wideEnough(shared(column, below), kNarrowColumn * half).empty()) {
        kept = united(kept, shared(column, grown(below, half)));
        continue;
      }
      const Paths upToWall = without(grown(column, options.gapMm), standing[k]);
      if (!wideEnough(shared(upToWall, below), kNarrowFooting * half).empty())
        kept = united(kept, shared(upToWall, grown(below, half)));
    }
    columns[k] = wideEnough(kept, kNarrowColumn * half);
    out.sections[k] = sectionOf(columns[k], levels.plane(k), levels.frame());
    below = united(columns[k], standing[k]);
  }
  return out;
}

} // namespace voluta::planar
