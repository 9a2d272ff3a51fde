// What material starts on, as the user chose it.
#pragma once

#include "platform/rod_shape.h"
#include "project/platform_kind.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::project {

// A kind with its sizes, or with its file.
class Platform {
public:
  // The area that the part stands on, without a margin.
  Platform() : Platform(std::string_view()) {}
  // Of the form that its kind has (platformForm()); empty: the first kind's usual one. Throws
  // Error{Usage} that names the nearest kind, or the field and what it may be.
  explicit Platform(std::string_view text);
  // The kind in its usual sizes. Precondition: it takes no file.
  explicit Platform(const PlatformKind& kind);
  // Preconditions: as many sizes as fields, within their limits.
  Platform(const PlatformKind& kind, std::vector<double> sizesMm);
  // Precondition: the kind takes a file; a path that is not empty.
  Platform(const PlatformKind& kind, std::string file);

  const PlatformKind& kind() const { return *kind_; }
  const std::vector<double>& sizesMm() const { return sizesMm_; }
  const std::string& file() const { return file_; } // of a body; else empty
  std::string text() const;                         // what makes it again
  base::Message shown() const;                      // in few words, for a user

  bool isFor(PlatformUse use) const;
  bool isForAnyOf(const std::vector<PlatformUse>& uses) const;
  bool isOfCell() const { return kind_->ofCell; }
  bool isBody() const { return isFor(PlatformUse::Body); }

  // Around what stands on it, mm, of a plate that is made for the part; none for others.
  std::optional<double> marginMm() const;
  // The same with another margin. Precondition: it has one.
  Platform withMarginMm(double marginMm) const;
  // The plate that is made for the part.
  static Platform madeForPart(double marginMm);

  // Corners of the plate about the origin: convex, counter-clockwise, mm. `standing`: points of the
  // part on the plate. Throws Error{Usage} for what is no plate, Error{UnusableInput} where a plate
  // that is made for the part has nothing standing on it.
  std::vector<Eigen::Vector2d> plateAround(std::vector<Eigen::Vector2d> standing) const;
  // The rod with so many sides (0: round); none: the cell's own.
  std::optional<platform::RodShape> rod(int sides) const;

  friend bool operator==(const Platform& a, const Platform& b) {
    return a.kind_ == b.kind_ && a.sizesMm_ == b.sizesMm_ && a.file_ == b.file_;
  }

private:
  const PlatformKind* kind_; // a row of platformKinds()
  std::vector<double> sizesMm_;
  std::string file_;
};

// For base::keyText(): a body counts by its file's content, wherever that lies. Throws nothing: a
// file that cannot be read counts as such.
std::string keyOf(const Platform& platform);

} // namespace voluta::project
