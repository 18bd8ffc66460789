/// Expressions in the values of functions.

#include <cmath>
#include <stdexcept>
#include <string>

#include "creepcontact/base/function.hpp"
#include "fuzz_target.hpp"

namespace creepcontact {
namespace {

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

void evaluate(const Function& function) {
  constexpr Arguments somewhere{.x = 1.5, .y = -2, .z = 0.25, .t = 100, .T = 550, .q = 120, .eps = 1e-3};
  const double first = function(somewhere);
  function({});
  fuzz::require(same(function(somewhere), first), "a value depends on the arguments alone");
  if (function.is_constant()) fuzz::require(std::isfinite(first), "constants are finite");
  function.breakpoints(100);
}

}  // namespace
}  // namespace creepcontact

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  try {
    evaluate(Function::expression(std::string(fuzz::text_of(data, size)), {"x", "y", "z", "t", "T", "q", "eps"}));
  } catch (const std::invalid_argument& error) {
    fuzz::require(error.what()[0] != '\0', "an error says what is wrong");
  }
  return 0;
}
