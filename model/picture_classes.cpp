// SPDX-License-Identifier: Apache-2.0
#include "model/picture_classes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/angle.hpp"
#include "model/quad_shape.hpp"

namespace quadbound {
namespace {

// ColorBrewer's YlGnBu in 6 classes without the darkest, on which edges could not be seen: safe for
// colour-blind readers, in print and as greys.
constexpr std::array<Colour, 5> kSequence{{{0xff, 0xff, 0xcc},
                                           {0xc7, 0xe9, 0xb4},
                                           {0x7f, 0xcd, 0xbb},
                                           {0x41, 0xb6, 0xc4},
                                           {0x2c, 0x7f, 0xb8}}};
// Okabe and Ito's qualitative palette without black.
constexpr std::array<Colour, 7> kCategories{{{0x56, 0xb4, 0xe9},
                                             {0xe6, 0x9f, 0x00},
                                             {0x00, 0x9e, 0x73},
                                             {0xf0, 0xe4, 0x42},
                                             {0x00, 0x72, 0xb2},
                                             {0xcc, 0x79, 0xa7},
                                             {0xd5, 0x5e, 0x00}}};
constexpr Colour kBeyond{0xd5, 0x5e, 0x00};

std::uint8_t mix(std::uint8_t from, std::uint8_t to, double share) {
  return static_cast<std::uint8_t>(std::lround(from + (to - from) * share));
}

Colour mix(Colour from, Colour to, double share) {
  return {mix(from.red, to.red, share), mix(from.green, to.green, share),
          mix(from.blue, to.blue, share)};
}

/// Light for 0, dark for 1.
Colour sequential(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(kSequence.size() - 1);
  const auto left = std::min(static_cast<std::size_t>(place), kSequence.size() - 2);
  return mix(kSequence[left], kSequence[left + 1], place - static_cast<double>(left));
}

/// After the last colour of the palette the same ones come again, lighter.
Colour category(std::size_t index) {
  const std::size_t round = index / kCategories.size();
  const double tint = 1 - std::pow(0.55, static_cast<double>(round));
  return mix(kCategories[index % kCategories.size()], kWhite, tint);
}

double degrees(Arctangent angle) {
  return std::atan2(angle.numerator, angle.denominator) * (180 / std::numbers::pi);
}

/// Classes between limits, the first one beyond the bound of Theorem 13; `sign` is 1 for smallest
/// angles, whose limits rise, and -1 for largest angles, whose limits fall.
struct AngleScale {
  std::string title;
  double QuadShape::*measure;
  int sign;
  std::array<double, 5> limits;
};

/// Angles at a bound come out of the floating point computation on either side of it; a picture
/// shows them on the good side. The verdict is not made here.
constexpr double kSlackDegrees = 1e-9;

std::string class_label(const AngleScale& scale, std::size_t index) {
  const std::size_t last = scale.limits.size();
  if (index == 0)
    return fmt::format("{} {:.5g}°", scale.sign > 0 ? "below" : "above", scale.limits[0]);
  if (index == last)
    return fmt::format("{} {:.5g}°", scale.sign > 0 ? "from" : "up to", scale.limits[last - 1]);
  const auto [low, high] = std::minmax(scale.limits[index - 1], scale.limits[index]);
  return fmt::format("{:.5g}° to {:.5g}°", low, high);
}

PictureClasses angle_classes(const Mesh& mesh, const AngleScale& scale) {
  PictureClasses result;
  result.title = scale.title;
  result.classes.push_back({class_label(scale, 0), kBeyond});
  const std::size_t best = scale.limits.size();
  for (std::size_t i = 1; i <= best; ++i) {
    const double badness = static_cast<double>(best - i) / static_cast<double>(best - 1);
    result.classes.push_back({class_label(scale, i), sequential(badness)});
  }
  for (const Quad& quad : mesh.quads) {
    const double angle = quad_shape(mesh.vertices, quad).*scale.measure;
    const auto reached = std::count_if(scale.limits.begin(), scale.limits.end(), [&](double limit) {
      return scale.sign * (angle - limit) >= -kSlackDegrees;
    });
    result.of_quad.push_back(static_cast<std::uint8_t>(reached));
  }
  return result;
}

PictureClasses min_angle_classes(const Mesh& mesh) {
  return angle_classes(mesh,
                       {"smallest angle",
                        &QuadShape::min_angle,
                        1,
                        {degrees(kTheorem13.smallest), degrees(kTheorem1.smallest), 45, 60, 75}});
}

PictureClasses max_angle_classes(const Mesh& mesh) {
  return angle_classes(mesh, {"largest angle",
                              &QuadShape::max_angle,
                              -1,
                              {180 - degrees(kTheorem13.from_straight),
                               180 - degrees(kTheorem1.from_straight), 135, 120, 105}});
}

PictureClasses construction_classes(const Mesh& mesh) {
  PictureClasses result{"construction", {}, mesh.construction};
  for (std::size_t i = 0; i < mesh.construction_names.size(); ++i)
    result.classes.push_back({mesh.construction_names[i], category(i)});
  return result;
}

PictureClasses level_classes(const Mesh& mesh) {
  PictureClasses result{"cell level", {}, {}};
  if (mesh.level.empty()) return result;
  const auto [low, high] = std::minmax_element(mesh.level.begin(), mesh.level.end());
  const int span = std::max(1, *high - *low);
  for (int level = *low; level <= *high; ++level)
    result.classes.push_back(
        {fmt::format("{}", level), sequential(static_cast<double>(level - *low) / span)});
  for (const std::uint8_t level : mesh.level)
    result.of_quad.push_back(static_cast<std::uint8_t>(level - *low));
  return result;
}

}  // namespace

PictureClasses picture_classes(const Mesh& mesh, PictureColour colour) {
  switch (colour) {
    case PictureColour::kNone:
      return {};
    case PictureColour::kMinAngle:
      return min_angle_classes(mesh);
    case PictureColour::kMaxAngle:
      return max_angle_classes(mesh);
    case PictureColour::kConstruction:
      return construction_classes(mesh);
    case PictureColour::kLevel:
      return level_classes(mesh);
  }
  return {};
}

}  // namespace quadbound
