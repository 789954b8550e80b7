// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <ft2build.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H

#include "generators/polygon_families.hpp"

namespace quadbound::generators {
namespace {

/// A file of the fonts DejaVu 2.37 and the checksum in its head table, which depends on all of it.
struct FontFile {
  const char* name;
  std::uint32_t checksum;
};
constexpr std::array<FontFile, 6> kFonts{{{"DejaVuSans.ttf", 0xBAB402EB},
                                          {"DejaVuSans-Bold.ttf", 0x290AD7D3},
                                          {"DejaVuSansMono.ttf", 0xF7BE0405},
                                          {"DejaVuSansMono-Bold.ttf", 0xDF91AAA5},
                                          {"DejaVuSerif.ttf", 0x3AF3FBB3},
                                          {"DejaVuSerif-Bold.ttf", 0x8BB19D41}}};
constexpr FT_UShort kUnitsPerEm = 2048;
/// 2048 units of the font are 2^20 of the lattice; so far up, too, the middle between two control
/// points, which TrueType leaves out, is an integer.
constexpr int kShift = 9;

/// Drawn by the seed where no character is asked for.
constexpr std::string_view kLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghklmnopqrstuvwxyz0123456789&@#$?<>+*";

/// A straight piece of an outline or, with a control point, a parabola.
struct Segment {
  LatticePoint from;
  LatticePoint control;
  LatticePoint to;
  bool curved = false;
};
using Contour = std::vector<Segment>;

LatticePoint lattice(const FT_Vector* v) { return {v->x, v->y}; }

/// What FreeType calls while it walks along an outline.
struct Walk {
  std::vector<Contour> contours;
  LatticePoint at;

  void add(const Segment& segment) {
    if (segment.from != segment.to) contours.back().push_back(segment);
    at = segment.to;
  }
  static int move_to(const FT_Vector* to, void* walk) {
    static_cast<Walk*>(walk)->contours.emplace_back();
    static_cast<Walk*>(walk)->at = lattice(to);
    return 0;
  }
  static int line_to(const FT_Vector* to, void* walk) {
    auto& self = *static_cast<Walk*>(walk);
    self.add({self.at, {}, lattice(to), false});
    return 0;
  }
  static int conic_to(const FT_Vector* control, const FT_Vector* to, void* walk) {
    auto& self = *static_cast<Walk*>(walk);
    self.add({self.at, lattice(control), lattice(to), true});
    return 0;
  }
  /// TrueType has none of these.
  static int cubic_to(const FT_Vector*, const FT_Vector*, const FT_Vector*, void*) { return 1; }
};

class Font {
 public:
  Font(const PolygonMaker& maker, const FontFile& file) {
    const std::string path = std::string(QUADBOUND_FONT_FOLDER "/") + file.name;
    FT_Library library = nullptr;
    maker.require(FT_Init_FreeType(&library) == 0, "FreeType does not start");
    library_.reset(library);
    FT_Face face = nullptr;
    maker.require(FT_New_Face(library, path.c_str(), 0, &face) == 0,
                  (path + " cannot be opened; it is in Debian's fonts-dejavu-core").c_str());
    face_.reset(face);
    const auto* head = static_cast<const TT_Header*>(FT_Get_Sfnt_Table(face, FT_SFNT_HEAD));
    maker.require(head != nullptr &&
                      static_cast<std::uint32_t>(head->CheckSum_Adjust) == file.checksum &&
                      face->units_per_EM == kUnitsPerEm,
                  (path + " is not the file of DejaVu 2.37; its outlines may differ").c_str());
  }

  /// Empty where the font has no such character or it has no outline.
  [[nodiscard]] std::vector<Contour> outline(std::int64_t character) const {
    const FT_UInt index = FT_Get_Char_Index(face_.get(), static_cast<FT_ULong>(character));
    if (index == 0 || FT_Load_Glyph(face_.get(), index, FT_LOAD_NO_SCALE) != 0) return {};
    const FT_Outline_Funcs functions{Walk::move_to,  Walk::line_to, Walk::conic_to,
                                     Walk::cubic_to, kShift,        0};
    Walk walk;
    if (FT_Outline_Decompose(&face_->glyph->outline, &functions, &walk) != 0) return {};
    std::erase_if(walk.contours, [](const Contour& c) { return c.empty(); });
    return std::move(walk.contours);
  }

 private:
  struct Close {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
  };
  std::unique_ptr<FT_LibraryRec_, Close> library_;
  std::unique_ptr<FT_FaceRec_, Close> face_;
};

/// Twice the area of the corners and control points; its sign is the orientation.
std::int64_t area(const Contour& contour) {
  std::int64_t sum = 0;
  const auto cross = [](LatticePoint a, LatticePoint b) { return a.x * b.y - a.y * b.x; };
  for (const Segment& s : contour)
    sum += s.curved ? cross(s.from, s.control) + cross(s.control, s.to) : cross(s.from, s.to);
  return sum;
}

/// One outline first and all others, if any, around holes in it.
bool is_one_piece(std::vector<Contour>& contours) {
  if (contours.empty()) return false;
  const auto size = [](const Contour& c) { return std::abs(area(c)); };
  std::ranges::iter_swap(contours.begin(), std::ranges::max_element(contours, {}, size));
  const bool positive = area(contours.front()) > 0;
  return std::all_of(contours.begin() + 1, contours.end(),
                     [&](const Contour& c) { return (area(c) > 0) != positive && area(c) != 0; });
}

/// The place k / pieces along a segment, rounded to the nearest lattice point.
LatticePoint place(const Segment& s, std::int64_t k, std::int64_t pieces) {
  const std::int64_t rest = pieces - k;
  const std::int64_t whole = s.curved ? pieces * pieces : pieces;
  const auto value = [&](std::int64_t from, std::int64_t control, std::int64_t to) {
    const std::int64_t sum =
        s.curved ? rest * rest * from + 2 * k * rest * control + k * k * to : rest * from + k * to;
    const std::int64_t doubled = 2 * sum + whole;
    return (doubled - ((doubled % (2 * whole)) + 2 * whole) % (2 * whole)) / (2 * whole);
  };
  return {value(s.from.x, s.control.x, s.to.x), value(s.from.y, s.control.y, s.to.y)};
}

std::int64_t curves(const Contour& contour) {
  return std::ranges::count_if(contour, [](const Segment& s) { return s.curved; });
}

/// As a ring of n vertices: the curves are divided alike, the straight pieces only where there is
/// no curve. Requires: n >= contour.size().
LatticeRing flattened(const Contour& contour, std::int64_t n) {
  const std::int64_t bent = curves(contour);
  const auto size = static_cast<std::int64_t>(contour.size());
  const std::int64_t divided = bent == 0 ? size : bent;
  const std::int64_t extra = n - size;
  LatticeRing ring;
  std::int64_t number = 0;
  for (const Segment& s : contour) {
    const bool divides = bent == 0 || s.curved;
    const std::int64_t pieces =
        divides ? 1 + extra / divided + (number < extra % divided ? 1 : 0) : 1;
    number += divides ? 1 : 0;
    for (std::int64_t k = 0; k < pieces; ++k) ring.push_back(place(s, k, pieces));
  }
  return ring;
}

/// The outlines of a letter drawn at random among those that n vertices are enough for.
std::vector<Contour> any_letter(PolygonMaker& maker, const Font& font) {
  std::vector<char> letters(kLetters.begin(), kLetters.end());
  maker.random.shuffle(letters);
  for (const char letter : letters) {
    std::vector<Contour> contours = font.outline(letter);
    if (is_one_piece(contours) && static_cast<std::int64_t>(contours.front().size()) <= maker.n)
      return contours;
  }
  maker.require(false, "no letter has so few vertices");
  return {};
}

}  // namespace

LatticePolygon make_glyph(PolygonMaker& maker) {
  const Font font(maker, kFonts[static_cast<std::size_t>(maker.parameter("font"))]);
  const std::int64_t character = maker.parameter("character");
  std::vector<Contour> contours =
      character == 0 ? any_letter(maker, font) : font.outline(character);
  maker.require(!contours.empty(), "the font has no such character, or it is blank");
  maker.require(is_one_piece(contours), "the character is not one piece");
  const auto corners = static_cast<std::int64_t>(contours.front().size());
  maker.require(maker.n >= corners, fmt::format("n must be {} at least", corners).c_str());
  LatticePolygon polygon{flattened(contours.front(), maker.n), {}};
  if (area(contours.front()) < 0) std::ranges::reverse(polygon.outer);
  for (std::size_t i = 1; i < contours.size(); ++i)
    polygon.holes.push_back(
        flattened(contours[i], static_cast<std::int64_t>(contours[i].size()) +
                                   (maker.parameter("pieces") - 1) * curves(contours[i])));
  return polygon;
}

}  // namespace quadbound::generators
