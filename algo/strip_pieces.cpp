// SPDX-License-Identifier: Apache-2.0
#include "algo/strip_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadbound {
namespace {

/// A pentagon in the frame of its edge: x at the origin, the edge along the first axis.
struct FramedPentagon {
  double y;  ///< the second foot, on the axis
  Vector a;
  Vector b;
  Vector c;
};

struct Candidate {
  Vector steiner;
  double foot;
};

/// An upper bound of all that a candidate can have: the corners at x, y and b are the same for all.
double largest_slack(const FramedPentagon& p) {
  const double at_x = corner_slack({1, 0}, p.a);
  const double at_y = corner_slack(p.c - Vector{p.y, 0}, {-1, 0});
  const double at_b = corner_slack(p.a - p.b, p.c - p.b);
  constexpr double kRounding = 1e-12;  // far above that of a slack
  return std::min({at_x, at_y, at_b}) + kRounding;
}

double slack_of(const FramedPentagon& p, const Candidate& candidate, double least) {
  const Vector s = candidate.steiner;
  const Vector z{candidate.foot, 0};
  if (!(s.y > 0 && 0 < z.x && z.x < p.y)) return -1;
  double slack = quad_slack({p.a, s, p.c, p.b});
  if (slack <= least) return slack;
  slack = std::min(slack, quad_slack({Vector{}, z, s, p.a}));
  if (slack <= least) return slack;
  return std::min(slack, quad_slack({z, Vector{p.y, 0}, p.c, s}));
}

class BestCandidate {
 public:
  BestCandidate(const FramedPentagon& pentagon, double least)
      : pentagon_(pentagon), slack_(least) {}

  void offer(const Candidate& candidate) {
    if (is_enough()) return;
    const double slack = slack_of(pentagon_, candidate, slack_);
    if (!(slack > slack_)) return;
    slack_ = slack;
    best_ = candidate;
  }
  [[nodiscard]] const std::optional<Candidate>& best() const { return best_; }
  [[nodiscard]] bool is_enough() const { return slack_ >= kEnoughSlack; }

 private:
  const FramedPentagon& pentagon_;
  double slack_;
  std::optional<Candidate> best_;
};

/// Steiner points on a grid over the whole pentagon.
void offer_grid(const FramedPentagon& p, BestCandidate& best) {
  constexpr int kSteps = 9;
  const double left = std::min(p.a.x, 0.0);
  const double right = std::max(p.c.x, p.y);
  const double top = std::max({p.a.y, p.b.y, p.c.y});
  for (int i = 1; i < kSteps && !best.is_enough(); ++i) {
    const double t = left + (right - left) * i / kSteps;
    for (int j = 1; j < kSteps; ++j) {
      const Vector s{t, top * j / kSteps};
      if (0.1 * p.y < t && t < 0.9 * p.y) {
        best.offer({s, t});
        best.offer({s, p.y / 2});
      } else {
        for (const double part : {0.25, 0.5, 0.75}) best.offer({s, part * p.y});
      }
    }
  }
}

/// Steiner points close to one end of alpha, at the scale of its height: an edge may run far below
/// the size of a cell under a centre (the paper's circle of radius |c_i p_i|).
void offer_near(Vector from, Vector towards, int turn, BestCandidate& best) {
  const Vector d = towards - from;
  const double size = length(d);
  // sin and cos of 4, 8.5, 16 and 30 degrees: from almost along alpha to well below it.
  constexpr std::array<Vector, 4> kTurns{
      {{0.99756, 0.06976}, {0.98902, 0.14781}, {0.96126, 0.27564}, {0.86603, 0.5}}};
  for (const Vector w : kTurns) {
    const Vector u{(d.x * w.x - turn * d.y * w.y) / size, (turn * d.x * w.y + d.y * w.x) / size};
    for (const double part : {0.15, 0.4, 0.8}) {
      const Vector s = from + part * std::min(from.y, size) * u;
      best.offer({s, s.x});
    }
  }
}

/// Where the Steiner point of a hexagon may be.
struct Place {
  Vector s;
  double slack = -1;
};

/// Uphill while the slack is below `most`. The step is halved while no neighbour is better; 2^-12
/// of `size` is finer than the slack is worth.
template <class SlackAt>
Place climb(const SlackAt& slack_at, Place here, double size, double most) {
  for (double step = size / 8; step > size * 0x1p-12 && here.slack < most;) {
    bool better = false;
    for (const Vector d : {Vector{step, 0}, Vector{-step, 0}, Vector{0, step}, Vector{0, -step}}) {
      const double there = slack_at(here.s + d, here.slack);
      if (!(there > here.slack)) continue;
      here = {here.s + d, there};
      better = true;
    }
    if (!better) step /= 2;
  }
  return here;
}

}  // namespace

std::optional<Pentagon> mesh_pentagon(const Domain& domain, EdgeId edge, const FinePoint& x,
                                      const FinePoint& y, LatticePoint a, LatticePoint b,
                                      LatticePoint c, double least) {
  const Vector direction = domain.direction(edge);
  const Vector u = (1 / length(direction)) * direction;
  const auto framed = [&](LatticePoint point) {
    const Vector d = on_lattice(point) - x;
    return Vector{dot(u, d), cross(u, d)};
  };
  const FramedPentagon pentagon{dot(u, y - x), framed(a), framed(b), framed(c)};
  if (!(largest_slack(pentagon) > least)) return std::nullopt;
  BestCandidate best(pentagon, least);
  offer_grid(pentagon, best);
  offer_near(pentagon.a, pentagon.c, -1, best);
  offer_near(pentagon.c, pentagon.a, +1, best);
  if (!best.best()) return std::nullopt;
  // Rounded to the lattice, and judged as it will be.
  const auto unframed = [&](Vector v) { return v.x * u + v.y * turned_left(u); };
  const LatticePoint s = nearest_lattice_point(x, unframed(best.best()->steiner));
  const LatticePoint z = nearest_lattice_point(x, unframed({best.best()->foot, 0}));
  const std::int64_t foot = domain.runs_in_x(edge) ? z.x : z.y;
  const FinePoint at = domain.foot_point(edge, foot);
  const FinePoint steiner = on_lattice(s);
  const double slack = std::min(
      {quad_slack(std::array<FinePoint, 4>{x, at, steiner, on_lattice(a)}),
       quad_slack(std::array<FinePoint, 4>{at, y, on_lattice(c), steiner}),
       quad_slack(std::array<FinePoint, 4>{on_lattice(a), steiner, on_lattice(c), on_lattice(b)})});
  if (!(slack > least)) return std::nullopt;
  return Pentagon{slack, s, foot};
}

std::optional<Hexagon> mesh_hexagon(const FinePoint& x, const FinePoint& v, const FinePoint& y,
                                    LatticePoint a, LatticePoint b, LatticePoint c) {
  const Vector vx = x - v;
  const Vector vy = y - v;
  const Vector va = on_lattice(a) - v;
  const Vector vb = on_lattice(b) - v;
  const Vector vc = on_lattice(c) - v;
  // That of the corners that are the same wherever s lies.
  const double most = std::min({corner_slack(-1.0 * vx, va - vx), corner_slack(vc - vy, -1.0 * vy),
                                corner_slack(va - vb, vc - vb)});
  if (!(most > kSmallestSlack)) return std::nullopt;
  // Exact where it is more than `least`.
  const auto slack_at = [&](Vector s, double least) {
    double slack = quad_slack({vx, Vector{}, s, va});
    if (!(slack > least)) return slack;
    slack = std::min(slack, quad_slack({Vector{}, vy, vc, s}));
    if (!(slack > least)) return slack;
    return std::min(slack, quad_slack({s, vc, vb, va}));
  };
  constexpr std::array<double, 4> kParts{0.3, 0.45, 0.6, 0.8};
  std::array<Place, 4> starts{};
  for (unsigned k = 0; k < 4; ++k) starts[k] = {kParts[k] * vb, slack_at(kParts[k] * vb, -1)};
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Place& p, const Place& q) { return p.slack > q.slack; });
  Place best{};
  for (const Place& start : starts) {
    const Place top = climb(slack_at, start, length(vb), most);
    if (top.slack > best.slack) best = top;
    if (best.slack >= kEnoughSlack) break;
  }
  if (best.slack <= kSmallestSlack) return std::nullopt;
  const LatticePoint s = nearest_lattice_point(v, best.s);
  const double slack = slack_at(on_lattice(s) - v, kSmallestSlack);
  if (!(slack > kSmallestSlack)) return std::nullopt;
  return Hexagon{slack, s};
}

}  // namespace quadbound
