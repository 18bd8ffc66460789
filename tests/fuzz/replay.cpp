/// Hands the files of a corpus to a fuzz target, without libFuzzer. usage: replay TARGET FILE_OR_DIRECTORY...

#include "fuzz/replay.hpp"

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <string>

int main(int argc, char** argv) {
  if (argc < 2 || !fuzz_targets.contains(argv[1])) {
    std::cerr << "usage: replay TARGET FILE_OR_DIRECTORY...\n";
    return 2;
  }
  const FuzzTarget target = fuzz_targets.at(argv[1]);
  std::set<std::filesystem::path> files;
  for (int i = 2; i < argc; ++i) {
    if (!std::filesystem::is_directory(argv[i])) {
      files.insert(argv[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) files.insert(entry.path());
  }
  for (const std::filesystem::path& file : files) {
    std::cerr << file.string() << std::endl;  // the last name is that of the file that ends the process
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) {
      std::cerr << "cannot be read\n";
      return 1;
    }
    try {
      target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    } catch (const std::exception& error) {
      std::cerr << "an exception that is no error of the program: " << error.what() << '\n';
      return 1;
    }
  }
  std::cerr << files.size() << " inputs\n";
  return files.empty() ? 1 : 0;
}
