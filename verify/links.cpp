// SPDX-License-Identifier: Apache-2.0
#include "verify/links.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace quadbound::judge {
namespace {

/// Looks at the vertices of one chunk, one after the other.
class Linker {
 public:
  Linker(const CornersByVertex& corners, const std::vector<std::uint8_t>& passes)
      : corners_(corners), passes_(passes) {}

  Links link(VertexId begin, VertexId end) {
    for (VertexId v = begin; v < end; ++v) {
      const auto at = corners_.at(v);
      if (at.empty()) continue;
      ++links_.used_vertices;
      if (is_surely_closed(at)) {
        links_.directed_edges += at.size();
        check_turns(v, at);
      } else {
        link_any(v, at);
      }
    }
    return std::move(links_);
  }

 private:
  using Outgoing = std::pair<VertexId, CornerIndex>;  ///< the other end, the corner it leaves

  /// Whether the outgoing edges differ and each is paired. The usual numbers of corners have a
  /// loop of their own, for speed; for many corners this says no.
  [[nodiscard]] bool is_surely_closed(std::span<const CornerIndex> at) const {
    switch (at.size()) {
      case 2:
        return is_closed<2>(at);
      case 3:
        return is_closed<3>(at);
      case 4:
        return is_closed<4>(at);
      case 5:
        return is_closed<5>(at);
      case 6:
        return is_closed<6>(at);
      case 7:
        return is_closed<7>(at);
      case 8:
        return is_closed<8>(at);
      default:
        return false;
    }
  }

  template <std::size_t kCount>
  [[nodiscard]] bool is_closed(std::span<const CornerIndex> at) const {
    std::array<VertexId, kCount> next;
    std::array<VertexId, kCount> previous;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < kCount; ++i) {
      next[i] = corners_.next(at[i]);
      previous[i] = corners_.previous(at[i]);
    }
    bool closed = true;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < kCount; ++i) {
      bool paired = false;
#pragma GCC unroll 8
      for (std::size_t j = 0; j < kCount; ++j) paired |= previous[j] == next[i];
#pragma GCC unroll 8
      for (std::size_t j = 0; j < i; ++j) closed &= next[j] != next[i];
      closed &= paired;
    }
    return closed;
  }

  void check_turns(VertexId v, std::span<const CornerIndex> at) {
    unsigned turns = 0;
    for (const CornerIndex c : at) turns += (unsigned{passes_[c / 4]} >> (c % 4)) & 1U;
    if (turns != 1 && !links_.winding) links_.winding = {v, turns};
  }

  void link_any(VertexId v, std::span<const CornerIndex> at) {
    outgoing_.clear();
    incoming_.clear();
    for (const CornerIndex c : at) {
      outgoing_.emplace_back(corners_.next(c), c);
      incoming_.push_back(corners_.previous(c));
    }
    std::sort(outgoing_.begin(), outgoing_.end());
    std::sort(incoming_.begin(), incoming_.end());
    drop_doubled(v);
    links_.directed_edges += outgoing_.size();
    std::optional<Outgoing> unpaired;
    std::size_t count = 0;
    for (const Outgoing& edge : outgoing_) {
      if (std::binary_search(incoming_.begin(), incoming_.end(), edge.first)) continue;
      links_.unpaired.push_back({v, edge.first, edge.second});
      unpaired = edge;
      ++count;
    }
    if (count == 0) check_turns(v, at);
    if (count == 1 && fan_size(unpaired->second) < at.size() && !links_.second_fan)
      links_.second_fan = v;
  }

  void drop_doubled(VertexId v) {
    const auto same = [](const Outgoing& a, const Outgoing& b) { return a.first == b.first; };
    const auto twice = std::adjacent_find(outgoing_.begin(), outgoing_.end(), same);
    if (twice == outgoing_.end()) return;
    if (!links_.doubled)
      links_.doubled = {{v, twice->first, twice->second}, std::next(twice)->second};
    list_surplus(v);
    outgoing_.erase(std::unique(outgoing_.begin(), outgoing_.end(), same), outgoing_.end());
  }

  void list_surplus(VertexId v) {
    for (auto edge = outgoing_.begin(); edge != outgoing_.end();) {
      const VertexId to = edge->first;
      const auto end = std::find_if(edge, outgoing_.end(),
                                    [&](const Outgoing& other) { return other.first != to; });
      const auto [first, last] = std::equal_range(incoming_.begin(), incoming_.end(), to);
      const auto back = std::max<std::ptrdiff_t>(last - first, 1);  // 1: unpaired, and listed
      for (auto i = back; i < end - edge; ++i) links_.surplus.push_back({v, to, edge->second});
      edge = end;
    }
  }

  /// Corners counter-clockwise from the one that the unpaired edge leaves to an unpaired edge.
  [[nodiscard]] std::size_t fan_size(CornerIndex corner) const {
    for (std::size_t size = 1; size <= outgoing_.size(); ++size) {
      const VertexId last = corners_.previous(corner);
      const auto next = std::lower_bound(outgoing_.begin(), outgoing_.end(), Outgoing{last, 0});
      if (next == outgoing_.end() || next->first != last) return size;
      corner = next->second;
    }
    return outgoing_.size();
  }

  const CornersByVertex& corners_;
  const std::vector<std::uint8_t>& passes_;
  Links links_;
  std::vector<Outgoing> outgoing_;
  std::vector<VertexId> incoming_;
};

void merge(Links& into, Links& from) {
  into.used_vertices += from.used_vertices;
  into.directed_edges += from.directed_edges;
  into.unpaired.insert(into.unpaired.end(), from.unpaired.begin(), from.unpaired.end());
  into.surplus.insert(into.surplus.end(), from.surplus.begin(), from.surplus.end());
  if (!into.doubled) into.doubled = from.doubled;
  if (!into.winding) into.winding = from.winding;
  if (!into.second_fan) into.second_fan = from.second_fan;
}

}  // namespace

CornersByVertex::CornersByVertex(const std::vector<Quad>& quads, std::size_t vertices,
                                 const Threads& threads)
    : quads_(quads), starts_(vertices + 1), corners_(4 * quads.size()) {
  // Every thread reads all quads and serves its own range of vertices: no atomics, and the order
  // within a vertex is always the same.
  const std::size_t ranges = threads.count();
  const auto for_corners = [&](std::size_t range, const auto& act) {
    const auto first = static_cast<VertexId>(vertices * range / ranges);
    const auto size = static_cast<VertexId>(vertices * (range + 1) / ranges) - first;
    for (std::size_t q = quads.size(); q-- > 0;)
      for (std::size_t i = 4; i-- > 0;)
        if (const VertexId v = quads[q][i]; v - first < size)
          act(v, static_cast<CornerIndex>(4 * q + i));
  };
  threads.for_each(ranges, [&](std::size_t range) {
    for_corners(range, [&](VertexId v, CornerIndex) { ++starts_[v]; });
  });
  std::uint32_t end = 0;
  for (std::uint32_t& start : starts_) start = end += start;
  // From the ends of the lists backwards, so that starts_ ends as what it is called.
  threads.for_each(ranges, [&](std::size_t range) {
    for_corners(range, [&](VertexId v, CornerIndex c) { corners_[--starts_[v]] = c; });
  });
}

Links link_corners(const CornersByVertex& corners, const std::vector<std::uint8_t>& passes,
                   const Threads& threads) {
  auto parts =
      for_chunks<Links>(threads, corners.vertices(), [&](std::size_t begin, std::size_t end) {
        return Linker(corners, passes)
            .link(static_cast<VertexId>(begin), static_cast<VertexId>(end));
      });
  Links total;
  for (Links& part : parts) merge(total, part);
  return total;
}

}  // namespace quadbound::judge
