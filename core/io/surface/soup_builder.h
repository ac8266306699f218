// What the surface readers share: points, polygons and groups become a soup of triangles.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/csr.h"
#include "surface/soup.h"

namespace lpq {

class SoupBuilder {
 public:
  Index point_count() const { return static_cast<Index>(soup_.points.size()); }
  void add_point(Vec3 p) { soup_.points.push_back(p); }

  /// Of the last point, where the file says it. Points without have none.
  void set_size(double size) {
    soup_.sizes.resize(soup_.points.size(), 0);
    soup_.sizes.back() = size;
  }

  /// Polygons from now on belong to the group of this key, which is shown as `name`.
  void set_group(const std::string& key, const std::string& name);

  /// Polygons from now on belong to the body of this name; before the first call to one without.
  void set_body(const std::string& name);

  /// Three or more corners, divided into triangles (polygon.h), with a warning where some of these
  /// turn over. Their points may come later, before take().
  void add_polygon(std::span<const Index> corners);
  bool has_polygon() const { return !soup_.triangles.empty() || !later_.empty(); }

  void warn(Warning warning) { soup_.warnings.push_back(std::move(warning)); }
  /// Whether the file is beyond what indices can count.
  bool too_large() const;

  /// With bodies as join_loose_bodies() leaves them, if set_body() was called.
  SurfaceSoup take();

 private:
  struct Owner {
    Index group, body;
  };
  Owner owner();
  void divide(std::span<const Index> corners, Owner owner);
  Warning warning_of_turned() const;

  SurfaceSoup soup_;
  Csr<Index> waiting_;        // polygons from the first on that had not all its points
  std::vector<Owner> later_;  // of each of these
  std::map<std::string, Index> groups_, bodies_;
  std::string key_, name_;
  Index group_ = none;  // none: the next polygon makes it
  std::string body_name_;
  Index body_ = none;  // as above
  bool has_bodies_ = false;
  Index turned_ = 0;  // polygons
  Vec3 first_turned_;
};

/// The error for a file that SoupBuilder finds too_large().
Error too_many_triangles();

}  // namespace lpq
