/// Geometries (.geo) as they are scanned before Gmsh sees them: what is given a value from outside is an identifier.

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "fuzz_target.hpp"
#include "io/msh/geo_scan.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "creepcontact_fuzz.geo";
  std::ofstream(file, std::ios::binary) << fuzz::text_of(data, size);
  fuzz::may_refuse([&] {
    const io::GeoScan scan = io::scan_geo(file);
    for (const std::string& name : scan.constants)
      fuzz::require(io::is_identifier(name), "a constant that can be overridden has an identifier");
    const auto lines = std::count(data, data + size, std::uint8_t{'\n'}) + 1;
    for (const auto* found : {&scan.reaching_out, &scan.unclear, &scan.lost})
      for (const io::GeoStatement& statement : *found)
        fuzz::require(statement.line >= 0 && statement.line <= lines, "statements lie in the file");
  });
  return 0;
}
