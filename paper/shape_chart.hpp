// SPDX-License-Identifier: Apache-2.0
#pragma once
// Figures 44 and 45: the quads of the spiral and of Lake Superior as dots.

#include <string>

#include "model/mesh.hpp"

namespace quadbound {

/// The same drawing twice.
struct VectorPicture {
  std::string svg;
  std::string pdf;
};

/// The spiral on the left and the lake on the right, quads in the order of the mesh. Fig. 44 has,
/// as the paper says, a dot for each corner of each quad, the sine of its angle; Fig. 45 one for
/// each quad. Lines are the paper's extreme value of its own polygon, and what Theorem 13 allows.
/// Of dots that are less than half a pixel apart one is drawn. Guarantees: 1. the same measurements
/// give the same bytes; the PDF's, with the same fonts.
VectorPicture scaled_jacobian_chart(const Mesh& spiral, const Mesh& lake);
VectorPicture aspect_ratio_chart(const Mesh& spiral, const Mesh& lake);

}  // namespace quadbound
