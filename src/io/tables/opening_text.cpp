#include <fmt/format.h>

#include "creepcontact/io/tables/summary.hpp"

namespace creepcontact::io {
namespace {

std::string times(std::int64_t n) {
  return n == 1 ? "once" : fmt::format("{} times", n);
}

}  // namespace

std::string opening_text(const Summary& summary, const Summary::Contact& contact,
                         const std::function<std::string(double)>& time) {
  if (!(contact.normal_force.largest > 0)) return "carries no force";
  if (contact.opened) {
    const std::string text = fmt::format("is open from t = {} on", time(*contact.opened));
    return contact.openings < 2 ? text : fmt::format("{}, having opened {}", text, times(contact.openings));
  }
  if (contact.openings == 0) return "";
  if (summary.cycles) {
    const std::int64_t cycles = summary.cycles->computed - summary.cycles->rejected_jumps;
    // The first cycle may begin open, and the last one may not be complete.
    if (cycles > 1 && contact.openings + 1 >= cycles) return "opens in every cycle";
    return fmt::format("opened {} in {} cycles that were computed", times(contact.openings), cycles);
  }
  return fmt::format("opened {} and closed again", times(contact.openings));
}

}  // namespace creepcontact::io
