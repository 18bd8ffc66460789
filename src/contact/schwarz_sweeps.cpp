#include "schwarz_sweeps.hpp"

#include <algorithm>

#include "creepcontact/contact/frozen_system.hpp"
#include "fixed_point.hpp"

namespace creepcontact::contact {
namespace {

/// Stiffness that each active row feels from one body alone: diag(F^-1), or 1/diag(F) where F is singular (the
/// master's when the slave is finer).
Eigen::VectorXd stiffness(const Eigen::MatrixXd& flexibility) {
  const Eigen::LLT<Eigen::MatrixXd> factor(flexibility);
  if (factor.info() != Eigen::Success || factor.rcond() < 1e-8)
    return flexibility.diagonal().cwiseMax(1e-14 * flexibility.diagonal().maxCoeff()).cwiseInverse();
  return factor.solve(Eigen::MatrixXd::Identity(flexibility.rows(), flexibility.rows())).diagonal();
}

}  // namespace

SchwarzSweeps::SchwarzSweeps(const ContactProblem& problem, const SchwarzOptions& options, std::vector<int> active)
    : options_(options), active_(std::move(active)), total_(problem.total(active_, active_)) {
  const auto n = static_cast<Eigen::Index>(active_.size());
  Eigen::VectorXd stiffness_sum = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::VectorXd> stiffnesses;
  Eigen::Index offset = 0;
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const Flexibility& body = problem.bodies[b];
    Share share;
    std::vector<int> own;
    std::vector<double> signs;
    for (std::size_t k = 0; k < active_.size(); ++k) {
      const auto found = std::lower_bound(body.rows.begin(), body.rows.end(), active_[k]);
      if (found == body.rows.end() || *found != active_[k]) continue;
      own.push_back(static_cast<int>(found - body.rows.begin()));
      share.places.push_back(static_cast<int>(k));
      signs.push_back(problem.slave_body[static_cast<std::size_t>(active_[k])] == static_cast<int>(b) ? 1.0 : -1.0);
    }
    if (own.empty()) continue;
    share.flexibility = body.matrix(own, own);
    factor_semidefinite(share.flexibility, share.factor);
    share.sign = Eigen::Map<const Eigen::VectorXd>(signs.data(), static_cast<Eigen::Index>(signs.size()));
    share.offset = offset;
    offset += share.flexibility.rows();
    stiffnesses.push_back(stiffness(share.flexibility));
    stiffness_sum(share.places) += stiffnesses.back();
    shares_.push_back(std::move(share));
  }
  for (std::size_t s = 0; s < shares_.size(); ++s) {
    Share& share = shares_[s];
    const Eigen::Index m = share.flexibility.rows();
    share.odd = options.alpha ? Eigen::VectorXd::Constant(m, *options.alpha)
                              : Eigen::VectorXd(stiffnesses[s].cwiseQuotient(stiffness_sum(share.places)));
    share.even = options.alpha ? share.odd : Eigen::VectorXd(Eigen::VectorXd::Ones(m) - share.odd);
  }
}

void SchwarzSweeps::sweep(const Eigen::VectorXd& gap, const Eigen::VectorXd& from, Eigen::VectorXd& to) const {
  Eigen::VectorXd mismatch = gap;  // of the traces, then of the multipliers
  for (const Share& share : shares_)
    mismatch(share.places) += share.flexibility * from.segment(share.offset, share.flexibility.rows());
  Eigen::VectorXd difference = Eigen::VectorXd::Zero(gap.size());
  to = from;
  for (const Share& share : shares_) {  // Dirichlet problems, in increments: the factor may be that of a shifted matrix
    auto part = to.segment(share.offset, share.flexibility.rows());
    part -= share.factor.solve(Eigen::VectorXd(share.even.cwiseProduct(mismatch(share.places))));
    difference(share.places) += share.sign.cwiseProduct(part);
  }
  for (const Share& share : shares_)
    to.segment(share.offset, share.flexibility.rows()) -=
        share.odd.cwiseProduct(share.sign).cwiseProduct(difference(share.places));
}

Eigen::VectorXd SchwarzSweeps::mean(const Eigen::VectorXd& both) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(active_.size()));
  for (const Share& share : shares_) result(share.places) += 0.5 * both.segment(share.offset, share.flexibility.rows());
  return result;
}

SweepResult SchwarzSweeps::solve(const Eigen::VectorXd& gap, const Eigen::VectorXd& start) const {
  SweepResult result{start, 0, active_.empty()};
  if (result.converged) return result;
  Eigen::Index size = 0;
  for (const Share& share : shares_) size += share.flexibility.rows();
  Eigen::VectorXd both(size), swept(size);
  for (const Share& share : shares_) both.segment(share.offset, share.flexibility.rows()) = start(share.places);

  FixedPoint accelerator(options_.acceleration, size);
  double first_residual = 0;
  while (result.iterations < options_.max_iterations) {
    sweep(gap, both, swept);
    ++result.iterations;
    const double change = (swept - both).cwiseAbs().maxCoeff();
    accelerator.advance(both, swept);
    result.multiplier = mean(both);
    const double scale = result.multiplier.cwiseAbs().maxCoeff();
    // The sweep's change vanishes only where traces and multipliers agree; the gap left is looked at besides.
    if (change <= options_.tolerance * scale) {
      const Eigen::VectorXd left = (gap + total_ * result.multiplier).cwiseQuotient(total_.diagonal());
      if (left.cwiseAbs().maxCoeff() <= 100 * options_.tolerance * scale) {
        result.converged = true;
        return result;
      }
    }
    if (first_residual == 0) first_residual = change;
    if (!(change < 1e6 * first_residual)) return result;
  }
  return result;
}

}  // namespace creepcontact::contact
