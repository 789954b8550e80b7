// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lemma 11: a polygon A_i meshed by the paper's pieces, each quad decided exactly.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "paper/edge_chains.hpp"

namespace quadbound {

struct StripMesh {
  unsigned quads = 0;
  bool moved_feet = false;
};

/// `chain` is alpha_i from c_i to c_(i+1) in the frame of its edge; `rise` / `run` the slope of the
/// edge, for vertical projections.
///
/// Guarantees: 1. a mesh that is returned has all angles within thm-13's interval, exactly. 2. Its
/// pieces are those of Lemma 11: one edge between two feet; two edges and a Steiner point s with
/// its foot; three edges closed by a fourth; four edges in the form CRC around a Steiner point on
/// c_i c_(i+1). Feet are perpendicular or vertical ones; that of s, c_i or c_(i+1) is moved only
/// where nothing else helps. 3. s is looked for where the paper puts it and then on a grid: that
/// nothing is found proves nothing.
std::optional<StripMesh> mesh_strip_by_lemma_11(const std::vector<Framed>& chain, Int128 rise,
                                                Int128 run);

/// Whether all angles of a quad are within thm-13's interval. Counter-clockwise.
bool is_good(const std::array<Framed, 4>& quad);

/// The pentagon x, y, c, b, a with feet x and y: the quads (x, z, s, a), (z, y, c, s), (a, s, c, b)
/// with a Steiner point s above its foot z, or, if that is free, beside it; looked for as in
/// guarantee 3.
bool is_pentagon_meshed(const Framed& x, const Framed& y, const Framed& a, const Framed& b,
                        const Framed& c, bool free_foot);

/// C, R or S for each inner vertex of a chain.
std::string turns_of(const std::vector<Framed>& chain);

}  // namespace quadbound
