// SPDX-License-Identifier: Apache-2.0
#pragma once
// The bound against the worst ever seen: for each construction the most extreme angles that any
// campaign has met, with the input that has them.

#include <array>
#include <string>
#include <string_view>

#include "cli/polygon_tally.hpp"

namespace quadbound::cli {

/// A JSON file that grows with every campaign that is told to add to it, and a table beside it with
/// the ending .md.
///
/// Guarantees: 1. an entry is replaced by more extreme angles only. 2. Every input can be given to
/// `quadbound fuzz --replay`: a recipe, or a GeoJSON file in the folder that is named as the file
/// without its ending.
class WorstEver {
 public:
  /// Reads what is there, if anything. Errors: InputError.
  explicit WorstEver(std::string path);

  /// `recipe` of a record is its input: a recipe, or the text of a GeoJSON file.
  void add(const std::array<ConstructionTally, kPolygonConstructionCount>& extremes);
  /// Errors: OutputError; what was there before is then still there.
  void write() const;

 private:
  struct Side {
    std::string_view name;
    Record ConstructionTally::*record;
  };
  static constexpr std::array<Side, 2> kSides{
      {{"smallest", &ConstructionTally::smallest}, {"largest", &ConstructionTally::largest}}};

  void read();
  [[nodiscard]] std::string folder() const;
  /// The input as it is told: the recipe, or the name of the file that it is put into.
  [[nodiscard]] std::string input_of(std::size_t construction, const Side& side) const;
  [[nodiscard]] std::string json_text() const;
  [[nodiscard]] std::string table_text() const;

  std::string path_;
  std::array<ConstructionTally, kPolygonConstructionCount> worst_;
};

}  // namespace quadbound::cli
