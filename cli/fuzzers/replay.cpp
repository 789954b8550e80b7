// SPDX-License-Identifier: Apache-2.0
// Runs a libFuzzer target on files, and on all files of folders, without libFuzzer: a target that
// finds something ends the program. Status 2 where there is no file at all.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "model/files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::vector<std::string> files_of(const std::string& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

void replay(const std::string& file) {
  std::fprintf(stderr, "%s\n", file.c_str());  // before, so that it is known which one failed
  const std::string bytes = quadbound::read_file(file);
  // libFuzzer's own type for bytes.
  (void)LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int count, char** arguments) try {
  std::size_t replayed = 0;
  for (int i = 1; i < count; ++i)
    for (const std::string& file : files_of(arguments[i])) {
      replay(file);
      ++replayed;
    }
  std::fprintf(stderr, "%zu files, nothing found\n", replayed);
  return replayed == 0 ? 2 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
