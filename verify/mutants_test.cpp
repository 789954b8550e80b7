// SPDX-License-Identifier: Apache-2.0
// Judging the judge at random: valid meshes are damaged in every way we could think of, and a
// second, naive judge must agree on every claim. A kind of damage that (almost) never changes a
// verdict would test nothing, so that is counted too.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "model/errors.hpp"
#include "model/validate.hpp"
#include "verify/mutations.hpp"
#include "verify/naive_judge.hpp"
#include "verify/test_meshes.hpp"
#include "verify/test_polygons.hpp"

namespace quadbound::test {
namespace {

// --- agreement -----------------------------------------------------------------------------------

/// What the judges are asked: about a set of points, or about a polygon.
enum class Subject { points, polygon };

Report judge(Subject subject, const Case& c, const VerifyOptions& options) {
  return subject == Subject::points ? verify_points(c.points, c.mesh, options)
                                    : verify_polygon(c.polygon, c.mesh, options);
}
NaiveReport judge_naively(Subject subject, const Case& c) {
  return subject == Subject::points ? naive_judge(c.points, c.mesh)
                                    : naive_judge(c.polygon, c.mesh);
}

/// no-overlap is the one claim that our judge may leave open where the naive one does not.
void expect_same_overlap(Verdict ours, const NaiveReport& naive, const char* boundary_claim) {
  const Verdict theirs = naive.exact.at("no-overlap");
  const bool must_decide = naive.exact.at("strictly-convex") == Verdict::holds &&
                           naive.exact.at("conforming") == Verdict::holds &&
                           naive.exact.at(boundary_claim) == Verdict::holds;
  if (must_decide || ours != Verdict::not_decided) {
    EXPECT_EQ(name(ours), name(theirs));
  }
}

void expect_same_corners(const Report& report, const NaiveReport& naive) {
  if (report.find("min-angle")->exact == Verdict::not_decided) return;
  for (const auto& [id, corner] :
       {std::pair{"min-angle", naive.smallest}, std::pair{"max-angle", naive.largest}}) {
    const auto& worst = report.find(id)->worst;
    ASSERT_EQ(worst.has_value(), corner.has_value()) << id;
    if (worst) {
      EXPECT_EQ(std::pair(*worst->place.quad, *worst->place.corner), *corner) << id;
    }
  }
  if (!report.polygon) return;
  EXPECT_EQ(report.polygon->whole_corners, naive.whole.size());
  if (report.polygon->steiner) {
    EXPECT_EQ(report.polygon->steiner->total, report.boundary_edges - report.input_points);
  }
}

/// Both judges on one mesh; returns our verdicts.
std::map<std::string, std::string> expect_agreement(Subject subject, const Case& c) {
  VerifyOptions options;
  const Report report = judge(subject, c, options);
  options.always_compare_positions = true;
  EXPECT_EQ(to_json(report), to_json(judge(subject, c, options)));
  const NaiveReport naive = judge_naively(subject, c);
  std::map<std::string, std::string> verdicts;
  for (const Claim& claim : report.claims) {
    verdicts[claim.id] = name(claim.exact);
    if (claim.stored) verdicts[claim.id + " as stored"] = name(claim.stored->verdict);
    if (claim.id == "no-overlap") {
      expect_same_overlap(claim.exact, naive, report.polygon ? "boundary-kept" : "one-boundary");
    } else if (claim.id != report.theorem) {
      EXPECT_EQ(name(claim.exact), name(naive.exact.at(claim.id))) << claim.id;
    }
    const auto stored = naive.stored.find(claim.id);
    EXPECT_EQ(claim.stored.has_value(), stored != naive.stored.end()) << claim.id;
    if (claim.stored && stored != naive.stored.end()) {
      EXPECT_EQ(name(claim.stored->verdict), name(stored->second)) << claim.id;
    }
  }
  expect_same_corners(report, naive);
  return verdicts;
}

/// How often each verdict on each claim was given.
using Tally = std::map<std::string, std::map<std::string, int>>;

/// Every claim must have been found to hold and to fail, and to be open where that is possible.
void expect_all_verdicts(Subject subject, Tally& tally) {
  const std::set<std::string> never_open{"all-quad", "size-3N", "size-5N", "thm-1", "thm-13"};
  const int least = subject == Subject::points ? 50 : 25;
  for (auto& [claim, verdicts] : tally) {
    EXPECT_GE(verdicts["holds"], 50) << claim;
    EXPECT_GE(verdicts["fails"], 25) << claim;
    const bool is_stored = claim.find("stored") != std::string::npos;
    if (!is_stored && never_open.count(claim) == 0) {
      EXPECT_GE(verdicts["not-decided"], least) << claim;
    }
  }
  EXPECT_GE(tally["min-angle as stored"]["within-rounding"], least);
  if (subject == Subject::points) {
    EXPECT_GE(tally["max-angle as stored"]["within-rounding"], least);
  }
}

std::vector<Case> bases_for(Subject subject, std::uint64_t seed) {
  return subject == Subject::points ? valid_cases(seed) : valid_polygon_cases();
}
std::vector<Mutation> mutations_for(Subject subject) {
  return subject == Subject::points ? mutations_for_points() : mutations_for_polygons();
}

/// Damages a case; a polygon that is not valid any more stays as it was, since the judge wants a
/// valid one.
void damage(Subject subject, const Mutation& mutation, Case& c, Random& random) {
  const Polygon before = c.polygon;
  mutation.damage(c, random);
  if (subject == Subject::points) return;
  try {
    c.polygon = normalised(c.polygon);
  } catch (const InputError&) {
    c.polygon = before;
  }
}

void expect_agreement_on_mutants(Subject subject, std::uint64_t seed, int mutants_of_a_kind) {
  Random random(seed);
  const std::vector<Case> bases = bases_for(subject, seed);
  std::vector<std::map<std::string, std::string>> sound;
  sound.reserve(bases.size());
  for (const Case& base : bases) sound.push_back(expect_agreement(subject, base));
  Tally tally;
  for (const Mutation& mutation : mutations_for(subject)) {
    int effective = 0;
    for (int i = 0; i < mutants_of_a_kind; ++i) {
      const std::size_t base = pick(random, bases.size());
      Case mutant = bases[base];
      damage(subject, mutation, mutant, random);
      SCOPED_TRACE(std::string(mutation.name) + ", " + mutant.name + ", number " +
                   std::to_string(i));
      const auto verdicts = expect_agreement(subject, mutant);
      if (verdicts != sound[base]) ++effective;
      for (const auto& [claim, verdict] : verdicts) ++tally[claim][verdict];
      if (testing::Test::HasFailure()) return;
    }
    testing::Test::RecordProperty(mutation.name, effective);
    if (mutation.effective_percent == 0) {
      EXPECT_EQ(effective, 0) << mutation.name;
    } else {
      EXPECT_GE(100 * effective, mutation.effective_percent * mutants_of_a_kind) << mutation.name;
    }
  }
  expect_all_verdicts(subject, tally);
}

bool can_be_damaged(const Mesh& mesh) {
  for (const Quad& q : mesh.quads)
    for (const VertexId v : q)
      if (v >= mesh.vertices.size()) return false;
  return !mesh.quads.empty();
}

void expect_agreement_on_mutants_of_mutants(Subject subject, std::uint64_t seed, int count) {
  Random random(seed);
  const std::vector<Case> bases = bases_for(subject, seed);
  const std::vector<Mutation> mutations = mutations_for(subject);
  for (int i = 0; i < count; ++i) {
    Case mutant = bases[pick(random, bases.size())];
    std::string names;
    for (std::size_t k = 2 + pick(random, 3); k-- > 0 && can_be_damaged(mutant.mesh);) {
      const Mutation& mutation = mutations[pick(random, mutations.size())];
      damage(subject, mutation, mutant, random);
      names += std::string(mutation.name) + ", ";
    }
    SCOPED_TRACE(names + mutant.name);
    expect_agreement(subject, mutant);
    if (testing::Test::HasFailure()) return;
  }
}

class Mutants : public testing::TestWithParam<int> {
 protected:
  static std::uint64_t seed() { return static_cast<std::uint64_t>(GetParam()); }
};

TEST_P(Mutants, BothJudgesAgreeOnEveryClaim) {
  expect_agreement_on_mutants(Subject::points, seed(), 180);
}
TEST_P(Mutants, BothJudgesAgreeOnMutantsOfMutants) {
  expect_agreement_on_mutants_of_mutants(Subject::points, seed() + 1000, 600);
}

// 4 * (29 * 180 + 600) = 23,280 mutants.
INSTANTIATE_TEST_SUITE_P(Seeds, Mutants, testing::Range(1, 5));

class PolygonMutants : public Mutants {};

TEST_P(PolygonMutants, BothJudgesAgreeOnEveryClaim) {
  expect_agreement_on_mutants(Subject::polygon, seed(), 45);
}
TEST_P(PolygonMutants, BothJudgesAgreeOnMutantsOfMutants) {
  expect_agreement_on_mutants_of_mutants(Subject::polygon, seed() + 1000, 300);
}

// 3 * (34 * 45 + 300) = 5,490 mutants.
INSTANTIATE_TEST_SUITE_P(Seeds, PolygonMutants, testing::Range(1, 4));

}  // namespace
}  // namespace quadbound::test
