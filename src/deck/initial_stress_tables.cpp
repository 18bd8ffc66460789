/// [initial_stress.<body>] of *INITIAL CONDITIONS, TYPE=STRESS

#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "creepcontact/fem/reference_element.hpp"
#include "draft.hpp"

namespace creepcontact::deck {
namespace {

using Stress = std::array<double, 6>;  // xx, yy, zz, xy, yz, zx

/// @param values  in the order of decks: 11, 22, 33, 12, 13, 23
Stress in_our_order(const std::vector<double>& values) {
  return {values[0], values[1], values[2], values[3], values[5], values[4]};
}

/// The integration points of CalculiX, in its order.
std::vector<Vector3> integration_points(const ElementType& type) {
  const bool is_reduced = type.variant.find('R') != std::string::npos;
  const auto brick = [](const std::vector<double>& along) {
    std::vector<Vector3> points;
    for (const double z : along)
      for (const double y : along)
        for (const double x : along) points.emplace_back(x, y, z);
    return points;
  };
  const auto wedge = [](const std::vector<std::array<double, 2>>& in_triangle, const std::vector<double>& along) {
    std::vector<Vector3> points;
    for (const double z : along)
      for (const auto& [x, y] : in_triangle) points.emplace_back(x, y, z);
    return points;
  };
  const double a = 1 / std::sqrt(3.0), b = std::sqrt(0.6);
  constexpr double near = 0.138196601125011, far = 0.585410196624968;
  switch (type.cell) {
    case mesh::CellType::hex8:
      return is_reduced ? std::vector{Vector3(0, 0, 0)} : brick({-a, a});
    case mesh::CellType::hex20:
      return is_reduced ? brick({-a, a}) : brick({-b, 0, b});
    case mesh::CellType::tet4:
      return {Vector3(0.25, 0.25, 0.25)};
    case mesh::CellType::tet10:
      return {Vector3(near, near, near), Vector3(far, near, near), Vector3(near, far, near), Vector3(near, near, far)};
    case mesh::CellType::wedge6:
      return wedge({{1 / 3.0, 1 / 3.0}}, {-a, a});
    case mesh::CellType::wedge15:
      return wedge({{1 / 6.0, 1 / 6.0}, {2 / 3.0, 1 / 6.0}, {1 / 6.0, 2 / 3.0}}, {-b, 0, b});
    default:
      return {};
  }
}

class StressReader {
 public:
  explicit StressReader(Draft& draft) : draft_(draft) {}

  void read() {
    for (const RawCard& raw : draft_.deck.cards)
      if (raw.card.name == "INITIAL CONDITIONS" && upper_case(raw.card.value("TYPE")) == "STRESS") {
        card_ = &raw;
        for (std::size_t line = 0; line < raw.data.size(); ++line) read(raw, line);
      }
    if (card_ == nullptr) return;
    for (const DeckBody& body : draft_.bodies.bodies) make(body);
  }

 private:
  struct OfElement {
    std::optional<Stress> whole;
    std::map<std::int64_t, Stress> at_points;  // by number, from 1
  };

  void read(const RawCard& raw, std::size_t line) {
    const auto refuse = [&](const std::string& why) {
      draft_.impossible.push_back({raw.places[line], raw.card.name, "TYPE=STRESS: " + why});
    };
    const std::vector<std::string>& fields = raw.data[line];
    const std::string target = fields.empty() ? "" : fields[0];
    const Numbers elements = draft_.resolver.elements(target);
    if (elements.empty()) return refuse(fmt::format("there is no element or set '{}'", target));
    std::vector<double> values;
    for (std::size_t i = 1; i < fields.size(); ++i) {
      const std::optional<double> value = number(fields[i]);
      if (!value) return refuse(fmt::format("'{}' is not a number", fields[i]));
      values.push_back(*value);
    }
    const std::size_t n_components = draft_.is_section() ? 4 : 6;
    if (values.size() == 7 && !draft_.is_section()) {
      const std::optional<std::int64_t> point = whole_number(fields[1]);
      if (!point || *point < 1) return refuse(fmt::format("'{}' is not the number of an integration point", fields[1]));
      values.erase(values.begin());
      for (const std::int64_t element : elements) of_[element].at_points[*point] = in_our_order(values);
      return;
    }
    // Zeros at the end may be left out.
    if (values.empty() || values.size() > n_components)
      return refuse(fmt::format("{} values; an element or set and {} stresses{} are known", values.size(), n_components,
                                draft_.is_section() ? "" : ", or an element, an integration point and 6 stresses"));
    values.resize(6, 0.0);
    for (const std::int64_t element : elements) of_[element] = {in_our_order(values), {}};
  }

  Vector3 place(std::int64_t element, const Vector3& xi) const {
    const Deck::ElementPlace at = draft_.deck.element_of_number.at(element);
    const ElementBlock& block = draft_.deck.elements[at.block];
    const std::vector<int>& order = gmsh_order(block.type.cell);
    Eigen::VectorXd shape(static_cast<Eigen::Index>(order.size()));
    fem::reference_element(block.type.cell).shape(xi, shape);
    Vector3 result = Vector3::Zero();
    for (std::size_t a = 0; a < order.size(); ++a)
      result += shape[static_cast<Eigen::Index>(a)] *
                draft_.position(block.nodes[at.element * order.size() + static_cast<std::size_t>(order[a])]);
    return result;
  }

  Vector3 centre(std::int64_t element) const {
    const Deck::ElementPlace at = draft_.deck.element_of_number.at(element);
    const fem::ReferenceElement& cell = fem::reference_element(draft_.deck.elements[at.block].type.cell);
    const int n_corners = mesh::n_corners(cell.type());
    return place(element, cell.nodes().topRows(n_corners).colwise().mean().transpose());
  }

  void append(std::string& table, const Vector3& x, const Stress& stress) const {
    table += fmt::format("{:.15g},{:.15g},{:.15g},{:.15g}\n", x[0], x[1], x[2], fmt::join(stress, ","));
  }

  void append(std::string& table, std::int64_t element, const OfElement& given) {
    if (given.at_points.empty()) return append(table, centre(element), given.whole.value_or(Stress{}));
    const ElementBlock& block = draft_.deck.elements[draft_.deck.element_of_number.at(element).block];
    const std::vector<Vector3> points = integration_points(block.type);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto found = given.at_points.find(static_cast<std::int64_t>(p) + 1);
      if (given.at_points.size() != points.size() || found == given.at_points.end())
        return draft_.refuse(*card_, fmt::format("TYPE=STRESS: element {} has stresses at {} integration points; a {} "
                                                 "has {}, numbered from 1",
                                                 element, given.at_points.size(), block.type.name, points.size()));
      append(table, place(element, points[p]), found->second);
    }
  }

  void make(const DeckBody& body) {
    std::size_t n_given = 0;
    std::optional<Stress> first;
    bool is_uniform = true;
    for (const std::int64_t element : body.elements) {
      const auto found = of_.find(element);
      const std::optional<Stress> own = found == of_.end() ? Stress{} : found->second.whole;
      n_given += static_cast<std::size_t>(found != of_.end());
      if (!first) first = own;
      is_uniform = is_uniform && own && own == first;
    }
    if (n_given == 0) return;
    if (!body.orientation.empty())
      return draft_.refuse(*card_, fmt::format("TYPE=STRESS: stresses along the axes of *ORIENTATION, which '{}' has, "
                                               "are not known",
                                               body.name));
    const std::string key = "initial_stress." + body.name;
    draft_.comment(key, card_->card.place.text());
    config::InitialStress& made = draft_.config.initial_stress.emplace_back();
    made.name = body.name;
    if (is_uniform) {
      for (std::size_t i = 0; i < 6; ++i) made.along_coordinates[i] = rounded((*first)[i]);
      return;
    }
    made.file = fmt::format("{}_stress_{}.csv", draft_.name, draft_.config.initial_stress.size());
    draft_.comments.above[key + ".file"] =
        "Interpolated between centres of elements or integration points: stresses that jump from element to element "
        "are smoothed.";
    std::string table = "x,y,z,xx,yy,zz,xy,yz,zx\n";
    for (const std::int64_t element : body.elements) {
      const auto found = of_.find(element);
      append(table, element, found == of_.end() ? OfElement() : found->second);
    }
    draft_.tables.emplace_back(made.file->string(), std::move(table));
  }

  Draft& draft_;
  std::map<std::int64_t, OfElement> of_;
  const RawCard* card_ = nullptr;
};

}  // namespace

void make_initial_stress(Draft& draft) {
  StressReader(draft).read();
}

}  // namespace creepcontact::deck
