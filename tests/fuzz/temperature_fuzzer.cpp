/// Temperatures in CSV.

#include <algorithm>

#include "creepcontact/io/temperatures/temperature_reader.hpp"
#include "fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  fuzz::may_refuse([&] {
    const io::PointTemperatures read = io::parse_temperatures(fuzz::text_of(data, size), "fuzz.csv");
    fuzz::require(!read.points.empty(), "what is accepted has points");
    fuzz::require(read.values.size() == read.times.size(), "values at every time");
    fuzz::require(std::is_sorted(read.times.begin(), read.times.end()), "times increase");
    for (const std::vector<double>& values : read.values)
      fuzz::require(values.size() == read.points.size(), "a value at every point");
  });
  return 0;
}
