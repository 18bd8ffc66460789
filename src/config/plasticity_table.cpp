/// [materials.<name>.plasticity]

#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

constexpr const char* rising = "numbers that do not fall: a stress that falls with the strain depends on the mesh";

Value<PlasticCurve> curve_table() {
  const auto keys = table<PlasticCurve>({
      field<PlasticCurve>("T", &PlasticCurve::T, number(), "temperature of this curve")
          .otherwise("required if there are several")
          .in("temperature"),
      field<PlasticCurve>("plastic_strain", &PlasticCurve::plastic_strain, list(number({.min = 0})),
                          "plastic strains, from 0 on, increasing", Presence::required),
      field<PlasticCurve>("stress", &PlasticCurve::stress, list(number(greater(0))),
                          "yield stresses at these strains; linear in between, constant after the last one",
                          Presence::required)
          .in("stress"),
  });
  return converted<PlasticCurve>(
      keys, [](PlasticCurve curve, const Item& item, Context& context) -> std::optional<PlasticCurve> {
        const std::vector<double>&strain = curve.plastic_strain, &stress = curve.stress;
        if (strain.empty() || stress.empty()) return curve;  // reported as missing
        if (strain.size() != stress.size())
          context.errors.add(item.child("stress").location, fmt::format("a list of {}", stress.size()),
                             fmt::format("as many values as 'plastic_strain' has: {}", strain.size()));
        if (strain.front() != 0 || std::ranges::adjacent_find(strain, std::greater_equal<>()) != strain.end())
          context.errors.add(item.child("plastic_strain").location, fmt::format("[{}]", fmt::join(strain, ", ")),
                             "increasing numbers, the first one 0");
        if (!std::ranges::is_sorted(stress))
          context.errors.add(item.child("stress").location, fmt::format("[{}]", fmt::join(stress, ", ")), rising);
        return curve;
      });
}

Value<KinematicHardening> kinematic_table() {
  return table<KinematicHardening>({
      field<KinematicHardening>("C", &KinematicHardening::C, function({"T"}, {.min = 0}),
                                "modulus of the back stress X: dX = 2/3 C d eps_p - gamma X dp", Presence::required)
          .in("stress"),
      field<KinematicHardening>("gamma", &KinematicHardening::gamma, function({"T"}, {.min = 0}),
                                "its recall; 0: linear. X tends to C/gamma"),
  });
}

void check(const Plasticity& given, const Item& item, Context& context) {
  if (!given.yield_stress && given.curve.empty())
    context.errors.add(item.location, "no yield stress", "yield_stress, or curve");
  if (!given.curve.empty())
    for (const std::string& key : given_keys(item, {"yield_stress", "hardening_modulus"}))
      context.errors.add(item.child(key).location, "given together with curve", "one of the two");
  if (given.curve.size() < 2) return;
  for (std::size_t i = 0; i < given.curve.size(); ++i) {
    const bool is_later =
        i == 0 || !given.curve[i - 1].T || !given.curve[i].T || *given.curve[i].T > *given.curve[i - 1].T;
    if (!given.curve[i].T || !is_later)
      context.errors.add(item.child("curve").location,
                         given.curve[i].T ? fmt::format("T = {:g} after {:g}", *given.curve[i].T, *given.curve[i - 1].T)
                                          : fmt::format("curve {} has no T", i + 1),
                         "several curves with increasing temperatures T");
  }
}

}  // namespace

Value<Plasticity> plasticity_table() {
  const auto keys = table<Plasticity>({
      field<Plasticity>("yield_stress", &Plasticity::yield_stress, function({"T"}, greater(0)),
                        "von Mises stress at which the material begins to flow")
          .otherwise("required without `curve`")
          .in("stress"),
      field<Plasticity>("hardening_modulus", &Plasticity::hardening_modulus, function({"T"}, {.min = 0}),
                        "linear isotropic hardening: yield stress per accumulated plastic strain")
          .in("stress"),
      field<Plasticity>("curve", &Plasticity::curve, one_or_more_tables(curve_table()),
                        "yield stress over accumulated plastic strain; a list with `T`"),
      field<Plasticity>("kinematic", &Plasticity::kinematic, tables(kinematic_table()),
                        "back stresses that act together"),
  });
  return converted<Plasticity>(keys, [](Plasticity given, const Item& item, Context& context) {
    given.location = item.location;
    check(given, item, context);
    return std::optional(std::move(given));
  });
}

}  // namespace creepcontact::config
