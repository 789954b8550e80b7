// SPDX-License-Identifier: Apache-2.0
// write_samples FOLDER: every sample mesh in every format, for the tests that read them back with
// other people's programs.

#include <exception>
#include <filesystem>
#include <iostream>

#include "model/write_mesh.hpp"
#include "model/write_samples.hpp"

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: write_samples FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path folder(arguments[1]);
    std::filesystem::create_directories(folder);
    for (const quadbound::SampleMesh& sample : quadbound::sample_meshes())
      for (const char* extension : {".json", ".vtu", ".msh", ".obj", ".svg", ".pdf", ".png"})
        quadbound::write_mesh(folder / (sample.name + extension), sample.mesh);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
