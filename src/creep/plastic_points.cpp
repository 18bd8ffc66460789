#include "plastic_points.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "creepcontact/base/error.hpp"

namespace creepcontact::creep {
namespace {

double accumulated_at(std::size_t point, const std::vector<double>& accumulated) {
  return accumulated.empty() ? 0 : accumulated[point];
}

}  // namespace

PlasticPoints::PlasticPoints(const mechanics::Body& body, const mechanics::BodyConditions& at)
    : body_(&body),
      at_(&at),
      law_(body.material().plasticity.get()),
      elastic_(at.stiffness()),
      n_points_(body.discretization().n_points()) {
  const bool varies = law_->depends_on_temperature() && !at.temperature.empty();
  const std::size_t n_sets = varies ? n_points_ : 1, width = law_->n_constants();
  constants_.resize(n_sets * width);
  try {
    for (std::size_t i = 0; i < n_sets; ++i)
      law_->evaluate(temperature(i), std::span(constants_).subspan(i * width, width));
  } catch (const std::invalid_argument& error) {
    throw SolverError(fmt::format("material '{}': {}", body.material().name, error.what()));
  }
}

double PlasticPoints::temperature(std::size_t point) const {
  return at_->temperature.empty() ? body_->material().reference_temperature : at_->temperature[point];
}

std::span<const double> PlasticPoints::constants(std::size_t point) const {
  const std::size_t width = law_->n_constants();
  return std::span(constants_).subspan(is_uniform() ? 0 : point * width, width);
}

std::span<const double> PlasticPoints::back_of(std::size_t point, const std::vector<double>& back) const {
  return back.empty() ? std::span<const double>() : std::span(back).subspan(point * back_width(), back_width());
}

double PlasticPoints::yield_stress(std::size_t point, const std::vector<double>& accumulated) const {
  return law_->yield_stress(accumulated_at(point, accumulated), temperature(point), constants(point)).stress;
}

Tensor6 PlasticPoints::back_stress(std::size_t point, const std::vector<double>& back) const {
  return law_->back_stress(back_of(point, back), constants(point));
}

double PlasticPoints::hardening(std::size_t point, const PlasticState& in, const Tensor6& direction) const {
  return law_->hardening(accumulated_at(point, in.accumulated), direction, temperature(point), constants(point),
                         back_of(point, in.back));
}

material::PlasticFlowStep PlasticPoints::flow(std::size_t point, const PlasticState& since, const Tensor6& trial,
                                              std::span<double> back) const {
  const material::PlasticPoint from{tensor::deviator(Tensor6(tensor::view(since.stress, point))),
                                    accumulated_at(point, since.accumulated), back_of(point, since.back)};
  return law_->flow(from, trial, shear_modulus(point), temperature(point), constants(point), back);
}

}  // namespace creepcontact::creep
