#include "schwarz_sweeps.hpp"

#include <algorithm>

#include "aitken.hpp"
#include "creepcontact/base/index.hpp"

namespace creepcontact::contact {
namespace {

using Acceleration = SchwarzOptions::Acceleration;

constexpr double growth = 1e6;             // of the change: beyond it the sweeps diverge
constexpr double max_remaining_gap = 100;  // times the tolerance: the sweep's change alone may deceive

std::span<double> span_of(Eigen::VectorXd& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

}  // namespace

SchwarzSweeps::SchwarzSweeps(const ContactProblem& problem, const SchwarzOptions& options, std::vector<int> active)
    : options_(options), set_(problem, std::move(active)) {
  std::vector<std::size_t> bodies;
  Index offset = 0;
  for (std::size_t b = 0; b < problem.of_bodies().size(); ++b) {
    OwnRows rows = own_rows(problem, b, set_.active());
    if (rows.own.empty()) continue;
    const Index size = rows.own.size();
    Eigen::VectorXd sign(size), layer = Eigen::VectorXd::Zero(size);  // a gasket is part of the slave
    for (Index k = 0; k < size; ++k) {
      const int row = set_.active()[rows.positions[k]];
      sign[k] = problem.node(row).slave_body == static_cast<int>(b) ? 1.0 : -1.0;
      if (sign[k] > 0 && problem.compliance.size() > 0) layer[k] = problem.compliance[row];
    }
    Eigen::MatrixXd flexibility = problem.of_bodies()[b].matrix(rows.own, rows.own);
    flexibility.diagonal() += layer;
    Share share{std::move(rows.positions),
                std::move(flexibility),
                DirichletProblem(problem, b, rows.own, layer),
                Eigen::MatrixXd(size, 0),
                {},
                {},
                std::move(sign),
                offset};
    if (problem.n_motions() > 0) share.rigid = problem.rigid_of_body[b](rows.own, Eigen::all);
    offset += size;
    shares_.push_back(std::move(share));
    bodies.push_back(b);
  }
  set_fractions(options.alpha, bodies);
}

void SchwarzSweeps::set_fractions(const std::vector<std::optional<double>>& alpha,
                                  const std::vector<std::size_t>& bodies) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(active().size());
  for (Share& share : shares_) {
    share.odd = share.body.stiffness();
    sum(share.positions) += share.odd;
  }
  for (std::size_t s = 0; s < shares_.size(); ++s) {
    Share& share = shares_[s];
    share.odd = share.odd.cwiseQuotient(Eigen::VectorXd(sum(share.positions)));
    share.even = Eigen::VectorXd::Ones(share.size()) - share.odd;
    if (bodies[s] < alpha.size() && alpha[bodies[s]])
      share.odd = share.even = Eigen::VectorXd::Constant(share.size(), *alpha[bodies[s]]);
  }
}

void SchwarzSweeps::sweep(const ActiveSetLoad& load, const Eigen::VectorXd& from, Eigen::VectorXd& to) const {
  const RigidBalance& balance = set_.balance();
  Eigen::VectorXd mismatch = load.gap;  // of the traces
  for (const Share& share : shares_)
    mismatch(share.positions) += share.flexibility * from.segment(share.offset, share.size());
  if (!balance.empty()) mismatch = balance.without_rigid_part(mismatch);
  Eigen::VectorXd difference = Eigen::VectorXd::Zero(load.gap.size());  // of the multipliers
  to = from;
  for (const Share& share : shares_) {  // Dirichlet problems, in increments: the factor may be that of a shifted matrix
    auto part = to.segment(share.offset, share.size());
    part -= share.body.balanced_multipliers(share.even.cwiseProduct(Eigen::VectorXd(mismatch(share.positions))));
    difference(share.positions) += share.sign.cwiseProduct(part);
  }
  for (const Share& share : shares_)
    to.segment(share.offset, share.size()) -=
        share.odd.cwiseProduct(share.sign).cwiseProduct(Eigen::VectorXd(difference(share.positions)));
  if (!balance.empty()) {
    Eigen::VectorXd unbalanced =
        load.resultant.size() > 0 ? load.resultant : Eigen::VectorXd::Zero(shares_.front().rigid.cols());
    for (const Share& share : shares_) unbalanced += share.rigid.transpose() * to.segment(share.offset, share.size());
    const Eigen::VectorXd carrying = balance.carrying(unbalanced);
    for (const Share& share : shares_) to.segment(share.offset, share.size()) -= carrying(share.positions);
  }
  if (options_.damping != 1.0) to = from + options_.damping * (to - from);
}

Eigen::VectorXd SchwarzSweeps::mean(const Eigen::VectorXd& both) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(active().size());
  for (const Share& share : shares_) result(share.positions) += 0.5 * both.segment(share.offset, share.size());
  return result;
}

InnerResult SchwarzSweeps::solve(const ActiveSetLoad& load, const Eigen::VectorXd& start, const InnerLog& log) const {
  InnerResult result{start, 0, active().empty()};
  if (result.converged) return result;
  const RigidBalance& balance = set_.balance();
  const auto rebalance = [&] {
    if (!balance.empty()) result.multiplier -= balance.carrying(balance.unbalanced(result.multiplier, load.resultant));
  };
  rebalance();
  Eigen::VectorXd both(shares_.back().offset + shares_.back().size());
  for (const Share& share : shares_) both.segment(share.offset, share.size()) = result.multiplier(share.positions);

  double first_change = 0;
  Eigen::VectorXd swept(both.size());
  // One sweep, judged. True: the end.
  const auto step = [&](const Eigen::VectorXd& from) {
    sweep(load, from, swept);
    ++result.iterations;
    result.multiplier = mean(swept);
    const double change = (swept - from).cwiseAbs().maxCoeff() / options_.damping;
    const double scale = result.multiplier.cwiseAbs().maxCoeff();
    log(settings::name_of(options_.acceleration), result.iterations, scale > 0 ? change / scale : 0.0, active().size());
    const double least = std::max(options_.tolerance * scale, load.rounding);
    if (change <= least) {
      const Eigen::VectorXd left = balance.without_rigid_part(load.gap + set_.gaps(result.multiplier));
      result.converged = left.cwiseQuotient(set_.diagonal()).cwiseAbs().maxCoeff() <= max_remaining_gap * least;
    }
    if (first_change == 0) first_change = change;
    return result.converged || result.iterations >= options_.max_iterations || !(change <= growth * first_change);
  };

  if (options_.acceleration == Acceleration::anderson) {
    options_.anderson(both.size())->solve(span_of(both), [&](std::span<const double> x, std::span<double> image) {
      const bool end = step(Eigen::Map<const Eigen::VectorXd>(x.data(), both.size()));
      std::copy_n(swept.data(), swept.size(), image.data());
      return end;
    });
  } else {
    Aitken aitken;
    while (!step(both)) {
      if (options_.acceleration == Acceleration::aitken)
        aitken.advance(both, swept);
      else
        both.swap(swept);
    }
  }
  rebalance();
  return result;
}

}  // namespace creepcontact::contact
