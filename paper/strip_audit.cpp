// SPDX-License-Identifier: Apache-2.0
#include "paper/strip_audit.hpp"

#include <algorithm>
#include <array>

#include "model/angle.hpp"

namespace quadbound {
namespace {

/// The frame is made finer by this, so that Steiner points are integers. Within a cell of 2^18
/// units and a direction of 2^17, coordinates from the start of the strip stay below 2^46, and the
/// tests far inside 128 bits.
constexpr Int128 kFiner = 1 << 10;

/// Two edges a, b, c of the chain between the feet x and y.
class StripPentagon {
 public:
  StripPentagon(const Framed& x, const Framed& y, const Framed& a, const Framed& b, const Framed& c,
                bool free_foot)
      : x_(x), y_(y), a_(a), b_(b), c_(c), free_foot_(free_foot) {}

  [[nodiscard]] bool can_be_meshed() const { return try_rays() || try_grid(); }

 private:
  static constexpr int kSteps = 16;

  /// With the foot of s straight below it, or, if it is free, elsewhere.
  [[nodiscard]] bool is_good_with(const Framed& s) const {
    if (s.h <= 0 || !is_good({a_, s, c_, b_})) return false;
    if (is_good_with(s, {s.t, 0})) return true;
    if (!free_foot_) return false;
    for (int k = 1; k < kSteps; ++k)
      if (is_good_with(s, {(k * x_.t + (kSteps - k) * y_.t) / kSteps, 0})) return true;
    return is_good_with(s, {(s.t + x_.t) / 2, 0}) || is_good_with(s, {(s.t + y_.t) / 2, 0});
  }
  [[nodiscard]] bool is_good_with(const Framed& s, const Framed& z) const {
    return x_.t < z.t && z.t < y_.t && is_good({x_, z, s, a_}) && is_good({z, y_, c_, s});
  }

  /// Cases 2a and 2b: s on a circle around c_i or c_(i+1), 18.43 degrees off the edge to its foot,
  /// or arctan(1/7) = 8.13 degrees and more below c_i c_(i+1).
  [[nodiscard]] bool try_rays() const {
    constexpr std::array<std::array<int, 2>, 5> kBelow{{{7, 1}, {6, 1}, {4, 1}, {2, 1}, {1, 1}}};
    if (try_ray(a_, {1, -3}) || try_ray(c_, {-1, -3})) return true;
    const Framed d = c_ - a_;
    return std::any_of(kBelow.begin(), kBelow.end(), [&](const std::array<int, 2>& turn) {
      const auto [p, q] = turn;
      return try_ray(a_, {p * d.t + q * d.h, p * d.h - q * d.t}) ||
             try_ray(c_, {-p * d.t + q * d.h, -p * d.h - q * d.t});
    });
  }

  /// At parts of the height of `from`, and of |a c|.
  [[nodiscard]] bool try_ray(const Framed& from, const Framed& direction) const {
    const auto size = [](const Framed& v) {
      return std::max(v.t < 0 ? -v.t : v.t, v.h < 0 ? -v.h : v.h);
    };
    for (const Int128 reach : {std::min(from.h, size(c_ - a_)), size(c_ - a_)}) {
      for (int k = 1; k < kSteps; ++k) {
        const Int128 scale = kSteps * size(direction);
        const Framed s{from.t + direction.t * reach * k / scale,
                       from.h + direction.h * reach * k / scale};
        if (is_good_with(s)) return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool try_grid() const {
    const Int128 top = std::max({a_.h, b_.h, c_.h});
    for (int i = 1; i < kSteps; ++i)
      for (int j = 1; j < kSteps; ++j)
        if (is_good_with({x_.t + (y_.t - x_.t) * i / kSteps, top * j / kSteps})) return true;
    return false;
  }

  Framed x_, y_, a_, b_, c_;
  bool free_foot_;
};

/// Four edges C, R, C: the edges of the reflex vertex's cell go on to s on c_i c_(i+1) and its
/// foot.
bool is_good_around_chord(const std::vector<Framed>& v, const Framed& x, const Framed& y) {
  const Framed d = v[4] - v[0];
  constexpr int kSteps = 16;
  for (int k = 1; k < kSteps; ++k) {
    const Framed s{v[0].t + d.t * k / kSteps, v[0].h + d.h * k / kSteps};
    const Framed z{s.t, 0};
    if (is_good({v[0], s, v[2], v[1]}) && is_good({s, v[4], v[3], v[2]}) &&
        is_good({x, z, s, v[0]}) && is_good({z, y, v[4], s}))
      return true;
  }
  return false;
}

/// The fewest quads that the pieces need from one foot to the last.
class Pieces {
 public:
  Pieces(const std::vector<Framed>& chain, const Framed& first, const Framed& last, Int128 rise,
         Int128 run, bool free_foot)
      : v_(chain), first_(first), last_(last), rise_(rise), run_(run), free_foot_(free_foot) {}

  [[nodiscard]] std::optional<unsigned> fewest() const { return from(0, first_); }

 private:
  [[nodiscard]] std::size_t end() const { return v_.size() - 1; }

  [[nodiscard]] std::vector<Framed> feet(std::size_t k) const {
    if (k == end()) return {last_};
    return {{v_[k].t, 0}, {v_[k].t - rise_ * v_[k].h / run_, 0}};
  }

  [[nodiscard]] std::optional<unsigned> from(std::size_t k, const Framed& x) const {
    if (k == end()) return 0;
    std::optional<unsigned> best;
    for (std::size_t next = k + 1; next <= std::min(k + 4, end()); ++next) {
      for (const Framed& y : feet(next)) {
        if (!(x.t < y.t)) continue;
        const auto rest = from(next, y);
        if (!rest || (best && *rest >= *best)) continue;
        if (const auto here = piece(k, next, x, y); here && (!best || *here + *rest < *best))
          best = *here + *rest;
      }
    }
    return best;
  }

  [[nodiscard]] std::optional<unsigned> piece(std::size_t k, std::size_t next, const Framed& x,
                                              const Framed& y) const {
    if (next == k + 1 && is_good({x, y, v_[next], v_[k]})) return 1;
    if (next == k + 2 && is_pentagon_meshed(x, y, v_[k], v_[k + 1], v_[k + 2], free_foot_))
      return 3;
    if (next == k + 3 && is_good({v_[k], v_[next], v_[k + 2], v_[k + 1]}) &&
        is_good({x, y, v_[next], v_[k]}))
      return 2;
    if (next == k + 4 &&
        is_good_around_chord({v_.begin() + static_cast<std::ptrdiff_t>(k), v_.end()}, x, y))
      return 4;
    return std::nullopt;
  }

  const std::vector<Framed>& v_;
  Framed first_;
  Framed last_;
  Int128 rise_;
  Int128 run_;
  bool free_foot_;
};

}  // namespace

bool is_good(const std::array<Framed, 4>& quad) {
  for (unsigned k = 0; k < 4; ++k) {
    const Framed u = quad[(k + 1) & 3U] - quad[k];
    const Framed v = quad[(k + 3) & 3U] - quad[k];
    if (!within(Corner<Int128>{cross(u, v), dot(u, v)}, kTheorem13)) return false;
  }
  return true;
}

bool is_pentagon_meshed(const Framed& x, const Framed& y, const Framed& a, const Framed& b,
                        const Framed& c, bool free_foot) {
  return StripPentagon(x, y, a, b, c, free_foot).can_be_meshed();
}

std::optional<StripMesh> mesh_strip_by_lemma_11(const std::vector<Framed>& chain, Int128 rise,
                                                Int128 run) {
  std::vector<Framed> v;
  v.reserve(chain.size());
  for (const Framed& p : chain) v.push_back({(p.t - chain.front().t) * kFiner, p.h * kFiner});
  const Framed first{v.front().t, 0};
  const Framed last{v.back().t, 0};
  for (const bool free_foot : {false, true})
    if (const auto quads = Pieces(v, first, last, rise, run, free_foot).fewest())
      return StripMesh{*quads, free_foot};
  // "The point p_i can be moved so that the edge c_i p_i swings outward."
  for (const int sixteenths : {1, 2, 3, 4, 6, 8}) {
    const Framed left{first.t - v.front().h * sixteenths / 16, 0};
    const Framed right{last.t + v.back().h * sixteenths / 16, 0};
    for (const auto& [x, y] : {std::pair{left, last}, {first, right}, {left, right}})
      if (const auto quads = Pieces(v, x, y, rise, run, true).fewest())
        return StripMesh{*quads, true};
  }
  return std::nullopt;
}

std::string turns_of(const std::vector<Framed>& chain) {
  std::string turns;
  for (std::size_t k = 1; k + 1 < chain.size(); ++k) {
    const Int128 turn = cross(chain[k] - chain[k - 1], chain[k + 1] - chain[k]);
    turns += turn < 0 ? 'C' : (turn > 0 ? 'R' : 'S');
  }
  return turns;
}

}  // namespace quadbound
