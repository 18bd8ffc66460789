#include "creepcontact/run/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "creepcontact/base/units.hpp"
#include "creepcontact/results/criteria.hpp"
#include "heat_lines.hpp"

namespace creepcontact::run {
namespace {

constexpr double many_failures = 0.1;     // of the steps
constexpr double many_rejections = 0.3;   // of the steps
constexpr double many_iterations = 40;    // of the contact solver in a solve
constexpr double many_set_changes = 0.2;  // of the steps
constexpr std::int64_t few_steps = 20;    // say nothing of habits

double share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

/// "where to look": the body that creeps fastest, and the contact that changes most.
std::string where(const io::Summary& summary, const Diagnosis& diagnosis) {
  std::string text;
  const auto fastest = std::ranges::min_element(diagnosis.bodies, {}, &Diagnosis::Body::relaxation_time);
  if (fastest != diagnosis.bodies.end() && std::isfinite(fastest->relaxation_time))
    text += fmt::format(" Body '{}' creeps fastest (relaxation time {:.3g} at the end).", fastest->name,
                        fastest->relaxation_time);
  const auto busiest = std::ranges::max_element(diagnosis.contacts, {}, &Diagnosis::Contact::set_changes);
  if (busiest != diagnosis.contacts.end() && busiest->set_changes > 0)
    text += fmt::format(" Contact '{}' opened or closed somewhere in {} of {} steps.", busiest->name,
                        busiest->set_changes, summary.steps);
  return text;
}

/// A row of the table of outcomes.
std::string row(const std::string& name, const io::Summary::Course& course) {
  const std::string remaining = course.largest > 0 ? fmt::format("{:.0f} %", 100 * course.remaining()) : "-";
  return fmt::format("  {:<34}{:>12.5g}{:>12.5g}{:>12.5g}{:>12}\n", name, course.start, course.largest, course.end,
                     remaining);
}

std::string cycle_lines(const io::Summary::Cycles& cycles) {
  std::string text = fmt::format("  {} cycle{}", cycles.completed, cycles.completed == 1 ? "" : "s");
  if (cycles.jumps + cycles.rejected_jumps > 0)
    text += fmt::format(": {} computed, {} jumps over up to {} cycles, {} more rejected", cycles.computed, cycles.jumps,
                        cycles.longest_jump, cycles.rejected_jumps);
  if (cycles.steady)
    text += fmt::format("; the last one repeats the one before it to within {:.3g}", cycles.steady_within);
  else if (cycles.last_change)
    text += fmt::format("; the last one changes the stress or a probe by {:.2g}, more than stop_when_steady = {:g}",
                        *cycles.last_change, cycles.steady_within);
  text += '\n';
  for (const auto& [name, limit] : cycles.to_limit)
    if (cycles.has_reached(limit))
      text += fmt::format("  body '{}' reached the limit of its life after {:.4g} cycles\n", name, limit);
    else if (std::isfinite(limit))
      text += fmt::format(
          "  body '{}' reaches the limit of its life {:.4g} cycles after t = 0, if all go on like the "
          "last one\n",
          name, limit);
  return text;
}

std::string share(double value) {
  return value < 10 ? fmt::format("{:.3g} %", 100 * value) : fmt::format("{:.3g} times the whole", value);
}

std::string place(const io::Summary::Largest& largest) {
  const auto& [x, y, z] = largest.position;
  return fmt::format("at ({:.6g}, {:.6g}, {:.6g})", x, y, z);
}

/// The heat that flows at the end, its balance, and the loop gain.
std::string heat_lines(const io::Summary::Heat& heat) {
  std::string text = "  heat at the end, per time of its data\n" + balance_lines(heat);
  if (heat.loop_gain)
    text += fmt::format("    loop gain of contact and heat: at most {:.2g}, at t = {:.6g}\n", heat.loop_gain->value,
                        heat.loop_gain->time);
  for (const io::Summary::Heat::SuddenLoss& loss : heat.sudden_losses)
    text += fmt::format("    contact '{}' lost its pressure at the speed of heat, between t = {:.6g} and {:.6g}\n",
                        loss.contact, loss.since, loss.time);
  return text;
}

std::string outcome_table(const io::Summary& summary) {
  // Without an output at its end a run has no values of its end.
  const bool is_end = summary.status == io::Summary::Status::completed || summary.rupture;
  const std::string up_to =
      is_end ? "" : fmt::format("last output: t = {:.6g}", summary.last_output.value_or(summary.time_reached));
  const auto is_unloaded = [](const auto& named) { return named.second.von_mises.largest == 0; };
  const auto criteria = [&] {
    std::string lines;
    for (const auto& [name, criterion] : summary.criteria)
      lines += "  " + results::criterion_line(name, criterion) + "\n";
    return lines;
  };
  if (summary.heat && summary.contacts.empty() && std::ranges::all_of(summary.bodies, is_unloaded))
    return heat_lines(*summary.heat) + criteria();
  std::string text = fmt::format("  {:<34}{:>12}{:>12}{:>12}{:>12}\n", up_to, "start", "largest",
                                 is_end ? "end" : "last", is_end ? "end/largest" : "last/largest");
  for (const auto& [name, contact] : summary.contacts)
    text += row(fmt::format("normal force of contact '{}'", name), contact.normal_force);
  for (const auto& [name, body] : summary.bodies)
    text += row(fmt::format("von Mises stress of body '{}'", name), body.von_mises);
  for (const auto& [name, body] : summary.bodies)
    if (body.yield_share) text += row(fmt::format("  / yield strength, body '{}'", name), *body.yield_share);
  for (const auto& [name, contact] : summary.contacts)
    if (const std::string opening =
            io::opening_text(summary, contact, [](double time) { return fmt::format("{:.6g}", time); });
        !opening.empty())
      text += fmt::format("  contact '{}' {}\n", name, opening);
  for (const auto& [name, yielded] : summary.plastic_strain)
    text += fmt::format("  body '{}' has yielded in {} of its volume; largest plastic strain {:.3g} {}\n", name,
                        share(yielded.volume), yielded.strain.value, place(yielded.strain));
  for (const auto& [name, largest] : summary.life_fraction)
    text += fmt::format("  body '{}' has used {} of its creep life {}\n", name, share(largest.value), place(largest));
  for (const auto& [name, largest] : summary.creep_fatigue)
    text += fmt::format("  body '{}' has used {} of the creep-fatigue diagram {}\n", name, share(largest.value),
                        place(largest));
  for (const auto& [name, largest] : summary.damage)
    text += fmt::format("  body '{}' has a damage of {:.3g} {}\n", name, largest.value, place(largest));
  for (const auto& [name, life] : summary.remaining_life)
    if (!summary.rupture)
      text += fmt::format("  body '{}' has a remaining life of {} at the present stress {}\n", name,
                          with_unit(life.value, Dimension::time, summary.units), place(life));
  if (const auto& rupture = summary.rupture)
    text +=
        fmt::format("  body '{}' ruptured at t = {:.6g} {}\n", rupture->body, rupture->time, place(rupture->damage));
  if (summary.heat) text += heat_lines(*summary.heat);
  text += criteria();
  if (summary.cycles) text += cycle_lines(*summary.cycles);
  if (summary.plastic_error.value_or(0) > 0)
    text += fmt::format("  plastic flow: estimated error of the stress {:.2g} of the yield stress\n",
                        *summary.plastic_error);
  if (summary.gasket_error.value_or(0) > 0)
    text += fmt::format("  gaskets: estimated error of the largest closure {:.2g} of it\n", *summary.gasket_error);
  return text;
}

std::string work_line(const Summary& run) {
  const io::Summary& summary = run.results;
  std::string text = "  ";
  if (!summary.method.empty()) text += fmt::format("{}: {} steps", summary.method, summary.steps);
  if (run.steps.largest_error() > 0)
    text += fmt::format(" (relative stress tolerance {:.0e})", summary.accuracy.tolerance);
  if (!summary.method.empty()) text += ", ";
  return text + fmt::format("{} elastic solves, {} Schwarz iterations, {:.2f} s, {:.0f} MB\n", summary.elastic_solves,
                            summary.schwarz_iterations, summary.wall_seconds.total, summary.peak_memory_mb);
}

std::string work_table(const Summary& run) {
  const io::Summary& summary = run.results;
  const StepStatistics& steps = run.steps;
  std::string text;
  const auto line = [&](const char* name, const std::string& value) {
    text += fmt::format("  {:<16}{}\n", name, value);
  };
  line("steps", fmt::format("{} of {:.3g} to {:.3g}, {} rejected, {} iterations failed; {}, order up to {}",
                            summary.steps, steps.shortest(), steps.longest(), summary.rejected_steps,
                            summary.convergence_failures, summary.method, steps.highest_order()));
  // A rate at the point of the last solve takes none.
  const std::int64_t others =
      std::max<std::int64_t>(0, summary.elastic_solves - summary.rhs_evaluations - summary.jacobian_products);
  line("elastic solves",
       fmt::format(
           "{}: {} rates, {} Jacobian products, {} others (start, outputs, repetitions, tangent); {} factorisations",
           summary.elastic_solves, summary.rhs_evaluations, summary.jacobian_products, others, summary.factorizations));
  if (summary.contact_solves > 0 && summary.schwarz_iterations > 0)
    line("contact",
         fmt::format("{:.1f} iterations per solve", share(summary.schwarz_iterations, summary.contact_solves)));
  if (steps.largest_error() > 0)
    line("accuracy", fmt::format("requested for the stress: {:.0e}; estimated errors of the steps: {:.2f} of this on "
                                 "average, {:.2f} at most",
                                 summary.accuracy.tolerance, steps.mean_error(), steps.largest_error()));
  const auto& wall = summary.wall_seconds;
  std::vector<std::string> shares;
  for (std::size_t i = 0; i < run_parts.size(); ++i)
    shares.push_back(fmt::format("{} {:.0f} %", run_parts[i].words, 100 * wall.parts[i] / wall.total));
  line("time", fmt::format("{:.2f} s: {}", wall.total, fmt::join(shares, ", ")));
  line("memory", fmt::format("{:.0f} MB at most", summary.peak_memory_mb));
  return text;
}

std::string process_table(const ProcessWork& work) {
  if (work.values.empty()) return {};
  std::string text = "  processes:\n";
  for (std::size_t i = 0; i < work.names.size(); ++i) {
    text += fmt::format("    {:<30}", work.names[i]);
    for (const std::vector<double>& of_process : work.values) text += fmt::format("{:>12.5g}", of_process[i]);
    text += '\n';
  }
  return text;
}

}  // namespace

std::string report(const Summary& run) {
  if (!run.has_output || run.results.status == io::Summary::Status::failed) return {};
  using Status = io::Summary::Status;
  const io::Summary& summary = run.results;
  const char* const end = summary.status == Status::interrupted ? "interrupted" : summary.rupture ? "ruptured" : "done";
  return fmt::format("{}: t = {:.6g}; results in {}\n", end, summary.time_reached, run.directory) +
         outcome_table(summary) + work_line(run);
}

std::string details(const Summary& run) {
  if (run.steps.empty()) return {};
  std::string text = work_table(run);
  if (run.is_resumed) text += "  (lengths, orders and errors of the steps and the time are counted since the resume)\n";
  return text + process_table(run.processes);
}

std::vector<std::string> advice(const Summary& run) {
  const io::Summary& summary = run.results;
  const StepStatistics& steps = run.steps;
  const Diagnosis& diagnosis = run.diagnosis;
  if (summary.rupture) return {};  // steps that are rejected and shrink are its signs
  std::vector<std::string> lines;
  if (summary.steps < few_steps) return lines;
  // `auto` has changed its method by itself.
  if (summary.integrator != "auto" && share(summary.convergence_failures, summary.steps) > many_failures)
    lines.push_back(
        fmt::format("the iterations of the implicit steps failed {} times in {} steps.{} Try "
                    "another time.integrator (auto, arkode_erk), or a tighter contact_solver.tolerance",
                    summary.convergence_failures, summary.steps, where(summary, diagnosis)));
  if (share(summary.rejected_steps, summary.steps) > many_rejections)
    lines.push_back(
        fmt::format("{} steps were rejected and {} accepted.{} If loads jump or change their slope at times that no "
                    "table shows, list these times in time.breakpoints",
                    summary.rejected_steps, summary.steps, where(summary, diagnosis)));
  const double iterations = share(summary.schwarz_iterations, summary.contact_solves);
  if (iterations > many_iterations)
    lines.push_back(
        fmt::format("the contact solver took {:.0f} iterations per solve. Try contact_solver.acceleration = "
                    "\"cg\", or contact_solver.method = \"active_set\"",
                    iterations));
  for (const Diagnosis::Contact& contact : diagnosis.contacts)
    if (steps.largest_error() > 0 && share(contact.set_changes, summary.steps) > many_set_changes &&
        share(summary.rejected_steps, summary.steps) > many_failures)
      lines.push_back(
          fmt::format("contact '{}' opened or closed somewhere in {} of {} steps, which keeps them short; {} makes "
                      "them longer",
                      contact.name, contact.set_changes, summary.steps,
                      // Accuracy comes first: such a contact needs a finer mesh.
                      contact.is_narrow ? "a larger time.tolerance"
                                        : "a coarser mesh of its slave surface, or a larger time.tolerance,"));
  return lines;
}

}  // namespace creepcontact::run
