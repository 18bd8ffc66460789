#pragma once
/// Errors that end a run, by what the user has to correct; each kind has its exit status.

#include <stdexcept>
#include <string>

namespace creepcontact {

/// Base of all errors that are reported to the user.
class Error : public std::runtime_error {
 public:
  Error(const std::string& message, int exit_status) : std::runtime_error(message), exit_status_(exit_status) {}
  int exit_status() const noexcept { return exit_status_; }

 private:
  int exit_status_;
};

/// Wrong command line or configuration: exit status 2.
class ConfigError : public Error {
 public:
  static constexpr int status = 2;
  explicit ConfigError(const std::string& message) : Error(message, status) {}
};

/// Wrong mesh or model (unsupported element, missing group, a body that can move freely): exit status 3.
class ModelError : public Error {
 public:
  static constexpr int status = 3;
  explicit ModelError(const std::string& message) : Error(message, status) {}
};

/// A failure that a smaller step may avoid (contact not converged, overflow): integrators retry.
struct RecoverableError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A numerical method failed; results computed before are kept. Exit status 4.
class SolverError : public Error {
 public:
  static constexpr int status = 4;
  explicit SolverError(const std::string& message) : Error(message, status) {}
};

}  // namespace creepcontact
