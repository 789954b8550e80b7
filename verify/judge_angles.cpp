// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/judge.hpp"

namespace quadbound::judge {
namespace {

void measure_excess(StoredBound& stored, const JudgedCorner& worst, Arctangent bound,
                    bool is_upper) {
  const Corner<Rational> corner{worst.cross, is_upper ? Rational(-worst.dot) : worst.dot};
  const auto [rise, run] = excess_tangent(corner, bound);
  const Rational larger = std::max(Rational(abs(rise)), Rational(abs(run)));
  if (larger == 0) return;
  const double excess =
      std::atan2(nearest_double(Rational(rise / larger)), nearest_double(Rational(run / larger)));
  stored.excess_radians = excess;
}

}  // namespace

void Judge::judge_angle(std::string id, BoundTally Survey::*end, Arctangent bound, bool is_upper) {
  const BoundTally& exact = survey_.*end;
  Claim& claim = add(std::move(id), exact.broken == 0);
  if (exact.broken != 0)
    claim.detail = fmt::format("{} corners are beyond the bound", exact.broken);
  // Every corner may be exempt.
  if (exact.extreme) claim.worst = judged(plane_, exact.extreme->id);
  const Rational tangent(bound.numerator, bound.denominator);
  claim.values = {{"tan of the bound", is_upper ? Rational(-tangent) : tangent}};
  claim.stored.emplace();
  if (infinite_vertex_) {
    claim.stored->verdict = StoredVerdict::fails;
  } else if (stored_survey_) {
    judge_stored_angle(*claim.stored, *stored_survey_.*end, bound, is_upper);
  } else if (exact.broken != 0) {
    // Nothing was rounded, so nothing is explained by rounding.
    measure_excess(*claim.stored, *claim.worst, bound, is_upper);
    claim.stored->verdict = StoredVerdict::fails;
  }
}

void Judge::judge_stored_angle(StoredBound& stored, const BoundTally& tally, Arctangent bound,
                               bool is_upper) const {
  if (!tally.extreme) return;
  const CornerId id = tally.extreme->id;
  stored.worst = judged(stored_plane_, id);
  if (tally.broken == 0) return;
  stored.verdict = tally.beyond_slack ? StoredVerdict::fails : StoredVerdict::within_rounding;
  measure_excess(stored, *stored.worst, bound, is_upper);
  const CornerScale scale = corner_scale(stored_plane_, mesh_.quads[id.quad], id.corner);
  if (scale.shorter_edge_squared == 0) return;
  const Rational ratio =
      scale.largest_coordinate * scale.largest_coordinate / scale.shorter_edge_squared;
  stored.slack_radians = 4 * std::sqrt(2 * nearest_double(ratio)) * 0x1p-53;
}

}  // namespace quadbound::judge
