/// [mesh] and [bodies.<name>]

#include <map>

#include "creepcontact/settings/mesh_formats.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

/// Any names, each a number.
Value<std::map<std::string, double>> numbers_by_name() {
  using Map = std::map<std::string, double>;
  Value<Map> value{.type = "a table of numbers", .read = {}, .json = [] {
                     return Json{{"type", "object"}, {"additionalProperties", Range{}.json()}};
                   }};
  value.read = [type = value.type](const Item& item, Context& context) -> std::optional<Map> {
    const toml::table* numbers = item.node->as_table();
    if (!numbers) {
      context.errors.add(item.location, describe(*item.node), type);
      return std::nullopt;
    }
    Map all;
    for (const auto& [key, node] : *numbers) {
      if (const auto found = number().read(item.child(key.str()), context)) all.emplace(key.str(), *found);
    }
    return all;
  };
  value.visit = [](const Map& all, Visitor& to) {
    to.table([&] {
      for (const auto& [name, one] : all)
        to.key(user_key(name), [&, value = one](Visitor& inner) { number().visit(value, inner); });
    });
  };
  return value;
}

/// `face = 12` is `faces = [12]`, which a written file has.
Field<Surface> only_with_one(const std::string& name, const std::string& description) {
  const Value<std::vector<int>> one = converted<std::vector<int>>(
      integer(1), [](int number, const Item&, Context&) { return std::optional(std::vector<int>{number}); },
      [](const std::vector<int>&) { return 1; });
  Field<Surface> made = field<Surface>(name, &Surface::faces, one, description).otherwise("see `faces`");
  made.visit = [](const Field<Surface>&, const Surface&, Visitor&) {};
  return made;
}

Value<MeshSize> mesh_size_table() {
  const auto keys = table<MeshSize>({
      field<MeshSize>("on", &MeshSize::on, reference("a surface"), "a surface of `[surfaces]`, or ..."),
      field<MeshSize>("body", &MeshSize::body, reference("a body"), "... a body"),
      field<MeshSize>("size", &MeshSize::size, number(greater(0)), "size of the elements there", Presence::required)
          .in("length"),
  });
  return converted<MeshSize>(keys, [](MeshSize found, const Item& item, Context& context) {
    if (found.on.given() == found.body.given())
      context.errors.add(item.location, found.on.given() ? "both 'on' and 'body'" : "no place", "one of on, body");
    return std::optional(std::move(found));
  });
}

Value<MeshCut> mesh_cut_table() {
  return table<MeshCut>({
      field<MeshCut>("axis", &MeshCut::axis, choice<CutAxis>("axis"), "the plane is at right angles to this axis",
                     Presence::required),
      field<MeshCut>("keep", &MeshCut::keep, choice<KeptSide>("side"), "the side that stays", Presence::required),
      field<MeshCut>("at", &MeshCut::at, number(), "coordinate of the plane").in("length"),
  });
}

Value<std::array<std::array<double, 3>, 2>> box_value() {
  using Box = std::array<std::array<double, 3>, 2>;
  const Value<std::vector<std::array<double, 3>>> corners = list(triple(number()));
  Value<Box> value = converted<Box>(
      corners,
      [](const std::vector<std::array<double, 3>>& found, const Item& item, Context& context) -> std::optional<Box> {
        if (found.size() == 2) return Box{found[0], found[1]};
        context.errors.add(item.location, fmt::format("{} points", found.size()), "[[x, y, z], [x, y, z]]");
        return std::nullopt;
      },
      [](const Box& box) {
        return std::vector<std::array<double, 3>>{box[0], box[1]};
      });
  value.type = "two corners, [[x, y, z], [x, y, z]]";
  return value;
}

Value<SectionPlane> plane_of_faces() {
  return written_inline(table<SectionPlane>({
      field<SectionPlane>("origin", &SectionPlane::origin, triple(number()), "a point of the plane").in("length"),
      field<SectionPlane>("normal", &SectionPlane::normal, triple(number()), "its normal, of any length",
                          Presence::required),
  }));
}

}  // namespace

Value<Surface> surface_table() {
  const std::vector<std::string> kinds{"plane", "cylinder", "cone", "sphere", "torus", "other"};
  const auto keys = table<Surface>({
      only_with_one("face", "number of the face, as `creepcontact faces` lists it"),
      field<Surface>("faces", &Surface::faces, list(integer(1)), "numbers of several faces")
          .otherwise("every face for which the other keys hold"),
      field<Surface>("kind", &Surface::kind, choice("kind of face", kinds), "what the faces are").otherwise("any"),
      field<Surface>("radius", &Surface::radius, number(greater(0)),
                     "radius of cylinders, spheres, the largest of cones, that of the centre line of tori")
          .in("length")
          .otherwise("any"),
      field<Surface>("touches", &Surface::touches, reference("a body"), "a body that the faces touch or nearly touch")
          .otherwise("any, or none"),
      field<Surface>("body", &Surface::body, reference("a body"), "the body that has the faces").otherwise("any"),
      field<Surface>("box", &Surface::box, box_value(), "lowest and highest corner of a box in which faces lie")
          .in("length")
          .otherwise("anywhere"),
      field<Surface>("plane", &Surface::plane, plane_of_faces(), "a plane in which faces lie").otherwise("any"),
  });
  return converted<Surface>(keys, [](Surface found, const Item& item, Context& context) -> std::optional<Surface> {
    found.location = item.location;
    if (item.has("face") && item.has("faces"))
      context.errors.add(item.child("face").location, "'faces' is given, too", "one of face, faces");
    if (given_keys(item, {"face", "faces", "kind", "radius", "touches", "body", "box", "plane"}).empty())
      context.errors.add(item.location, "no faces are named",
                         "at least one of face, faces, kind, radius, touches, body, box, plane");
    if (found.plane && found.plane->normal == std::array<double, 3>{})
      context.errors.add(item.child("plane").child("normal").location, "[0, 0, 0]", "a direction");
    return found;
  });
}

std::vector<std::string> given_keys(const Item& item, const std::vector<std::string>& keys) {
  std::vector<std::string> given;
  for (const std::string& key : keys) {
    if (item.has(key)) given.push_back(key);
  }
  return given;
}

Value<Mesh> mesh_table() {
  const auto shared = choice<SharedNodes>("treatment of shared nodes");
  const auto keys = table<Mesh>({
      field<Mesh>("file", &Mesh::file, path(),
                  "geometry, meshed by the Gmsh library in a separate process: `.geo`, or CAD as `.step`, `.iges`, "
                  "`.brep`; or a mesh: `.msh` (2.2, 4.1; ASCII, binary), `.inp`, `.unv`, `.bdf`, `.nas`",
                  Presence::required)
          .changeable(),
      field<Mesh>("order", &Mesh::order, integer(1, 2),
                  "geometries only: order of the elements; 2 gives tet10, hex20, wedge15")
          .changeable(),
      field<Mesh>("parameters", &Mesh::parameters, numbers_by_name(),
                  "`.geo` only: values for constants defined with `DefineConstant`")
          .changeable(),
      field<Mesh>("allow_locking", &Mesh::allow_locking, boolean(),
                  "accept `tet4` and `wedge6`, which are too stiff under creep; otherwise they are an error")
          .changeable(),
      field<Mesh>(
          "project_distorted", &Mesh::project_distorted, boolean(),
          "project the volumetric strain of `hex20`, and of `quad8` in plane sections, where they are far from a "
          "parallelepiped; `false`: plain reduced integration as in C3D20R of CalculiX and Abaqus, whose mean "
          "stress oscillates there under creep"),
      field<Mesh>("time_limit", &Mesh::time_limit, number(greater(0)),
                  "geometries only: time limit of meshing in seconds; longer meshing is an error")
          .changeable()
          .in("seconds"),
      field<Mesh>("memory_limit_mb", &Mesh::memory_limit_mb, integer(1, 1 << 24),
                  "geometries only: memory limit of meshing in MB")
          .changeable()
          .in("MB"),
      field<Mesh>("thickness", &Mesh::thickness, number(greater(0)),
                  "thickness of plane sections: results such as forces and areas are those of this thickness")
          .in("length")
          .otherwise("1, in plane sections"),
      field<Mesh>("share_nodes", &Mesh::share_nodes, shared,
                  "what to do about nodes that several bodies share outside any contact: report an error, or tie the "
                  "bodies there, node to node"),
      field<Mesh>("size", &Mesh::size, number(greater(0)), "CAD only: size of the elements")
          .in("length")
          .changeable()
          .otherwise("a twenty-fifth of the diagonal of the model"),
      field<Mesh>("elements_per_circle", &Mesh::elements_per_circle, number(at_least(0)),
                  "CAD only: elements on a full circle of a curved face; 0: curvature does not count")
          .changeable()
          .otherwise("12, of CAD models"),
      field<Mesh>("sizes", &Mesh::sizes, written_inline(list(mesh_size_table())),
                  "CAD only: sizes of the elements on surfaces and near them, or in bodies")
          .changeable()
          .otherwise("`size` everywhere"),
      field<Mesh>("cut", &Mesh::cut, written_inline(list(mesh_cut_table())),
                  "CAD only: symmetry planes at which the model is cut; their faces are the surfaces `cut_x`, ...")
          .changeable()
          .otherwise("the whole model"),
  });
  return converted<Mesh>(keys, [](Mesh mesh, const Item& item, Context& context) -> std::optional<Mesh> {
    mesh.location = item.child("file").location;
    const std::string extension = mesh.file.extension().string();
    if (!mesh.file.empty() && !settings::is_mesh_file(extension))
      context.errors.add(mesh.location, fmt::format("'{}'", mesh.file.filename().string()),
                         std::string(settings::mesh_files_in_words));
    if (!settings::is_mesh_file(extension)) return mesh;
    const bool is_cad = settings::is_cad_file(extension);
    if (extension != ".geo" && !is_cad)
      for (const std::string& key : given_keys(item, {"order", "time_limit", "memory_limit_mb"}))
        context.errors.add(item.child(key).location, "has no effect on a finished mesh",
                           "with a geometry (.geo, .step, .iges, .brep) only");
    if (extension != ".geo" && item.has("parameters"))
      context.errors.add(item.child("parameters").location, "has no effect here", "with a .geo file only");
    if (!is_cad)
      for (const std::string& key : given_keys(item, {"size", "elements_per_circle", "sizes", "cut"}))
        context.errors.add(item.child(key).location, "has no effect here",
                           "with a CAD file (.step, .iges, .brep) only");
    return mesh;
  });
}

Value<CylindricalAxes> cylindrical_axes_table() {
  const auto keys = table<CylindricalAxes>({
      field<CylindricalAxes>("axis", &CylindricalAxes::axis, triple(number()), "direction of the axis, of any length"),
      field<CylindricalAxes>("origin", &CylindricalAxes::origin, triple(number()), "a point of the axis").in("length"),
  });
  return converted<CylindricalAxes>(keys, [](CylindricalAxes found, const Item& item, Context& context) {
    if (found.axis == std::array<double, 3>{})
      context.errors.add(item.child("axis").location, "[0, 0, 0]", "a direction");
    return std::optional(found);
  });
}

Value<MaterialAxes> material_axes_table() {
  const auto direction = triple(function({"x", "y", "z"}));
  const std::vector<Field<MaterialAxes>> directions{
      field<MaterialAxes>("first", &MaterialAxes::first, direction, "direction of axis 1, of any length")
          .otherwise("required without `cylindrical`"),
      field<MaterialAxes>("second", &MaterialAxes::second, direction,
                          "direction of axis 2, of any length; its part along axis 1 is taken out. Axis 3 is at right "
                          "angles to both")
          .otherwise("required without `cylindrical`"),
  };
  const auto keys = table<MaterialAxes>({
      directions[0],
      directions[1],
      field<MaterialAxes>("cylindrical", &MaterialAxes::cylindrical, written_inline(cylindrical_axes_table()),
                          "axes 1, 2, 3 are radial, circumferential and axial, instead of two directions"),
  });
  return converted<MaterialAxes>(keys, [directions](MaterialAxes axes, const Item& item, Context& context) {
    if (!item.has("cylindrical")) {
      std::vector<KeyInfo> needed{directions[0].info, directions[1].info};
      for (KeyInfo& key : needed) key.required = true;
      require_keys(item, needed, context);
    } else {
      for (const std::string& key : given_keys(item, {"first", "second"}))
        context.errors.add(item.child(key).location, "the axes are given by 'cylindrical' too",
                           "either 'first' and 'second', or 'cylindrical'");
    }
    return std::optional(std::move(axes));
  });
}

Value<Body> body_table() {
  const auto keys = table<Body>({
      field<Body>("region", &Body::region, one_or_more("a physical volume"),
                  "volume or volumes of the body, in sections physical surfaces; each may belong to one body only",
                  Presence::required)
          .changeable(),
      field<Body>("material", &Body::material, reference("the name of a material"), "one of `[materials]`",
                  Presence::required),
      field<Body>("thickness", &Body::thickness, number(greater(0)), "plane stress only: thickness of this body")
          .in("length")
          .otherwise("that of the mesh"),
      field<Body>("axial_force", &Body::axial_force, function({"t"}),
                  "generalised plane strain with `per_body = true` only: axial force on the cross-section of this body")
          .in("force")
          .otherwise("no force"),
      field<Body>("material_axes", &Body::material_axes, material_axes_table(),
                  "axes of an orthotropic material or of Hill's creep")
          .otherwise("axes 1, 2, 3 along x, y, z"),
  });
  return converted<Body>(keys, [](Body body, const Item& item, Context&) -> std::optional<Body> {
    body.location = item.location;
    return body;
  });
}

}  // namespace creepcontact::config
