/// What came out, in sentences and tables.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engineering.hpp"
#include "markdown.hpp"
#include "run_sections.hpp"

namespace creepcontact::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string at_place(const RunData& run, const io::Summary::Largest& largest) {
  return "at " + place_text(largest.position, run.unit(Dimension::length));
}

/// The time of the last output, whose values are those of the end.
double last_time(const io::Summary& summary) {
  return summary.last_output.value_or(summary.time_reached);
}

/// The course from the start over the largest value to the end. A percentage of a start that hardly carries anything
/// means nothing.
std::string force_sentence(const std::string& name, const io::Summary::Course& course, double end, const Scale& force,
                           const std::string& time) {
  constexpr double min_relative_start = 0.01, notable = 1e-3;  // of the largest; beyond start and end
  std::string text = fmt::format("The normal force of contact {} goes from {} at the start to {} at t = {}", name,
                                 force.with_unit(course.start), force.with_unit(course.end), time_text(end, time));
  if (course.start > min_relative_start * course.largest)
    text += fmt::format(", which is {} of the start", percent(course.end / course.start));
  if (course.largest > (1 + notable) * std::max(course.start, course.end))
    text += fmt::format("; its largest value is {} at t = {}", force.with_unit(course.largest),
                        time_text(course.t_largest, time));
  return text + ".";
}

/// The results in sentences, the most important ones first.
std::vector<std::string> sentences(const RunData& run) {
  const io::Summary& summary = *run.summary;
  const std::string force = run.unit(Dimension::force), time = run.unit(Dimension::time);
  std::vector<double> forces;
  for (const auto& [name, contact] : summary.contacts) forces.push_back(contact.normal_force.largest);
  const Scale scale(force, forces);
  std::vector<std::string> all;
  if (const auto& rupture = summary.rupture)
    all.push_back(fmt::format("Body {} ruptures at t = {} {}.", rupture->body, time_text(rupture->time, time),
                              at_place(run, rupture->damage)));
  for (const auto& [name, contact] : summary.contacts) {
    if (contact.normal_force.largest > 0)
      all.push_back(force_sentence(name, contact.normal_force, last_time(summary), scale, time));
    if (const std::string opening = io::opening_text(summary, contact, [&](double at) { return time_text(at, time); });
        !opening.empty())
      all.push_back(fmt::format("Contact {} {}.", name, opening));
  }
  if (summary.heat && summary.heat->loop_gain) {
    const auto [gain, at] = *summary.heat->loop_gain;
    all.push_back(fmt::format(
        "Of a change of temperature at most {} comes back through pressure and conductance of the contacts (t = "
        "{}){}.",
        engineering(gain, 2), time_text(at, time),
        gain > 1 ? ": the joint is unstable there, and loses or gains its pressure at the speed of heat" : ""));
  }
  if (summary.heat)
    for (const io::Summary::Heat::SuddenLoss& loss : summary.heat->sudden_losses)
      all.push_back(fmt::format(
          "Contact {} loses the last {} of its normal force at the speed of heat, between t = {} and t = {}: no steady "
          "state with contact exists any more.",
          loss.contact, quantity(loss.force, force), time_text(loss.since, ""), time_text(loss.time, time)));
  for (const auto& [name, largest] : summary.life_fraction)
    all.push_back(
        fmt::format("Body {} has used {} of its creep life {}.", name, percent(largest.value), at_place(run, largest)));
  for (const auto& [name, largest] : summary.creep_fatigue)
    all.push_back(fmt::format("Body {} has used {} of its creep-fatigue diagram {}.", name, percent(largest.value),
                              at_place(run, largest)));
  if (const auto& cycles = summary.cycles)
    for (const auto& [name, limit] : cycles->to_limit) {
      if (cycles->has_reached(limit))
        all.push_back(fmt::format("After {} cycles the life of body {} was used up.", engineering(limit, 4), name));
      else if (std::isfinite(limit))
        all.push_back(fmt::format("After {} cycles the life of body {} is used up, if all go on like cycle {}.",
                                  engineering(limit, 4), name, cycles->completed));
    }
  for (const auto& [name, yielded] : summary.plastic_strain)
    all.push_back(fmt::format("Body {} has yielded in {} of its volume; its largest plastic strain is {} {}.", name,
                              percent(yielded.volume), engineering(yielded.strain.value),
                              at_place(run, yielded.strain)));
  for (const auto& [name, largest] : summary.damage)
    all.push_back(
        fmt::format("The damage of body {} reaches {} {}.", name, engineering(largest.value), at_place(run, largest)));
  for (const auto& [name, life] : summary.remaining_life)
    if (!summary.rupture)
      all.push_back(fmt::format("The remaining life of body {} is {}, with the stress and temperature of {}, {}.", name,
                                time_text(life.value, time),
                                summary.ended_early() ? "t = " + time_text(last_time(summary), time) : "the end",
                                at_place(run, life)));
  for (const auto& [name, at] : summary.events)
    all.push_back(
        at ? fmt::format("Event {}: first true at t = {}.", name, time_text(*at, time))
           : fmt::format("Event {}: did not happen up to t = {}.", name, time_text(summary.time_reached, time)));
  return all;
}

/// What flows at the end; none of it is what nothing balances.
void add_heat(const io::Summary::Heat& heat, const std::string& end, Html& page) {
  std::vector<double> all{heat.stored};
  for (const auto& [name, flow] : heat.flows) all.push_back(flow);
  for (const auto& [name, flow] : heat.contacts) all.push_back(flow);
  const Scale scale("", all);
  Rows rows;
  for (const auto& [name, flow] : heat.flows) rows.push_back({name, scale.text(flow)});
  for (const auto& [name, flow] : heat.contacts)
    rows.push_back({fmt::format("across contact {}, from slave to master", name), scale.text(flow)});
  rows.push_back({"stored in the bodies", scale.text(heat.stored)});
  if (const double largest = heat.largest(); largest > 0)
    rows.push_back({"missing in the sum, of the largest flow", engineering(std::abs(heat.rest) / largest, 2)});
  page.table({"heat into the bodies", "per time of the heat data"}, rows,
             fmt::format("Heat that flows at the {}", end));
}

/// A row of a table of courses.
struct NamedCourse {
  std::string name;
  io::Summary::Course course;
};

/// Start, largest value, end and what remains, all in one unit.
void add_courses(const std::string& first, const std::vector<NamedCourse>& courses, const std::string& unit,
                 const std::string& end, const std::string& caption, Html& page) {
  if (courses.empty()) return;
  std::vector<double> all;
  for (const NamedCourse& one : courses) all.insert(all.end(), {one.course.start, one.course.largest, one.course.end});
  const Scale scale(unit, all);
  Rows rows;
  for (const auto& [name, course] : courses)
    rows.push_back({name, scale.text(course.start), scale.text(course.largest), scale.text(course.end),
                    course.largest > 0 ? percent(course.remaining()) : "-"});
  page.table({first, "start", "largest", end, end + " / largest"}, rows, labelled(caption, scale.unit()));
}

/// Shares of life, where bodies have data for them.
void add_life(const RunData& run, Html& page) {
  const io::Summary& summary = *run.summary;
  std::map<std::string, std::vector<std::string>> by_body;
  const auto add = [&](const std::map<std::string, io::Summary::Largest>& shares, std::size_t column) {
    for (const auto& [body, largest] : shares) {
      std::vector<std::string>& row =
          by_body.try_emplace(body, std::vector<std::string>{body, "-", "-", "-", "-", "-"}).first->second;
      row[column] = percent(largest.value);
      row[5] = place_text(largest.position, run.unit(Dimension::length));
    }
  };
  add(summary.life_fraction, 1);
  add(summary.fatigue_fraction, 2);
  add(summary.creep_fatigue, 3);
  if (summary.cycles)
    for (const auto& [body, limit] : summary.cycles->to_limit)
      if (const auto row = by_body.find(body); row != by_body.end()) row->second[4] = engineering(limit, 4);
  if (summary.fatigue_fraction.empty() && summary.creep_fatigue.empty()) return;
  Rows rows;
  for (const auto& [body, row] : by_body) rows.push_back(row);
  page.table({"body", "creep life used", "fatigue life used", "of the interaction diagram", "cycles to the limit",
              "where (last of them)"},
             rows, "Creep and fatigue, the largest of each body");
}

void add_probes(const RunData& run, const std::string& end, Html& page) {
  const std::string at_time = labelled("at t", run.unit(Dimension::time));
  Rows rows;
  for (const auto& [name, probe] : run.summary->probes)
    if (probe.course) {
      const io::SummaryProbe::Course& c = *probe.course;
      const Scale scale(probe.unit.value_or(""), std::array{c.start, c.end, c.min, c.max});
      rows.push_back({name, probe.quantity.empty() ? probe.expression : probe.quantity, scale.unit(),
                      scale.text(c.start), scale.text(c.end), scale.text(c.min), time_text(c.t_min, ""),
                      scale.text(c.max), time_text(c.t_max, "")});
    }
  if (!rows.empty())
    page.table({"probe", "quantity", "unit", "start", end, "smallest", at_time, "largest", at_time}, rows, "Probes");
}

}  // namespace

std::string ending(const RunData& run) {
  using Status = io::Summary::Status;
  if (!run.summary) return "This run has no summary: what follows is as far as it came.";
  const std::string of_time = run.unit(Dimension::time);
  const std::string reached = time_text(run.summary->time_reached, of_time),
                    last = time_text(last_time(*run.summary), of_time);
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

void add_answer(const RunData& run, Html& page) {
  page.element("h2", "What came out");
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
  const std::string last = fmt::format("t = {}", time_text(last_time(summary), run.unit(Dimension::time)));
  const std::string end = summary.ended_early() ? last : "end";
  std::vector<NamedCourse> forces, stresses, shares;
  for (const auto& [name, contact] : summary.contacts) forces.push_back({name, contact.normal_force});
  for (const auto& [name, body] : summary.bodies) stresses.push_back({name, body.von_mises});
  for (const auto& [name, body] : summary.bodies)
    if (body.yield_share) shares.push_back({name, *body.yield_share});
  add_courses("contact", forces, run.unit(Dimension::force), end, "Normal forces of the modelled part", page);
  add_courses("body", stresses, run.unit(Dimension::stress), end, "Largest von Mises stress in each body", page);
  add_courses("body", shares, "", end, "Largest von Mises stress / yield strength at its temperature", page);
  add_life(run, page);
  if (summary.heat) add_heat(*summary.heat, end, page);
  add_probes(run, end, page);
  if (!summary.warnings.empty())
    page.element("p", fmt::format("The run warned {} time{}: see Accuracy and warnings.", summary.warnings.size(),
                                  summary.warnings.size() == 1 ? "" : "s"));
  if (!run.record.report.assessment.empty()) {
    page.element("h2", "Assessment");
    page.raw(markdown(run.record.report.assessment, 3));
  }
}

}  // namespace creepcontact::report
