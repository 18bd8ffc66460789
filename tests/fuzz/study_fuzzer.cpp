/// Studies: the file and the runs that it plans.

#include <string>

#include "creepcontact/config/study.hpp"
#include "fuzz_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  fuzz::may_refuse([&] {
    const config::Study study = config::parse_study(std::string(fuzz::text_of(data, size)), "cases/study.toml");
    for (const config::PlannedRun& run : config::plan(study)) config::overrides(study, run);
    for (const config::Product& product : config::products(study)) config::axis_of_curves(study, product);
  });
  return 0;
}
