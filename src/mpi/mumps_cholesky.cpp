#include "creepcontact/mpi/mumps_cholesky.hpp"

#include <dmumps_c.h>
#include <fmt/format.h>
#include <mpi.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "counting.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/index.hpp"
#include "long_messages.hpp"
#include "node_ordering.hpp"

namespace creepcontact::mpi {
namespace {

constexpr double least_rcond = 1e-12;
constexpr int use_communicator = -987654;  // MUMPS' name for MPI_COMM_WORLD

// MUMPS' jobs.
constexpr int initialize = -1, finish = -2, analyse = 1, factor = 2, solve = 3;
// ICNTL(26): halves of a solve.
constexpr int condense = 1, expand = 2, whole = 0;

/// One instance of MUMPS. Numbers of its arrays are those of the users' guide.
class Instance {
 public:
  Instance() {
    data_.comm_fortran = use_communicator;
    data_.par = 1;  // process 0 factors too
    data_.sym = 1;
    data_.job = initialize;
    dmumps_c(&data_);
    for (const int messages : {1, 2, 3, 4}) icntl(messages) = 0;
    icntl(5) = 0;    // assembled entries ...
    icntl(18) = 3;   // ... of all processes
    icntl(7) = 1;    // ordered by the caller
    icntl(28) = 1;   // by process 0
    icntl(8) = 0;    // not scaled
    icntl(20) = 10;  // right-hand side and ...
    icntl(21) = 1;   // ... solution spread over all processes
    icntl(10) = 0;   // no iterative refinement
  }
  ~Instance() {
    data_.job = finish;
    dmumps_c(&data_);
  }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  DMUMPS_STRUC_C& data() { return data_; }
  const DMUMPS_STRUC_C& data() const { return data_; }
  MUMPS_INT& icntl(int number) { return data_.icntl[number - 1]; }
  MUMPS_INT info(int number) const { return data_.info[number - 1]; }
  MUMPS_INT infog(int number) const { return data_.infog[number - 1]; }

  /// @returns INFOG(1), the same on all processes: negative if the job has failed on one
  int run(int job) {
    data_.job = job;
    dmumps_c(&data_);
    return infog(1);
  }

 private:
  DMUMPS_STRUC_C data_{};
};

[[noreturn]] void fail(const char* what, const Instance& mumps) {
  const int code = mumps.infog(1);
  constexpr int no_memory[] = {-7, -13, -19, -9, -8, -14, -15, -17, -20};
  if (std::ranges::count(no_memory, code) > 0)
    throw SolverError(fmt::format(
        "memory runs out on one of the processes in the attempt to {} the stiffness (MUMPS error {}, {}); use more "
        "machines, or fewer processes on each",
        what, code, mumps.infog(2)));
  throw SolverError(fmt::format("MUMPS fails to {} the stiffness: error {}, {}", what, code, mumps.infog(2)));
}

class MumpsCholesky final : public linalg::StiffnessSolver {
 public:
  MumpsCholesky(const linalg::SparseMatrix& lower, std::span<const std::int64_t> block_of,
                std::span<const std::int64_t> trailing)
      : size_(lower.rows()), trailing_(trailing.begin(), trailing.end()) {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    if (size_ > std::numeric_limits<MUMPS_INT>::max()) throw SolverError("a body has more unknowns than MUMPS takes");
    for (const std::int64_t unknown : elimination_order(lower, block_of, trailing))
      order_.push_back(static_cast<MUMPS_INT>(unknown + 1));
    set_pattern(lower);
    prepare();
  }
  MumpsCholesky(const MumpsCholesky& analysed)
      : size_(analysed.size_),
        trailing_(analysed.trailing_),
        rank_(analysed.rank_),
        order_(analysed.order_),
        rows_(analysed.rows_),
        columns_(analysed.columns_),
        own_(analysed.own_) {
    prepare();
  }

  MumpsCholesky& operator=(const MumpsCholesky&) = delete;

  std::unique_ptr<StiffnessSolver> same_pattern() const override { return std::make_unique<MumpsCholesky>(*this); }

  void factorize(const linalg::SparseMatrix& lower) override {
    if (lower.rows() != size_ || lower.nonZeros() != std::ssize(rows_))
      throw std::invalid_argument("the pattern is not the one analysed");
    rcond_ = 1;
    places_.clear();
    if (size_ == 0) return;
    DMUMPS_STRUC_C& data = mumps_.data();
    std::vector<double> values(lower.valuePtr(), lower.valuePtr() + lower.nonZeros());
    data.a_loc = values.data();
    schur_.resize(rank_ == 0 ? std::ssize(trailing_) : 0, rank_ == 0 ? std::ssize(trailing_) : 0);
    schur_.setZero();
    data.schur = schur_.data();
    constexpr int most_space = 320;  // percent above the estimate
    int status = mumps_.run(factor);
    while ((status == -9 || status == -8) && mumps_.icntl(14) < most_space) {
      mumps_.icntl(14) *= 2;
      status = mumps_.run(factor);
    }
    data.a_loc = nullptr;
    counting().factorization_flops += data.rinfo[2];
    counted_bytes_.set(8.0 * (mumps_.info(9) < 0 ? -1e6 * mumps_.info(9) : mumps_.info(9)));
    constexpr int zero_pivot = -10;
    if (status == zero_pivot) throw linalg::SingularMatrix{-1, 0};
    if (status < 0) fail("factorise", mumps_);
    estimate_condition();
    if (!(rcond_ >= least_rcond)) throw linalg::SingularMatrix{-1, rcond_};
  }

  std::int64_t size() const override { return size_; }
  std::int64_t trailing_size() const override { return std::ssize(trailing_); }

  linalg::TaskList& forward_tasks(std::span<const double> b, std::span<double> y) override {
    if (size_ == 0) return nothing_;
    right_.resize(own_.size());
    for (std::size_t i = 0; i < own_.size(); ++i) right_[i] = b[own_[i] - 1];
    if (trailing_.empty()) return nothing_;  // all of it in the backward half
    run_solve(condense, "substitute forward with");
    if (rank_ != 0) return nothing_;
    auto end = Eigen::Map<Eigen::VectorXd>(y.data() + (size_ - trailing_size()), trailing_size());
    end = trailing_values_;
    trailing_factor_.triangularView<Eigen::Lower>().solveInPlace(end);
    return nothing_;
  }

  linalg::TaskList& backward_tasks(std::span<const double> y, std::span<double> x) override {
    if (size_ == 0) return nothing_;
    if (!trailing_.empty() && rank_ == 0) {
      trailing_values_ = Eigen::Map<const Eigen::VectorXd>(y.data() + (size_ - trailing_size()), trailing_size());
      trailing_factor_.triangularView<Eigen::Lower>().transpose().solveInPlace(trailing_values_);
    }
    run_solve(trailing_.empty() ? whole : expand, "substitute backward with");
    collect(x);
    return nothing_;
  }

  Eigen::MatrixXd trailing_factor() const override { return trailing_factor_; }
  std::int64_t factor_bytes() const override {
    const std::int64_t entries = mumps_.infog(20);  // in millions if negative
    int size = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return 8 * (entries < 0 ? -1000000 * entries : entries) / size;
  }
  std::int64_t work_bytes() const override {
    return std::max<std::int64_t>(0, std::int64_t{1000000} * mumps_.info(15) - factor_bytes());
  }
  double rcond() const override { return rcond_; }

 private:
  void set_pattern(const linalg::SparseMatrix& lower) {
    rows_.reserve(lower.nonZeros());
    columns_.reserve(lower.nonZeros());
    std::vector<char> used(size_, 0);
    for (std::int64_t column = 0; column < lower.outerSize(); ++column)
      for (linalg::SparseMatrix::InnerIterator entry(lower, column); entry; ++entry) {
        rows_.push_back(static_cast<MUMPS_INT>(entry.row() + 1));
        columns_.push_back(static_cast<MUMPS_INT>(column + 1));
        used[entry.row()] = used[column] = 1;
      }
    for (std::int64_t i = 0; i < size_; ++i)
      if (used[i]) own_.push_back(static_cast<MUMPS_INT>(i + 1));
  }

  void prepare() {
    if (size_ == 0) return;
    DMUMPS_STRUC_C& data = mumps_.data();
    data.n = static_cast<MUMPS_INT>(size_);
    data.nnz_loc = std::ssize(rows_);
    data.irn_loc = rows_.data();
    data.jcn_loc = columns_.data();
    std::vector<MUMPS_INT> position(order_.size());
    for (std::size_t k = 0; k < order_.size(); ++k) position[order_[k] - 1] = static_cast<MUMPS_INT>(k + 1);
    data.perm_in = position.data();
    std::vector<MUMPS_INT> schur_unknowns;
    for (const std::int64_t unknown : trailing_) schur_unknowns.push_back(static_cast<MUMPS_INT>(unknown + 1));
    if (!trailing_.empty()) {
      mumps_.icntl(19) = 1;  // the Schur complement on process 0
      data.size_schur = static_cast<MUMPS_INT>(trailing_.size());
      data.listvar_schur = schur_unknowns.data();
    }
    if (mumps_.run(analyse) < 0) fail("analyse", mumps_);
    data.perm_in = nullptr;
    data.listvar_schur = nullptr;
    trailing_values_.resize(rank_ == 0 ? std::ssize(trailing_) : 0);
  }

  /// Estimates the condition of the leading block from its pivots, that of the Schur complement from those of its
  /// factor, which is made here.
  void estimate_condition() {
    double rcond = 1;
    if (rank_ == 0) {
      if (!trailing_.empty()) {
        // MUMPS gives the lower triangle by rows: the upper one of a matrix by columns.
        const Eigen::LLT<Eigen::MatrixXd, Eigen::Upper> llt(schur_);
        trailing_factor_ = llt.matrixU().transpose();
        schur_.resize(0, 0);
        const auto diagonal = trailing_factor_.diagonal().array();
        rcond = llt.info() == Eigen::Success ? std::pow(diagonal.minCoeff() / diagonal.maxCoeff(), 2) : 0;
      }
      const double least = mumps_.data().rinfog[19], largest = mumps_.data().rinfog[20];
      if (largest > 0 && least < largest) rcond = std::min(rcond, least / largest);
      if (mumps_.infog(12) > 0) rcond = 0;  // negative pivots
      if (!std::isfinite(rcond)) rcond = 0;
    }
    MPI_Bcast(&rcond, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    rcond_ = rcond;
  }

  void run_solve(int half, const char* what) {
    DMUMPS_STRUC_C& data = mumps_.data();
    mumps_.icntl(26) = half;
    data.nrhs = 1;
    data.nloc_rhs = static_cast<MUMPS_INT>(own_.size());
    data.lrhs_loc = std::max<MUMPS_INT>(1, data.nloc_rhs);
    data.irhs_loc = own_.data();
    data.rhs_loc = right_.data();
    data.redrhs = trailing_values_.data();
    data.lredrhs = static_cast<MUMPS_INT>(std::max<std::int64_t>(1, trailing_size()));
    solution_.resize(std::max(1, mumps_.info(23)));
    solution_rows_.resize(solution_.size());
    data.lsol_loc = static_cast<MUMPS_INT>(solution_.size());
    data.sol_loc = solution_.data();
    data.isol_loc = solution_rows_.data();
    if (mumps_.run(solve) < 0) fail(what, mumps_);
  }

  /// The parts of the solution of all processes.
  void collect(std::span<double> x) {
    int n_processes = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &n_processes);
    const int n_own = mumps_.info(23);
    std::vector<double> own(solution_.begin(), solution_.begin() + n_own);
    if (places_.empty()) {
      std::vector<std::int32_t> rows(solution_rows_.begin(), solution_rows_.begin() + n_own);
      counts_.resize(n_processes);
      MPI_Allgather(&n_own, 1, MPI_INT, counts_.data(), 1, MPI_INT, MPI_COMM_WORLD);
      starts_.assign(n_processes, 0);
      std::partial_sum(counts_.begin(), counts_.end() - 1, starts_.begin() + 1);
      places_.resize(starts_.back() + counts_.back());
      MPI_Allgatherv(rows.data(), n_own, MPI_INT32_T, places_.data(), counts_.data(), starts_.data(), MPI_INT32_T,
                     MPI_COMM_WORLD);
      std::vector<char> found(size_, 0);
      for (const std::int32_t row : places_) found[row - 1] = 1;
      if (!std::ranges::all_of(found, [](char is) { return is != 0; }))
        throw std::logic_error("MUMPS leaves out a part of the solution");
    }
    std::vector<double> all(places_.size());
    MPI_Allgatherv(own.data(), n_own, MPI_DOUBLE, all.data(), counts_.data(), starts_.data(), MPI_DOUBLE,
                   MPI_COMM_WORLD);
    for (std::size_t i = 0; i < all.size(); ++i) x[places_[i] - 1] = all[i];
  }

  std::int64_t size_;
  std::vector<std::int64_t> trailing_;
  int rank_ = 0;
  std::vector<MUMPS_INT> order_;           // on process 0
  std::vector<MUMPS_INT> rows_, columns_;  // of the entries of this process, from 1
  std::vector<MUMPS_INT> own_;             // unknowns with entries, from 1
  Instance mumps_;
  double rcond_ = 0;
  Eigen::MatrixXd schur_, trailing_factor_;  // on process 0
  Eigen::VectorXd trailing_values_;          // on process 0: right-hand side, then solution
  std::vector<double> right_, solution_;
  std::vector<MUMPS_INT> solution_rows_;
  std::vector<int> counts_, starts_;  // of the parts of the solution of all processes
  std::vector<std::int32_t> places_;  // the unknowns of these parts
  linalg::SingleTask nothing_;
  CountedBytes counted_bytes_;
};

}  // namespace

std::unique_ptr<linalg::StiffnessSolver> mumps_cholesky(const linalg::StiffnessToAnalyze& matrix) {
  return std::make_unique<MumpsCholesky>(matrix.lower, matrix.block_of, matrix.trailing);
}

}  // namespace creepcontact::mpi
