#include "field_arrays.hpp"

#include "creepcontact/results/quantities.hpp"
#include "probe_quantity.hpp"

namespace creepcontact::results {
namespace {

/// The variables that the field files have, each with its array, which a member of OutputVariable names.
class Arrays {
 public:
  Arrays(std::string OutputVariable::*name, const Snapshot& snapshot)
      : is_axisymmetric_(snapshot.assembly().bodies().front().mesh().section.is_axisymmetric()) {
    for (const OutputVariable& variable : output_variables()) {
      const creep::Assembly& assembly = snapshot.assembly();
      if (variable.needs_heat && assembly.conduction() == nullptr) continue;
      if (assembly.is_heat_alone() && !variable.is_of_heat) continue;
      if ((variable.*name).empty() || (variable.state_variable && !snapshot.has(*variable.state_variable))) continue;
      variables_.push_back(&variable);
      // Vectors and tensors have the component names of ParaView.
      const bool own_names = variable.point_array != variable.name;
      arrays_.push_back({variable.*name,
                         static_cast<int>(variable.n_components()),
                         {},
                         own_names ? variable.components : std::vector<std::string>()});
    }
    arrays_.push_back({"body", 1, {}});
  }

  void append(const Sample& sample, std::size_t body) {
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      std::vector<double>& values = arrays_[i].values;
      values.resize(values.size() + variables_[i]->n_components());
      double* const into = values.data() + values.size() - variables_[i]->n_components();
      if (variables_[i]->cylindrical && is_axisymmetric_)
        variables_[i]->evaluate(turned(sample, axes_about_y_, Vector3::Zero()), into);
      else
        variables_[i]->evaluate(sample, into);
    }
    arrays_.back().values.push_back(static_cast<double>(body));
  }

  std::vector<io::FieldData> take() { return std::move(arrays_); }

 private:
  bool is_axisymmetric_;  // then cylindrical components are those about y
  const Matrix3 axes_about_y_ = cylindrical_axes(Vector3::UnitY());
  std::vector<const OutputVariable*> variables_;
  std::vector<io::FieldData> arrays_;  // of the variables, then the number of the body
};

}  // namespace

std::vector<io::FieldData> point_arrays(Snapshot& snapshot) {
  Arrays arrays(&OutputVariable::point_array, snapshot);
  for (std::size_t b = 0; b < snapshot.assembly().bodies().size(); ++b) {
    const BodyFields& fields = snapshot.fields(b);
    for (std::size_t i = 0; i < fields.n_nodes(); ++i) arrays.append(fields.at_node(i), b);
  }
  return arrays.take();
}

std::vector<io::FieldData> cell_arrays(Snapshot& snapshot) {
  Arrays arrays(&OutputVariable::cell_array, snapshot);
  for (std::size_t b = 0; b < snapshot.assembly().bodies().size(); ++b) {
    const BodyFields& fields = snapshot.fields(b);
    const mechanics::Discretization& discretization = fields.body().discretization();
    std::vector<double> stress(6 * discretization.n_elements()), creep(6 * discretization.n_elements());
    discretization.to_elements(fields.point_values(PointField::stress), 6, stress);
    discretization.to_elements(fields.point_values(PointField::creep_strain), 6, creep);
    Sample mean;
    for (std::size_t e = 0; e < discretization.n_elements(); ++e) {
      mean.stress = tensor::view(stress, e);
      mean.creep_strain = tensor::view(creep, e);
      arrays.append(mean, b);
    }
  }
  return arrays.take();
}

}  // namespace creepcontact::results
