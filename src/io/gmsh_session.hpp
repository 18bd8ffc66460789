#pragma once
/// The Gmsh library for the time of one mesh: quiet, single-threaded, its errors as exceptions.

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace creepcontact::io {

/// Initialises the library on construction, finalises it on destruction.
class GmshSession {
 public:
  /// @param name  of the file, for messages
  explicit GmshSession(std::string name);
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Runs Gmsh calls. @throws ModelError with all lines that Gmsh logged as errors, even if it went on after them
  void run(const std::function<void()>& calls) const;

  /// Forgets the variables of earlier files and gives these ones their values, which DefineConstant then leaves alone.
  void set_variables(const std::map<std::string, double>& values) const;

 private:
  std::string name_;
};

}  // namespace creepcontact::io
