#include "contact_broadcast.hpp"

#include <vector>

namespace creepcontact::creep {
namespace {

/// A sequence of vectors of numbers, sent together.
class Parcel {
 public:
  template <typename Numbers>
  void add(const Numbers& numbers) {
    lengths_.push_back(static_cast<double>(numbers.size()));
    content_.insert(content_.end(), numbers.begin(), numbers.end());
  }
  void send(const Team& team) {
    creepcontact::broadcast(team, lengths_, 0);
    creepcontact::broadcast(team, content_, 0);
  }
  std::vector<double> take() {
    const auto from = content_.begin() + static_cast<std::ptrdiff_t>(taken_);
    taken_ += static_cast<std::size_t>(lengths_[next_]);
    return {from, from + static_cast<std::ptrdiff_t>(lengths_[next_++])};
  }
  Eigen::VectorXd take_vector() {
    const std::vector<double> numbers = take();
    return Eigen::VectorXd::Map(numbers.data(), static_cast<Index>(numbers.size()));
  }

 private:
  std::vector<double> lengths_, content_;
  std::size_t next_ = 0, taken_ = 0;
};

void add(const contact::ContactState& state, Parcel& to) {
  to.add(state.multiplier);
  to.add(state.rigid);
  to.add(state.active);
  to.add(packed(state.nodes));
  to.add(packed(state.factored));
  to.add(state.image);
}

void take(Parcel& from, contact::ContactState& state) {
  state.multiplier = from.take_vector();
  state.rigid = from.take_vector();
  const std::vector<double> active = from.take();
  state.active.assign(active.begin(), active.end());
  state.nodes = unpacked(from.take());
  state.factored = unpacked(from.take());
  state.image = from.take_vector();
}

void add(const SlipHistory& friction, Parcel& to) {
  for (const Eigen::VectorXd* rows :
       {&friction.slip, &friction.gap, &friction.direction, &friction.rate, &friction.path})
    to.add(*rows);
  to.add(friction.dissipated);
  to.add(std::vector<double>{friction.time, friction.is_fresh ? 1.0 : 0.0});
}

void take(Parcel& from, SlipHistory& friction) {
  for (Eigen::VectorXd* rows : {&friction.slip, &friction.gap, &friction.direction, &friction.rate, &friction.path})
    *rows = from.take_vector();
  friction.dissipated = from.take();
  const std::vector<double> clock = from.take();
  friction.time = clock[0];
  friction.is_fresh = clock[1] != 0;
}

}  // namespace

void broadcast(const Team& team, std::vector<PathPoint>& points) {
  if (team.size() == 1) return;
  Parcel parcel;
  if (team.rank() == 0) {
    parcel.add(std::vector<double>(points.size()));
    for (const PathPoint& point : points) {
      add(point.contact, parcel);
      add(point.friction, parcel);
    }
  }
  parcel.send(team);
  points.resize(parcel.take().size());
  for (PathPoint& point : points) {
    take(parcel, point.contact);
    take(parcel, point.friction);
  }
}

void broadcast(const Team& team, contact::ContactState& state) {
  if (team.size() == 1) return;
  Parcel parcel;
  if (team.rank() == 0) add(state, parcel);
  parcel.send(team);
  take(parcel, state);
}

void broadcast(const Team& team, contact::ContactResult& result) {
  if (team.size() == 1) return;
  Parcel parcel;
  if (team.rank() == 0) {
    add(result.state, parcel);
    parcel.add(result.gap);
    parcel.add(std::vector<double>{static_cast<double>(result.iterations), static_cast<double>(result.set_changes)});
  }
  parcel.send(team);
  take(parcel, result.state);
  result.gap = parcel.take_vector();
  const std::vector<double> counts = parcel.take();
  result.iterations = static_cast<int>(counts[0]);
  result.set_changes = static_cast<int>(counts[1]);
}

std::vector<double> packed(const std::vector<contact::NodeLinearization>& nodes) {
  std::vector<double> values;
  for (const contact::NodeLinearization& node : nodes)
    values.insert(values.end(), {static_cast<double>(node.status), node.friction, node.direction.x(),
                                 node.direction.y(), node.equation.x(), node.equation.y(), node.flexibility});
  return values;
}

std::vector<contact::NodeLinearization> unpacked(const std::vector<double>& values) {
  constexpr std::size_t width = 7;
  std::vector<contact::NodeLinearization> nodes;
  for (std::size_t i = 0; i + width <= values.size(); i += width)
    nodes.push_back({static_cast<contact::ContactStatus>(static_cast<int>(values[i])),
                     values[i + 1],
                     {values[i + 2], values[i + 3]},
                     {values[i + 4], values[i + 5]},
                     values[i + 6]});
  return nodes;
}

}  // namespace creepcontact::creep
