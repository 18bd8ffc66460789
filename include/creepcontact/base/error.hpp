#pragma once
/// Errors that end a run, by what the user has to mend; each kind has its exit status.

#include <stdexcept>
#include <string>

namespace creepcontact {

class Error : public std::runtime_error {
 public:
  Error(const std::string& message, int exit_status) : std::runtime_error(message), exit_status_(exit_status) {}
  int exit_status() const noexcept { return exit_status_; }

 private:
  int exit_status_;
};

/// Command line or configuration: exit status 2.
class ConfigError : public Error {
 public:
  static constexpr int status = 2;
  explicit ConfigError(const std::string& message) : Error(message, status) {}
};

/// Mesh or model (unsupported element, missing group, a body free to move): exit status 3.
class ModelError : public Error {
 public:
  static constexpr int status = 3;
  explicit ModelError(const std::string& message) : Error(message, status) {}
};

/// A failure that a smaller step may mend (contact not converged, overflow): integrators retry.
struct RecoverableError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A numerical method gave up; what was computed before is kept: exit status 4.
class SolverError : public Error {
 public:
  static constexpr int status = 4;
  explicit SolverError(const std::string& message) : Error(message, status) {}
};

}  // namespace creepcontact
