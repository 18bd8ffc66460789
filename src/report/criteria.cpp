#include "criteria.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "engineering.hpp"

namespace creepcontact::report {
namespace {

using Criterion = io::Summary::Criterion;
using Criteria = std::map<std::string, Criterion>;

const char* style_of(const Criterion& criterion) {
  if (!criterion.met) return "open";
  return *criterion.met ? "met" : "missed";
}

/// How many are met, and the names of those that are not.
std::string verdict_of_all(const Criteria& all) {
  std::vector<std::string> missed, open;
  for (const auto& [name, criterion] : all) {
    if (!criterion.met)
      open.push_back(name);
    else if (!*criterion.met)
      missed.push_back(name);
  }
  const std::size_t met = all.size() - missed.size() - open.size();
  std::string text = met == all.size() ? fmt::format("All {} criteria are met.", met)
                                       : fmt::format("{} of {} criteria are met.", met, all.size());
  if (all.size() == 1 && met == 1) text = "The criterion is met.";
  if (!missed.empty()) text += fmt::format(" NOT met: {}.", fmt::join(missed, ", "));
  if (!open.empty()) text += fmt::format(" Not judged, as the run did not come so far: {}.", fmt::join(open, ", "));
  return text;
}

void add_verdict(const Criteria& all, const std::string& of, Html& page) {
  const bool missed = std::ranges::any_of(all, [](const auto& one) { return one.second.met == false; });
  const bool open = std::ranges::any_of(all, [](const auto& one) { return !one.second.met; });
  page.element("p", of + verdict_of_all(all),
               fmt::format("class=\"verdict {}\" role=\"note\"", missed ? "missed"
                                                                 : open ? "open"
                                                                        : "met"));
}

void cell(const std::string& text, const char* style, Html& page) {
  page.element("td", text, *style == '\0' ? std::string() : fmt::format("class=\"{}\"", style));
}

void open_table(const std::string& caption, const std::vector<std::string>& head, Html& page) {
  page.open("div", fmt::format("class=\"table\" tabindex=\"0\" role=\"group\" aria-label=\"{}\"", escaped(caption)));
  page.open("table", "class=\"criteria\"");
  page.element("caption", caption);
  page.open("thead");
  page.open("tr");
  for (const std::string& title : head) page.element("th", title, "scope=\"col\"");
  page.close("tr");
  page.close("thead");
  page.open("tbody");
}

void close_table(Html& page) {
  page.close("tbody");
  page.close("table");
  page.close("div");
}

}  // namespace

const char* verdict(const Criterion& criterion) {
  if (!criterion.met) return "not judged";
  return *criterion.met ? "met" : "NOT met";
}

std::string utilisation(const Criterion& criterion) {
  if (!criterion.met) return "-";
  double share = criterion.utilisation;
  // summary.json has no infinite numbers: nothing was found where something must be.
  if (criterion.is_minimum && share == 0 && criterion.found <= 0 && criterion.allowed > 0)
    share = std::numeric_limits<double>::infinity();
  if (std::isinf(share)) return "∞";
  constexpr double near = 0.05;
  if (share > 1 && share < 1 + near) return fmt::format("{:.1f}\u00a0%", std::ceil(1000 * share) / 10);
  if (share < 1 && share > 1 - near) return fmt::format("{:.1f}\u00a0%", std::floor(1000 * share) / 10);
  return percent(share);
}

void add_criteria(const RunData& run, Html& page) {
  if (!run.summary || run.summary->criteria.empty()) return;
  page.open("section", "id=\"criteria\"");
  page.element("h2", "Criteria");
  add_verdict(run.summary->criteria, "", page);
  open_table("Criteria, each where it is closest to its limit, or farthest beyond",
             {"criterion", "demand", "found", "allowed", "utilisation", labelled("at t", run.unit(Dimension::time)),
              "where", "met?"},
             page);
  for (const auto& [name, criterion] : run.summary->criteria) {
    const Scale scale(criterion.unit, std::array{criterion.found, criterion.allowed});
    const bool judged = criterion.met.has_value();
    std::string where = criterion.body;
    if (criterion.position)
      where += (where.empty() ? "" : " ") + place_text(*criterion.position, run.unit(Dimension::length));
    page.open("tr");
    page.element("th", name, "scope=\"row\"");
    cell(criterion.demand, "", page);
    cell(judged ? scale.with_unit(criterion.found) : "-", "number", page);
    cell(judged ? (criterion.is_minimum ? "≥\u00a0" : "≤\u00a0") + scale.with_unit(criterion.allowed) : "-", "number",
         page);
    cell(utilisation(criterion), "number", page);
    cell(judged ? time_text(criterion.time, "") : "-", "number", page);
    cell(judged && !where.empty() ? where : "-", "", page);
    cell(verdict(criterion), style_of(criterion), page);
    page.close("tr");
  }
  close_table(page);
  page.close("section");
}

void add_criteria(const std::vector<RunData>& runs, Html& page) {
  std::set<std::string> names;
  for (const RunData& run : runs)
    if (run.summary)
      for (const auto& [name, criterion] : run.summary->criteria) names.insert(name);
  if (names.empty()) return;
  page.open("section", "id=\"criteria\"");
  page.element("h2", "Criteria");
  for (const RunData& run : runs)
    if (run.summary && !run.summary->criteria.empty()) add_verdict(run.summary->criteria, run.label + ": ", page);
  std::vector<std::string> head{"criterion", "demand"};
  for (const RunData& run : runs) head.push_back(run.label);
  open_table("Criteria of all runs, with their utilisation", head, page);
  for (const std::string& name : names) {
    page.open("tr");
    page.element("th", name, "scope=\"row\"");
    std::string demand;
    for (const RunData& run : runs)
      if (run.summary && demand.empty())
        if (const auto found = run.summary->criteria.find(name); found != run.summary->criteria.end())
          demand = found->second.demand;
    cell(demand, "", page);
    for (const RunData& run : runs) {
      const Criterion* criterion = nullptr;
      if (run.summary)
        if (const auto found = run.summary->criteria.find(name); found != run.summary->criteria.end())
          criterion = &found->second;
      if (criterion == nullptr)
        cell("-", "", page);
      else
        cell(
            criterion->met ? fmt::format("{} ({})", verdict(*criterion), utilisation(*criterion)) : verdict(*criterion),
            style_of(*criterion), page);
    }
    page.close("tr");
  }
  close_table(page);
  page.close("section");
}

}  // namespace creepcontact::report
