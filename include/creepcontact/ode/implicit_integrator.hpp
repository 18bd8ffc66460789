#pragma once
/// Integration of F(t, y, dy/dt) = 0 by BDF of variable order and step (SUNDIALS IDA, Hindmarsh et al. 2005), with a
/// direct solver of the caller's own.

#include <cstddef>
#include <memory>
#include <span>

namespace creepcontact::ode {

/// Exceptions of its functions pass the integrator; a RecoverableError makes it try a shorter step.
class ImplicitSystem {
 public:
  virtual ~ImplicitSystem() = default;
  virtual std::size_t size() const = 0;
  /// residual = F(t, y, rate)
  virtual void residual(double t, std::span<const double> y, std::span<const double> rate,
                        std::span<double> residual) = 0;
  /// Prepares solve() with dF/dy + c dF/drate at this point, or with a matrix near it.
  virtual void prepare(double t, std::span<const double> y, std::span<const double> rate, double c) = 0;
  /// Another c in the matrix that was prepared. It comes often: the work of prepare() is not for each.
  virtual void shift(double c) = 0;
  /// x = matrix^-1 x, to a tenth or to this root mean square
  virtual void solve(std::span<double> x, double tolerance) = 0;
};

class ImplicitIntegrator {
 public:
  /// @param system  must outlive the integrator
  /// @param tolerance  absolute, of the root mean square over the entries of y
  ImplicitIntegrator(ImplicitSystem& system, double tolerance);
  ~ImplicitIntegrator();
  ImplicitIntegrator(const ImplicitIntegrator&) = delete;
  ImplicitIntegrator& operator=(const ImplicitIntegrator&) = delete;

  /// Starts, or starts again, without regard to earlier steps. Precondition: F(t, y, rate) = 0, about
  void start(double t, std::span<const double> y, std::span<const double> rate);
  /// Length of the next step, which may turn out shorter; 0: not chosen yet.
  double next_step() const;
  /// One step, which ends at `end` or before. @throws SolverError if the integration fails
  void step(double end);

  double time() const;
  /// At time(). The rate is that of the polynomial of the method.
  std::span<const double> state() const;
  std::span<const double> rate() const;
  /// Since the last start.
  long n_steps() const;

 private:
  struct Ida;
  std::unique_ptr<Ida> ida_;
};

}  // namespace creepcontact::ode
