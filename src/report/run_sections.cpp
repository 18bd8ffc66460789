#include "run_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "assets.hpp"
#include "base64.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/units.hpp"

namespace creepcontact::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string below(const std::string& level) {
  return level == "h2" ? "h3" : "h4";
}

std::string unit(Dimension dimension, const RunData& run) {
  return unit_of(dimension, run.units());
}

std::string label(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string at_place(const io::Summary::Largest& largest) {
  const auto& [x, y, z] = largest.position;
  return fmt::format("at ({:.6g}, {:.6g}, {:.6g})", x, y, z);
}

/// Start, largest value, end and what remains, as the program prints them at the end of a run.
std::vector<std::string> course_row(const std::string& name, const io::Summary::Course& course) {
  return {name, number(course.start), number(course.largest), number(course.end),
          course.largest > 0 ? fmt::format("{:.0f} %", 100 * course.remaining()) : "-"};
}

/// The time of the last output, whose values are those of the end.
double last_time(const io::Summary& summary) {
  return summary.last_output.value_or(summary.time_reached);
}

/// The course from the start over the largest value to the end. A percentage of a start that hardly carries anything
/// means nothing.
std::string force_sentence(const std::string& name, const io::Summary::Course& course, double end,
                           const std::string& force, const std::string& time) {
  constexpr double min_relative_start = 0.01, notable = 1e-3;  // of the largest; beyond start and end
  std::string text = fmt::format("The normal force of contact {} goes from {} at the start to {} at t = {}", name,
                                 with_unit(course.start, force), with_unit(course.end, force), with_unit(end, time));
  if (course.start > min_relative_start * course.largest)
    text += fmt::format(", which is {:.0f}\u00a0% of the start", 100 * course.end / course.start);
  if (course.largest > (1 + notable) * std::max(course.start, course.end))
    text += fmt::format("; its largest value is {} at t = {}", with_unit(course.largest, force),
                        with_unit(course.t_largest, time));
  return text + ".";
}

/// The results in sentences, the most important ones first.
std::vector<std::string> sentences(const RunData& run) {
  const io::Summary& summary = *run.summary;
  const std::string force = unit(Dimension::force, run), time = unit(Dimension::time, run);
  std::vector<std::string> all;
  if (const auto& rupture = summary.rupture)
    all.push_back(fmt::format("Body {} ruptures at t = {} {}.", rupture->body, with_unit(rupture->time, time),
                              at_place(rupture->damage)));
  for (const auto& [name, contact] : summary.contacts) {
    if (contact.normal_force.largest > 0)
      all.push_back(force_sentence(name, contact.normal_force, last_time(summary), force, time));
    if (const std::string opening = io::opening_text(summary, contact, [&](double at) { return with_unit(at, time); });
        !opening.empty())
      all.push_back(fmt::format("Contact {} {}.", name, opening));
  }
  if (summary.heat && summary.heat->loop_gain) {
    const auto [gain, time] = *summary.heat->loop_gain;
    all.push_back(fmt::format(
        "Of a change of temperature at most {:.2g} comes back through pressure and conductance of the contacts (t = "
        "{}){}.",
        gain, with_unit(time, unit(Dimension::time, run)),
        gain > 1 ? ": the joint is unstable there, and loses or gains its pressure at the speed of heat" : ""));
  }
  if (summary.heat)
    for (const io::Summary::Heat::SuddenLoss& loss : summary.heat->sudden_losses)
      all.push_back(fmt::format(
          "Contact {} loses the last {} of its normal force at the speed of heat, between t = {} and t = {}: no steady "
          "state with contact exists any more.",
          loss.contact, with_unit(loss.force, force), number(loss.since), with_unit(loss.time, time)));
  for (const auto& [name, largest] : summary.life_fraction)
    all.push_back(fmt::format("Body {} has used {:.3g}\u00a0% of its creep life {}.", name, 100 * largest.value,
                              at_place(largest)));
  for (const auto& [name, largest] : summary.creep_fatigue)
    all.push_back(fmt::format("Body {} has used {:.3g}\u00a0% of its creep-fatigue diagram {}.", name,
                              100 * largest.value, at_place(largest)));
  if (const auto& cycles = summary.cycles)
    for (const auto& [name, limit] : cycles->to_limit) {
      if (cycles->has_reached(limit))
        all.push_back(fmt::format("After {:.4g} cycles the life of body {} was used up.", limit, name));
      else if (std::isfinite(limit))
        all.push_back(fmt::format("After {:.4g} cycles the life of body {} is used up, if all go on like cycle {}.",
                                  limit, name, cycles->completed));
    }
  for (const auto& [name, yielded] : summary.plastic_strain)
    all.push_back(fmt::format("Body {} has yielded in {:.3g} % of its volume; its largest plastic strain is {:.3g} {}.",
                              name, 100 * yielded.volume, yielded.strain.value, at_place(yielded.strain)));
  for (const auto& [name, largest] : summary.damage)
    all.push_back(fmt::format("The damage of body {} reaches {:.3g} {}.", name, largest.value, at_place(largest)));
  for (const auto& [name, life] : summary.remaining_life)
    if (!summary.rupture)
      all.push_back(fmt::format("The remaining life of body {} is {}, with the stress and temperature of {}, {}.", name,
                                with_unit(life.value, time),
                                summary.ended_early() ? "t = " + with_unit(last_time(summary), time) : "the end",
                                at_place(life)));
  for (const auto& [name, at] : summary.events)
    all.push_back(
        at ? fmt::format("Event {}: first true at t = {}.", name, with_unit(*at, time))
           : fmt::format("Event {}: did not happen up to t = {}.", name, with_unit(summary.time_reached, time)));
  return all;
}

/// What flows at the end; none of it is what nothing balances.
void add_heat(const io::Summary::Heat& heat, const std::string& end, Html& page) {
  Rows rows;
  for (const auto& [name, flow] : heat.flows) rows.push_back({name, number(flow)});
  for (const auto& [name, flow] : heat.contacts)
    rows.push_back({fmt::format("across contact {}, from slave to master", name), number(flow)});
  rows.push_back({"stored in the bodies", number(heat.stored)});
  if (const double largest = heat.largest(); largest > 0)
    rows.push_back({"missing in the sum, of the largest flow", fmt::format("{:.1e}", std::abs(heat.rest) / largest)});
  page.table({"heat into the bodies", "per time of the heat data"}, rows,
             fmt::format("Heat that flows at the {}", end));
}

void add_table(const io::RecordedTable& table, Html& page) {
  page.table(table.head, table.rows, table.title);
}

void add_stills(const std::vector<Drawings::Still>& stills, Html& page, const char* box) {
  if (stills.empty()) return;
  page.open("div", fmt::format("class=\"{}\"", box));
  for (const Drawings::Still& still : stills) page.image(still.url, still.title, still.title);
  page.close("div");
}

}  // namespace

std::string number(double value) {
  return fmt::format("{:.5g}", value);
}

std::string with_unit(double value, const std::string& unit) {
  return number(value) + (unit.empty() ? "" : " " + unit);
}

std::string ending(const RunData& run) {
  using Status = io::Summary::Status;
  if (!run.summary) return "This run has no summary: what follows is as far as it came.";
  const std::string of_time = unit(Dimension::time, run);
  const std::string reached = with_unit(run.summary->time_reached, of_time),
                    last = with_unit(last_time(*run.summary), of_time);
  switch (run.summary->status) {
    case Status::completed:
      return "";
    case Status::ruptured:
      return fmt::format("The run ended by rupture at t = {}.", reached);
    case Status::failed:
      return fmt::format("The run failed at t = {}: {}. The last output is that of t = {}.", reached,
                         run.summary->message, last);
    default:
      return fmt::format(
          "The run was interrupted at t = {}, before its end. The last output is that of t = {}. It can be continued "
          "with --resume.",
          reached, last);
  }
}

void add_answer(const RunData& run, Html& page, const std::string& level) {
  page.element(level, "What came out");
  if (!run.summary) {
    page.element("p", "Without summary.json there is no overview of the results.");
    return;
  }
  const io::Summary& summary = *run.summary;
  if (const std::vector<std::string> all = sentences(run); !all.empty()) {
    page.open("ul", "class=\"answer\"");
    for (const std::string& sentence : all) page.element("li", sentence);
    page.close("ul");
  }
  Rows forces, stresses, shares;
  for (const auto& [name, contact] : summary.contacts) forces.push_back(course_row(name, contact.normal_force));
  for (const auto& [name, body] : summary.bodies) stresses.push_back(course_row(name, body.von_mises));
  for (const auto& [name, body] : summary.bodies)
    if (body.yield_share) shares.push_back(course_row(name, *body.yield_share));
  const std::string last = fmt::format("t = {}", with_unit(last_time(summary), unit(Dimension::time, run)));
  const std::string end = summary.ended_early() ? last : "end";
  const std::vector<std::string> course{"start", "largest", end, end + " / largest"};
  const auto head = [&](const char* first) {
    std::vector<std::string> all{first};
    all.insert(all.end(), course.begin(), course.end());
    return all;
  };
  if (!forces.empty())
    page.table(head("contact"), forces, label("Normal forces of the modelled part", unit(Dimension::force, run)));
  if (!stresses.empty())
    page.table(head("body"), stresses, label("Largest von Mises stress in each body", unit(Dimension::stress, run)));
  if (!shares.empty()) page.table(head("body"), shares, "Largest von Mises stress / yield strength at its temperature");
  if (summary.heat) add_heat(*summary.heat, end, page);
  Rows probes;
  for (const auto& [name, probe] : summary.probes)
    if (probe.course) {
      const io::SummaryProbe::Course& c = *probe.course;
      probes.push_back({name, probe.quantity.empty() ? probe.expression : probe.quantity, probe.unit.value_or(""),
                        number(c.start), number(c.end), number(c.min), number(c.t_min), number(c.max),
                        number(c.t_max)});
    }
  if (!probes.empty())
    page.table({"probe", "quantity", "unit", "start", end, "smallest", label("at t", unit(Dimension::time, run)),
                "largest", label("at t", unit(Dimension::time, run))},
               probes, "Probes");
  if (!summary.warnings.empty())
    page.element("p", fmt::format("The run warned {} time{}: see Accuracy and warnings.", summary.warnings.size(),
                                  summary.warnings.size() == 1 ? "" : "s"));
}

void add_histories(const RunData& run, Drawings& drawings, Html& page, const std::string& level) {
  page.element(level, "Histories");
  if (!run.tables || run.tables->history.rows() < 2) {
    page.element("p", "There are fewer than two output times so far: no curves can be drawn.");
    return;
  }
  if (run.tables->history.names.size() < 2) {
    page.element("p", "The run has no probes ([[probes]] in its configuration).");
    return;
  }
  try {
    for (const plot::NamedFigure& one : plot::run_figures(*run.tables, {}))
      if (one.name != "steps") drawings.add(one.figure, "Histories of the probes over time", page);
  } catch (const ConfigError& error) {
    page.element("p", error.what());
  }
}

void add_fields(const RunData& run, std::size_t n, Drawings& drawings, Html& page, const std::string& level) {
  page.element(level, "Fields");
  if (!run.scene) {
    page.element("p", "The run has no field files.");
    return;
  }
  std::vector<Drawings::Still> stills = drawings.fields(run), beside;
  // The view of a section has no place for values along an edge.
  if (run.scene->flat) {
    std::ranges::copy_if(stills, std::back_inserter(beside), &Drawings::Still::on_contact);
    std::erase_if(stills, [](const Drawings::Still& still) { return still.on_contact; });
  }
  page.open("figure", fmt::format("class=\"fields\" id=\"fields-{}\"", n));
  add_stills(stills, page, "still");
  if (!viewer_script().empty()) {
    page.raw(fmt::format("<div class=\"viewer\" data-scene=\"scene-{}\"></div>\n", n));
    page.element("noscript", "The interactive view needs JavaScript.");
  }
  page.element("figcaption",
               "Displacements are drawn larger by the factor shown, from the mesh as it was made. Bodies with an "
               "interference or a gap given in the configuration touch in the mesh; deformed they therefore appear "
               "apart, or overlap, by that amount times the factor." +
                   (run.scene->note.empty() ? "" : " " + run.scene->note));
  page.close("figure");
  add_stills(beside, page, "small");
  if (viewer_script().empty()) return;
  const PackedScene scene = packed(*run.scene);
  page.raw(fmt::format("<script type=\"application/json\" id=\"scene-{}\">{}</script>\n", n, scene.header));
  page.raw(fmt::format("<script type=\"text/plain\" id=\"scene-{}-data\">{}</script>\n", n, scene.data));
}

void add_inputs(const RunData& run, Drawings& drawings, Html& page, const std::string& level) {
  page.element(level, "Inputs");
  if (run.record.sections.empty()) {
    page.element("p", "The run has no model.json, which describes the inputs.");
    return;
  }
  bool is_first = true;
  for (const io::RecordedSection& section : run.record.sections) {
    page.element(below(level), section.title);
    for (const std::string& note : section.notes) page.element("p", note);
    for (const io::RecordedTable& table : section.tables) add_table(table, page);
    if (!section.plots.empty()) page.open("div", "class=\"small\"");
    for (const io::RecordedPlot& plot : section.plots) drawings.add(plot, page);
    if (!section.plots.empty()) page.close("div");
    if (std::exchange(is_first, false)) add_stills(drawings.meshes(run), page, "meshes");
  }
}

void add_accuracy(const RunData& run, Drawings& drawings, Html& page, const std::string& level) {
  page.element(level, "Accuracy and warnings");
  if (run.summary) {
    const io::Summary& summary = *run.summary;
    const io::Summary::Accuracy& accuracy = summary.accuracy;
    Rows rows;
    if (accuracy.tolerance > 0)
      rows.push_back(
          {"relative accuracy asked for the stress (time.tolerance)", fmt::format("{:.2g}", accuracy.tolerance)});
    if (accuracy.largest_step_error > 0) {
      rows.push_back({"estimated error of the steps on average, of what is allowed",
                      fmt::format("{:.0f} %", 100 * accuracy.mean_step_error)});
      rows.push_back({"the same, the largest", fmt::format("{:.0f} %", 100 * accuracy.largest_step_error)});
    }
    if (accuracy.equilibrium_residual)
      rows.push_back({"forces that nothing balances at the end, of the largest nodal force",
                      fmt::format("{:.1e}", *accuracy.equilibrium_residual)});
    if (summary.friction_kappa)
      rows.push_back({"friction: kappa (above 1 several states may be possible)", number(*summary.friction_kappa)});
    rows.push_back({"integrator", summary.method.empty() || summary.method == summary.integrator
                                      ? summary.integrator
                                      : fmt::format("{} ({})", summary.integrator, summary.method)});
    rows.push_back({"time steps, accepted + rejected", fmt::format("{} + {}", summary.steps, summary.rejected_steps)});
    rows.push_back({"elastic solves", fmt::format("{}", summary.elastic_solves)});
    rows.push_back({"computing time", fmt::format("{:.2f} s", summary.wall_seconds.total)});
    rows.push_back({"memory", fmt::format("{:.0f} MB", summary.peak_memory_mb)});
    page.table({"item", "value"}, rows, "Accuracy and cost");
    page.element("p",
                 "The error estimate is that of the integration in time. The error of the mesh is not in it: compare "
                 "with a finer mesh. The forces that nothing balances include those of the stabilisation of elements "
                 "with reduced integration.");
    if (summary.warnings.empty()) {
      page.element("p", accuracy.tolerance > 0 ? "The run gave no warnings."
                                               : "Runs of this version do not record what they warned of.");
    } else {
      page.open("ul", "class=\"warnings\"");
      for (const std::string& warning : summary.warnings) page.element("li", warning);
      page.close("ul");
    }
  }
  if (run.tables && run.tables->steps.rows() > 1) {
    const bool logarithmic = plot::spans_decades(run.tables->steps.columns[0]);
    plot::Figure figure = plot::steps_figure(run.tables->steps, run.tables->heading, logarithmic);
    figure.title = "Time steps";
    drawings.add(figure, "Length, order and cost of the time steps", page);
  }
}

void add_origin(const RunData& run, Html& page, const std::string& level) {
  page.element(level, "Origin");
  Rows rows;
  const auto add = [&](const char* what, const std::string& text) {
    if (!text.empty()) rows.push_back({what, text});
  };
  add("directory", run.directory.lexically_normal().string());
  add("configuration", run.record.configuration);
  add("fingerprint of configuration and mesh", run.record.fingerprint);
  add("run started", run.record.started);
  add("version of the program", run.summary ? run.summary->version : run.record.version);
  add("units", run.units());
  page.table({"item", "value"}, rows, "Origin of the results");
  if (run.notes.empty()) return;
  page.open("ul");
  for (const std::string& note : run.notes) page.element("li", note);
  page.close("ul");
}

}  // namespace creepcontact::report
