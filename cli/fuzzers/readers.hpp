// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the fuzzers ask of the readers: any text is refused on one line that names the file, or
// read; and what was read, written and read again is the same. Each ends the program on a finding.

#include <string_view>

namespace quadbound::fuzzer {

void geojson(std::string_view text);
void poly(std::string_view text);
void wkt(std::string_view text);

void csv(std::string_view text);
void node(std::string_view text);
void xyz(std::string_view text);

void mesh_json(std::string_view text);
void msh(std::string_view text);
void obj(std::string_view text);

}  // namespace quadbound::fuzzer
