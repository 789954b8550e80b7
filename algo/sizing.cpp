// SPDX-License-Identifier: Apache-2.0
#include "algo/sizing.hpp"

// Boost 1.74's R-tree includes a header of Boost that is deprecated and says so on every build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>

namespace quadbound {
namespace {

namespace geometry = boost::geometry;
using PlainPoint = geometry::model::d2::point_xy<double>;
using Segment = geometry::model::segment<PlainPoint>;

double distance(const Point& point, const Point& a, const Point& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double along = (point.x - a.x) * dx + (point.y - a.y) * dy;
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  return std::hypot(point.x - a.x - t * dx, point.y - a.y - t * dy);
}

}  // namespace

struct SizeField::Edges {
  geometry::index::rtree<Segment, geometry::index::rstar<16>> tree;
};

SizeField::SizeField(const Sizing& sizing, const Polygon& polygon) : sizing_(sizing) {
  if (sizing.boundary_size <= 0) return;
  std::vector<Segment> segments;
  for (const Ring& ring : polygon.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& b = ring[(i + 1) % ring.size()];
      segments.emplace_back(PlainPoint(ring[i].x, ring[i].y), PlainPoint(b.x, b.y));
    }
  }
  edges_ = std::make_unique<Edges>();
  edges_->tree = decltype(edges_->tree)(segments);
}

SizeField::~SizeField() = default;

double SizeField::size_at(const Point& point) const {
  double size = sizing_.largest;
  for (const SizeSource& source : sizing_.sources)
    size = std::min(size, source.size + source.growth * distance(point, source.a, source.b));
  if (!edges_) return size;
  const PlainPoint at(point.x, point.y);
  const auto nearest = edges_->tree.qbegin(geometry::index::nearest(at, 1));
  return std::min(
      size, sizing_.boundary_size + sizing_.boundary_growth * geometry::distance(at, *nearest));
}

}  // namespace quadbound
