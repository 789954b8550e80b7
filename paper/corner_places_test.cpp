// SPDX-License-Identifier: Apache-2.0
// lemma-12: corners with the same place in their cells at every level.
#include "paper/corner_places.hpp"

#include <gtest/gtest.h>

#include <string>

namespace quadbound {
namespace {

TEST(CornerPlaces, AllAreMeshedAndProvedInOneRootSquare) {
  NoWatcher watcher;
  const CornerPlaces places = search_corner_places(40, watcher);
  const DeadEndTally all = places.total();
  EXPECT_TRUE(places.hold()) << places.worst;
  EXPECT_EQ(places.rows.size(), 36U);
  EXPECT_EQ(all.corners, 36U * 40U);
  // They are of all kinds, and some do meet dead ends.
  EXPECT_GT(all.acute, 100U);
  EXPECT_GT(all.with_dead_ends, 0U);
  EXPECT_LT(all.most_rounds, 10U);
}

TEST(CornerPlaces, DependOnTheArgumentsAlone) {
  NoWatcher watcher;
  const std::string once = to_text(search_corner_places(2, watcher));
  EXPECT_EQ(to_text(search_corner_places(2, watcher)), once);
  EXPECT_NE(once.find("| all |  | 72 |"), std::string::npos) << once;
}

TEST(CornerPlaces, HoldOnlyWhereNothingWasRefusedAndAllWasProved) {
  const CornerPlace good{{1, 2}, {1, 3}, {.corners = 1}};
  CornerPlace refused = good;
  refused.tally.refused = 1;
  CornerPlace not_proved = good;
  not_proved.tally.not_proved = 1;
  EXPECT_TRUE((CornerPlaces{{good}, ""}.hold()));
  EXPECT_FALSE((CornerPlaces{{good, refused}, ""}.hold()));
  EXPECT_FALSE((CornerPlaces{{not_proved, good}, ""}.hold()));
}

}  // namespace
}  // namespace quadbound
