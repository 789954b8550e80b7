// SPDX-License-Identifier: Apache-2.0
#pragma once
// One sheet with a small polygon of every family.

#include "model/picture_canvas.hpp"

namespace quadbound {

struct Gallery {
  double width = 0;  ///< in pixels
  double height = 0;
  Drawing drawing;
};

/// A polygon of each of polygon_families(), in their order, with its name and its recipe.
Gallery gallery_of_polygons();

}  // namespace quadbound
