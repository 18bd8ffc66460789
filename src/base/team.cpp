#include "creepcontact/base/team.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>
#include <string>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/stop_request.hpp"

namespace creepcontact {
namespace {

// Other than `recoverable`, all end the run.
enum class Kind { none, recoverable, other, memory, error, solver, model, config, cancelled };
constexpr bool is_fatal(Kind kind) {
  return kind > Kind::recoverable;
}

struct Failure {
  Kind kind = Kind::none;
  int exit_status = 0;
  std::string message = {};
};

Failure describe(const std::exception_ptr& failure) {
  if (!failure) return {};
  try {
    std::rethrow_exception(failure);
  } catch (const RecoverableError& error) {
    return {Kind::recoverable, 0, error.what()};
  } catch (const ConfigError& error) {
    return {Kind::config, 0, error.what()};
  } catch (const ModelError& error) {
    return {Kind::model, 0, error.what()};
  } catch (const SolverError& error) {
    return {Kind::solver, 0, error.what()};
  } catch (const Error& error) {
    return {Kind::error, error.exit_status(), error.what()};
  } catch (const std::bad_alloc&) {
    return {Kind::memory};
  } catch (const Cancelled&) {
    return {Kind::cancelled};
  } catch (const std::exception& error) {
    return {Kind::other, 0, error.what()};
  } catch (...) {
    return {Kind::other, 0, "unknown error"};
  }
}

[[noreturn]] void raise(const Failure& failure) {
  switch (failure.kind) {
    case Kind::recoverable:
      throw RecoverableError(failure.message);
    case Kind::config:
      throw ConfigError(failure.message);
    case Kind::model:
      throw ModelError(failure.message);
    case Kind::solver:
      throw SolverError(failure.message);
    case Kind::error:
      throw Error(failure.message, failure.exit_status);
    case Kind::memory:
      throw std::bad_alloc();
    case Kind::cancelled:
      throw Cancelled();
    default:
      throw std::runtime_error(failure.message);
  }
}

/// What `root` has, to all.
Failure of_root(const Team& team, Failure failure, int root) {
  std::array<double, 2> header{static_cast<double>(failure.kind), static_cast<double>(failure.exit_status)};
  team.broadcast(header, root);
  broadcast(team, failure.message, root);
  failure.kind = static_cast<Kind>(static_cast<int>(header[0]));
  failure.exit_status = static_cast<int>(header[1]);
  return failure;
}

}  // namespace

double Team::sum(double value) const {
  sum(std::span(&value, 1));
  return value;
}
double Team::max(double value) const {
  max(std::span(&value, 1));
  return value;
}
double Team::min(double value) const {
  min(std::span(&value, 1));
  return value;
}

int Team::rank_of_max(double value) const {
  const double largest = max(value);
  return std::min(static_cast<int>(min(value == largest ? rank() : size())), size() - 1);
}

const Team& serial_team() {
  static const SerialTeam alone;
  return alone;
}

void broadcast(const Team& team, std::vector<double>& values, int root) {
  if (team.size() == 1) return;
  std::array<double, 1> size{static_cast<double>(values.size())};
  team.broadcast(size, root);
  values.resize(static_cast<std::size_t>(size[0]));
  team.broadcast(values, root);
}

void broadcast(const Team& team, std::string& text, int root) {
  std::vector<double> letters(text.begin(), text.end());
  broadcast(team, letters, root);
  text.clear();
  for (const double letter : letters) text += static_cast<char>(letter);
}

void agree_on_failure(const Team& team, const std::exception_ptr& own) {
  const Failure failure = describe(own);
  const double weight = failure.kind == Kind::none ? 0.0 : is_fatal(failure.kind) ? 2.0 : 1.0;
  // One reduction where nothing has failed: the heaviest failure, and of equals that of the lowest rank.
  const double heaviest = team.max(weight * team.size() - (weight > 0 ? team.rank() : 0));
  if (!(heaviest > 0)) return;
  const double its_weight = heaviest > team.size() ? 2 : 1;
  const int root = static_cast<int>(its_weight * team.size() - heaviest);
  if (root == team.rank()) {
    of_root(team, failure, root);
    std::rethrow_exception(own);
  }
  raise(of_root(team, {}, root));
}

}  // namespace creepcontact
