/// The files of `check --fields`.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/base/units.hpp"
#include "creepcontact/io/fields/field_writer.hpp"
#include "creepcontact/mesh/outer_faces.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "creepcontact/plot/solid_picture.hpp"
#include "model_view.hpp"

namespace creepcontact::run {
namespace {

namespace fs = std::filesystem;

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

using Arrays = std::vector<io::FieldData>;

/// The bodies with their elements: which nodes are held, and the external forces.
struct Bodies {
  explicit Bodies(const model::Model& model) : model(model) {
    io::TextArray names{"bodies", {}};
    for (const mechanics::Body& body : model.bodies()) {
      mesh.append(body.mesh());
      names.values.push_back(body.name());
    }
    mesh.texts.push_back(std::move(names));
  }

  Arrays points(double t) const {
    io::FieldData body{"body", 1, {}}, support{"support", 1, {}}, load{"load", 3, {}};
    const std::vector<mechanics::BodyConditions> conditions = model.assembly.at(t);
    for (std::size_t b = 0; b < model.bodies().size(); ++b) {
      const mechanics::Body& one = model.bodies()[b];
      const std::size_t n = one.mesh().n_cell_nodes();
      for (std::size_t node = 0; node < n; ++node) {
        const auto& free = one.constraints().free_index(static_cast<std::int64_t>(node));
        support.values.push_back(static_cast<double>(std::ranges::count(free, -1)));
      }
      body.values.insert(body.values.end(), n, static_cast<double>(b));
      const std::span<const double> forces = conditions[b].external_forces();
      load.values.insert(load.values.end(), forces.begin(), forces.begin() + static_cast<std::ptrdiff_t>(3 * n));
    }
    return {body, support, load};
  }

  Arrays cells() const {
    io::FieldData body{"body", 1, {}};
    for (std::size_t b = 0; b < model.bodies().size(); ++b)
      body.values.insert(body.values.end(), model.bodies()[b].discretization().n_elements(), static_cast<double>(b));
    return {body};
  }

  const model::Model& model;
  io::FieldMesh mesh;
};

/// The named groups on the bodies, with what acts there.
struct Groups {
  Groups(const model::Model& model, const std::vector<Mark>& marks) : model(model) {
    io::TextArray group_names{"groups", {}}, body_names{"bodies", {}};
    for (std::size_t b = 0; b < model.bodies().size(); ++b) {
      const mechanics::Body& body = model.bodies()[b];
      body_names.values.push_back(body.name());
      first_node_.push_back(static_cast<std::int64_t>(mesh.points.size()));
      const std::size_t n = body.mesh().n_cell_nodes();
      mesh.points.insert(mesh.points.end(), body.mesh().nodes.begin(),
                         body.mesh().nodes.begin() + static_cast<std::ptrdiff_t>(n));
      for (const auto& [name, group] : body.mesh().groups) {
        if (group.dimension >= body.mesh().section.dimension()) continue;
        auto known = std::ranges::find(group_names.values, name);
        if (known == group_names.values.end()) known = group_names.values.insert(known, name);
        const auto number = static_cast<double>(known - group_names.values.begin());
        std::array<double, 3> acting{};  // by kind: the entry of the configuration, from 1
        for (const Mark& mark : marks)
          if (mark.group == name && mark.acts_on(body))
            acting[static_cast<std::size_t>(mark.kind)] = static_cast<double>(mark.number + 1);
        for (const mesh::Face& cell : mesh::cells_of_group(body.mesh(), group)) {
          add(cell);
          const std::array<double, 5> values{static_cast<double>(b), number, acting[0], acting[1], acting[2]};
          for (std::size_t i = 0; i < values.size(); ++i) arrays_[i].values.push_back(values[i]);
        }
      }
    }
    mesh.texts = {group_names, body_names};
  }

  /// The gaps given and the distances in the mesh at the slaves' nodes, and nowhere else.
  Arrays points(double t) const {
    io::FieldData gap{"gap", 1, std::vector<double>(mesh.points.size(), nowhere)};
    io::FieldData distance{"distance", 1, gap.values};
    for (const contact::Pair& pair : model.pairs()) {
      if (pair.ties_nodes()) continue;
      const contact::MortarCoupling& coupling = pair.coupling;
      const Eigen::VectorXd measured = coupling.geometric_gap;
      const Eigen::VectorXd given = pair.initial_gap(t);
      for (std::size_t i = 0; i < coupling.nodes.size(); ++i) {
        const auto at = static_cast<std::size_t>(first_node_[pair.slave_body] + coupling.nodes[i].node);
        gap.values[at] = given[coupling.row(i)] / coupling.area[i];
        distance.values[at] = measured[coupling.row(i)] / coupling.area[i];
      }
      const mesh::Mesh& slave = model.bodies()[pair.slave_body].mesh();
      for (const mesh::Face& face : mesh::cells_of_group(slave, slave.group(pair.slave_surface)))
        for (io::FieldData* const field : {&gap, &distance}) fill_between_corners(face, pair.slave_body, *field);
    }
    return {gap, distance};
  }

  Arrays cells() const { return {arrays_.begin(), arrays_.end()}; }

 private:
  void add(const mesh::Face& cell) {
    if (mesh.blocks.empty() || mesh.blocks.back().type != cell.type) mesh.blocks.push_back({cell.type, {}});
    for (const std::int64_t node : cell.nodes) mesh.blocks.back().connectivity.push_back(first_node_.back() + node);
  }

  /// Multipliers, and so gaps, are at corners only.
  void fill_between_corners(const mesh::Face& face, std::size_t body, io::FieldData& field) const {
    const auto corners = static_cast<std::size_t>(mesh::n_corners(face.type));
    const auto value = [&](std::size_t k) -> double& {
      return field.values[static_cast<std::size_t>(first_node_[body] + face.nodes[k])];
    };
    for (std::size_t k = corners; k < std::min(2 * corners, face.nodes.size()); ++k)
      value(k) = (value(k - corners) + value((k - corners + 1) % corners)) / 2;
    if (face.type == mesh::CellType::quad9) value(8) = (value(0) + value(1) + value(2) + value(3)) / 4;
  }

 public:
  const model::Model& model;
  io::FieldMesh mesh;

 private:
  std::vector<std::int64_t> first_node_;  // of every body
  std::array<io::FieldData, 5> arrays_{
      {{"body", 1, {}}, {"group", 1, {}}, {"support", 1, {}}, {"load", 1, {}}, {"contact", 1, {}}}};
};

/// Around a cell or a face: corners, and the nodes between them.
std::vector<Vector3> outline(const mesh::Mesh& mesh, const mesh::Face& face) {
  const auto corners = static_cast<std::size_t>(mesh::n_corners(face.type));
  const bool curved = mesh::dimension(face.type) == 2 && face.nodes.size() >= 2 * corners;
  std::vector<Vector3> points;
  for (std::size_t k = 0; k < corners; ++k) {
    points.push_back(mesh.nodes[face.nodes[k]]);
    if (curved) points.push_back(mesh.nodes[face.nodes[corners + k]]);
  }
  return points;
}

plot::SolidMark::Kind kind_of(Mark::Kind kind) {
  switch (kind) {
    case Mark::Kind::support:
      return plot::SolidMark::Kind::support;
    case Mark::Kind::load:
      return plot::SolidMark::Kind::load;
    case Mark::Kind::contact:
      break;
  }
  return plot::SolidMark::Kind::contact;
}

/// An edge with its middle node in between.
std::vector<Vector3> line_of(const mesh::Mesh& mesh, const mesh::Face& cell) {
  std::vector<Vector3> points;
  for (const std::int64_t node : cell.nodes) points.push_back(mesh.nodes[node]);
  if (points.size() == 3) std::swap(points[1], points[2]);
  return points;
}

plot::SolidPicture picture_of(const config::Config& config, const model::Model& model, const std::vector<Mark>& marks) {
  plot::SolidPicture picture;
  picture.title = config.title.empty() ? config.file.stem().string() : config.title;
  picture.length_unit = unit_of(Dimension::length, config.units);
  for (const Mark& mark : marks) picture.marks.push_back({mark.name, kind_of(mark.kind)});
  for (std::size_t b = 0; b < model.bodies().size(); ++b) {
    const mechanics::Body& body = model.bodies()[b];
    const mesh::Mesh& mesh = body.mesh();
    const auto number = static_cast<int>(b);
    picture.bodies.push_back(fmt::format("body '{}'", body.name()));
    picture.flat = mesh.section.dimension() == 2;
    std::map<std::vector<std::int64_t>, int> marked;  // later ones cover earlier ones: contacts, loads, supports
    for (int m = 0; m < static_cast<int>(marks.size()); ++m) {
      const Mark& mark = marks[m];
      if (mark.group.empty() && (mark.body.empty() || mark.body == body.name())) {
        const auto near = std::ranges::min_element(mesh.nodes, {},
                                                   [&](const Vector3& x) { return (x - mark.position).squaredNorm(); });
        if ((*near - mark.position).norm() < 1e-6 * (1 + mark.position.norm()))
          picture.lines.push_back({{mark.position}, number, m});
      }
      if (!mark.acts_on(body)) continue;
      for (const mesh::Face& cell : mesh::cells_of_group(mesh, mesh.groups.at(mark.group)))
        if (mesh::dimension(cell.type) == 2)
          marked[mesh::corners_of(cell)] = m;
        else
          picture.lines.push_back({line_of(mesh, cell), number, m});
    }
    const auto add = [&](const mesh::Face& face) {
      const auto found = marked.find(mesh::corners_of(face));
      picture.facets.push_back({outline(mesh, face), number, found == marked.end() ? -1 : found->second});
    };
    if (!picture.flat) std::ranges::for_each(mesh::outer_faces(mesh.blocks, 3), add);
    for (const mesh::CellBlock& block : mesh.blocks)
      for (std::size_t i = 0; picture.flat && mesh.is_bulk(block.type) && i < block.size(); ++i)
        add({block.type, {block.cell(i).begin(), block.cell(i).end()}});
  }
  return picture;
}

}  // namespace

std::string model_picture_job(const config::Config& config, const model::Model& model) {
  constexpr std::size_t most_facets = 40000;
  plot::SolidPicture picture = picture_of(config, model, marks(config, model));
  if (picture.facets.size() > most_facets) return "";
  picture.title.clear();  // a report has captions
  return plot::picture_job(picture, "");
}

std::vector<fs::path> write_model_view(const config::Config& config, const model::Model& model,
                                       const fs::path& directory) {
  const std::vector<Mark> all = marks(config, model);
  const Bodies bodies(model);
  const Groups groups(model, all);
  io::FieldWriter body_files(directory, "model", bodies.mesh, config.units);
  io::FieldWriter group_files(directory, "groups", groups.mesh, config.units);
  for (const double t : {0.0, config.time.end}) {
    body_files.write(t, bodies.points(t), bodies.cells());
    group_files.write(t, groups.points(t), groups.cells());
  }
  std::vector<fs::path> files{directory / "model.pvd", directory / "groups.pvd"};
  try {
    platform::make_inner_directory(directory / "plots");
    plot::draw(picture_of(config, model, all), directory / "plots/model.png");
    files.push_back(directory / "plots/model.png");
  } catch (const Error& error) {
    log::warning("no picture: {}", error.what());
  }
  return files;
}

}  // namespace creepcontact::run
