// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures of meshes: SVG, PDF and PNG. Pictures only, never data.

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "model/mesh.hpp"

namespace quadbound {

enum class PictureColour { kNone, kMinAngle, kMaxAngle, kConstruction, kLevel };

/// A rectangle of the plane, y up.
struct PictureWindow {
  Point low;
  Point high;
};

struct PictureOptions {
  PictureColour colour = PictureColour::kNone;
  std::optional<PictureWindow> window;  ///< draw only this part, as large as the picture
  std::vector<Point> points;            ///< drawn as dots, for instance the input's vertices
  double width = 1600;                  ///< in pixels, the legend included
  /// Of edges, in pixels; the boundary is drawn twice as wide. 0: chosen from the size of the
  /// quads.
  double line_width = 0;
};

/// Why the picture cannot be drawn, if so: the mesh has no construction or level to colour by, the
/// window or the width is empty. One line without the name of the file.
std::optional<std::string> picture_problem(const Mesh& mesh, const PictureOptions& options);

/// The mesh fitted to the width (and to four times the width in height), y up, each edge drawn
/// once, with a legend on the right where quads are coloured. Faces with another number of sides
/// are left white.
///
/// Colours are safe for colour-blind readers. Angles are drawn in classes that end at the bounds of
/// the paper, arctan(1/3) = 18.43 and arctan(1/2) = 26.57 degrees and their counterparts; a quad
/// beyond the bound of Theorem 13 is orange, the only warm colour there.
///
/// Guarantees: 1. the same mesh and options give the same bytes; for PDF and PNG with a legend, on
/// machines with the same fonts. 2. SVG coordinates are rounded to 1/100 pixel and relative: about
/// 60 bytes for a coloured quad. 3. What lies outside the window is cut off before it is drawn, so
/// that any magnification works as far as doubles tell the vertices apart.
/// Requires: no picture_problem; coordinates within doubles.
/// Errors: show in the stream's state; std::runtime_error from the graphics library, for instance
/// out of memory.
void write_svg(std::ostream& stream, const Mesh& mesh, const PictureOptions& options = {});
void write_pdf(std::ostream& stream, const Mesh& mesh, const PictureOptions& options = {});
void write_png(std::ostream& stream, const Mesh& mesh, const PictureOptions& options = {});

}  // namespace quadbound
