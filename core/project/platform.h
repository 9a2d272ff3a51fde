// The platform that the user chose.
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
  // The default: the contact area without a margin.
  Platform() : Platform(std::string_view()) {}
  // Parses the form of the kind (platformForm()); empty: the first kind with its default sizes.
  // Throws Error{Usage} that names the nearest kind, or the field and its range.
  explicit Platform(std::string_view text);
  // The kind with its default sizes. Precondition: it takes no file.
  explicit Platform(const PlatformKind& kind);
  // Preconditions: as many sizes as fields, within their limits.
  Platform(const PlatformKind& kind, std::vector<double> sizesMm);
  // Precondition: the kind takes a file; the path is not empty.
  Platform(const PlatformKind& kind, std::string file);

  const PlatformKind& kind() const { return *kind_; }
  const std::vector<double>& sizesMm() const { return sizesMm_; }
  const std::string& file() const { return file_; } // of a body; else empty
  std::string text() const;                         // input of the constructor
  base::Message shown() const;                      // short text for the user

  bool isFor(PlatformUse use) const;
  bool isForAnyOf(const std::vector<PlatformUse>& uses) const;
  bool isOfCell() const { return kind_->ofCell; }
  bool isBody() const { return isFor(PlatformUse::Body); }

  // Returns the margin around the part [mm] of a plate made for the part; nullopt for other kinds.
  std::optional<double> marginMm() const;
  // Returns the platform with another margin. Precondition: it has one.
  Platform withMarginMm(double marginMm) const;
  // Returns the plate made for the part.
  static Platform madeForPart(double marginMm);

  // Returns the corners of the plate about the origin [mm], convex, counter-clockwise. `standing`:
  // points of the part on the plate. Throws Error{Usage} if the platform is not a plate,
  // Error{UnusableInput} if a plate made for the part has no points on it.
  std::vector<Eigen::Vector2d> plateAround(std::vector<Eigen::Vector2d> standing) const;
  // Returns the rod with this number of sides (0: cylinder); nullopt: the cell's own.
  std::optional<platform::RodShape> rod(int sides) const;

  friend bool operator==(const Platform& a, const Platform& b) {
    return a.kind_ == b.kind_ && a.sizesMm_ == b.sizesMm_ && a.file_ == b.file_;
  }

private:
  const PlatformKind* kind_; // a row of platformKinds()
  std::vector<double> sizesMm_;
  std::string file_;
};

// For base::keyText(). A body is compared by its file's content, regardless of its path. Does not
// throw: an unreadable file has a key that names its path.
std::string keyOf(const Platform& platform);

} // namespace voluta::project
