// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which colour a quad gets in a picture, and what the legend says.

#include <cstddef>
#include <string>
#include <vector>

#include "model/mesh.hpp"
#include "model/picture.hpp"
#include "model/picture_canvas.hpp"

namespace quadbound {

struct PictureClass {
  std::string label;
  Colour colour;
};

/// The classes of a colouring, and the class of each quad.
struct PictureClasses {
  std::string title;
  std::vector<PictureClass> classes;
  std::vector<std::uint8_t> of_quad;  ///< empty where nothing is coloured
};

/// Requires: no picture_problem.
PictureClasses picture_classes(const Mesh& mesh, PictureColour colour);

}  // namespace quadbound
