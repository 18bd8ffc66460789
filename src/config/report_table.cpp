/// [report]

#include <algorithm>
#include <cmath>

#include "creepcontact/base/image.hpp"
#include "creepcontact/settings/views.hpp"
#include "table.hpp"
#include "tables.hpp"

namespace creepcontact::config {
namespace {

Value<SectionPlane> plane_of_pictures() {
  const auto keys = table<SectionPlane>({
      field<SectionPlane>("origin", &SectionPlane::origin, triple(number()), "a point of the plane").in("length"),
      field<SectionPlane>("normal", &SectionPlane::normal, triple(number()),
                          "its normal, of any length, towards the part that is cut away", Presence::required),
  });
  return written_inline(converted<SectionPlane>(keys, [](SectionPlane plane, const Item& item, Context& context) {
    if (std::ranges::all_of(plane.normal, [](double part) { return part == 0; }))
      context.errors.add(item.child("normal").location, "[0, 0, 0]", "a vector that is not zero");
    return std::optional(plane);
  }));
}

Value<ReportPicture> picture_table(const Vocabulary& vocabulary) {
  std::vector<std::string> fields{"displacement_magnitude", "mesh"};
  for (const Quantity& quantity : vocabulary.quantities) fields.push_back(quantity.name);
  const std::vector<std::string> directions(settings::views.begin(), settings::views.end());
  const Value<Interval> colours = converted<Interval>(
      interval(number()), [](Interval range, const Item& item, Context& context) -> std::optional<Interval> {
        if (range.low < range.high) return range;
        context.errors.add(item.location, fmt::format("[{}, {}]", range.low, range.high),
                           "[low, high] with low < high");
        return std::nullopt;
      });
  const auto keys = table<ReportPicture>({
      field<ReportPicture>("field", &ReportPicture::field, name("a quantity"),
                           "a quantity of the field files, or `\"mesh\"`", Presence::required),
      field<ReportPicture>("time", &ReportPicture::time, number(at_least(0)), "the nearest output time is drawn")
          .in("time")
          .otherwise("the last one"),
      field<ReportPicture>(
          "section", &ReportPicture::section, plane_of_pictures(),
          "a plane `{ origin = [x, y, z], normal = [x, y, z] }`; what the normal points to is cut away")
          .otherwise("the whole bodies"),
      field<ReportPicture>("view", &ReportPicture::view, choice("view", directions),
                           "direction from which solids are seen"),
      field<ReportPicture>("range", &ReportPicture::range, colours, "values at the ends of the colours")
          .otherwise("those of the picture"),
  });
  return written_inline(
      converted<ReportPicture>(keys, [fields](ReportPicture picture, const Item& item, Context& context) {
        if (std::ranges::count(fields, picture.field) == 0 && !picture.field.empty())
          context.errors.add_unknown(item.child("field").location, fmt::format("unknown quantity '{}'", picture.field),
                                     picture.field, fields);
        return std::optional(std::move(picture));
      }));
}

}  // namespace

Value<Report> report_table(const Vocabulary& vocabulary) {
  const auto keys = table<Report>({
      field<Report>("title", &Report::title, text(), "heading of the report").otherwise("`title` of the configuration"),
      field<Report>("project", &Report::project, text(), "project, in the block of the title"),
      field<Report>("drawing", &Report::drawing, text(), "number of the drawing, likewise"),
      field<Report>("revision", &Report::revision, text(), "revision, likewise"),
      field<Report>("author", &Report::author, text(), "who wrote the report, likewise"),
      field<Report>("checker", &Report::checker, text(), "who checked it, likewise"),
      field<Report>("logo", &Report::logo, path(), "a PNG, JPEG or SVG file of at most 1 MB").otherwise("none"),
      field<Report>("purpose", &Report::purpose, text(), "the question that the run answers, in Markdown"),
      field<Report>("assumptions", &Report::assumptions, text(), "what the model takes for granted, in Markdown"),
      field<Report>("assessment", &Report::assessment, text(), "what follows from the results, in Markdown"),
      field<Report>("appendix", &Report::appendix, boolean(),
                    "end the report with an appendix on steps, cost and origin"),
      field<Report>("pictures", &Report::pictures, list(picture_table(vocabulary)),
                    "still pictures, each `{ field = \"von_mises\", time = 1e5 }`")
          .otherwise("von Mises stress at the start and the end, and the contact pressure at the end"),
  });
  return converted<Report>(keys, [](Report found, const Item& item, Context& context) {
    if (!found.logo.empty())
      if (const std::string failure = read_image(found.logo).failure; !failure.empty())
        context.errors.add(item.child("logo").location, fmt::format("logo '{}': {}", found.logo.string(), failure),
                           "a PNG, JPEG or SVG file of at most 1 MB");
    return std::optional(std::move(found));
  });
}

}  // namespace creepcontact::config
