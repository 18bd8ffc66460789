/// Temperatures in .vtu files.

#include "../../src/io/vtu_temperatures.hpp"
#include "fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  fuzz::may_refuse([&] {
    const io::PointTemperatures read = io::parse_vtu(fuzz::text_of(data, size), "fuzz.vtu", "");
    fuzz::require(!read.points.empty(), "what is accepted has points");
    fuzz::require(read.values.size() == 1 && read.values[0].size() == read.points.size(), "a value at every point");
  });
  return 0;
}
