#include "load_course.hpp"

#include <algorithm>
#include <utility>

namespace creepcontact::creep {
namespace {
constexpr int most_splits = 6;
}

LoadCourse::Deviation LoadCourse::Piece::at(double part) const {
  const double x = (part - begin) / (end - begin);
  const double a = (1 - x) * (1 - 2 * x), b = 4 * x * (1 - x), c = x * (2 * x - 1);
  return {a * first.gap + b * middle.gap + c * last.gap,
          a * first.resultant + b * middle.resultant + c * last.resultant};
}

LoadCourse::LoadCourse(const Deviation& none, const At& at, const IsNear& is_near) {
  split({0, 1, none, at(0.5), none}, 0, at, is_near);
}

void LoadCourse::split(Piece piece, int depth, const At& at, const IsNear& is_near) {
  const double middle = (piece.begin + piece.end) / 2;
  const double quarter = (piece.begin + middle) / 2, three_quarters = (middle + piece.end) / 2;
  const Deviation before = at(quarter), after = at(three_quarters);
  const bool near = is_near(piece.at(quarter), before) && is_near(piece.at(three_quarters), after);
  if (near || depth == most_splits) {
    is_resolved_ = is_resolved_ && near;
    pieces_.push_back(std::move(piece));
    return;
  }
  split({piece.begin, middle, piece.first, before, piece.middle}, depth + 1, at, is_near);
  split({middle, piece.end, piece.middle, after, piece.last}, depth + 1, at, is_near);
}

LoadCourse::Deviation LoadCourse::at(double part) const {
  const auto found = std::ranges::find_if(pieces_, [&](const Piece& piece) { return part <= piece.end; });
  return (found != pieces_.end() ? *found : pieces_.back()).at(part);
}

}  // namespace creepcontact::creep
