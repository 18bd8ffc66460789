#include "anisotropy_tables.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace creepcontact::deck {
namespace {

/// Columns of both kinds of tables: nine constants and the temperature.
constexpr std::size_t n_constants = 9, of_temperature = 9;

/// D1111, D1122, D2222, D1133, D2233, D3333, D1212, D1313, D2323, T as E1, E2, E3, nu12, nu13, nu23, G12, G13, G23, T.
/// Empty if the matrix is not positive definite.
std::vector<double> engineering_constants(const std::vector<double>& row) {
  Matrix3 normal;
  normal << row[0], row[1], row[3], row[1], row[2], row[4], row[3], row[4], row[5];
  if (Eigen::LLT<Matrix3>(normal).info() != Eigen::Success) return {};
  const Matrix3 compliance = normal.inverse();
  std::vector<double> result{1 / compliance(0, 0),
                             1 / compliance(1, 1),
                             1 / compliance(2, 2),
                             -compliance(0, 1) / compliance(0, 0),
                             -compliance(0, 2) / compliance(0, 0),
                             -compliance(1, 2) / compliance(1, 1),
                             row[6],
                             row[7],
                             row[8]};
  if (row.size() > of_temperature) result.push_back(row[of_temperature]);
  return result;
}

/// Adds rows in between: what is linear in the temperature there is not so in other constants.
std::vector<std::vector<double>> refined(const std::vector<std::vector<double>>& rows) {
  constexpr int steps = 20;  // between two rows
  std::vector<std::vector<double>> result{rows.front()};
  for (std::size_t i = 1; i < rows.size(); ++i)
    for (int k = 1; k <= steps; ++k) {
      const std::size_t n = std::min(rows[i - 1].size(), rows[i].size());
      std::vector<double> between(n);
      for (std::size_t j = 0; j < n; ++j)
        between[j] = rows[i - 1][j] + (rows[i][j] - rows[i - 1][j]) * k / static_cast<double>(steps);
      result.push_back(std::move(between));
    }
  return result;
}

std::array<Function, 3> three(const Table& table, const std::array<std::size_t, 3>& columns) {
  return {function_of_temperature(table, columns[0], of_temperature),
          function_of_temperature(table, columns[1], of_temperature),
          function_of_temperature(table, columns[2], of_temperature)};
}

/// Axes 1, 2, 3 as columns, of axes by two points.
Matrix3 rectangular_axes(const Orientation& orientation) {
  Matrix3 axes;
  axes.col(0) = orientation.a.normalized();
  axes.col(2) = orientation.a.cross(orientation.b).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  if (orientation.turned_about == 0) return axes;
  const Vector3 about = axes.col(orientation.turned_about - 1);
  return Eigen::AngleAxisd(orientation.turned_by * std::numbers::pi / 180, about) * axes;
}

}  // namespace

void make_orthotropic(Draft& draft, const Material& material, config::Material& made) {
  Table table = *material.elastic;
  const auto refuse = [&](const std::string& why) { draft.impossible.push_back({table.place, "ELASTIC", why}); };
  if (std::ranges::any_of(table.rows, [](const auto& row) { return row.size() < n_constants; }))
    return refuse("nine constants are expected, eight in the first line and one in the second");
  const bool by_matrix = material.elasticity == Elasticity::stiffness_matrix;
  if (by_matrix) {
    table.rows = refined(table.rows);
    for (auto& row : table.rows) row = engineering_constants(row);
    if (std::ranges::any_of(table.rows, [](const auto& row) { return row.empty(); }))
      return refuse("the matrix of D1111, D1122, ... is not positive definite");
  }
  made.orthotropic = {three(table, {0, 1, 2}), three(table, {3, 5, 4}), three(table, {6, 8, 7})};
  const std::string key = fmt::format("materials.{}.orthotropic", made.name);
  draft.comment(key, table.place.text() + (by_matrix ? ": from the matrix of D1111, D1122, ..." : ""));
  draft.comment(key + ".poisson_ratios", "nu12, nu23, nu13");
  draft.comment(key + ".shear_moduli", "G12, G23, G13");
}

void make_hill(Draft& draft, const Material& material, config::Material& made) {
  const Table& table = *material.potential;
  const auto refuse = [&](const std::string& why) { draft.impossible.push_back({table.place, "POTENTIAL", why}); };
  if (table.rows.size() != 1) return refuse("ratios that depend on the temperature are not known; one line is");
  const std::vector<double>& R = table.rows.front();  // 11, 22, 33, 12, 13, 23
  if (std::ranges::any_of(R.begin(), R.begin() + 6, [](double ratio) { return !(ratio > 0); }))
    return refuse("R11, R22, R33, R12, R13 and R23 must be positive");
  made.hill = {{rounded(R[0]), rounded(R[1]), rounded(R[2])}, {rounded(R[3]), rounded(R[5]), rounded(R[4])}};
  const std::string key = fmt::format("materials.{}.hill", made.name);
  draft.comment(key, table.place.text() + ": *POTENTIAL");
  draft.comment(key + ".shear", "R12, R23, R13");
}

void make_axes(Draft& draft, const DeckBody& body, config::Body& made) {
  const auto found = draft.deck.orientations.find(body.orientation);
  if (found == draft.deck.orientations.end()) {
    draft.impossible.push_back(
        {body.section, "SOLID SECTION", fmt::format("there is no *ORIENTATION '{}'", body.orientation)});
    return;
  }
  const Orientation& orientation = found->second;
  const std::string key = fmt::format("bodies.{}.material_axes", body.name);
  const auto refuse = [&](const std::string& why) {
    draft.impossible.push_back({orientation.place, "ORIENTATION", why});
  };
  if (!orientation.problem.empty()) return refuse(orientation.problem);
  if (orientation.is_cylindrical) {
    if (orientation.a == orientation.b) return refuse("the two points of the axis are one");
    if (orientation.turned_by != 0) return refuse("cylindrical axes that are turned by an angle are not known");
    made.material_axes.emplace().cylindrical = {rounded(orientation.b - orientation.a), rounded(orientation.a)};
    return draft.comment(key, orientation.place.text());
  }
  if (orientation.a.cross(orientation.b).isZero(0)) return refuse("the two points give no directions");
  const Matrix3 axes = rectangular_axes(orientation);
  config::MaterialAxes& directions = made.material_axes.emplace();
  std::ranges::copy(rounded(axes.col(0)), directions.first.begin());
  std::ranges::copy(rounded(axes.col(1)), directions.second.begin());
  draft.comment(key, orientation.place.text());
}

}  // namespace creepcontact::deck
