#include "field_arrays.hpp"

namespace creepcontact::results {
namespace {

void append_components(const Tensor6& mandel, std::vector<double>& values) {
  for (int k = 0; k < 6; ++k) values.push_back(k < 3 ? mandel[k] : mandel[k] / tensor::sqrt2);
}

}  // namespace

std::vector<io::FieldData> point_arrays(Snapshot& snapshot) {
  io::FieldData displacement{"displacement", 3, {}}, stress{"stress", 6, {}}, creep{"creep_strain", 6, {}};
  io::FieldData von_mises{"von_mises", 1, {}}, equivalent{"creep_strain_equivalent", 1, {}};
  io::FieldData temperature{"temperature", 1, {}}, body_id{"body", 1, {}};
  io::FieldData damage{"damage", 1, {}}, life{"life_fraction", 1, {}};
  const std::vector<mechanics::Body>& bodies = snapshot.assembly().bodies();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const BodyFields& fields = snapshot.fields(b);
    for (std::size_t i = 0; i < fields.n_nodes(); ++i) {
      const Sample sample = fields.at_node(i);
      displacement.values.insert(displacement.values.end(), sample.displacement.begin(), sample.displacement.end());
      append_components(sample.stress, stress.values);
      append_components(sample.creep_strain, creep.values);
      von_mises.values.push_back(tensor::von_mises(sample.stress));
      equivalent.values.push_back(tensor::equivalent_strain(sample.creep_strain));
      temperature.values.push_back(sample.temperature);
      damage.values.push_back(sample.damage);
      life.values.push_back(sample.life_fraction);
      body_id.values.push_back(static_cast<double>(b));
    }
  }
  std::vector<io::FieldData> result{displacement, stress, creep, von_mises, equivalent, temperature, body_id};
  if (snapshot.knows(material::Measure::damage)) result.push_back(std::move(damage));
  if (snapshot.knows(material::Measure::life_fraction)) result.push_back(std::move(life));
  return result;
}

std::vector<io::FieldData> cell_arrays(Snapshot& snapshot) {
  io::FieldData stress{"stress", 6, {}}, creep{"creep_strain", 6, {}}, von_mises{"von_mises", 1, {}};
  io::FieldData body_id{"body", 1, {}};
  const std::vector<mechanics::Body>& bodies = snapshot.assembly().bodies();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const BodyFields& fields = snapshot.fields(b);
    const mechanics::Discretization& discretization = bodies[b].discretization();
    std::vector<double> stress_means(6 * discretization.n_elements()), creep_means(6 * discretization.n_elements());
    discretization.to_elements(fields.point_values(PointField::stress), 6, stress_means);
    discretization.to_elements(fields.point_values(PointField::creep_strain), 6, creep_means);
    for (std::size_t e = 0; e < discretization.n_elements(); ++e) {
      const Tensor6 mean = tensor::view(stress_means, e);
      append_components(mean, stress.values);
      append_components(tensor::view(creep_means, e), creep.values);
      von_mises.values.push_back(tensor::von_mises(mean));
      body_id.values.push_back(static_cast<double>(b));
    }
  }
  return {stress, creep, von_mises, body_id};
}

}  // namespace creepcontact::results
