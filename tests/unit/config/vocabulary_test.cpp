#include <fmt/format.h>

#include <optional>
#include <vector>

#include "unit/config/test_vocabulary.hpp"

namespace creepcontact::config {

Vocabulary test_vocabulary() {
  Vocabulary words;
  words.integrators = {"explicit_euler", "beta_euler", "cvode_bdf", "arkode_erk"};
  words.tables = {{"arkode_erk", {"heun_euler_2_1_2", "bogacki_shampine_4_2_3"}}};
  words.laws = {{"norton", {{"A", "factor"}, {"n", "exponent"}}},
                {"hereditary",
                 {{.name = "compliances", .description = "of the elements", .list = true},
                  {.name = "times", .description = "of retardation", .list = true}}},
                {"expression",
                 {{.name = "rate", .description = "equivalent", .strict = false, .variables = {"q", "T", "t", "eps"}}}},
                {"picky",
                 {{.name = "m", .description = "exponent", .variables = {}, .maximum = 1.0},
                  {.name = "Q", .description = "energy", .strict = false, .required = false, .fallback = {0.0}}},
                 [](const std::vector<std::vector<Function>>& values) {
                   LawValidation verdict{.mistake = {}, .depends_on_temperature = !values[1][0].is_zero()};
                   if (values[0][0]({}) == 0.5) verdict.mistake = {"m", "the number 0.5", "any other"};
                   return verdict;
                 }},
                {"hardening",
                 {{.name = "A", .description = "factor"},
                  {.name = "by",
                   .description = "what hardens",
                   .required = false,
                   .fallback = {0.0},
                   .words = {"strain", "time"}}}}};
  words.validate_larson_miller = [](const std::vector<double>& stress, const std::vector<double>& parameter) {
    std::optional<LawError> mistake;
    if (parameter[0] == 7) mistake = {"stress", fmt::format("{} values", stress.size()), "none"};
    return mistake;
  };
  words.quantities = {
      {"von_mises"},
      {"stress_xx"},
      {.name = "stress_theta", .cylindrical = true},
      {.name = "contact_pressure", .surface_only = true},
      {.name = "contact_area", .surface_only = true, .sum_only = true},
      {.name = "section_force_x", .body_only = true, .sum_only = true, .section = true},
      {.name = "section_moment_x", .body_only = true, .sum_only = true, .moment = true, .section = true}};
  return words;
}

}  // namespace creepcontact::config
