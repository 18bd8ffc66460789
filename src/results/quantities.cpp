#include "creepcontact/results/quantities.hpp"

#include <algorithm>
#include <stdexcept>

namespace creepcontact::results {
namespace {

using Kind = QuantityInfo::Kind;
using Axis = QuantityInfo::Axis;
using Field = Tensor6 Sample::*;

/// Component (i, j) of a tensor field, Cartesian.
template <Field field, int i, int j>
double cartesian(const Sample& sample) {
  return tensor::to_matrix(sample.*field)(i, j);
}

/// Directions of cylindrical coordinates about the z axis.
enum class Direction { radial, circumferential };

template <Direction first, Direction second>
double cylindrical(const Sample& sample) {
  const double r = sample.place.head<2>().norm();
  const Vector3 radial = r > 0 ? Vector3(sample.place.x() / r, sample.place.y() / r, 0) : Vector3(1, 0, 0);
  const Vector3 circumferential(-radial.y(), radial.x(), 0);
  const auto unit = [&](Direction of) { return of == Direction::radial ? radial : circumferential; };
  return unit(first).dot(tensor::to_matrix(sample.stress) * unit(second));
}

enum class Rank { smallest, middle, largest };

template <Rank rank>
double principal(const Sample& sample) {
  return tensor::principal_values(tensor::to_matrix(sample.stress))[static_cast<int>(rank)];
}

template <Axis axis>
double displacement(const Sample& sample) {
  return sample.displacement[static_cast<int>(axis)];
}

template <Field field>
void add_components(std::vector<QuantityInfo>& list, const std::string& name, const std::string& description) {
  const auto add = [&](const char* suffix, double (*value)(const Sample&)) {
    list.push_back({name + "_" + suffix, description, Kind::field, value});
  };
  add("xx", cartesian<field, 0, 0>);
  add("yy", cartesian<field, 1, 1>);
  add("zz", cartesian<field, 2, 2>);
  add("xy", cartesian<field, 0, 1>);
  add("yz", cartesian<field, 1, 2>);
  add("zx", cartesian<field, 2, 0>);
}

std::vector<QuantityInfo> make_quantities() {
  std::vector<QuantityInfo> list;
  const auto field = [&](const char* name, const char* description, double (*value)(const Sample&)) {
    list.push_back({name, description, Kind::field, value});
  };
  field("displacement_x", "displacement", displacement<Axis::x>);
  field("displacement_y", "displacement", displacement<Axis::y>);
  field("displacement_z", "displacement", displacement<Axis::z>);
  field("displacement_magnitude", "length of the displacement",
        [](const Sample& sample) { return sample.displacement.norm(); });
  add_components<&Sample::stress>(list, "stress", "stress");
  const auto cylinder = [&](const char* name, double (*value)(const Sample&)) {
    list.push_back({name, "stress in cylindrical components about the probe's `axis`, by default z", Kind::field, value,
                    Axis::z, true});
  };
  cylinder("stress_r", cylindrical<Direction::radial, Direction::radial>);
  cylinder("stress_theta", cylindrical<Direction::circumferential, Direction::circumferential>);
  cylinder("stress_rtheta", cylindrical<Direction::radial, Direction::circumferential>);
  field("von_mises", "equivalent stress of von Mises",
        [](const Sample& sample) { return tensor::von_mises(sample.stress); });
  field("principal_1", "largest principal stress", principal<Rank::largest>);
  field("principal_2", "middle principal stress", principal<Rank::middle>);
  field("principal_3", "smallest principal stress", principal<Rank::smallest>);
  field("hydrostatic", "mean stress", [](const Sample& sample) { return tensor::trace(sample.stress) / 3; });
  add_components<&Sample::strain>(list, "strain", "total strain, tensor components");
  add_components<&Sample::creep_strain>(list, "creep_strain", "creep strain, tensor components");
  field("creep_strain_equivalent", "equivalent creep strain sqrt(2/3 e:e)",
        [](const Sample& sample) { return tensor::equivalent_strain(sample.creep_strain); });
  field("temperature", "temperature", [](const Sample& sample) { return sample.temperature; });
  field("damage", "damage of `kachanov_rabotnov`, 0 to 1; 0 where there is none",
        [](const Sample& sample) { return sample.damage; });
  field("life_fraction", "creep life used up, by rupture data; 0 where there are none",
        [](const Sample& sample) { return sample.life_fraction; });

  list.push_back({"contact_pressure", "the multipliers; either surface of a pair gives the same", Kind::pressure});
  list.push_back({"gap", "normal distance; zero but for rounding where closed", Kind::gap});
  list.push_back({"contact_area", "area in contact, its edge found between the nodes", Kind::area});
  const std::pair<const char*, Axis> axes[] = {{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}};
  for (const auto& [name, axis] : axes)
    list.push_back({std::string("contact_force_") + name, "resultant contact force on the body of this surface",
                    Kind::force, nullptr, axis});
  for (const auto& [name, axis] : axes)
    list.push_back({std::string("reaction_") + name, "resultant force of the supports on the body", Kind::reaction,
                    nullptr, axis});
  return list;
}

}  // namespace

const std::vector<QuantityInfo>& quantities() {
  static const std::vector<QuantityInfo> list = make_quantities();
  return list;
}

const QuantityInfo& quantity(const std::string& name) {
  const auto& list = quantities();
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& info) { return info.name == name; });
  if (found == list.end()) throw std::out_of_range("no quantity '" + name + "'");
  return *found;
}

}  // namespace creepcontact::results
