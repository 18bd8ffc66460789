#include "creepcontact/report/model_page.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "assets.hpp"
#include "creepcontact/base/error.hpp"
#include "html.hpp"
#include "page.hpp"
#include "scene.hpp"

namespace creepcontact::report {
namespace {

using PageJson = nlohmann::ordered_json;

/// Bodies by colours, and how far they are from each other.
Scene scene_of(const ModelPage& page) {
  Scene scene;
  scene.title = page.title;
  scene.length_unit = page.length_unit;
  scene.is_model = true;
  scene.flat = page.flat;
  scene.times = {0};
  scene.positions = page.positions;
  scene.n_surface = scene.n_points();
  scene.triangles = page.triangles;
  scene.edges = page.edges;
  std::vector<float> body(scene.n_points(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t b = 0; b < page.bodies.size(); ++b) {
    const ModelPage::Body& from = page.bodies[b];
    scene.bodies.push_back({.name = from.name,
                            .first_triangle = from.first_triangle,
                            .n_triangles = from.n_triangles,
                            .first_edge = from.first_edge,
                            .n_edges = from.n_edges});
    for (std::size_t i = 3 * from.first_triangle; i < 3 * (from.first_triangle + from.n_triangles); ++i)
      body[page.triangles[i]] = static_cast<float>(b + 1);
  }
  Field of_body, distance;
  of_body.name = "body";
  of_body.label = "number of the body";
  distance.name = "distance";
  distance.label = "distance from the next body (negative: interference)";
  distance.unit = page.length_unit;
  scene.fields = {of_body};
  scene.values = {{std::move(body)}};
  if (!page.distances.empty()) {
    scene.fields.push_back(distance);
    scene.values.push_back({page.distances});
  }
  return scene;
}

std::string model_json(const ModelPage& page) {
  PageJson faces = PageJson::array(), groups = PageJson::array();
  for (const ModelPage::Face& face : page.faces)
    faces.push_back({{"number", face.number},
                     {"body", face.body},
                     {"kind", face.kind},
                     {"text", face.text},
                     {"names", face.names},
                     {"next_to", face.next_to},
                     {"triangles", {face.first_triangle, face.n_triangles}}});
  for (const ModelPage::Group& group : page.groups)
    groups.push_back({{"name", group.name}, {"uses", group.uses}, {"faces", group.faces}});
  const PageJson all{{"faces", faces}, {"groups", groups}};
  return without_tags(all.dump(-1, ' ', false, PageJson::error_handler_t::replace));
}

}  // namespace

void write_model_page(const ModelPage& page, const std::filesystem::path& file) {
  if (viewer_script().empty())
    throw ConfigError(
        "the program was built without the interactive view (npm was missing), which the page of a model needs");
  Html html;
  open_page(page.title, html);
  html.open("header");
  html.element("h1", page.title);
  html.close("header");
  html.open("main");
  for (const std::string& note : page.notes) html.element("p", note);
  const PackedScene packed_scene = packed(scene_of(page));
  html.raw(
      "<div class=\"viewer model\" data-scene=\"model\"></div>\n<noscript><p>The picture needs "
      "JavaScript.</p></noscript>\n");
  html.raw("<script type=\"application/json\" id=\"model\">" + packed_scene.header + "</script>\n");
  html.raw("<script type=\"text/plain\" id=\"model-data\">" + packed_scene.data + "</script>\n");
  html.raw("<script type=\"application/json\" id=\"model-model\">" + model_json(page) + "</script>\n");
  html.close("main");
  close_page(html);
  write_page(file, html.text(), "--page");
}

}  // namespace creepcontact::report
